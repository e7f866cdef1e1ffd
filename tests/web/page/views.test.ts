import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { expectClean, opened, picture, play, ready, running, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
afterEach(async () => {
  expectClean(seen, here.site);
  await seen.page.context().close();
});

async function open(query: string, options: Parameters<typeof visit>[2] = {}): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}${query}`, options);
  await ready(seen.page);
  return seen.page;
}
const view = (page: Page) => page.evaluate(() => window.weft.world!.view);
const WHY = "View contacts shows the pairs of contact method proximity, and this scene has none.";

test("a view that the scene has nothing to show in cannot be chosen, says why, and never stops the cloth", async () => {
  const page = await open("?scene=hanging&nodes=16");
  const contacts = page.getByRole("radio", { name: "Contacts" });
  expect(await contacts.isDisabled()).toBe(true);
  expect(await page.locator(`#${await contacts.getAttribute("aria-describedby")}`).textContent()).toBe(WHY);
  await play(page, 2);
  await page.keyboard.press("6");
  await until("it is said", async () => (await page.locator("#notice-text").textContent()) === WHY);
  await play(page, 3);
  expect(await running(page)).toBe(true);
  expect(await page.locator("#views input:checked").inputValue()).toBe("textured");

  await page.locator("#contact").selectOption("proximity");
  await until("it can be chosen", () => contacts.isEnabled());
  expect(await page.getByText(WHY).isVisible()).toBe(false);
  await page.keyboard.press("6");
  await until("contacts", async () => (await view(page)) === "contacts");
  await page.keyboard.press("x");
  await until("wireframe", async () => (await view(page)) === "wireframe");
  await page.locator("#contact").selectOption("none");
  await until("it cannot be chosen", () => contacts.isDisabled());
  await until("the page is ready", () => page.locator("#play").isEnabled());
  await page.keyboard.press("x"); // back from wireframe, but not to contacts
  await until("textured", async () => (await view(page)) === "textured");
  expect(await running(page)).toBe(true);
});

/** Of WCAG, of two colours in sRGB from 0 to 255. */
function contrast(a: readonly number[], b: readonly number[]): number {
  const luminance = (color: readonly number[]) => {
    const [red, green, blue] = color.map((value) => value / 255).map((
      part,
    ) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
  };
  const [lighter, darker] = [luminance(a), luminance(b)].sort((one, other) => other - one) as [number, number];
  return (lighter + 0.05) / (darker + 0.05);
}

test("the scene's title is readable in every view", async () => {
  const page = await open("?scene=pull-sphere&nodes=16", { reducedMotion: "reduce" });
  await page.locator("#notice-close").evaluate((button: HTMLElement) => button.click());
  const title = page.locator("#scene-title");
  const box = (await title.boundingBox())!;
  const { width } = (await page.locator("#canvas").boundingBox())!;
  for (const name of ["Textured", "Wireframe", "Normals", "Stretch", "Velocity", "Contacts"]) {
    await page.getByRole("radio", { name }).check();
    await until(name, async () => (await view(page)) === name.toLowerCase());
    await page.waitForTimeout(400); // for the picture to reach the screen
    const ink = (await title.evaluate((line) => getComputedStyle(line).color)).match(/\d+/g)!.map(Number);
    await title.evaluate((line) => {
      line.style.visibility = "hidden";
    });
    const pixels = await picture(page);
    await title.evaluate((line) => {
      line.style.visibility = "";
    });
    let least = Infinity;
    for (let y = Math.floor(box.y); y < box.y + box.height; y++)
      for (let x = Math.floor(box.x); x < box.x + 120; x++) {
        const at = 4 * (y * width + x);
        least = Math.min(least, contrast(ink, [...pixels.subarray(at, at + 3)]));
      }
    expect(least, name).toBeGreaterThan(4.5);
  }
});
