import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { BrowserContextOptions, Page } from "playwright-core";
import { createReference, type Snapshot } from "weft-cloth";
import { expect, test } from "vitest";
import stored from "../../../apps/web/methods/sheet_run.json";
import type { MethodsHandle } from "../../../apps/web/methods/main.js";
import { front, kindsOf, sidesOf, type StoredRun } from "../../../apps/web/methods/stored_run.ts";
import { violations } from "../axe.ts";
import { launch, ROOT } from "../chromium.ts";
import { expectClean, opened, until, visit, type Visit } from "../page/browser.ts";

declare const window: { readonly methods: MethodsHandle }; // in the functions that the page runs

const here = opened();
const run: StoredRun = stored;

async function methods(query: string, options: BrowserContextOptions = {}): Promise<Visit> {
  const seen = await visit(here.browser, `${here.site.address}methods/${query}`, {
    viewport: { width: 1440, height: 900 },
    reducedMotion: "reduce",
    bypassCSP: true,
    ...options,
  });
  await seen.page.evaluate(() => window.methods.ready);
  return seen;
}
const settled = (page: Page) => page.evaluate(() => window.methods.settled());
const frames = (page: Page) =>
  page.evaluate(() => window.methods.worlds.map((world) => world?.statistics.frames ?? null));
const readings = (page: Page) => page.evaluate(() => window.methods.readings);
const button = (page: Page, name: string) => page.getByRole("button", { name, exact: true });
const facts = (page: Page, name: string) =>
  page.locator(".pane dl > div", { hasText: name }).locator("dd").allInnerTexts();

type State = { positions: number[]; velocities: number[]; inverseMasses: number[]; hash: string };
/** The state of each world, read without the page's own code. */
const states = (page: Page): Promise<State[]> =>
  page.evaluate(async () => {
    const read: Snapshot[] = [];
    for (const world of window.methods.worlds) read.push(await world!.snapshot());
    return read.map(({ positions, velocities, inverseMasses, hash }) => ({ positions: [...positions],
      velocities: [...velocities], inverseMasses: [...inverseMasses], hash })
    );
  });

/** Each world's eye and target; a snapshot first, since a camera that is still to be turned is so before it. */
const cameras = async (page: Page) => {
  await states(page);
  return page.evaluate(() => window.methods.worlds.map((world) => world!.camera));
};

const overflow = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

const norm = (values: readonly number[]) => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0));
const apart = (a: readonly number[], b: readonly number[]) => norm(a.map((value, i) => value - b[i]!));

