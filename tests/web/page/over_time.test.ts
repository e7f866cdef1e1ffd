import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { frames, pages, until } from "./browser.js";
import { violations } from "../axe.ts";
import { Series } from "../../../apps/web/src/state/series.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const open = pages({ reducedMotion: "reduce", permissions: ["clipboard-read", "clipboard-write"] });
const summary = (page: Page) => page.getByText("Energy, stretch, residual");
/** The rows that are copied, without their heading. */
async function rows(page: Page): Promise<number[][]> {
  await page.getByRole("button", { name: "Copy as CSV" }).click();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  const [heading, ...lines] = text.trimEnd().split("\n");
  expect(heading).toMatch(/^frame,time_s,kinetic_J,potential_J,/);
  return lines.map((line) => line.split(",").map(Number));
}

test("energy, stretch and residual are measured while the part is open, and copied as they are", async () => {
  const page = await open("?scene=sheet&nodes=16"); // implicit, so there is a residual
  await page.evaluate(() => window.weft.world!.step(2));
  await summary(page).click();
  await until("the first point", async () => (await rows(page)).length === 1);
  for (let i = 0; i < 3; i++) {
    await page.locator("#step").click();
    await until(`frame ${i + 3}`, async () => (await rows(page)).at(-1)![0] === i + 3);
  }
  const all = await rows(page);
  expect(all.map(([frame]) => frame)).toEqual([2, 3, 4, 5]);
  const [, , kinetic, potential] = all.map((row) => row).at(-1)!;
  expect(kinetic).toBeGreaterThan(all[0]![2]!);
  expect(potential).toBeLessThan(all[0]![3]!); // it falls
  expect(all.every((row) => row.length === 12 && row.every(Number.isFinite))).toBe(true);
  const measured = await page.evaluate(() => window.weft.world!.measure());
  expect(kinetic).toBe(measured.kinetic);
  for (const id of ["energy", "stretch", "residual"])
    expect(await page.locator(`#${id}-plot .line`).first().getAttribute("d")).toMatch(/^M[\d.]+ [\d.]+L/);

  await page.locator("#reset").click();
  await until("it begins anew", async () => (await rows(page)).length === 1);
  await summary(page).click();
  await page.locator("#step").click();
  await until("a frame", async () => (await frames(page)) === 1);
  await summary(page).click();
  await until("both are there", async () => (await rows(page)).map(([frame]) => frame).join() === "0,1");
});

test("on a phone the curves fit, and axe finds nothing", async () => {
  const page = await open("?scene=hanging&nodes=12", { viewport: { width: 360, height: 740 }, bypassCSP: true });
  await page.getByRole("button", { name: "More" }).click();
  await summary(page).click();
  await until("the first point", async () => (await rows(page)).length === 1);
  expect(await page.locator("#residual-part").isVisible()).toBe(false); // explicit steps leave none
  for (const svg of await page.locator(".curves svg:visible").all()) {
    const box = (await svg.boundingBox())!;
    expect(box.x).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width).toBeLessThanOrEqual(360);
  }
  expect(await violations(page)).toEqual([]);
});

test("of a long run every second row goes, and the last stays", () => {
  const series = new Series();
  const row = { seconds: 0, kinetic: 0, potential: 0, springs: 0, membranes: 0, bending: 0, tetrahedra: 0, gas: 0,
    maxStretch: 1, contacts: 0, residual: 0 };
  for (let frame = 0; frame < 5000; frame++) expect(series.add({ frame, ...row })).toBe(true);
  expect(series.add({ frame: 4999, ...row })).toBe(false);
  expect(series.rows.length).toBeLessThanOrEqual(600);
  expect(series.rows.length).toBeGreaterThanOrEqual(300);
  expect(series.rows[0]!.frame).toBe(0);
  expect(series.rows.at(-1)!.frame).toBe(4999);
  expect(series.add({ frame: 3, ...row })).toBe(true);
  expect(series.rows.length).toBe(1);
});
