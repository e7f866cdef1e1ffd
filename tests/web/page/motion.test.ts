import { expect, test } from "vitest";
import { brightness, difference, drawn, expectClean, frames, hash, opened, picture, play, positions, ready, running,
  visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();

for (const [scene, nodes, moved] of [["hanging", 24, 0.01], ["pull-sphere", 32, 0.002]] as const)
  test(`${scene} is drawn and moves`, async () => {
    const seen = await visit(here.browser, `${here.site.address}?scene=${scene}&nodes=${nodes}`);
    const { page } = seen;
    await ready(page);
    expect(await page.evaluate(() => window.weft.world!.info.nodes)).toBe(nodes * nodes);
    const before = { positions: await positions(page), picture: await picture(page) };
    await play(page, 6);
    await drawn(page);
    const after = { positions: await positions(page), picture: await picture(page) };

    const largest = after.positions.reduce((most, value, i) => Math.max(most, Math.abs(value - before.positions[i]!)),
      0);
    expect(largest).toBeGreaterThan(moved); // m
    for (const { picture } of [before, after]) {
      const { mean, deviation } = brightness(picture);
      expect(mean).toBeGreaterThan(40); // of 255: not black
      expect(deviation).toBeGreaterThan(8); // nor a single colour
    }
    expect(difference(before.picture, after.picture)).toBeGreaterThan(0.002);
    expectClean(seen, here.site);
    await page.context().close();
  });

test("with reduced motion the cloth waits, and reset restores its rest state to the bit", async () => {
  const seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=24`, { reducedMotion: "reduce" });
  const { page } = seen;
  await ready(page);
  await page.waitForTimeout(300);
  expect(await running(page)).toBe(false);
  expect(await page.locator("#notice").textContent()).toContain("Play");
  const rest = await hash(page);

  await page.getByRole("button", { name: "Play" }).click();
  await play(page, 3);
  await page.getByRole("button", { name: "Pause" }).click();
  expect(await hash(page)).not.toBe(rest);
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  expect(await hash(page)).toBe(rest);
  expect(await frames(page)).toBe(0);
  expectClean(seen, here.site);
  await page.context().close();
});
