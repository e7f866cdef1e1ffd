import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { violations } from "../axe.ts";
import { composed, difference, pages, picture, ready, until } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const open = pages({ reducedMotion: "reduce", permissions: ["clipboard-read", "clipboard-write"] });

/** Frame and state hash of the left side and of the right one; null where there is none. */
const sides = (page: Page) =>
  page.evaluate(async () => {
    const { world, other } = window.weft;
    const read = async (one: typeof world) =>
      one && { frames: (await one.step(0)).frames, hash: (await one.snapshot()).hash };
    return { left: await read(world), right: await read(other) };
  });
const compared = (page: Page) => page.evaluate(() => window.weft.other !== null);
const compare = (page: Page) => page.evaluate(() => window.weft.state!.compare);
const notice = async (page: Page) => (await page.locator("#notice-text").textContent())!;
const search = (page: Page) => new URL(page.url()).search;

async function step(page: Page, frames: number): Promise<void> {
  const start = (await sides(page)).left!.frames;
  for (let i = 1; i <= frames; i++) {
    await page.locator("#step").click();
    await until(`frame ${start + i}`, async () => (await sides(page)).left!.frames === start + i);
  }
}
async function alone(page: Page, query: string, frames: number): Promise<string> {
  await page.goto(new URL(query, page.url()).href);
  await ready(page);
  expect(await compared(page)).toBe(false);
  await step(page, frames);
  return (await sides(page)).left!.hash;
}
/** All that was asked of both worlds is drawn and on the screen. */
async function shown(page: Page): Promise<Uint8Array> {
  await composed(page);
  await sides(page);
  await composed(page);
  return picture(page);
}

test("both sides go in lock step, to the bits that each goes to alone, and playing keeps them together", async () => {
  const page = await open("?scene=hanging&nodes=12");
  await step(page, 2);
  await page.getByLabel("Other method").selectOption("xpbd");
  await until("both are there", () => compared(page));
  await until("at rest", async () => (await sides(page)).left!.frames === 0);
  await until("the address says so",
    async () => search(page) === "?v=1&scene=hanging&nodes=12&compare=solver.kind=xpbd");
  await step(page, 3);
  const { left, right } = await sides(page);
  expect([left!.frames, right!.frames]).toEqual([3, 3]);
  expect(right!.hash).not.toBe(left!.hash);
  await until("each side is labelled",
    async () =>
      /^mass_spring, \d+\ssubsteps, [\d.,]+\sms$/.test((await page.locator("#left-side").textContent())!) &&
      /^xpbd, \d+\ssubsteps, [\d.,]+\sms$/.test((await page.locator("#right-side").textContent())!));

  await page.locator("#play").click();
  await until("it has played", async () => (await sides(page)).left!.frames >= 8);
  await page.locator("#play").click();
  await until("it stands", async () => {
    const { left, right } = await sides(page);
    await page.waitForTimeout(100);
    return left!.frames === right!.frames && left!.frames === (await sides(page)).left!.frames;
  });
  await page.locator("#reset").click();
  await until("both are at rest", async () => {
    const now = await sides(page);
    return now.left!.frames === 0 && now.right!.frames === 0;
  });

  // The left side goes on by itself from where it is.
  await step(page, 2);
  const before = (await sides(page)).left;
  await page.getByRole("button", { name: "End the comparison" }).click();
  await until("it is alone", async () => !(await compared(page)));
  expect((await sides(page)).left).toEqual(before);
  await until("the address says so", async () => search(page) === "?v=1&scene=hanging&nodes=12");
  await step(page, 1);
  expect((await sides(page)).left!.hash).toBe(left!.hash);

  expect(await alone(page, "?scene=hanging&nodes=12", 3)).toBe(left!.hash);
  expect(await alone(page, "?scene=hanging&nodes=12&solver.kind=xpbd", 3)).toBe(right!.hash);
});

