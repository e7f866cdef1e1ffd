import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { difference, drawn, expectClean, frames, opened, picture, play, ready, running, until, visit,
  type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
let page: Page;
beforeAll(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=24`);
  page = seen.page;
  await ready(page);
});
afterAll(() => expectClean(seen, here.site));

const view = () => page.evaluate(() => window.weft.world!.view);
const checked = () => page.locator("#views :checked").getAttribute("value");

test("keys play, pause, step and reset", async () => {
  await play(page, 3);
  await page.keyboard.press("Space");
  await until("it pauses", async () => !(await running(page)));
  await page.evaluate(() => window.weft.world!.snapshot()); // waits for the frames under way
  await page.waitForTimeout(200);
  const before = await frames(page);
  await page.keyboard.press(".");
  await until("one frame passes", async () => (await frames(page)) === before + 1);
  await page.keyboard.press("r");
  await until("time is 0", async () => (await frames(page)) === 0);
  expect(await running(page)).toBe(false);
  await page.keyboard.press("Space");
  await play(page, 8);
  await page.keyboard.press("Space");
});

test("a tab that is hidden stops, and goes on when it is seen", async () => {
  const hide = (hidden: boolean) =>
    page.evaluate((value) => {
      Object.defineProperty(document, "hidden", { value, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
    }, hidden);
  await page.keyboard.press("Space");
  await hide(true);
  expect(await running(page)).toBe(false);
  await hide(false);
  expect(await running(page)).toBe(true);
  await page.keyboard.press("Space");
});

test("each view shows another picture, by digit, by letter and by mouse", async () => {
  const pictures: Uint8Array[] = [];
  for (const [key, name] of [["1", "textured"], ["2", "wireframe"], ["3", "normals"], ["4", "stretch"]] as const) {
    await page.keyboard.press(key);
    await until(`view ${name}`, async () => (await view()) === name && (await checked()) === name);
    await drawn(page);
    pictures.push(await picture(page));
  }
  for (const [i, one] of pictures.entries())
    for (const other of pictures.slice(i + 1)) expect(difference(one, other)).toBeGreaterThan(0.005);

  await page.keyboard.press("x");
  await until("wireframe", async () => (await view()) === "wireframe");
  await page.keyboard.press("x");
  await until("stretch again", async () => (await view()) === "stretch");
  await page.getByRole("radio", { name: "Textured" }).check();
  await until("textured", async () => (await view()) === "textured");
});

test("keys leave a control that has the focus alone, and can be turned off", async () => {
  await page.locator("#step").focus();
  const before = await frames(page);
  await page.keyboard.press("Space"); // presses the button, and does not play
  await until("one frame passes", async () => (await frames(page)) === before + 1);
  expect(await running(page)).toBe(false);
  await page.keyboard.press("?");
  await page.getByLabel("Use these keys").uncheck();
  await page.keyboard.press("Escape");
  await page.keyboard.press("2");
  await page.waitForTimeout(200);
  expect(await view()).toBe("textured");
  await page.getByRole("button", { name: "Help" }).click();
  await page.getByLabel("Use these keys").check();
  await page.keyboard.press("Escape");
});

test("another resolution and another scene are loaded, and the page's address names them", async () => {
  await page.getByLabel("Resolution").selectOption("32");
  await until("1,024 nodes", async () => (await page.locator("#facts").textContent())!.includes("1,024"));
  await until("the address", async () => new URL(page.url()).search === "?v=1&scene=hanging&nodes=32");
});

test("the panel says which method moves the cloth, and why “auto” took it", async () => {
  const facts = async () => (await page.locator("#facts").textContent())!;
  expect(await facts()).toContain("Methodmass_spring"); // the scene names it
  expect(await facts()).not.toContain("Chosen since");
  await page.getByLabel("Method", { exact: true }).selectOption("auto");
  await until("it says so", async () => (await facts()).includes("Chosen sincea frame is predicted to take "));
});

test("another scene is loaded at its own resolution, and an address opens the one it names", async () => {
  await page.goto(`${here.site.address}?scene=pull-sphere&nodes=24`);
  await ready(page);
  expect(await page.locator("#scene").inputValue()).toBe("pull-sphere");
  expect(await page.evaluate(() => window.weft.world!.info.nodes)).toBe(576);
  await page.keyboard.press("Space");
  await page.locator("#scene").selectOption("hanging");
  await until("4,096 nodes", async () => (await page.locator("#facts").textContent())!.includes("4,096"));
  await until("the address", async () => new URL(page.url()).search === "?v=1&scene=hanging");
});
