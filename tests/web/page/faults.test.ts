import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { brightness, difference, expectClean, frames, meanVelocity, picture, play, ready, running, serve, until, visit,
  type Site } from "./browser.js";
import { launch, SOFTWARE_FLAGS } from "../chromium.ts";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

let site: Site;
beforeAll(async () => {
  site = await serve();
});
afterAll(() => site.close());

async function withBrowser(gpu: boolean, use: (browser: Browser) => Promise<void>): Promise<void> {
  const browser = await launch(gpu ? SOFTWARE_FLAGS : []);
  try {
    await use(browser);
  } finally {
    await browser.close();
  }
}

test("a device that is lost is reported, and the cloth runs on", () =>
  withBrowser(true, async (browser) => {
    const seen = await visit(browser, `${site.address}?scene=hanging&nodes=24`);
    const { page } = seen;
    await ready(page);
    await page.keyboard.press("2");
    await page.locator("#contact").selectOption("bvh");
    await until("it is loaded", () => page.evaluate(() => window.weft.state!.set["contact.method"] === "bvh"));
    await page.getByLabel("Gravity", { exact: true }).fill("3");
    await until("gravity is 3", () => page.evaluate(() => String(window.weft.state!.set["gravity"]) === "0,-3,0"));
    await play(page, 3);
    await page.evaluate(() => window.weft.world!.device!.destroy());
    await until("it is said", async () => /lost.*opened again/.test((await page.locator("#notice").textContent())!));
    await until("it runs again", async () => (await running(page)) && (await frames(page)) > 3);
    expect(await page.evaluate(() => window.weft.world!.view)).toBe("wireframe");
    expect(await page.evaluate(() => window.weft.state!.set)).toEqual({ "contact.method": "bvh", gravity: [0, -3, 0] });
    const falling = (await meanVelocity(page))[1]; // m/s after a sixtieth of a second
    expect(falling).toBeLessThan(-0.7 * 3 / 60);
    expect(falling).toBeGreaterThan(-3 / 60);
    expectClean(seen, site);

    await page.keyboard.press("Space"); // a paused one is told too
    await page.locator("#notice-text").evaluate((line) => {
      line.textContent = "";
    });
    await page.evaluate(() => window.weft.world!.device!.destroy());
    await until("it is said again",
      async () => /opened again/.test((await page.locator("#notice-text").textContent())!));
    expect(await running(page)).toBe(false);
    expectClean(seen, site);
  }));