test("the divider shows more of one side, by pointer and by key; camera, view and parameters are of both", async () => {
  const page = await open("?scene=hanging&nodes=12&compare=nodes=4&divider=100&view=wireframe");
  expect(await compare(page)).toEqual({ other: { nodes: 4 }, divider: 100 });
  await step(page, 1);
  const left = await shown(page);
  const divider = page.getByLabel("Divider between both sides");
  await divider.focus();
  await page.keyboard.press("Home");
  expect(await divider.inputValue()).toBe("0");
  const right = await shown(page);
  const handle = (await page.locator(".divider-line svg").boundingBox())!;
  const box = (await page.locator("#canvas").boundingBox())!;
  expect(handle.x).toBeCloseTo(box.x, 0);
  await page.mouse.move(handle.x + 22, handle.y + 22);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, handle.y + 22, { steps: 4 });
  await page.mouse.up();
  expect(await divider.inputValue()).toBe("50");
  await page.locator("#canvas").focus(); // no outline about the handle
  const both = await shown(page);
  // Columns at a tenth from either edge, below the labels and above the handle, are those of one side alone.
  const columns = (image: Uint8Array, from: number, to: number) => {
    const out: number[] = [];
    for (let y = Math.round(0.3 * box.height); y < 0.8 * box.height; y++)
      out.push(
        ...image.subarray(4 * (y * box.width + Math.round(from * box.width)),
          4 * (y * box.width + Math.round(to * box.width))),
      );
    return Uint8Array.from(out);
  };
  const apart = (a: Uint8Array, b: Uint8Array, from: number, to: number) =>
    difference(columns(a, from, to), columns(b, from, to));
  expect(apart(both, left, 0.1, 0.45)).toBeLessThan(0.0005);
  expect(apart(both, right, 0.1, 0.45)).toBeGreaterThan(0.003); // the lines of 144 nodes, and of 16
  expect(apart(both, right, 0.55, 0.9)).toBeLessThan(0.0005);
  expect(apart(both, left, 0.55, 0.9)).toBeGreaterThan(0.003);
  await until("the address has left it out", async () => search(page).endsWith("&view=wireframe&compare=nodes=4"));

  const cameras = () => page.evaluate(() => [window.weft.world!.camera, window.weft.other!.camera] as const);
  const [start] = await cameras();
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
  await until("both are turned", async () => {
    await sides(page);
    const [a, b] = await cameras();
    return JSON.stringify(a) === JSON.stringify(b) && JSON.stringify(a) !== JSON.stringify(start);
  });
  await page.keyboard.press("1");
  await until("both have the view",
    () => page.evaluate(() => window.weft.other!.view === "textured" && window.weft.world!.view === "textured"));

  // On the right there is nothing to take hold of.
  await page.mouse.dblclick(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  await until("it is said", async () => /no cloth to pin/.test(await notice(page)));
});

test("a link opens the same comparison; parameters act on both sides, and restart both if at all", async () => {
  const page = await open(
    "?v=1&scene=hanging&nodes=12&compare=solver.kind=multigrid:cloths.0.fabric=denim_11oz:nodes=8&divider=30",
  );
  expect(await page.getByLabel("Other grid").inputValue()).toBe("8");
  const asked = { other: { "solver.kind": "multigrid", "cloths.0.fabric": "denim_11oz", nodes: 8 }, divider: 30 };
  expect(await compare(page)).toEqual(asked);
  await page.getByRole("button", { name: "Copy link" }).click();
  await until("it is said", async () => (await notice(page)) === "The link is copied.");
  await page.goto(await page.evaluate(() => navigator.clipboard.readText()));
  await ready(page);
  expect(await compare(page)).toEqual(asked);
  expect(await page.evaluate(() => [window.weft.world!.info.nodes, window.weft.other!.info.nodes])).toEqual([144, 64]);
  expect(await page.evaluate(() => window.weft.other!.info.solver)).toBe("multigrid");

  await page.getByLabel("Gravity", { exact: true }).fill("4.2");
  await step(page, 2);
  const live = await sides(page);
  await page.getByLabel("Substeps per frame").evaluate((field) => {
    (field.closest("details") as HTMLDetailsElement).open = true;
  });
  await page.getByLabel("Substeps per frame").fill("60");
  await page.getByLabel("Substeps per frame").press("Enter");
  await until("both are made anew",
    async () => await compared(page) && /Substeps per frame60/.test((await page.locator("#facts").textContent())!));
  await step(page, 2);
  const { left, right } = await sides(page);
  expect(right!.hash).toBe(live.right!.hash); // another resolution chooses its substeps again
  expect(left!.hash).not.toBe(live.left!.hash);
  expect(await alone(page, "?scene=hanging&nodes=12&gravity=0,-4.2,0&time.substeps=60", 2)).toBe(left!.hash);
  expect(
    await alone(page, "?scene=hanging&nodes=8&gravity=0,-4.2,0&cloths.0.fabric=denim_11oz&solver.kind=multigrid", 2),
  ).toBe(right!.hash);
});

