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

test("pins are set by key and by click, and go together", async () => {
  await page.keyboard.press("u");
  await until("none is pinned", async () => (await pins()).length === 0);
  await page.keyboard.press("r");
  const places = [[200, 150], [300, 150], [240, 220], [280, 260]] as const;
  await page.mouse.move(...places[0]);
  await page.keyboard.press("p");
  await until("one is pinned", async () => (await pins()).length === 1);
  await page.getByRole("button", { name: "Pin by click" }).click();
  for (const [i, place] of places.slice(1).entries()) {
    await page.mouse.click(place[0], place[1]);
    await until("one more is pinned", async () => (await pins()).length === i + 2);
  }
  expect(await markers()).toBe(4);
  await page.getByRole("button", { name: "Remove all" }).click();
  await until("none is pinned", async () => (await pins()).length === 0 && (await markers()) === 0);
  await page.getByRole("button", { name: "Pin by click" }).click();
});

/** Nodes that the scene does not hold and that are seen, or hidden, within a rectangle [CSS pixels]. */
const nodesWithin = (a: Corner, b: Corner) =>
  page.evaluate(async ([from, to]) => {
    const world = window.weft.world!;
    const { positions, inverseMasses } = await world.snapshot();
    while (world.busy) await new Promise((wake) => setTimeout(wake, 5));
    const box = document.querySelector("canvas")!.getBoundingClientRect();
    const between = (x: number, p: number, q: number) => x >= Math.min(p, q) && x <= Math.max(p, q);
    return [...inverseMasses.keys()].filter((node) => {
      const [x, y] = world.project([positions[3 * node]!, positions[3 * node + 1]!, positions[3 * node + 2]!]);
      return inverseMasses[node] !== 0 && between(box.left + (box.width * (x + 1)) / 2, from.x, to.x) &&
        between(box.top + (box.height * (1 - y)) / 2, from.y, to.y);
    });
  }, [a, b] as const);
interface Corner {
  readonly x: number;
  readonly y: number;
}
const byClick = () => page.getByRole("button", { name: "Pin by click" }).click();
async function frame(a: Corner, b: Corner): Promise<void> {
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 3 });
  await page.mouse.up();
}
const notice = () => page.locator("#notice-text").textContent();

test("a rectangle pins all nodes under it and lets them go again; a restart and the link keep them", async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=40`);
  await ready(page);
  await step(10);
  const [a, b] = [{ x: 330, y: 310 }, { x: 190, y: 120 }];
  const inside = await nodesWithin(a, b);
  expect(inside.length).toBeGreaterThan(100);
  await byClick();
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 3 });
  const shown = page.locator("#pins .frame");
  await until("the rectangle is drawn", () => shown.isVisible());
  const box = (await shown.boundingBox())!;
  expect(way([box.x, box.y, box.width, box.height], [b.x, b.y, a.x - b.x, a.y - b.y])).toBeLessThan(3);
  await page.mouse.up();
  await until("they are pinned", async () => (await pins()).length > 0);
  expect(await shown.isVisible()).toBe(false);
  expect(await pins()).toEqual(inside);
  expect(await markers()).toBe(inside.length);
  expect(await page.locator("#pin-count").textContent()).toMatch(new RegExp(`^${inside.length} of 1,023 pinned`));
  const start = await page.evaluate(() => window.weft.world!.positions());
  await step(20);
  const now = await page.evaluate(() => window.weft.world!.positions());
  const moved = (node: number) => way([...start.slice(3 * node, 3 * node + 3)], [...now.slice(3 * node, 3 * node + 3)]);
  expect(Math.max(...inside.map(moved))).toBe(0);
  const free = [...Array(start.length / 3).keys()].filter((node) => !inside.includes(node));
  expect(Math.max(...free.map(moved))).toBeGreaterThan(0.02);

  // A restart and the link hold the same nodes where they were.
  await page.getByLabel("Substeps per frame").evaluate((field) => {
    (field.closest("details") as HTMLDetailsElement).open = true;
  });
  await page.getByLabel("Substeps per frame").fill("90");
  await page.getByLabel("Substeps per frame").press("Enter");
  await until("it has been restarted",
    async () =>
      (await page.locator("#facts").textContent())!.includes("Substeps per frame90") && (await pins()).length > 0);
  expect(new Set(await pins())).toEqual(new Set(inside));
  await until("the address has them", async () => (new URL(page.url()).searchParams.get("pins") ?? "").startsWith("~"));
  const kept = await page.evaluate(() => window.weft.state!.pins);
  await page.reload();
  await ready(page);
  expect(new Set(await pins())).toEqual(new Set(inside));
  const read = await page.evaluate(() => window.weft.state!.pins);
  for (const [i, pin] of kept.entries()) expect(way(pin.target, read[i]!.target)).toBeLessThan(2e-4); // m

  await byClick(); // once they have come to where they are held
  await step(60);
  await frame({ x: 360, y: 340 }, { x: 150, y: 80 }); // with more around them: those are pinned too
  await until("more are pinned", async () => (await pins()).length > inside.length);
  await frame({ x: 360, y: 340 }, { x: 150, y: 80 });
  await until("all are let go", async () => (await pins()).length === 0 && (await markers()) === 0);
  await byClick();
});

test("a pin is still dragged while pins are set by click, and Escape ends a rectangle", async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=24`);
  await ready(page);
  await byClick();
  await page.mouse.click(spot.x, spot.y);
  await until("it is pinned", async () => (await pins()).length === 1);
  const [node] = (await pins()) as [number];
  const marker = (await page.locator("#pins circle").boundingBox())!;
  const middle = { x: marker.x + marker.width / 2, y: marker.y + marker.height / 2 };
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await until("it is grabbed", async () => (await page.locator("#canvas").getAttribute("data-gesture")) === "grab");
  await page.mouse.move(middle.x + 40, middle.y - 20, { steps: 4 });
  await page.mouse.up();
  expect(await pins()).toEqual([node]);
  await page.locator("#canvas").focus();
  await page.mouse.move(150, 100);
  await page.mouse.down();
  await page.mouse.move(330, 310, { steps: 3 });
  await until("the rectangle is drawn", () => page.locator("#pins .frame").isVisible());
  await page.keyboard.press("Escape");
  expect(await page.locator("#pins .frame").isVisible()).toBe(false);
  await page.mouse.up();
  await page.waitForTimeout(300);
  expect(await pins()).toEqual([node]);
  await byClick();
});

