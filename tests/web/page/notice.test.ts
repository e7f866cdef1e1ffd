import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { expectClean, opened, ready, running, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
afterEach(async () => {
  expectClean(seen, here.site);
  await seen.page.context().close();
});

async function open(query: string): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}${query}`);
  await ready(seen.page);
  return seen.page;
}
const shown = async (page: Page) =>
  (await page.locator("#notice").isVisible()) ? page.locator("#notice-text").textContent() : null;

test("a plain message goes by itself, and an error that it stood over is back until it is closed", async () => {
  const page = await open("?scene=hanging&nodes=16&drag=1e9");
  const error = (await shown(page))!;
  expect(error).toContain("drag is “1e9”");
  await page.mouse.move(20, 380); // beside the cloth
  await page.keyboard.press("p");
  await until("it is said", async () => (await shown(page)) === "There is no cloth to pin there.");
  await until("the error is back", async () => (await shown(page)) === error);
  await page.getByRole("button", { name: "Close the message" }).click();
  expect(await shown(page)).toBe(null);
  await page.keyboard.press("p");
  await until("it is said", async () => (await shown(page)) === "There is no cloth to pin there.");
  await until("it has gone", async () => (await shown(page)) === null);
});

test("an unstable step is said in the program's words, and “auto” mends it", async () => {
  const page = await open("?scene=hanging&nodes=16&time.substeps=1");
  const { unstableStep, stableStepSeconds } = await page.evaluate(() => window.weft.world!.info);
  const stable = (1000 * stableStepSeconds).toPrecision(3);
  expect(unstableStep).toBe(
    `The step of 16.7 ms is longer than the largest stable one of ${stable} ms, so the cloth ` +
      `may blow up: ${Math.ceil(1 / 60 / stableStepSeconds)} substeps a frame are needed, not 1.`,
  );
  // The warning, or in its place that the cloth has blown up: both come with the offer.
  await until("it is said", async () => (await shown(page)) !== null);
  await page.getByRole("button", { name: "Use “auto”" }).click();
  await until("the step is stable", () => page.evaluate(() => window.weft.state!.set["time.substeps"] === "auto"));
  expect(await page.evaluate(() => window.weft.world!.info.unstableStep)).toBe(null);
  expect(await shown(page)).toBe(null);
});

test("the warning of an unstable step stays while the cloth plays", async () => {
  const page = await open("?scene=hanging&nodes=16");
  const { stableStepSeconds } = await page.evaluate(() => window.weft.world!.info);
  const substeps = Math.ceil(1 / 60 / stableStepSeconds) - 1; // just too few: at rest nothing blows up at once
  await page.goto(`${here.site.address}?scene=hanging&nodes=16&time.substeps=${substeps}&gravity=0,0,0`);
  await ready(page);
  const warning = (await shown(page))!;
  expect(warning).toContain(`substeps a frame are needed, not ${substeps}.`);
  await page.keyboard.press("Space");
  await until("it pauses", async () => !(await running(page)));
  await page.keyboard.press("Space");
  await until("it plays", () => running(page));
  expect(await shown(page)).toBe(warning);
});
