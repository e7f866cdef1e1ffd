// The baselines are worth comparing with only if they simulate the same cloth.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { CATALOG, type PathName } from "../../../apps/web/compare/catalog.ts";
import { CpuSheet } from "../../../apps/web/compare/cpu_sheet.ts";
import type { CompareHandle } from "../../../apps/web/compare/main.js";
import { restPositions, sheetOf, springCount } from "../../../apps/web/compare/sheet.ts";
import { springLists } from "../../../apps/web/compare/spring_lists.ts";
import { composed, difference, expectClean, picture } from "../page/browser.ts";
import { ROOT } from "../chromium.ts";
import { compared, openedWithBoth } from "./compare.ts";

declare const window: { readonly compare: CompareHandle }; // in the functions that the page runs

const scene = readFileSync(join(ROOT, "scenes/hanging-paper.json"), "utf8");
const here = openedWithBoth();

const WIDTH = 300; // m
/**
 * Positions of up to 150 m are rounded to 2^-16 m in every step, by half of that: over 100 steps by 7.6e-4 m if all
 * fall the same way, some 4e-5 m if they do not. Seen on SwiftShader are 1.1e-4 m at most, between f32 and the CPU's
 * doubles. Divisions and roots may be 2.5 units off on other GPUs, so nearly three times that is allowed: a millionth
 * of the width.
 */
const TOLERANCE = 1e-6 * WIDTH;

const positionsAfter = (page: Page, name: PathName, grid: readonly [number, number], steps: number,
  from = scene): Promise<number[]> =>
  page.evaluate(async ([name, grid, steps, from]) => {
    const path = await window.compare.open(name, grid, from);
    await path.simulate(steps);
    const positions = Array.from(await path.positions());
    path.dispose();
    return positions;
  }, [name, grid, steps, from] as const);

const furthest = (a: readonly number[], b: readonly number[]) =>
  Math.max(...a.map((value, i) => Math.abs(value - b[i]!)));

/** The scene's own damping of 3 N·s/m moves nothing by more than the tolerance; in this sheet damping rules. */
function syrup(): string {
  const changed = JSON.parse(scene) as { cloths: [{ stiffness: object; damping: number }] };
  changed.cloths[0].stiffness = { structural: 1500, shear: 1200, bend: 2190 };
  changed.cloths[0].damping = 300;
  return JSON.stringify(changed);
}

for (const [nx, ny, what, from] of [[32, 32, "", scene], [21, 34, "", scene], [17, 12, "soft and damped ",
  syrup()]] as const)
  test(`after 100 steps of ${nx} × ${ny} ${what}nodes all paths are where weft's core is`, async () => {
    const seen = await compared(here.browser, here.site, "");
    const core = await positionsAfter(seen.page, "weft-node", [nx, ny], 100, from);
    const rest = Array.from(restPositions(sheetOf(from, nx, ny)));
    expect(core).toHaveLength(rest.length);
    expect(furthest(core, rest)).toBeGreaterThan(1); // it has moved by far more than the tolerance [m]
    for (const { name } of CATALOG)
      expect({ name, apart: furthest(await positionsAfter(seen.page, name, [nx, ny], 100, from), core) })
        .toEqual({ name, apart: expect.toSatisfy((apart: number) => apart <= TOLERANCE) });
    expectClean(seen, here.site);
    await seen.page.context().close();
  });

test("all paths draw the same sheet, a step further with each picture", async () => {
  const seen = await compared(here.browser, here.site, "");
  const { page } = seen;
  const drawn = async (name: PathName) => {
    const path = await page.evaluateHandle(async (name) => {
      const path = await window.compare.open(name, [24, 36]);
      await path.animate(6);
      return path;
    }, name);
    // Reading the positions also waits for the picture.
    const positions = await path.evaluate(async (path) => Array.from(await path.positions()));
    await composed(page);
    const image = await picture(page, "#live canvas");
    await path.evaluate((path) => path.dispose());
    return { ...cloth(image), positions };
  };
  const core = await drawn("weft-node");
  expect(core.share).toBeGreaterThan(0.15); // of the picture
  expect(core.share).toBeLessThan(0.5);
  for (const { name } of CATALOG) {
    const own = name === "weft-node" ? core : await drawn(name);
    expect({ name, differs: difference(own.image, core.image) })
      .toEqual({ name, differs: expect.toSatisfy((part: number) => part < 0.01) }); // the rim, by its samples
    expect(own.positions).toEqual(await positionsAfter(page, name, [24, 36], 6));
  }
  expectClean(seen, here.site);
});

/** The cloth alone: normals that face the eye are blue, and no background is. */
function cloth(image: Uint8Array): { image: Uint8Array; share: number } {
  const out = new Uint8Array(image.length);
  let count = 0;
  for (let i = 0; i < image.length; i += 4) {
    if (image[i + 2]! < 200 || image[i]! > 180) continue;
    out.set(image.subarray(i, i + 4), i);
    count++;
  }
  return { image: out, share: count / (image.length / 4) };
}

test("no spring of the CPU's sheet pushes it as a whole: without pins its momentum is that of gravity", () => {
  const sheet = { ...sheetOf(scene, 13, 9), pinned: [] };
  const cloth = new CpuSheet(sheet);
  cloth.velocity.forEach((_, at) => {
    cloth.velocity[at] = 5 * Math.sin(97.3 * at);
  }); // m/s
  const momentum = () =>
    [0, 1, 2].map((axis) =>
      cloth.velocity.reduce((sum, value, at) => sum + (at % 3 === axis ? sheet.nodeMass * value : 0), 0)
    );
  const before = momentum();
  for (let step = 0; step < 50; step++) cloth.step();
  momentum().forEach((value, axis) => {
    const gained = 13 * 9 * sheet.nodeMass * sheet.gravity[axis]! * 50 * sheet.step;
    expect(value - before[axis]!).toBeCloseTo(gained, 6); // kg m/s, of some thousands; doubles
  });
});

test("the lists of springs have every spring of the grid at both its nodes, and none at a pinned one", () => {
  const sheet = sheetOf(scene, 7, 5), lists = springLists(sheet);
  const structural = 6 * 5 + 7 * 4, shear = 2 * 6 * 4, bend = 5 * 5 + 7 * 3; // as src/mesh/springs.hpp counts them
  expect(springCount(sheet)).toBe(structural + shear + bend);
  expect(lists.restLength).toHaveLength(structural + shear + bend);
  const atPins = lists.nodes.filter((node) => sheet.pinned.includes(node)).length;
  expect(atPins).toBe(2 * 5); // two structural, one shear, two bend at a corner
  expect(lists.ofNode).toHaveLength(2 * springCount(sheet) - atPins);
  lists.count.forEach((count, node) => {
    for (const spring of lists.ofNode.subarray(lists.begin[node]!, lists.begin[node]! + count))
      expect([lists.nodes[2 * spring], lists.nodes[2 * spring + 1]]).toContain(node);
  });
});