test("a scene that cannot be fetched is reported, and the one before stays", () =>
  withBrowser(true, async (browser) => {
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

test("a scene that the core refuses is reported, and the one before is opened again as it was", () =>
  withBrowser(true, async (browser) => {
    const seen = await visit(browser, `${site.address}?scene=hanging&nodes=24`);
    const { page } = seen;
    await ready(page);
    await page.getByLabel("Gravity", { exact: true }).fill("3");
    await until("gravity is 3", () => page.evaluate(() => String(window.weft.state!.set["gravity"]) === "0,-3,0"));
    await page.route("**/pull-sphere*.json", (route) => route.fulfill({ json: { format: "weft-scene/1", gravty: 1 } }));
    await page.locator("#scene").selectOption("pull-sphere");
    await until("it is said", async () => (await page.locator("#notice").textContent())!.includes("gravty"));
    await until("the scene before is back", async () => (await page.locator("#scene").inputValue()) === "hanging");
    expect(await page.evaluate(() => [window.weft.world!.info.nodes, window.weft.state!.set])).toEqual([576, {
      gravity: [0, -3, 0],
    }]);
    await play(page, 2);
    expectClean(seen, site);
  }));

test("where the first scene fails, another can be chosen", () =>
  withBrowser(true, async (browser) => {
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

test("after a trap of the module what is chosen next opens in a new one", () =>
  withBrowser(true, async (browser) => {
    const seen = await visit(browser, `${site.address}?scene=hanging&nodes=16`);
    const { page } = seen;
    await ready(page);
    await play(page, 2);
    await page.evaluate(() => {
      const { core } = window.weft.world as unknown as { core: { module: Record<string, () => number> } };
      core.module["_weft_advance_and_draw"] = () => {
        throw new WebAssembly.RuntimeError("unreachable");
      };
    });
    await until("it is said", async () => /module has stopped/.test((await page.locator("#notice").textContent())!));
    await until("it stops", async () => !(await running(page)));
    await page.locator("#resolution").selectOption("32");
    await until("it is open", () => page.evaluate(() => window.weft.world?.info.nodes === 1024));
    await page.getByRole("button", { name: "Play" }).click();
    await play(page, 2);
    expectClean(seen, site);
  }));

const TALL = { width: 800, height: 900 }; // so that the whole card is in view

/** The reference on the CPU is there, labelled, drawn and in motion. */
async function expectReference(page: Page): Promise<void> {
  const still = () => picture(page, "#reference-canvas");
  const label = page.locator("#reference-label");
  await until("the label",
    async () => /CPU reference, 24.×.18 nodes, double precision/.test((await label.textContent())!));
  expect(await page.locator("#reference-note").textContent()).toContain("Without WebGPU");
  const before = await still();
  await until("the cloth moves", async () => difference(before, await still()) > 0.01);
  const { mean, deviation } = brightness(await still());
  expect(mean).toBeGreaterThan(30); // of 255: neither black
  expect(deviation).toBeGreaterThan(8); // nor a single colour
}

test("without a graphics adapter one sentence says so, and what to do", () =>
  withBrowser(false, async (browser) => {
    const seen = await visit(browser, site.address, { viewport: TALL });
    const cause = seen.page.locator("#fallback-cause");
    await until("the sentence", () => cause.isVisible());
    expect(await cause.textContent()).toContain("no graphics adapter");
    expect(await seen.page.locator("#fallback-advice").textContent()).toContain("graphics acceleration");
    expect(await seen.page.locator("#canvas").isVisible()).toBe(false);
    await expectReference(seen.page);
    expectClean(seen, site);
  }));

test("without WebGPU one sentence says so, and what to do", () =>
  withBrowser(false, async (browser) => {
    const context = await browser.newContext({ viewport: TALL });
    const page = await context.newPage();
    // Chromium of today has no flag that takes navigator.gpu away altogether.
    await page.addInitScript(() => {
      Reflect.deleteProperty(Navigator.prototype, "gpu");
    });
    await page.goto(site.address);
    const cause = page.locator("#fallback-cause");
    await until("the sentence", () => cause.isVisible());
    expect(await cause.textContent()).toContain("no WebGPU");
    expect(await page.locator("#fallback-advice").textContent()).toContain("Chrome");
    await expectReference(page);
  }));

test("the reference stops when it is told to, in a hidden tab and where less motion is asked for", () =>
  withBrowser(false, async (browser) => {
    const seen = await visit(browser, site.address, { viewport: TALL, reducedMotion: "reduce" });
    const { page } = seen;
    const change = async () => {
      const before = await picture(page, "#reference-canvas");
      await page.waitForTimeout(400);
      return difference(before, await picture(page, "#reference-canvas"));
    };
    const hide = (hidden: boolean) =>
      page.evaluate((hidden) => {
        Object.defineProperty(document, "hidden", { value: hidden, configurable: true });
        document.dispatchEvent(new Event("visibilitychange"));
      }, hidden);
    await until("it waits", async () => /press Play/.test((await page.locator("#reference-note").textContent())!));
    expect(await change()).toBe(0);
    await page.getByRole("button", { name: "Play" }).click();
    await until("it moves", async () => (await change()) > 0.01);
    await hide(true);
    expect(await change()).toBe(0);
    await hide(false);
    await until("it moves again", async () => (await change()) > 0.001);
    await page.getByRole("button", { name: "Pause" }).click();
    expect(await change()).toBe(0);

    const before = await picture(page, "#reference-canvas"); // a drag turns it, playing or not
    const box = (await page.locator("#reference-canvas").boundingBox())!;
    await page.mouse.move(box.x + 100, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + 180, box.y + 100, { steps: 4 });
    await page.mouse.up();
    await until("it has turned", async () => difference(before, await picture(page, "#reference-canvas")) > 0.05);
    expectClean(seen, site);
  }));

for (const colorScheme of ["dark", "light"] as const)
  test(`without WebGPU nothing is wider than a ${colorScheme} phone`, () =>
    withBrowser(false, async (browser) => {
      const seen = await visit(browser, site.address, { viewport: { width: 390, height: 844 }, colorScheme });
      const { page } = seen;
      await until("the label", async () => (await page.locator("#reference-label").textContent()) !== "");
      expect(await page.evaluate(() =>
        [...document.querySelectorAll("html, #fallback, #reference")].filter((element) =>
          element.scrollWidth > element.clientWidth
        ).length
      )).toBe(0);
      const ground = () =>
        page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const before = await ground();
      await page.locator("#theme").click();
      expect(await ground()).not.toBe(before);
      const box = (await page.locator("#reference-play").boundingBox())!;
      expect(box.x >= 0 && box.x + box.width <= 390 && box.height >= 44).toBe(true);
      expectClean(seen, site);
    }));
