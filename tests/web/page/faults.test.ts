import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { expectClean, frames, launch, play, ready, running, serve, until, visit, type Site } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

let site: Site;
beforeAll(async () => { site = await serve(); });
afterAll(() => site.close());

async function withBrowser(gpu: boolean, use: (browser: Browser) => Promise<void>): Promise<void> {
  const browser = await launch(gpu);
  try {
    await use(browser);
  } finally {
    await browser.close();
  }
}

test("a device that is lost is reported, and the cloth runs on", () => withBrowser(true, async (browser) => {
  const seen = await visit(browser, `${site.address}?scene=hanging&nodes=24`);
  const { page } = seen;
  await ready(page);
  await page.keyboard.press("2");
  await play(page, 3);
  await page.evaluate(() => window.weft.world!.device!.destroy());
  await until("it is said", async () => /lost.*opened again/.test((await page.locator("#notice").textContent())!));
  await until("it runs again", async () => (await running(page)) && (await frames(page)) > 3);
  expect(await page.evaluate(() => window.weft.world!.view)).toBe("wireframe");
  expectClean(seen, site);

  await page.keyboard.press("Space"); // a paused one is told too
  await page.getByRole("button", { name: "Close the message" }).click();
  await page.evaluate(() => window.weft.world!.device!.destroy());
  await until("it is said again", async () => await page.locator("#notice").isVisible());
  expect(await running(page)).toBe(false);
  expectClean(seen, site);
}));

test("a scene that cannot be fetched is reported, and the one before stays", () => withBrowser(true, async (browser) => {
  const seen = await visit(browser, `${site.address}?scene=hanging&nodes=24`);
  const { page } = seen;
  await ready(page);
  await page.route("**/dragon*.ply", (route) => route.fulfill({ status: 404, body: "" }));
  await page.locator("#scene").selectOption("pull-dragon");
  await until("it is said", async () => /dragon.*404/.test((await page.locator("#notice").textContent())!));
  await until("the scene before is back", async () => (await page.locator("#scene").inputValue()) === "hanging");
  await play(page, 2);
  expect(seen.errors.filter((error) => !error.includes("404"))).toEqual([]);
}));

test("a scene that the core refuses is reported, and the one before is opened again", () =>
  withBrowser(true, async (browser) => {
    const seen = await visit(browser, `${site.address}?scene=hanging&nodes=24`);
    const { page } = seen;
    await ready(page);
    await page.route("**/pull-sphere*.json", (route) => route.fulfill({ json: { format: "weft-scene/1", gravty: 1 } }));
    await page.locator("#scene").selectOption("pull-sphere");
    await until("it is said", async () => (await page.locator("#notice").textContent())!.includes("gravty"));
    await until("the scene before is back", async () => (await page.locator("#scene").inputValue()) === "hanging");
    expect(await page.evaluate(() => window.weft.world!.info.nodes)).toBe(576);
    await play(page, 2);
    expectClean(seen, site);
  }));

test("where the first scene fails, another can be chosen", () => withBrowser(true, async (browser) => {
  const hanging = readFileSync(join(import.meta.dirname, "../../../scenes/hanging.json"), "utf8");
  const context = await browser.newContext({ viewport: { width: 800, height: 400 } });
  const page = await context.newPage();
  await page.route("**/pull-sphere*.json", (route) => route.fulfill({ json: {} }));
  await page.route("**/hanging*.json", (route) => route.fulfill({ body: hanging.replace("[64, 64]", "[24, 24]") }));
  await page.goto(`${site.address}?scene=pull-sphere`);
  await until("it is said", () => page.locator("#notice").isVisible());
  await page.locator("#scene").selectOption("hanging");
  await until("it runs", () => page.evaluate(() => (window.weft.world?.statistics.frames ?? 0) > 1));
  expect(await page.locator("#notice").isVisible()).toBe(false);
}));

test("without a graphics adapter one sentence says so, and what to do", () => withBrowser(false, async (browser) => {
  const seen = await visit(browser, site.address);
  const cause = seen.page.locator("#fallback-cause");
  await until("the sentence", () => cause.isVisible());
  expect(await cause.textContent()).toContain("no graphics adapter");
  expect(await seen.page.locator("#fallback-advice").textContent()).toContain("graphics acceleration");
  expect(await seen.page.locator("canvas").isVisible()).toBe(false);
  expectClean(seen, site);
}));

test("without WebGPU one sentence says so, and what to do", () => withBrowser(false, async (browser) => {
  const context = await browser.newContext();
  const page = await context.newPage();
  // Chromium of today has no flag that takes navigator.gpu away altogether.
  await page.addInitScript(() => { Reflect.deleteProperty(Navigator.prototype, "gpu"); });
  await page.goto(site.address);
  const cause = page.locator("#fallback-cause");
  await until("the sentence", () => cause.isVisible());
  expect(await cause.textContent()).toContain("no WebGPU");
  expect(await page.locator("#fallback-advice").textContent()).toContain("Chrome");
}));
