import { readdirSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { brightness, expectClean, LONG, opened, picture, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const SWITCHES = LONG ? 200 : 50;
const FRAMES = 3;

const here = opened();
let seen: Visit;
let page: Page;
beforeAll(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=16`, {
    viewport: { width: 780, height: 280 },
    reducedMotion: "reduce",
  });
  page = seen.page;
  await ready(page);
});
afterAll(() => expectClean(seen, here.site));

const SCENES = readdirSync(join(import.meta.dirname, "../../../scenes")).map((file) => file.replace(".json", ""));

test("the list has all scenes, in groups", async () => {
  const names = await page.locator("#scene option").evaluateAll((all) =>
    all.map((one) => (one as HTMLOptionElement).value)
  );
  expect([...names].sort()).toEqual([...SCENES].sort());
  expect(await page.locator("#scene optgroup").count()).toBe(4);
});

/** A page compiles what a scene needs for up to 40 s, so in CI's part N every third has a turn. */
const PART = process.env["WEFT_PART"];
const IN_TURN = SCENES.filter((_, i) => PART === undefined || (i + Number(PART)) % 3 === 0);

test.for(IN_TURN)("%s loads, is drawn and moves", async (name) => {
  await page.goto(`${here.site.address}?scene=${name}&nodes=${name === "stack" ? 6 : 16}`);
  await ready(page);
  const moved = await page.evaluate(async (frames) => {
    const world = window.weft.world!;
    const before = await world.positions();
    await world.step(frames);
    const after = await world.positions();
    return Math.max(...after.map((value, i) => Math.abs(value - before[i]!)));
  }, FRAMES);
  expect(moved).toBeGreaterThan(name === "incline" ? 0 : 1e-3); // m; friction holds that one
  expect(moved).toBeLessThan(name === "hanging-paper" ? 10 : 1); // and none flies away
  await until("it is on the screen", async () => {
    const { mean, deviation } = brightness(await picture(page));
    return mean > 40 && deviation > 6; // of 255: neither black nor one colour
  });
  expect((await page.locator("#description").textContent())!.length).toBeGreaterThan(20);
});

/** What stands over the canvas is little; the rest of it is neither black nor one colour. */
test.for(LONG ? SCENES : [])("long: %s is drawn in every window and theme", async (name) => {
  for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]] as const)
    for (const colorScheme of ["light", "dark"] as const) {
      const other = await visit(here.browser, `${here.site.address}?scene=${name}&nodes=${name === "stack" ? 6 : 16}`, {
        viewport: { width, height },
        colorScheme,
        reducedMotion: "reduce",
      });
      await ready(other.page);
      await other.page.evaluate(async (frames) => void (await window.weft.world!.step(frames)), FRAMES);
      await until(`${name} is on the screen of ${width} × ${height}, ${colorScheme}`, async () => {
        const { mean, deviation } = brightness(await picture(other.page));
        return mean > 40 && deviation > 6;
      });
      expectClean(other, here.site);
      await other.page.context().close();
    }
});

test(`${SWITCHES} switches keep the pin, and leave no elements or listeners behind on the page`, async () => {
  await page.goto(`${here.site.address}?scene=breeze&nodes=8`);
  await ready(page);
  const metrics = await page.context().newCDPSession(page);
  await metrics.send("Performance.enable");
  const counts = async () => {
    await metrics.send("HeapProfiler.collectGarbage");
    const { metrics: all } = await metrics.send("Performance.getMetrics");
    const value = (name: string) => all.find((one) => one.name === name)!.value;
    return { elements: await page.evaluate(() => document.querySelectorAll("*").length), nodes: value("Nodes"),
      listeners: value("JSEventListeners") };
  };
  const change = async (method: string) => {
    await page.locator("#contact").selectOption(method);
    await until(`contact is ${method}`,
      () => page.evaluate((wanted) => window.weft.state!.set["contact.method"] === wanted, method));
    await until("the pin is kept", () => page.evaluate(() => window.weft.pins.length === 1));
  };
  await page.locator("#canvas").focus();
  await page.keyboard.press("p");
  await until("a node is pinned", () => page.evaluate(() => window.weft.pins.length === 1));
  for (let i = 0; i < 4; i++) await change(i % 2 ? "none" : "bvh");
  const before = await counts();
  for (let i = 0; i < SWITCHES; i++) await change(i % 2 ? "none" : "bvh");
  const after = await counts();
  expect(await page.evaluate(() => window.weft.pins.length)).toBe(1);
  expect(after.elements).toBe(before.elements);
  expect(after.listeners).toBeLessThanOrEqual(before.listeners);
  expect(after.nodes).toBeLessThan(before.nodes + SWITCHES); // one a switch would be a leak
});
