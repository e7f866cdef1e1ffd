import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { expectClean, opened, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
let page: Page;
beforeAll(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=breeze&nodes=24`, { reducedMotion: "reduce" });
  page = seen.page;
  await ready(page);
});
afterAll(() => expectClean(seen, here.site));

const pins = () => page.evaluate(() => [...window.weft.pins]);
const markers = () => page.locator("#pins circle").count();
const at = (node: number) =>
  page.evaluate(async (n) => [...(await window.weft.world!.positions()).subarray(3 * n, 3 * n + 3)], node);
const way = (from: readonly number[], to: readonly number[]) => Math.hypot(...from.map((value, i) => value - to[i]!));
const step = (frames: number) => page.evaluate((count) => window.weft.world!.step(count).then(() => undefined), frames);
const spot = { x: 240, y: 220 }; // on the sheet, [CSS pixels]

test("a double click pins a node where it is while the cloth around it goes on, and another lets it go", async () => {
  await page.mouse.dblclick(spot.x, spot.y);
  await until("it is pinned", async () => (await pins()).length === 1);
  const [node] = (await pins()) as [number];
  const [start, free] = [await at(node), await at(node + 100)];
  await step(40);
  expect(way(start, await at(node))).toBeLessThan(0.005); // m
  expect(way(free, await at(node + 100))).toBeGreaterThan(0.05);

  const marker = (await page.locator("#pins circle").boundingBox())!; // it lies over its node
  expect(way([marker.x + marker.width / 2, marker.y + marker.height / 2], [spot.x, spot.y])).toBeLessThan(12);
  await page.mouse.dblclick(marker.x + marker.width / 2, marker.y + marker.height / 2);
  await until("it is free", async () => (await pins()).length === 0);
  expect(await markers()).toBe(0);
  await step(20);
  expect(way(start, await at(node))).toBeGreaterThan(0.01);
});

test("a pin that is dragged stays where it is left", async () => {
  await page.keyboard.press("r");
  await page.mouse.dblclick(spot.x, spot.y);
  await until("it is pinned", async () => (await pins()).length === 1);
  const [node] = (await pins()) as [number];
  const start = await at(node);
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  await until("it is grabbed", async () => (await page.locator("#canvas").getAttribute("data-gesture")) === "grab");
  await page.mouse.move(spot.x + 30, spot.y - 30, { steps: 4 });
  await page.waitForTimeout(100);
  await page.mouse.up();
  await step(60);
  expect(await pins()).toEqual([node]);
  const left = await at(node);
  expect(way(start, left)).toBeGreaterThan(0.1);
  await step(30);
  expect(way(left, await at(node))).toBeLessThan(0.005);
});

test("pins are set by key and by click, up to what the core holds, and go together", async () => {
  await page.keyboard.press("u");
  await until("none is pinned", async () => (await pins()).length === 0);
  await page.keyboard.press("r");
  const places = [[200, 150], [300, 150], [240, 220], [280, 260]] as const;
  await page.mouse.move(...places[0]);
  await page.keyboard.press("p");
  await until("one is pinned", async () => (await pins()).length === 1);
  await page.getByRole("button", { name: "Pin by click" }).click();
  for (const [i, place] of places.slice(1, 3).entries()) {
    await page.mouse.click(place[0], place[1]);
    await until("one more is pinned", async () => (await pins()).length === i + 2);
  }
  expect(await markers()).toBe(3);
  await page.mouse.click(...places[3]);
  await until("it is refused",
    async () => /3 nodes are pinned.*the core holds 4/.test((await page.locator("#notice").textContent())!));
  await page.getByRole("button", { name: "Remove all" }).click();
  await until("none is pinned", async () => (await pins()).length === 0 && (await markers()) === 0);
  await page.getByRole("button", { name: "Pin by click" }).click();
});

test("without a pointer, P pins in the middle of the picture, and reset lets go", async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=24`);
  await ready(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("p");
  await until("it is pinned", async () => (await pins()).length === 1);
  await page.keyboard.press("r");
  await until("it is let go", async () => (await pins()).length === 0);
});

