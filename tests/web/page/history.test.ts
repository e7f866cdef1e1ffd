import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { expectClean, opened, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
afterEach(() => seen.page.context().close());

async function open(query: string): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}${query}`, { reducedMotion: "reduce" });
  await ready(seen.page);
  return seen.page;
}
const state = (page: Page) => page.evaluate(() => window.weft.state!);
const opens = (page: Page, scene: string) =>
  until(`${scene} is open`, async () =>
    (await state(page)).scene === scene && (await page.locator("#scene").inputValue()) === scene &&
    new URL(page.url()).searchParams.get("scene") === scene);
const go = (page: Page, by: number) => page.evaluate((entries) => history.go(entries), by);
const length = (page: Page) => page.evaluate(() => history.length);

test("Back returns to the scene before as it was left, and Forward goes on", async () => {
  const page = await open("?scene=hanging&nodes=16");
  const first = await length(page);
  await page.keyboard.press("4");
  await page.getByLabel("Gravity", { exact: true }).fill("3");
  await until("gravity is 3", async () => String((await state(page)).set["gravity"]) === "0,-3,0");
  await page.locator("#scene").selectOption("breeze"); // before the address has settled
  await opens(page, "breeze");
  await page.locator("#resolution").selectOption("32");
  await until("32 nodes", async () => (await state(page)).nodes === 32);
  await page.locator("#scene").selectOption("drag");
  await opens(page, "drag");
  expect(await length(page)).toBe(first + 2); // a change within a scene is no entry

  await go(page, -1);
  await opens(page, "breeze");
  expect((await state(page)).nodes).toBe(32);
  await go(page, -1);
  await opens(page, "hanging");
  expect(await state(page)).toMatchObject({ nodes: 16, view: "stretch", set: { gravity: [0, -3, 0] } });
  expect(await page.evaluate(() => window.weft.world!.info.nodes)).toBe(256);
  await go(page, 2);
  await opens(page, "drag");
  expect(await length(page)).toBe(first + 2);
  expectClean(seen, here.site);
});

test("a scene that Back cannot open any more is said, and the one that is shown takes its entry", async () => {
  const page = await open("?scene=hanging&nodes=16");
  await page.locator("#scene").selectOption("breeze");
  await opens(page, "breeze");
  const entries = await length(page);
  await page.route("**/hanging*.json", (route) => route.fulfill({ status: 404, body: "" }));
  await go(page, -1);
  await until("it is said", async () => /hanging.*404/.test((await page.locator("#notice").textContent())!));
  await opens(page, "breeze");
  expect(await length(page)).toBe(entries);
});

test("a link within the page reloads nothing", async () => {
  const page = await open("?scene=hanging&nodes=16");
  await until("the address", async () => new URL(page.url()).search === "?v=1&scene=hanging&nodes=16");
  await page.evaluate(() => window.weft.world!.step(3));
  await page.locator(".skip").evaluate((link: HTMLElement) => link.click());
  await until("it is gone to", async () => page.url().endsWith("#controls"));
  await go(page, -1);
  await until("it is gone back", async () => !page.url().endsWith("#controls"));
  expect(await page.evaluate(() => window.weft.world!.statistics.frames)).toBe(3);
  expectClean(seen, here.site);
});

test("Back returns to a scene of the visitor's own", async () => {
  const page = await open("?scene=hanging&nodes=16");
  const scene = { format: "weft-scene/1", title: "Mine", contact: { method: "none" },
    cloths: [{ grid: [9, 9], size: [1, 1], density: 0.2, pins: ["top"] }] };
  await page.locator("#file-chooser").setInputFiles(
    { name: "mine.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(scene)) },
  );
  await until("it is open", async () => (await state(page)).scene === "own");
  await page.locator("#scene").selectOption("breeze");
  await opens(page, "breeze");
  await go(page, -1);
  await until("it is back", async () =>
    (await state(page)).scene === "own" &&
    (await page.locator("#scene-title").textContent()) === "Mine");
  await go(page, -1);
  await opens(page, "hanging");
  expectClean(seen, here.site);
});
