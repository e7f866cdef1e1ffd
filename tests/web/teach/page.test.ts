// The lessons as a visitor has them, each held to its law on both sides of what it says.
import type { BrowserContextOptions, Page } from "playwright-core";
import { expect, test } from "vitest";
import type { TeachHandle } from "../../../apps/web/teach/main.js";
import { violations } from "../axe.ts";
import { launch } from "../chromium.ts";
import { expectClean, opened, until, visit, type Visit } from "../page/browser.ts";

declare const window: { readonly teach: TeachHandle }; // in the functions that the page runs

const here = opened(["--disable-3d-apis"]); // the page needs no WebGPU

async function teach(options: BrowserContextOptions = {}): Promise<Visit> {
  const seen = await visit(here.browser, `${here.site.address}teach/`, { viewport: { width: 1280, height: 900 },
    reducedMotion: "reduce", bypassCSP: true, ...options });
  await seen.page.evaluate(() => window.teach.ready);
  return seen;
}

type Readings = Record<string, number>;
/** Moves the sliders as a visitor does; the numbers that the page then shows. */
async function set(page: Page, sliders: Readonly<Record<string, number>>): Promise<Readings> {
  for (const [id, value] of Object.entries(sliders)) await page.locator(`#${id}`).fill(String(value));
  await page.evaluate(() => window.teach.settled());
  return page.evaluate(() => window.teach.readings()) as Promise<Readings>;
}
const verdict = (page: Page, name: string) => page.locator(`#${name}-verdict`).textContent();

test("what the lessons measure is what the laws say", async () => {
  const seen = await teach();
  const { page } = seen;

  // A period within 1 %; of a mass nine times lighter on another spring too.
  for (const [mass, stiffness] of [[0.1, 20], [0.3, 5], [0.05, 40]] as const) {
    const found = await set(page, { "spring-mass": mass, "spring-stiffness": stiffness });
    const law = 2 * Math.PI * Math.sqrt(mass / stiffness);
    expect(found["spring-law"]).toBeCloseTo(law, 12);
    expect(Math.abs(found["spring-measured"]! / law - 1)).toBeLessThan(0.01);
  }
  expect(await page.locator("#spring-law").textContent()).toBe(`${
    Number((2 * Math.PI * Math.sqrt(0.05 / 40))
      .toPrecision(4))
  }\u00a0s`);

  // Short steps stay, long ones blow up, and the limit that is found is that of the fastest swing.
  for (const masses of [2, 7]) {
    const frequency = 2 * Math.sqrt(20 / 0.1) * Math.sin(((2 * masses - 1) * Math.PI) / (4 * masses + 2));
    const short = await set(page, { "stability-masses": masses, "stability-percent": 98 });
    expect(short["stability-step"]).toBeCloseTo((0.98 * 2000) / frequency, 9);
    expect(await verdict(page, "stability")).toContain("short enough");
    expect(Math.abs(short["stability-measured"]! / (2000 / frequency) - 1)).toBeLessThan(2e-3);
    await set(page, { "stability-percent": 103 });
    expect(await verdict(page, "stability")).toContain("blows up");
  }

  // It sticks below the friction angle, and slides as it should above: arctan 0.3 is 16.7°, arctan 0.6 31.0°.
  for (const [angle, friction, slides] of [[16, 0.3, false], [18, 0.3, true], [30, 0.6, false], [45, 0.6, true], [10, 0,
    true]] as const) {
    const found = await set(page, { "friction-slope": angle, "friction-coefficient": friction });
    const a = (angle * Math.PI) / 180;
    const law = slides ? 9.81 * (Math.sin(a) - friction * Math.cos(a)) : 0;
    expect(found["friction-law"]).toBeCloseTo(law, 9);
    if (slides) expect(Math.abs(found["friction-measured"]! / law - 1)).toBeLessThan(0.01);
    else expect(found["friction-way"]).toBeLessThan(0.05); // cm
    expect(await verdict(page, "friction")).toContain(slides ? "It slides" : "It sticks");
  }

  // Energy: of first order it is lost by the factor of the formula, of second order far less; none by the explicit one.
  for (const steps of [20, 40, 80]) {
    const found = await set(page, { "energy-steps": steps });
    const phase = (2 * Math.PI) / steps;
    const euler = 100 * (1 + phase * phase) ** -steps;
    expect(found["energy-backward-law"]! / euler).toBeCloseTo(1, 9);
    expect(Math.abs(found["energy-backward-period"]! / euler - 1)).toBeLessThan(0.01);
    expect(Math.abs(found["energy-bdf2-period"]! / found["energy-bdf2-law"]! - 1)).toBeLessThan(0.01);
    expect(found["energy-bdf2"]).toBeGreaterThan(found["energy-backward"]!);
    expect(Math.abs(found["energy-symplectic"]! / 100 - 1)).toBeLessThan(phase / 2);
    expect(found["energy-forward-law"]).toBeGreaterThan(10_000); // %
  }
  expectClean(seen, here.site);
  await page.context().close();
});

