import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { violations } from "../axe.ts";
import { expectClean, frames, opened, ready, until, visit, type Visit } from "./browser.js";

const here = opened();
let seen: Visit;
afterEach(async () => {
  expectClean(seen, here.site);
  await seen.page.context().close();
});

async function open(options: Parameters<typeof visit>[2]): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=16&view=stretch&drag=2`, {
    reducedMotion: "reduce",
    ...options,
  });
  await ready(seen.page);
  return seen.page;
}

for (const colorScheme of ["dark", "light"] as const)
  test(`axe finds nothing on the ${colorScheme} page, nor with the help open`, async () => {
    const page = await open({ viewport: { width: 1024, height: 768 }, colorScheme, bypassCSP: true });
    for (const summary of await page.locator("summary").all()) await summary.click();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press("?");
    expect(await page.locator("#help").evaluate((dialog: HTMLDialogElement) => dialog.open)).toBe(true);
    expect(await violations(page)).toEqual([]);
  });

test("the help takes the focus, keeps it, and gives it back", async () => {
  const page = await open({});
  const focused = () => page.evaluate(() => document.activeElement!.id);
  await page.locator("#step").click();
  await until("a frame has passed", async () => (await frames(page)) === 1);
  await page.keyboard.press("?");
  expect(await page.locator("#help").isVisible()).toBe(true);
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press("Tab");
    expect(["help", "help-close", "shortcuts", ""]).toContain(await focused()); // "": the browser's own, after the last
  }
  await page.keyboard.press("r"); // behind the dialog no key does anything
  await page.waitForTimeout(200);
  expect(await frames(page)).toBe(1);
  await page.keyboard.press("Escape");
  expect(await page.locator("#help").isVisible()).toBe(false);
  expect(await focused()).toBe("step");
  await page.getByRole("button", { name: "Help" }).click();
  const keys = await page.locator("#help kbd").allTextContents();
  expect(keys).toEqual(expect.arrayContaining(["Space", ".", "R", "P", "U", "1 to 6", "X", "F", "T", "?"]));
  await page.getByRole("button", { name: "Close the help" }).click();
  expect(await focused()).toBe("help-open");
});

test("every control is reached by the Tab key", async () => {
  const page = await open({});
  for (const summary of await page.locator("summary").all()) await summary.click();
  // What is unfolded measures, and then has something to copy.
  await until("curves can be copied", () => page.locator("#copy-series").isEnabled());
  const wanted = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, select, input, summary, a[href], canvas[tabindex]")]
      .filter((one) =>
        one.checkVisibility() && !(one as HTMLButtonElement).disabled && !one.closest("dialog") &&
        !((one as HTMLInputElement).type === "radio" && !(one as HTMLInputElement).checked)
      ).length
  );
  const reached = new Set<string>();
  await page.locator(".skip").focus();
  for (let i = 0; i < wanted + 4; i++) {
    reached.add(await page.evaluate(() => {
      const all = [...document.querySelectorAll("*")];
      return document.activeElement === document.body ? "" : String(all.indexOf(document.activeElement!));
    }));
    await page.keyboard.press("Tab");
  }
  reached.delete("");
  expect(reached.size).toBe(wanted);
});

test("the theme is the system's, until it is switched here; the switch lasts over a reload", async () => {
  const page = await open({ colorScheme: "dark" });
  const panel = () => page.evaluate(() => getComputedStyle(document.querySelector(".panel")!).backgroundColor);
  const dark = await panel();
  await page.emulateMedia({ colorScheme: "light" });
  const light = await panel();
  expect(light).not.toBe(dark);
  await page.getByRole("button", { name: "Dark theme" }).click();
  expect(await panel()).toBe(dark);
  await page.reload();
  await ready(page);
  expect(await panel()).toBe(dark);
  await page.locator("#canvas").focus();
  await page.keyboard.press("t");
  await until("it is light", async () => (await panel()) === light);
});

test("the legend shows the core's range and colours, where the view has a scale", async () => {
  const page = await open({});
  const legend = page.locator("#legend");
  expect(await legend.innerText()).toMatch(/Length over rest length\s+0\.95\s+1\.15/);
  const bar = await page.locator("#legend-bar").evaluate((one) => getComputedStyle(one).backgroundImage);
  // viridis, src/render/color_map.hpp
  expect(bar).toMatch(/^linear-gradient\(to right, rgb\(68, 1, 84\).*rgb\(253, 231, 37\)\)$/);
  await page.keyboard.press("1");
  await until("it is gone", async () => !(await legend.isVisible()));
});
