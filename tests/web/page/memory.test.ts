// The memory that the page names before it is taken, against what the core then takes.
import { expect, test } from "vitest";
import { expectClean, opened, ready, until, visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const MARGIN = 0.1;

const here = opened();

const bytes = (text: string): number => {
  const [, value, unit] = /about ([\d.]+) ([kMG])B/.exec(text)!;
  return Number(value) * { k: 1e3, M: 1e6, G: 1e9 }[unit as "k" | "M" | "G"];
};

test(`what the list names for a resolution is what the GPU's buffers take, within ${100 * MARGIN} %`, async () => {
  const seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=8`, { reducedMotion: "reduce" });
  const { page } = seen;
  await ready(page);
  for (const [query, finer] of [["scene=hanging&solver.forces=spring_centric", "100"], [
    "scene=hanging&solver.forces=spring_blocks",
    "128",
  ], ["scene=sheet", "100"], ["scene=pull-sphere&contact.method=bvh", "64"], ["scene=stack", "24"], [
    "scene=pull-armadillo",
    "64",
  ]] as const) {
    await page.goto(`${here.site.address}?v=1&${query}&nodes=8`);
    await ready(page);
    const named = bytes((await page.locator(`#resolution option[value="${finer}"]`).textContent())!);
    const refused = await page.locator("#resolution option:disabled").allTextContents();
    if (query === "scene=stack") expect(refused).toContain("2048 × 2048 × 16 sheets, too large");
    expect(refused.every((text) => text.endsWith("too large"))).toBe(true);
    await page.locator("#resolution").selectOption(finer);
    await until("it is loaded", () => page.evaluate((nodes) => window.weft.state!.nodes === nodes, Number(finer)));
    const taken = await page.evaluate(() => window.weft.world!.info.gpuBytes);
    expect(Math.abs(named / taken - 1), `${query}: ${named} named, ${taken} taken`).toBeLessThan(MARGIN);
  }
  expectClean(seen, here.site);
});
