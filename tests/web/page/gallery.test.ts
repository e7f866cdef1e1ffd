import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { frames, pages, play, running, until } from "./browser.js";
import { violations } from "../axe.ts";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const ROOT = join(import.meta.dirname, "../../..");
const PICTURES = join(ROOT, "apps/web/src/gallery");
const MOST_BYTES = 250e3; // of all pictures: a fifth more of what the page's program has
const LIST = JSON.parse(readFileSync(join(ROOT, "apps/shared/scenes.json"), "utf8")) as {
  groups: { scenes: { name: string; title: string }[] }[];
};
const SCENES = LIST.groups.flatMap(({ scenes }) => scenes);

const open = pages();
const state = (page: Page) => page.evaluate(() => window.weft.state!);
const gallery = (page: Page) => page.locator("#gallery");

test("every shipped scene has a picture and a title of its own, and all pictures together are small", () => {
  const shipped = readdirSync(join(ROOT, "scenes")).map((file) => file.replace(".json", ""));
  const pictures = readdirSync(PICTURES).map((file) => file.replace(".webp", ""));
  expect(pictures.sort()).toEqual(shipped.sort());
  expect(SCENES.map(({ name }) => name).sort()).toEqual(shipped);
  expect(new Set(SCENES.map(({ title }) => title)).size).toBe(shipped.length);
  const bytes = pictures.map((name) => statSync(join(PICTURES, `${name}.webp`)).size);
  expect(bytes.reduce((sum, one) => sum + one, 0)).toBeLessThan(MOST_BYTES);
});

test("a bare address opens the gallery, and a click on a picture runs its scene", async () => {
  const page = await open("");
  expect(await gallery(page).isVisible()).toBe(true);
  expect(await page.locator("#gallery .card").allTextContents()).toEqual(SCENES.map(({ title }) => title));
  await until("the first pictures are there",
    () =>
      page.locator("#gallery img").first().evaluate((image: HTMLImageElement) =>
        image.complete && image.naturalWidth === 384
      ));
  expect(await running(page)).toBe(false); // nobody would see it
  expect(new URL(page.url()).search).toBe(""); // nothing has been chosen
  await page.getByRole("button", { name: "Hanging", exact: true }).click();
  expect(await gallery(page).isVisible()).toBe(false);
  await until("it hangs", async () => (await state(page)).scene === "hanging");
  await play(page, 2);
  await until("the address says so", async () => new URL(page.url()).search === "?v=1&scene=hanging");
});

test("an address that names a scene opens it, and the gallery is a key or a button away", async () => {
  const page = await open("?scene=hanging&nodes=12");
  expect(await gallery(page).isVisible()).toBe(false);
  await play(page, 1);
  await page.keyboard.press("g");
  expect(await gallery(page).isVisible()).toBe(true);
  await until("it stops", async () => !(await running(page)));
  const focused = () => page.evaluate(() => document.activeElement!.textContent);
  expect(await focused()).toBe("Hanging"); // the one that is shown
  await page.keyboard.press("Escape");
  expect(await gallery(page).isVisible()).toBe(false);
  expect(await page.evaluate(() => document.activeElement!.id)).toBe("canvas");
  expect(await running(page)).toBe(true);
  const before = await frames(page);
  await play(page, 1);
  expect(await frames(page)).toBeGreaterThan(before); // it went on, not anew
  await page.getByRole("button", { name: "Gallery", exact: true }).click();
  await page.keyboard.press("Shift+Tab");
  expect(await focused()).toBe(SCENES[SCENES.findIndex(({ name }) => name === "hanging") - 1]!.title);
  await page.keyboard.press("Enter");
  await until("another scene is shown", async () => (await state(page)).scene !== "hanging");
  expect(await gallery(page).isVisible()).toBe(false);
});

test("a scene that is chosen in the panel closes the gallery", async () => {
  const page = await open("", { reducedMotion: "reduce" });
  await page.locator("#scene").selectOption("drag");
  await until("it is open", async () => (await state(page)).scene === "drag");
  expect(await gallery(page).isVisible()).toBe(false);
});

for (const [device, viewport] of [["desktop", { width: 1280, height: 800 }], ["phone", { width: 390,
  height: 844 }]] as const)
  for (const colorScheme of ["dark", "light"] as const)
    test(`on a ${colorScheme} ${device} the gallery has room for fingers, scrolls, and axe finds nothing`, async () => {
      const page = await open("", { viewport, colorScheme, bypassCSP: true, reducedMotion: "reduce" });
      expect(await violations(page)).toEqual([]);
      const boxes = await page.locator("#gallery button").evaluateAll((all) =>
        all.map((one) => one.getBoundingClientRect()).map(({ left, right, width, height }) => ({ left, right, width,
          height })
        )
      );
      const stage = (await page.locator("main").boundingBox())!;
      for (const { left, right, width, height } of boxes) {
        expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
        expect(left).toBeGreaterThanOrEqual(stage.x);
        expect(right).toBeLessThanOrEqual(stage.x + stage.width);
      }
      const last = page.locator("#gallery .card").last();
      await last.focus();
      await until("the last is on the screen", async () => {
        const box = (await last.boundingBox())!;
        return box.y >= 0 && box.y + box.height <= viewport.height;
      });
    });