test("a finger draws the rectangle too, and a second one makes it a pinch", async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=24`);
  await ready(page);
  const touch = await page.context().newCDPSession(page);
  const fingers = (type: "touchStart" | "touchMove" | "touchEnd", ...points: Corner[]) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
  await byClick();
  const [a, b] = [{ x: 200, y: 140 }, { x: 320, y: 300 }];
  await fingers("touchStart", a);
  await fingers("touchMove", b);
  await fingers("touchStart", b, { x: 350, y: 320 });
  await fingers("touchEnd");
  expect(await page.locator("#pins .frame").isVisible()).toBe(false);
  const inside = await nodesWithin(a, b);
  expect(await pins()).toEqual([]);
  await fingers("touchStart", a);
  await fingers("touchMove", b);
  await fingers("touchEnd");
  await until("they are pinned", async () => (await pins()).length > 0);
  expect((await pins()).length).toBeGreaterThan(inside.length / 2); // the pinch has moved the camera
  await byClick();
});

test("Shift and P pin the middle of the picture, and more than the core holds is refused with numbers", async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=64`);
  await ready(page);
  await page.locator("#canvas").focus();
  for (let i = 0; i < 12; i++) await page.keyboard.press("+"); // until fewer are in the middle than can be pinned
  const box = (await page.locator("#canvas").boundingBox())!;
  const corner = (part: number) => ({ x: box.x + part * box.width, y: box.y + part * box.height });
  const middle = await nodesWithin(corner(0.25), corner(0.75));
  expect(middle.length).toBeGreaterThan(50);
  await page.keyboard.press("Shift+P");
  await until("the middle is pinned", async () => (await pins()).length > 0);
  expect(await pins()).toEqual(middle);
  await page.keyboard.press("Shift+P");
  await until("the middle is let go", async () => (await pins()).length === 0);
  await page.keyboard.press("f");
  await byClick();
  const all = await nodesWithin({ x: 1, y: 1 }, { x: 470, y: 390 });
  expect(all.length).toBeGreaterThan(1023);
  await frame({ x: 1, y: 1 }, { x: 470, y: 390 });
  await until("it is refused", async () => ((await notice()) ?? "").includes("the core holds"));
  expect(await notice()).toBe(
    `0 nodes are pinned, and the rectangle has ${
      all.length.toLocaleString("en")
    } more; there can be 1,023: the core holds 1,024, and the hand needs one.`,
  );
  expect(await pins()).toEqual([]);
  await byClick();
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
  expect(await said(`pins=${Array.from({ length: 1024 }, () => "0,0,0,0,1,0").join(":")}`)).toMatch(
    /pins is “.*”, but must be at most 1023;/,
  );
  expect((await pins()).length).toBe(1); // all of them mean one node
  expect(await said("pins=~BAA!")).toMatch(/^In the page's address a pin is “~BAA!”, but must be six numbers/);
  const pinned = await page.evaluate(async () => (await window.weft.world!.snapshot()).inverseMasses.indexOf(0));
  const corner = await at(pinned);
  expect(await said(`pins=${[...corner, ...corner].join()}`)).toMatch(
    /^A pin could not be set again\. Node \d+ cannot be grabbed: it is pinned\.$/,
  );
  expect(await pins()).toEqual([]);
});
