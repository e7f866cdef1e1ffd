import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { frames, pages, until } from "./browser.js";
import { violations } from "../axe.ts";
import { Past } from "../../../apps/web/src/state/past.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const open = pages({ reducedMotion: "reduce" });
/** What stands beside each name in a list. */
const readings = (page: Page, list: string) =>
  page.locator(`#${list} > div`).evaluateAll((rows) =>
    rows.map((row) => [row.querySelector("dt")!.textContent!, row.querySelector("dd")!.textContent!] as const)
  );
const reading = async (page: Page, name: string) =>
  (await readings(page, "probe-readings")).find(([term]) => term === name)?.[1];

test("a probe says what the core says of a node, and a second one how far apart they are", async () => {
  const page = await open("?scene=breeze&nodes=24");
  const [first, second] = [{ x: 240, y: 220 }, { x: 300, y: 160 }];
  await page.mouse.move(first.x, first.y);
  await page.keyboard.press("m");
  await until("a node is measured", async () => (await reading(page, "A: node")) !== undefined);
  const a = Number(await reading(page, "A: node"));
  const marker = (await page.locator("#pins .probe").boundingBox())!;
  expect(Math.hypot(marker.x + marker.width / 2 - first.x, marker.y + marker.height / 2 - first.y)).toBeLessThan(14);

  await page.evaluate(() => window.weft.world!.step(12).then(() => undefined));
  const probe = (node: number) => page.evaluate((n) => window.weft.world!.probe(n), node);
  const now = await probe(a);
  expect(Math.hypot(...now.velocity)).toBeGreaterThan(0.01);
  const speed = Math.hypot(...now.velocity).toFixed(3);
  await until("the readings follow", async () => (await reading(page, "Speed")) === `${speed} m/s`);
  expect(await reading(page, "Place")).toBe(`${now.position.map((x) => x.toFixed(3)).join(", ")} m`);
  expect(await reading(page, "Stretch")).toBe(`${(100 * (now.stretch - 1)).toFixed(1)} %`);

  await page.getByRole("button", { name: "Measure by click" }).click();
  await page.mouse.click(second.x, second.y);
  await until("a second one is measured", async () => (await reading(page, "B: node")) !== undefined);
  const other = await probe(Number(await reading(page, "B: node")));
  const way = (p: readonly number[], q: readonly number[]) => Math.hypot(...p.map((x, i) => x - q[i]!)).toFixed(3);
  expect(await reading(page, "Apart")).toBe(`${way(now.position, other.position)} m`);
  expect(await reading(page, "At rest")).toBe(`${way(now.rest, other.rest)} m`);
  expect(await page.locator("#pins .ruler").isVisible()).toBe(true);

  // A click has one meaning at a time.
  await page.getByRole("button", { name: "Pin by click" }).click();
  expect(await page.locator("#probe-mode").getAttribute("aria-pressed")).toBe("false");
  await page.getByRole("button", { name: "Remove both" }).click();
  expect(await readings(page, "probe-readings")).toEqual([]);
  expect(await page.locator("#pins .probe").count()).toBe(0);
  await page.mouse.move(8, 300); // beside the cloth
  await page.keyboard.press("m");
  await until("it is said", async () => /no cloth to measure/.test((await page.locator("#notice").textContent())!));
});

test("the slider goes back to what was, and from there the cloth goes on as it did", async () => {
  const page = await open("?scene=hanging&nodes=12");
  const slider = page.getByLabel("Last ten seconds");
  expect(await slider.isDisabled()).toBe(true);
  await page.locator("#play").click();
  await until("some states are kept", async () => Number(await slider.getAttribute("max")) >= 4);
  await page.locator("#play").click();
  const state = () =>
    page.evaluate(async () => {
      const world = window.weft.world!;
      await world.step(0); // what was under way at the pause has ended
      return { frames: world.statistics.frames, hash: (await world.snapshot()).hash };
    });
  const end = await state();
  await until("the end is kept", async () => {
    const { seconds } = await page.evaluate(() => window.weft.world!.statistics);
    return (await page.locator("#past-time").textContent()) === `${seconds.toFixed(2)} s`;
  });
  await slider.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await until("an earlier one is shown", async () => (await frames(page)) < end.frames);
  await until("the second", async () => {
    const { seconds } = await page.evaluate(() => window.weft.world!.statistics);
    return (await page.locator("#past-time").textContent()) === `${seconds.toFixed(2)} s`;
  });
  const then = await state();
  expect(then.hash).not.toBe(end.hash);
  await page.evaluate((count) => window.weft.world!.step(count).then(() => undefined), end.frames - then.frames);
  expect(await state()).toEqual(end);
  await page.keyboard.press("End");
  await until("it is at the end again", async () => (await frames(page)) === end.frames);

  await page.getByRole("combobox", { name: "Scene" }).selectOption("breeze");
  await until("another scene has no past", () => slider.isDisabled());
});

test("on a phone the instruments fit, the legend stands in the picture, and axe finds nothing", async () => {
  const page = await open("?scene=hanging&nodes=12&view=stretch", { viewport: { width: 360, height: 740 },
    bypassCSP: true });
  expect(await page.locator("#timeline").isVisible()).toBe(false);
  const [legend, canvas] = await Promise.all([page.locator("#legend").boundingBox(),
    page.locator("#canvas").boundingBox()]);
  expect(legend!.x).toBeGreaterThanOrEqual(canvas!.x);
  expect(legend!.x + legend!.width).toBeLessThanOrEqual(canvas!.x + canvas!.width);
  expect(legend!.y + legend!.height).toBeLessThanOrEqual(canvas!.y + canvas!.height);
  await page.getByRole("button", { name: "More" }).click();
  for (const id of ["timeline", "probe-mode", "unprobe"]) {
    const box = (await page.locator(`#${id}`).boundingBox())!;
    expect(box.x).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width).toBeLessThanOrEqual(360);
  }
  expect(await violations(page)).toEqual([]);
});

test("ten seconds are kept, and no more bytes than may be; another future takes the place of the old one", () => {
  const past = new Past();
  const times = () => past.moments.map(({ seconds }) => seconds);
  for (let i = 0; i <= 30; i++) past.keep({ seconds: i / 2, bytes: new Uint8Array(1) });
  expect(times()).toEqual(Array.from({ length: 21 }, (_, i) => 5 + i / 2));
  past.keep({ seconds: 7.25, bytes: new Uint8Array(1) });
  expect(times()).toEqual([5, 5.5, 6, 6.5, 7, 7.25]);
  past.keep({ seconds: 8, bytes: new Uint8Array(95 << 20) });
  expect(times()).toEqual([5, 5.5, 6, 6.5, 7, 7.25, 8]);
  past.keep({ seconds: 9, bytes: new Uint8Array(2 << 20) });
  expect(times()).toEqual([9]);
  expect([Past.takes(8 << 20), Past.takes((8 << 20) + 1)]).toEqual([true, false]); // twelve of them fit
});