test("methods step in lock step, and what is read of them is what their states say", async () => {
  const seen = await methods("?nodes=12&methods=mass_spring,mass_spring,xpbd:substeps=8", { colorScheme: "dark" });
  const { page } = seen;
  expect(await page.locator("#said").textContent()).toContain("waits until you press Play");
  const rest = await states(page);
  const [camera] = await cameras(page);
  expect(await frames(page)).toEqual([0, 0, 0]);
  expect((await readings(page)).map((reading) => reading!.error)).toEqual([null, null, null]);
  expect(await facts(page, "Substeps")).toEqual(["20", "20", "8"]);

  for (let i = 0; i < 3; i++) await button(page, "One frame").click();
  await settled(page);
  expect(await frames(page)).toEqual([3, 3, 3]);
  const after = await states(page);
  const way = apart(after[0]!.positions, rest[0]!.positions);
  expect(way).toBeGreaterThan(0.01 * Math.sqrt(144)); // it falls by g t² / 2 = 12 mm and more
  const [first, same, xpbd] = await readings(page);
  expect([first!.error, same!.error]).toEqual([0, 0]);
  expect(after[1]!.hash).toBe(after[0]!.hash);
  expect(xpbd!.error).toBeGreaterThan(1e-4);
  expect(xpbd!.error).toBeCloseTo(apart(after[2]!.positions, after[0]!.positions) / way, 12);
  [first, xpbd].forEach((reading, i) => {
    const { velocities, inverseMasses, positions } = after[2 * i]!;
    const free = [...inverseMasses.keys()].filter((node) => inverseMasses[node]! > 0);
    const sum = (of: (node: number) => number) => free.reduce((all, node) => all + of(node) / inverseMasses[node]!, 0);
    expect(reading!.kinetic).toBeCloseTo(
      sum((node) => norm(velocities.slice(3 * node, 3 * node + 3)) ** 2) / 2,
      9,
    );
    expect(reading!.height).toBeCloseTo(
      sum((node) => 9.81 * (positions[3 * node + 1]! - rest[0]!.positions[3 * node + 1]!)),
      9,
    );
    expect(reading!.milliseconds).toBeGreaterThan(0);
  });
  expect(await facts(page, "Off from the first")).toEqual(["the first", "0 %",
    `${Number((100 * xpbd!.error!).toPrecision(3))} %`]);
  expect(await page.locator("#clock").textContent()).toBe("0.05 s, 3 frames");

  await button(page, "Play").click();
  await until("it has played", async () => (await frames(page))[0]! >= 6);
  await button(page, "Pause").click();
  await settled(page);
  const [played, ...others] = await frames(page);
  expect(others).toEqual([played, played]);
  expect(await page.evaluate(() => window.methods.frames)).toBe(played);

  await button(page, "Reset").click();
  await settled(page);
  expect((await states(page)).map(({ hash }) => hash)).toEqual(rest.map(({ hash }) => hash));
  expect(await frames(page)).toEqual([0, 0, 0]);

  // What turns one camera turns all of them, also those of worlds that are made anew below.
  await page.locator(".pane canvas").nth(1).focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  const turned = await cameras(page);
  const distance = apart(camera!.eye, camera!.target);
  expect(apart(turned[0]!.eye, camera!.eye)).toBeGreaterThan(0.05 * distance); // by 0.1 rad
  // Pictures differ by a pixel in width, and so do the distances that they are seen from.
  for (const { eye } of turned) expect(apart(eye, turned[0]!.eye)).toBeLessThan(0.01 * distance);

  // A setting restarts all of them, and stands in the address; another pane goes.
  await page.getByRole("group", { name: "Method 3: xpbd" }).getByLabel("Iterations").fill("3");
  await page.keyboard.press("Enter");
  await button(page, "Remove method 2, mass_spring").click();
  await settled(page);
  expect(new URL(page.url()).search).toBe("?v=1&scene=sheet&nodes=12&methods=mass_spring,xpbd:substeps=8:iterations=3");
  await button(page, "One frame").click();
  await settled(page);
  expect(await frames(page)).toEqual([1, 1]);
  const [kept, made] = await cameras(page);
  expect(apart(made!.eye, kept!.eye)).toBeLessThan(0.01 * distance);
  expect(apart(made!.eye, camera!.eye)).toBeGreaterThan(0.05 * distance);
  expect(await violations(page)).toEqual([]);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  expectClean(seen, here.site);
  await page.context().close();
});

test("a method that refuses the scene says so in the core's words, and takes part in another", async () => {
  const scene = readFileSync(join(ROOT, "scenes/fabric.json"), "utf8");
  const refusal = await createReference({ scene, set: { solver: { kind: "mass_spring", forces: "spring_centric" } } })
    .then(() => "none", (reason: Error) => reason.message);
  expect(refusal).toContain("has springs only");
  const seen = await methods("?scene=fabric&nodes=8&methods=mass_spring:forces=spring_centric,cuda", {
    viewport: { width: 400, height: 800 },
    colorScheme: "light",
  });
  const { page } = seen;
  expect(await page.locator("#error").textContent()).toContain("a method is “cuda”, but must be one of");
  expect(await page.locator(".pane-over").allTextContents()).toEqual([refusal]);
  expect(await facts(page, "Kinetic energy")).toEqual(["–"]);
  await button(page, "Play").click();
  await until("it stops, since nothing can play", () => button(page, "Play").isVisible());
  for (const summary of await page.locator("summary").all()) await summary.click();
  expect(await violations(page)).toEqual([]);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  const small = await page.locator("button:visible, select:visible, input:visible, summary, .home")
    .evaluateAll((all) => all.filter((one) => one.getBoundingClientRect().height < 44).map((one) => one.outerHTML));
  expect(small).toEqual([]);

  await page.getByLabel("Scene").selectOption("hanging");
  await settled(page);
  expect(await page.locator("#error").isVisible()).toBe(false);
  expect(await page.locator(".pane-over").isVisible()).toBe(false);
  await button(page, "One frame").click();
  await settled(page);
  expect(await frames(page)).toEqual([1]);

  // A device that is lost is said in its place, and Reset has another one.
  await page.evaluate(() => window.methods.worlds[0]!.device!.destroy());
  await until("it is said", async () => (await page.locator(".pane-over").textContent())!.includes("device is lost"));
  expect(await page.evaluate(() => window.methods.worlds)).toEqual([null]);
  await button(page, "Reset").click();
  await settled(page);
  expect(await page.locator(".pane-over").isVisible()).toBe(false);
  expect(await frames(page)).toEqual([0]);
  expectClean(seen, here.site);
  await page.context().close();
});