test("explicit steps grow in number with the nodes along a side, implicit ones do not", async () => {
  const seen = await teach();
  const { page } = seen;
  expect(await page.locator("#fineness-play").isDisabled()).toBe(true);
  await page.locator("#fineness-measure").click();
  const { "fineness-explicit": explicit, "fineness-implicit": implicit, "fineness-times": time } = await set(page, {
    "fineness-error": 2,
  }) as unknown as Record<string, string>;
  const [few, many] = explicit!.match(/\d+(?= (substeps )?at)/g)!.map(Number) as [number, number];
  expect(many / few).toBeCloseTo(31 / 7, 0); // cells along a side
  expect(implicit).toBe("1 at 8², 1 at 32²");
  expect(Number(time)).toBeGreaterThan(0);
  const finer = await set(page, { "fineness-error": 0.2 });
  expect(finer["fineness-implicit"]).not.toBe(implicit);
  expect(await page.locator("#stored-times tr").count()).toBeGreaterThan(0);
  expect(await page.locator("#fineness-plot .series").count()).toBe(2);
  expectClean(seen, here.site);
  await page.context().close();
});

for (const colorScheme of ["dark", "light"] as const)
  test(`the ${colorScheme} page is fit for all: axe, a phone, the keyboard, less motion`, async () => {
    const seen = await teach({ colorScheme, viewport: { width: 390, height: 844 } });
    const { page } = seen;
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    const small = await page.locator("button:visible, input:visible, .contents a, .home").evaluateAll((all) =>
      all.filter((one) => one.getBoundingClientRect().height < 44).map((one) => one.outerHTML)
    );
    expect(small).toEqual([]);
    // It waits until Play is pressed, and goes on then.
    const cursor = () => page.locator("#spring-plot .cursor").getAttribute("d");
    await page.locator("#spring-play").scrollIntoViewIfNeeded();
    const rest = await cursor();
    expect(await page.locator("#spring-play-label").textContent()).toBe("Play");
    await page.locator("#spring-play").press("Enter");
    await until("it moves", async () => (await cursor()) !== rest);
    await page.locator("#spring-mass").press("ArrowRight");
    expect(await page.locator("#spring-mass-value").textContent()).toBe("0.15\u00a0kg");
    expectClean(seen, here.site);
    await page.context().close();
  });

test("each page leads to the lessons, and they lead on and back", async () => {
  for (const [from, link] of [["", "./teach/"], ["", "./methods/"], ["", "./compare/"], ["methods/", "../teach/"], [
    "compare/",
    "../teach/",
  ], ["teach/", "../"], ["teach/", "../methods/"], ["teach/", "../compare/"]]) {
    const page = await (await fetch(`${here.site.address}${from}`)).text();
    expect(page).toContain(`href="${link}"`);
    expect((await fetch(new URL(link!, `${here.site.address}${from}`))).status).toBe(200);
  }
});

test("without the core's module the page says so in a sentence", async () => {
  const browser = await launch([]);
  try {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.route("**/*.wasm", (route) => route.abort());
    await page.goto(`${here.site.address}teach/`);
    await until("it is said", async () => (await verdict(page, "energy"))!.includes("The core cannot be loaded"));
  } finally {
    await browser.close();
  }
});
