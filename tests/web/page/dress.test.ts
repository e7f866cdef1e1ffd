// Fabric, look, colour, materials and light: what is chosen by name.
import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { difference, drawn, expectClean, frames, hash, opened, picture, ready, until, visit,
  type Visit } from "./browser.js";
import { violations } from "../axe.ts";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
afterEach(async () => {
  expectClean(seen, here.site);
  await seen.page.context().close();
});

async function open(query: string, options: Parameters<typeof visit>[2] = {}): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}${query}`, { reducedMotion: "reduce", ...options });
  await ready(seen.page);
  return seen.page;
}
const set = (page: Page) => page.evaluate(() => window.weft.state!.set as Record<string, unknown>);
const becomes = (page: Page, expected: Record<string, unknown>) =>
  until(`it is ${JSON.stringify(expected)}`, async () => JSON.stringify(await set(page)) === JSON.stringify(expected));
const info = (page: Page) => page.evaluate(() => window.weft.world!.info);
const choice = (page: Page, label: string) => page.getByLabel(label, { exact: true });
const closeNotice = (page: Page) =>
  // it may have gone by itself
  page.locator("#notice-close").evaluate((button: HTMLElement) => {
    button.click();
    (document.activeElement as HTMLElement).blur(); // its ring would be part of the picture
  });
const shown = async (page: Page) => {
  await drawn(page);
  return picture(page);
};

/** The picture, once it is another than `before`: the state changes at once, and the world after it. */
async function changed(page: Page, before: Uint8Array, least: number): Promise<Uint8Array> {
  let now = before;
  await until("the picture is another", async () => difference(now = await shown(page), before) > least);
  return now;
}

test("looks, colour, materials and light change the picture and leave the running cloth alone", async () => {
  const page = await open("?scene=drape-sphere&nodes=16");
  await closeNotice(page);
  await page.evaluate(() => window.weft.world!.step(3));
  const [state, first] = [await hash(page), await shown(page)];
  let last = first;
  for (const [label, value, key] of [["Look", "silk", "cloths.0.look"], ["Obstacle", "metal", "colliders.0.material"], [
    "Floor",
    "marble",
    "colliders.1.material",
  ], ["Light", "sky", "render.light.environment"]] as const) {
    await choice(page, label).selectOption(value);
    await until(`${label} is ${value}`, async () => (await set(page))[key] === value);
    last = await changed(page, last, 0.002);
  }
  await choice(page, "Colour").fill("#20c040");
  await until("it is green", async () => String((await set(page))["cloths.0.color"]) === "0.125,0.753,0.251");
  last = await changed(page, last, 0.01);
  await choice(page, "Softness").fill("9");
  await until("it is soft", async () => (await set(page))["render.light.degrees"] === 9);
  const before = await changed(page, last, 0.0005);
  expect(await frames(page)).toBe(3);
  expect(await hash(page)).toBe(state);

  // The address opens the same, to the eye.
  await until("the address has it", async () => page.url().includes("render.light.degrees=9"));
  await page.reload();
  await ready(page);
  await closeNotice(page);
  await page.evaluate(() => window.weft.world!.step(3));
  expect(difference(await shown(page), before)).toBeLessThan(0.001);
  expect(await choice(page, "Colour").inputValue()).toBe("#20c040");

  await page.getByRole("button", { name: "Reset look and light" }).click();
  await becomes(page, {});
  await until("the picture is the scene's again", async () => difference(await shown(page), first) < 0.001);
  await page.waitForTimeout(400); // a fault is said once the device is known not to be lost
  expect(await page.locator("#notice").isVisible()).toBe(false);
});

test("the sun goes where two angles put it, from where it stands, and its place stands in the address", async () => {
  const page = await open("?scene=drape-sphere&nodes=16");
  await closeNotice(page);
  await page.evaluate(() => window.weft.world!.step(3));
  const [state, first] = [await hash(page), await shown(page)];
  const [azimuth, elevation] = [choice(page, "Azimuth"), choice(page, "Elevation")];
  const at = async () => [Number(await azimuth.inputValue()), Number(await elevation.inputValue())] as const;
  const direction = async () => (await set(page))["render.light.direction"] as number[] | undefined;
  // What the sliders show is where it stands: said, it is the same picture but for a rounding to whole degrees.
  const [around, above] = await at();
  expect(above).toBe(44); // atan(0.9 / hypot(0.85, 0.4)) is 43.8°
  await elevation.fill(String(above + 1));
  await elevation.fill(String(above));
  await until("it is said", async () => (await direction()) !== undefined);
  const [a, e] = [around, above].map((degrees) => degrees * Math.PI / 180) as [number, number];
  const said = (await direction())!;
  [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)].forEach((x, i) =>
    expect(said[i]).toBeCloseTo(x, 3)
  );
  expect(difference(await shown(page), first)).toBeLessThan(0.005);

  await azimuth.focus();
  const turned = around > 60 ? around - 120 : around + 120;
  await azimuth.fill(String(turned));
  const other = await changed(page, first, 0.02);
  expect(await hash(page)).toBe(state);
  await until("the address has it",
    async () => new URL(page.url()).searchParams.get("render.light.direction") === (await direction())!.join());
  await page.reload();
  await ready(page);
  await closeNotice(page);
  await page.evaluate(() => window.weft.world!.step(3));
  expect(difference(await shown(page), other)).toBeLessThan(0.001);
  expect(await at()).toEqual([turned, above]);

  await elevation.fill("90");
  await until("it is overhead", async () => String(await direction()) === "0,1,0");
  expect(await at()).toEqual([turned, 90]); // where it was around is still there to come back to
  await page.getByRole("button", { name: "Reset look and light" }).click();
  await becomes(page, {});
  expect(await at()).toEqual([around, above]);
  await until("the picture is the scene's again", async () => difference(await shown(page), first) < 0.001);
});

test("a fabric by name replaces springs, mass and method, and brings its look unless one was chosen", async () => {
  const page = await open("?scene=breeze&nodes=16&cloths.0.stiffness.shear=30");
  expect((await info(page)).springs).toBeGreaterThan(0);
  const look = () => choice(page, "Look").inputValue();
  expect(await choice(page, "Look").locator("option:checked").textContent()).toBe("Cotton, altered");
  await choice(page, "Fabric").selectOption("denim_11oz");
  await becomes(page, { "cloths.0.fabric": "denim_11oz" });
  await until("it is of membranes", async () => (await info(page)).springs === 0);
  expect((await info(page)).membranes).toBeGreaterThan(0);
  expect(await look()).toBe("denim");
  expect(await page.getByText("jeans: 99 % cotton, 1 % spandex").isVisible()).toBe(true);
  expect(await page.getByLabel("Method", { exact: true }).inputValue()).toBe("auto");
  for (const summary of await page.locator("summary").all()) await summary.click();
  expect(await choice(page, "Density").inputValue()).toBe("0.324");
  for (const label of ["Structural stiffness", "Damping", "Modulus along the warp"])
    expect(await choice(page, label).isVisible()).toBe(false);

  await choice(page, "Look").selectOption("velvet");
  await until("it looks like velvet", async () => (await set(page))["cloths.0.look"] === "velvet");
  await choice(page, "Fabric").selectOption("interlock");
  await until("it is interlock", async () => (await set(page))["cloths.0.fabric"] === "interlock");
  expect((await set(page))["cloths.0.look"]).toBe("velvet");
  await until("the address has both", async () => /fabric=interlock.*look=velvet/.test(page.url()));
  await page.reload();
  await ready(page);
  expect([await choice(page, "Fabric").inputValue(), await look()]).toEqual(["interlock", "velvet"]);
  await choice(page, "Look").selectOption("jersey"); // the fabric's own is nothing that has to be said
  await becomes(page, { "cloths.0.fabric": "interlock" });

  await choice(page, "Fabric").selectOption("");
  await becomes(page, {});
  await until("it has springs again", async () => (await info(page)).springs > 0);
});

test("an address with a fabric or a look that there is not is refused with those that there are", async () => {
  const page = await open("?scene=hanging&nodes=12&cloths.0.fabric=tweed&cloths.0.look=silk");
  expect(await page.locator("#notice-text").textContent()).toMatch(/cloths\.0\.fabric is “tweed”.*“denim_11oz”/);
  expect(await set(page)).toEqual({ "cloths.0.look": "silk" });
});

test("what was chosen outlives a lost device", async () => {
  const page = await open("?scene=hanging&nodes=12");
  await closeNotice(page);
  const woven = await shown(page);
  await choice(page, "Look").selectOption("denim");
  const before = await changed(page, woven, 0.01);
  await page.evaluate(() => window.weft.world!.device!.destroy());
  await until("it is said", async () => (await page.locator("#notice-text").textContent())!.includes("opened again"));
  await closeNotice(page);
  expect(difference(await shown(page), before)).toBeLessThan(0.001);
  expect(await choice(page, "Look").inputValue()).toBe("denim");
});

test("obstacles are called what they are, and a scene without any is asked for none", async () => {
  const page = await open("?scene=hammock&nodes=12");
  const labels = () =>
    page.locator("#group-look label").evaluateAll((all) =>
      all.filter((one) => (one as HTMLElement).offsetParent !== null).map((one) => one.textContent)
    );
  expect(await labels()).toEqual(["Look", "Colour", "Floor", "Ball 1", "Ball 2", "Ball 3", "Light", "Softness",
    "Azimuth", "Elevation"]);
  await page.locator("#scene").selectOption("hanging");
  await until("it hangs", async () => (await labels()).join() === "Look,Colour,Light,Softness,Azimuth,Elevation");
});

test("on a phone the choices are reached by touch and by keys, and axe finds nothing", async () => {
  const page = await open("?scene=drape-sphere&nodes=12", { viewport: { width: 390, height: 844 }, hasTouch: true,
    bypassCSP: true });
  await page.getByRole("button", { name: "More" }).tap();
  await choice(page, "Look").focus();
  await page.keyboard.press("s"); // to the first that begins with it
  await until("it is silk", async () => (await set(page))["cloths.0.look"] === "silk");
  const box = (await choice(page, "Fabric").boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(390);
  expect(await violations(page)).toEqual([]);
});