test("more work than the page's limit in a frame is refused with both numbers", async () => {
  const seen = await methods("?nodes=8&methods=xpbd:substeps=512:iterations=9");
  expect(await seen.page.locator(".pane-over").textContent()).toBe(
    "xpbd needs 512 substeps of 9 sweeps a frame, more than the page's limit of 4096 sweeps.",
  );
  expect(await seen.page.evaluate(() => window.methods.worlds)).toEqual([null]);
  expectClean(seen, here.site);

  // A scene that the server does not send is said above the panes, which are of another one.
  await seen.page.route("**/hanging-*.json", (route) => route.abort());
  await seen.page.getByLabel("Scene").selectOption("hanging");
  await settled(seen.page);
  expect(await seen.page.locator("#error").textContent()).toBe(
    "The scene hanging cannot be fetched: the server does not answer.",
  );
  expect(await seen.page.locator("#panes").isVisible()).toBe(false);
  await seen.page.getByLabel("Scene").selectOption("sheet");
  await settled(seen.page);
  expect(await seen.page.locator("#error").isVisible()).toBe(false);
  expect(await seen.page.locator(".pane-over").isVisible()).toBe(true);
  await seen.page.context().close();
});

test("without WebGPU the page says why, and has the stored measurements", async () => {
  const browser = await launch(["--disable-3d-apis"]);
  try {
    const seen = await visit(browser, `${here.site.address}methods/`, { viewport: { width: 1440, height: 900 } });
    const { page } = seen;
    expect(await page.evaluate(() => window.methods.ready.catch((reason: Error) => reason.message)))
      .toContain("WebGPU");
    expect(await page.locator("#fallback-cause").textContent()).toContain("WebGPU");
    expect(await page.locator("#fallback-advice").textContent()).not.toBe("");
    expect(await page.locator("#panes").isVisible()).toBe(false);
    expect(await page.locator("#stored-machine").textContent()).toBe(`${run.adapter}, driver ${run.driver}`);
    const points = sidesOf(run).flatMap((side) => kindsOf(run).map((kind) => front(run, side, kind).length));
    expect(await page.locator("#stored-plots .marker").count()).toBe(points.reduce((sum, count) => sum + count, 0));
    expect(await page.locator("#stored-summary tr").count()).toBe(points.length);
    expect(await page.locator("#stored-rows tr").count()).toBe(run.rows.length);
    const colours = await page.locator("#legend .series").evaluateAll((all) =>
      all.map((one) => getComputedStyle(one).color)
    );
    expect(new Set(colours).size).toBe(colours.length);
    expectClean(seen, here.site);
  } finally {
    await browser.close();
  }
});

test("the other pages lead to it, and it leads back", async () => {
  for (const [from, link] of [["", "./methods/"], ["compare/", "../methods/"], ["methods/", "../compare/"], ["methods/",
    "../"]]) {
    const page = await (await fetch(`${here.site.address}${from}`)).text();
    expect(page).toContain(`href="${link}"`);
    expect((await fetch(new URL(link!, `${here.site.address}${from}`))).status).toBe(200);
  }
});
