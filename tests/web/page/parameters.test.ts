import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { expectClean, hash, meanVelocity, opened, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
let page: Page;
beforeAll(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=16`, { reducedMotion: "reduce" });
  page = seen.page;
  await ready(page);
  for (const summary of await page.locator("summary").all()) await summary.click();
});
afterAll(() => expectClean(seen, here.site));

const FRAME = 1 / 60; // s
const set = () => page.evaluate(() => window.weft.state!.set as Record<string, unknown>);
const has = (key: string, value: unknown) =>
  until(`${key} is ${JSON.stringify(value)}`, async () => JSON.stringify((await set())[key]) === JSON.stringify(value));
const slide = (label: string, value: number) => page.getByLabel(label, { exact: true }).fill(String(value));
const info = () => page.evaluate(() => window.weft.world!.info);

test("gravity, drag and wind act on the cloth as it moves, and each group goes back to the scene's own", async () => {
  const own = await meanVelocity(page);
  expect(own[1]).toBeLessThan(-0.8 * 9.81 * FRAME);
  await slide("Gravity", 0);
  await has("gravity", [0, 0, 0]);
  expect(Math.abs((await meanVelocity(page))[1])).toBeLessThan(1e-6);

  await slide("Drag", 3);
  await has("drag", 3);
  await slide("Direction", 90);
  await slide("Speed", 10);
  await has("wind.velocity", [10, 0, 0]);
  const [along, up, across] = await meanVelocity(page);
  expect(along).toBeGreaterThan(0.7 * 3 * 10 * FRAME); // drag times wind; some of it is the pins'
  expect(along).toBeLessThan(3 * 10 * FRAME);
  expect(Math.hypot(up, across)).toBeLessThan(0.02 * along);

  await page.getByRole("button", { name: "Reset wind" }).click();
  await has("wind.velocity", undefined);
  expect(Object.keys(await set()).sort()).toEqual(["drag", "gravity"]);
  await page.getByRole("button", { name: "Reset gravity and air" }).click();
  await until("nothing is changed", async () => Object.keys(await set()).length === 0);
  expect(await meanVelocity(page)).toEqual(own);
});

test("a flag of fabric has its moduli and its air to change, and no springs", async () => {
  const visited = await visit(here.browser, `${here.site.address}?scene=flag-in-air&nodes=16`, {
    reducedMotion: "reduce",
  });
  const flag = visited.page;
  await ready(flag);
  for (const summary of await flag.locator("summary").all()) await summary.click();
  const set = () => flag.evaluate(() => window.weft.state!.set as Record<string, unknown>);
  const becomes = (expected: Record<string, unknown>) =>
    until(`it is ${JSON.stringify(expected)}`, async () => JSON.stringify(await set()) === JSON.stringify(expected));
  for (const label of ["Structural stiffness", "Bend stiffness", "Damping", "Mass of a node"])
    expect(await flag.getByLabel(label, { exact: true }).isVisible()).toBe(false);
  const own = await meanVelocity(flag);
  await flag.getByLabel("Density of air", { exact: true }).fill("0");
  await becomes({ "air.density": 0 });
  expect((await meanVelocity(flag))[0]).toBeLessThan(own[0]);
  await flag.getByRole("button", { name: "Reset gravity and air" }).click();
  await becomes({});
  await flag.getByLabel("Modulus along the warp", { exact: true }).fill("500");
  await flag.keyboard.press("Enter");
  await becomes({ "cloths.0.fabric.warp": 500 });
  await expectClean(visited, here.site);
});

test("wind that nothing feels says why", async () => {
  const remark = page.getByText("raise it to feel the wind");
  expect(await remark.isVisible()).toBe(false);
  await slide("Drag", 0);
  await until("it says so", () => remark.isVisible());
  await page.getByRole("button", { name: "Reset gravity and air" }).click();
  await has("drag", undefined);
});

test("cloth, contact and time restart the scene with the values entered", async () => {
  const before = await info();
  const enter = async (label: string, value: string) => {
    await page.getByLabel(label, { exact: true }).fill(value);
    await page.keyboard.press("Enter");
  };
  const stretched = async () => {
    await page.evaluate(async () => {
      await window.weft.world!.reset();
      await window.weft.world!.step(12);
    });
    return page.evaluate(() => window.weft.world!.statistics.maxStretch);
  };
  const firm = await stretched();
  await enter("Structural stiffness", "500");
  await has("cloths.0.stiffness.structural", 500);
  expect((await info()).stableStepSeconds).toBeGreaterThan(before.stableStepSeconds);
  expect(await stretched()).toBeGreaterThan(firm);
  await enter("Substeps per frame", "40");
  await has("time.substeps", 40);
  expect((await info()).substeps).toBe(40);
  for (const [label, key, value] of [["Density", "cloths.0.density", 0.5], ["Shear stiffness",
    "cloths.0.stiffness.shear", 300], ["Bend stiffness", "cloths.0.stiffness.bend", 20], ["Damping", "cloths.0.damping",
    0.02], ["Thickness", "contact.thickness", 0.01], ["Friction", "cloths.0.friction", 0.7]] as const) {
    const last = await page.evaluate(async () => {
      await window.weft.world!.reset();
      await window.weft.world!.step(2);
      return (await window.weft.world!.snapshot()).hash;
    });
    await enter(label, String(value));
    await has(key, value);
    if (!key.startsWith("cloths.0.") || key.endsWith("friction")) continue; // without contact these two change nothing
    await page.evaluate(() => window.weft.world!.step(2));
    expect(await hash(page)).not.toBe(last);
  }

  await enter("Substeps per frame", "");
  await has("time.substeps", "auto");
  for (const group of ["cloth", "contact", "time"]) {
    await page.getByRole("button", { name: `Reset ${group}`, exact: true }).click();
    await until(`${group} is reset`, async () =>
      !(await page.getByRole("button", { name: `Reset ${group}`, exact: true }).isVisible()));
  }
  expect(await set()).toEqual({});
  expect((await info()).stableStepSeconds).toBe(before.stableStepSeconds);
});

test("a value past the core's limits is refused in one sentence, and the field shows what holds", async () => {
  const density = page.getByLabel("Density", { exact: true });
  const own = await density.inputValue();
  await density.fill("-1");
  await page.keyboard.press("Enter");
  await until("it is said", async () =>
    (await page.locator("#notice").textContent())!.includes(
      "Density is “-1”, but must be a number from 0.000001 to 1000000 kg/m².",
    ));
  expect(await density.inputValue()).toBe(own);
  expect(await set()).toEqual({});
});

test("formulation and contact method are the core's, by its names, and change what is loaded", async () => {
  const options = (id: string) =>
    page.locator(`#${id} option`).evaluateAll((all) => all.map((one) => (one as HTMLOptionElement).value));
  expect(await options("formulation")).toEqual(["node_centric", "spring_centric", "spring_blocks"]);
  expect(await options("contact")).toEqual(["none", "paper", "bvh", "proximity"]);
  const nodewise = (await info()).gpuBytes;
  await page.locator("#formulation").selectOption("spring_centric");
  await has("solver.forces", "spring_centric");
  expect((await info()).gpuBytes).toBeGreaterThan(nodewise + 60 * 256); // it keeps lists of springs
  await page.locator("#formulation").selectOption("node_centric");
  await has("solver.forces", "node_centric");

  await page.goto(`${here.site.address}?scene=pull-sphere&nodes=16`);
  await ready(page);
  const fall = async () =>
    page.evaluate(async () => {
      await window.weft.world!.reset();
      return (await window.weft.world!.step(4)).contacts;
    });
  expect(await fall()).toBeGreaterThan(0);
  await page.locator("#contact").selectOption("none");
  await has("contact.method", "none");
  expect(await fall()).toBe(0);
  expect(await page.locator("#contact-remark").textContent()).toContain("falls through");
  await page.locator("#contact").selectOption("paper");
  await has("contact.method", "paper");
  expect(await page.locator("#contact-remark").textContent()).toContain("slow");
  expect(await fall()).toBeGreaterThan(0);
});