test("another side that is refused leaves the page as it was, with a sentence", async () => {
  const page = await open("?scene=breeze&nodes=24&compare=nodes=8"); // too coarse for one of its pins
  expect(await notice(page)).toMatch(/^The other side cannot be shown\. .*pins\[2\] selects none/);
  expect([await compared(page), await compare(page), await page.locator("#sides").isVisible()]).toEqual([false, null,
    false]);

  // Of two sides the one that was there before stays.
  await page.goto(new URL("?scene=sheet&nodes=12&compare=nodes=8", page.url()).href);
  await ready(page);
  await step(page, 2);
  const before = await sides(page);
  expect(before.right!.frames).toBe(2);
  await page.getByLabel("Other method").selectOption("pbd");
  await until("it is refused", async () => /^The other side cannot be shown\. .*bending/.test(await notice(page)));
  await until("the list says what is shown", async () => (await page.getByLabel("Other method").inputValue()) === "");
  expect(await sides(page)).toEqual(before);
  expect(await compare(page)).toEqual({ other: { nodes: 8 }, divider: 50 });

  // Each would have room alone, but the module's memory is counted for both.
  await page.goto(new URL("?scene=hanging&nodes=64&compare=nodes=2093", page.url()).href);
  await ready(page);
  expect(await notice(page)).toMatch(
    /^The other side cannot be shown\. 2 cloths of 4,384,745 nodes together need .* more than/,
  );
});

test("a device that is lost on the right ends the comparison, one on the left is opened again with both", async () => {
  const page = await open("?scene=hanging&nodes=12&compare=nodes=8");
  await step(page, 1);
  await page.evaluate(() => window.weft.world!.device!.destroy());
  await until("it is said", async () => /has been opened again/.test(await notice(page)));
  await until("both are there", () => compared(page));
  await step(page, 1);
  const before = await sides(page);
  expect(before.right!.frames).toBe(1);
  await page.evaluate(() => window.weft.other!.device!.destroy());
  await until("it is said", async () => /^On the right: The GPU device is lost/.test(await notice(page)));
  expect(await compare(page)).toBe(null);
  expect((await sides(page)).left).toEqual(before.left);
});

test("an address that compares what cannot be compared is refused in one sentence", async () => {
  const page = await open("?v=1&scene=hanging&nodes=12&compare=drag=2:nodes=1:solver.kind=cuda&divider=300");
  expect(await notice(page)).toBe("In the page's address a key of compare is “drag”, but must be one of solver.kind, " +
    "cloths.0.fabric, nodes, and 3 more values are refused; what the scene has is used instead.");
  expect(await compare(page)).toBe(null);
});

for (const [device, viewport] of [["desktop", { width: 1280, height: 800 }], ["phone", { width: 360,
  height: 740 }]] as const)
  test(`on a ${device} axe finds nothing in a comparison, and all of it is within the window`, async () => {
    const page = await open("?scene=hanging&nodes=12&compare=nodes=8", { viewport, bypassCSP: true });
    for (const id of ["left-side", "right-side", "divider"]) {
      const box = (await page.locator(`#${id}`).boundingBox())!;
      expect(box.x).toBeGreaterThanOrEqual(0);
      expect(box.x + box.width).toBeLessThanOrEqual(viewport.width);
    }
    if (device === "phone") {
      const handle = (await page.locator(".divider-line svg").boundingBox())!;
      expect(handle.y + handle.height).toBeLessThanOrEqual((await page.locator("#controls").boundingBox())!.y);
      await page.getByRole("button", { name: "More" }).click();
    }
    for (const id of ["other-solver", "other-fabric", "other-resolution", "compare-end"]) {
      const box = (await page.locator(`#${id}`).boundingBox())!;
      expect(box.height).toBeGreaterThanOrEqual(44);
      expect(box.x + box.width).toBeLessThanOrEqual(viewport.width);
    }
    expect(await violations(page)).toEqual([]);
  });