test("pins hold the same place of the cloth after a restart, at another resolution, and by the link", async () => {
  const kept = () => page.evaluate(() => window.weft.state!.pins);
  const nodes = () => page.evaluate(() => window.weft.world!.info.nodes);
  const sheet = async (text: string) => (await page.locator("#facts").textContent())!.includes(text);
  await page.goto(`${here.site.address}?scene=breeze&nodes=24`);
  await ready(page);
  await step(20);
  await page.mouse.dblclick(spot.x, spot.y);
  await until("it is pinned", async () => (await pins()).length === 1);
  const [node] = (await pins()) as [number];
  const [pin] = await kept();
  const { rest } = await page.evaluate((n) => window.weft.world!.probe(n), node);
  expect(pin!.rest).toEqual(rest);
  expect(way(pin!.target, await at(node))).toBeLessThan(1e-6);
  expect(way(pin!.target, rest)).toBeGreaterThan(0.01); // it has fallen since, and stays where it was pinned

  const count = await nodes();
  await page.getByLabel("Substeps per frame").evaluate((field) => {
    (field.closest("details") as HTMLDetailsElement).open = true;
  });
  await page.getByLabel("Substeps per frame").fill("90");
  await page.getByLabel("Substeps per frame").press("Enter");
  await until("it has been restarted", async () => await sheet("Substeps per frame90") && (await pins()).length === 1);
  expect(await pins()).toEqual([node]);
  expect([await kept(), await markers(), await nodes()]).toEqual([[pin], 1, count]);
  await step(30);
  expect(way(pin!.target, await at(node))).toBeLessThan(0.005);

  await page.getByLabel("Resolution").selectOption("64");
  await until("it is finer", async () => await sheet("Nodes3,072") && (await pins()).length === 1);
  const [finer] = (await pins()) as [number];
  const spacing = 2 / 63; // m
  expect(way((await page.evaluate((n) => window.weft.world!.probe(n), finer)).rest, rest)).toBeLessThan(spacing);
  expect(await kept()).toEqual([pin]);
  await step(20);
  expect(way(pin!.target, await at(finer))).toBeLessThan(0.005);

  const part = [...pin!.rest, ...pin!.target].map((x) => Number(x.toFixed(4))).join();
  await until("the address has it", async () => new URL(page.url()).searchParams.get("pins") === part);
  await page.reload();
  await ready(page);
  expect(await pins()).toEqual([finer]);
  await page.getByLabel("Other grid").selectOption("32");
  await until("it is compared", () => page.evaluate(() => window.weft.other !== null));
  await until("it is pinned on the left", async () => (await pins()).length === 1);
  await page.locator("#reset").click();
  await until("the address has none", async () => !new URL(page.url()).searchParams.has("pins"));
  expect([await pins(), await kept()]).toEqual([[], []]);
});

test("an address whose pins are none, too many, or where the scene has its own is refused in a sentence", async () => {
  const said = async (query: string) => {
    await page.goto(`${here.site.address}?scene=hanging&nodes=12&${query}`);
    await ready(page);
    return (await page.locator("#notice-text").textContent())!;
  };
  expect(await said("pins=0,0,0:0,0,0,0,1,0")).toBe("In the page's address a pin is “0,0,0”, but must be six numbers " +
    "[m]: its place on the cloth at rest, and where it is held; what the scene has is used instead.");
  expect((await pins()).length).toBe(1);
  expect(await said(`pins=${Array.from({ length: 4 }, (_, i) => `0,0,${i / 2},0,1,0`).join(":")}`)).toMatch(
    /pins is “.*”, but must be at most 3;/,
  );
  expect((await pins()).length).toBe(3);
  const pinned = await page.evaluate(async () => (await window.weft.world!.snapshot()).inverseMasses.indexOf(0));
  const corner = await at(pinned);
  expect(await said(`pins=${[...corner, ...corner].join()}`)).toMatch(
    /^A pin could not be set again\. Node \d+ cannot be grabbed: it is pinned\.$/,
  );
  expect(await pins()).toEqual([]);
});
