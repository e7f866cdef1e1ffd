import type { Page } from "playwright-core";
import { afterEach, expect, test } from "vitest";
import { expectClean, opened, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";
import type { PageState } from "../../../apps/web/src/state/page_state.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
afterEach(async () => {
  expectClean(seen, here.site);
  await seen.page.context().close();
});

async function open(query: string): Promise<Page> {
  seen = await visit(here.browser, `${here.site.address}${query}`, { reducedMotion: "reduce",
    permissions: ["clipboard-read", "clipboard-write"] });
  await ready(seen.page);
  return seen.page;
}
const state = (page: Page): Promise<PageState> => page.evaluate(() => window.weft.state!);
const notice = (page: Page) => page.locator("#notice-text").textContent();
const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText());

test("what is changed stands in the address, and the copied link opens the same", async () => {
  const page = await open("?scene=pull-sphere&nodes=24");
  await page.keyboard.press("4");
  await page.locator("#canvas").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
  await until("the camera is taken up", async () => (await state(page)).camera !== null);
  await page.getByLabel("Gravity", { exact: true }).fill("4.2");
  await page.getByLabel("Gusts").fill("0.35");
  await page.locator("#formulation").selectOption("spring_centric");
  await until("all is taken up", async () => {
    const { set, view, camera } = await state(page);
    return view === "stretch" && camera !== null && Object.keys(set).length === 3;
  });
  await page.getByRole("button", { name: "Copy link" }).click();
  await until("it is said", async () => (await notice(page)) === "The link is copied.");
  const [link, before] = [await clipboard(page), await state(page)];
  await until("the address is the link", async () => page.url() === link);
  expect(before).toMatchObject({ scene: "pull-sphere", nodes: 24, view: "stretch",
    set: { gravity: [0, -4.2, 0], "wind.gusts": 0.35, "solver.forces": "spring_centric" } });

  await page.goto(link);
  await ready(page);
  const after = await state(page);
  expect({ ...after, camera: null }).toEqual({ ...before, camera: null });
  for (const part of ["eye", "target"] as const)
    for (const axis of [0, 1, 2]) expect(after.camera![part][axis]).toBeCloseTo(before.camera![part][axis]!, 3);
  expect(await page.evaluate(() => [window.weft.world!.view, window.weft.world!.info.nodes])).toEqual(["stretch", 576]);
  await until("the address is as before", async () => page.url() === link);
  expect(await page.locator("#formulation").inputValue()).toBe("spring_centric");
});

test("a method is chosen by its name, stands in the address, and is opened by it", async () => {
  const page = await open("?scene=hanging&nodes=12");
  const substeps = () => page.evaluate(() => window.weft.world!.info.substeps);
  const explicit = await substeps();
  await page.getByLabel("Method", { exact: true }).selectOption("xpbd");
  await until("it is taken up", async () => (await state(page)).set["solver.kind"] === "xpbd");
  await until("the address has it", async () => page.url().includes("solver.kind=xpbd"));
  expect(await page.locator("#formulation").isVisible()).toBe(false);
  expect(await substeps()).not.toBe(explicit);
  await page.reload();
  await ready(page);
  expect(await page.getByLabel("Method", { exact: true }).inputValue()).toBe("xpbd");

  // The scene's own is nothing that has to be said.
  await page.getByLabel("Method", { exact: true }).selectOption("mass_spring");
  await until("it is the scene's again", async () => Object.keys((await state(page)).set).length === 0);
  expect(await substeps()).toBe(explicit);

  // One that the scene cannot have is refused in the core's words, and the scene stays as it was.
  await page.locator("#scene").selectOption("sheet");
  await until("it is open", async () => (await page.locator("#scene-title").textContent())!.startsWith("Thin fabric"));
  await page.getByLabel("Method", { exact: true }).selectOption("pbd");
  await until("it is refused", async () => (await notice(page))!.includes("bending"));
  await until("the choice is as before",
    async () => (await page.getByLabel("Method", { exact: true }).inputValue()) === "multigrid");
});

test("a method that there is not is refused with those that there are", async () => {
  const page = await open("?scene=hanging&nodes=12&solver.kind=cuda");
  expect(await notice(page)).toMatch(/solver\.kind is “cuda”.*“multigrid”.*“mass_spring”/);
  expect((await state(page)).set).toEqual({});
});

test("an address draws and exports the cloth finer than it is simulated", async () => {
  const page = await open("?v=1&scene=hanging&nodes=16&render.subdivide=2");
  expect((await state(page)).set).toEqual({ "render.subdivide": 2 });
  const [nodes, vertices] = await page.evaluate(async () => {
    const world = window.weft.world!;
    const text = new TextDecoder().decode(await world.exportMesh("obj"));
    return [world.info.nodes, text.match(/^v /gm)!.length];
  });
  expect(nodes).toBe(256);
  expect(vertices).toBe(61 * 61); // 15 cells a side, each halved twice
});

test("a view that the scene has nothing to show in is said, and another is shown", async () => {
  const page = await open("?v=1&scene=hanging&nodes=16&view=contacts");
  expect(await notice(page)).toBe(
    "View contacts shows the pairs of contact method proximity, and this scene has none.",
  );
  expect((await state(page)).view).toBe("textured");
  expect(await page.evaluate(() => window.weft.world!.view)).toBe("textured");
  expect(await page.locator("#views input:checked").inputValue()).toBe("textured");
});

test("the readings are copied as JSON, with what was loaded and how it went", async () => {
  const page = await open("?scene=hanging&nodes=16");
  await page.evaluate(() => window.weft.world!.step(4));
  await page.getByRole("button", { name: "Measure passes" }).click();
  await until("passes are listed", async () => (await page.locator("#passes dt").count()) > 0);
  await page.getByRole("button", { name: "Copy readings" }).click();
  await until("it is said", async () => /readings is copied/.test((await notice(page)) ?? ""));
  const copied = JSON.parse(await clipboard(page)) as Record<string, unknown>;
  expect(copied).toMatchObject({ weft: 1, state: { scene: "hanging", nodes: 16 },
    loaded: { nodes: 256, substeps: await page.evaluate(() => window.weft.world!.info.substeps) },
    statistics: { frames: 4, nonfinite: 0 } });
  expect((copied["passes"] as { kernel: string; milliseconds: number }[]).map(({ kernel }) => kernel)).toContain(
    "advance_grid",
  );
});

for (const [query, said, kept] of [
  ["?v=1&scene=hanging&nodes=16&drag=1e9", "drag is “1e9”, but must be a number from 0 to 10000 1/s", {}],
  ["?v=1&scene=hanging&nodes=16&gravity=0,-3&drag=2",
    "gravity is “0,-3”, but must be 3 numbers, each from -10000 to 10000 m/s²", { drag: 2 }],
  ["?v=1&scene=hanging&nodes=16&contact.method=<script>&time.substeps=1.5",
    "contact.method is “<script>”, but must be one of “none”, “paper”, “bvh”, “proximity”, " +
    "and one more value is refused", {}],
  ["?v=1&scene=hanging&nodes=16&eye=1,2,3&target=1,2,3&fov=40", "eye is “1,2,3”, but must be another point than target",
    {}],
  ["?v=1&scene=hanging&nodes=16&view=__proto__", "view is “__proto__”, but must be one of textured", {}],
] as const)
  test(`an address that says ${query.split("&").slice(3).join("&")} is refused in one sentence`, async () => {
    const page = await open(query);
    expect(await notice(page)).toContain(`In the page's address ${said}`);
    expect(await state(page)).toMatchObject({ scene: "hanging", nodes: 16, view: "textured", camera: null });
    expect((await state(page)).set).toEqual(kept);
    expect(await page.evaluate(() => window.weft.world!.info.nodes)).toBe(256);
  });

test("a version, scene or size that the page does not know is refused", async () => {
  const page = await open("?v=2&scene=hanging");
  expect(await notice(page)).toContain("v is “2”, but must be 1");
  await page.goto(`${here.site.address}?scene=../../etc/passwd&nodes=99999999`);
  await ready(page);
  expect(await notice(page)).toContain(
    "scene is “../../etc/passwd”, but must be one of the page's list, and one more value is refused",
  );
  expect(await state(page)).toMatchObject({ scene: "breeze", nodes: null });
});

test("values that are each good but that the core refuses together leave the scene as it is", async () => {
  const page = await open("?v=1&scene=hanging&nodes=16&cloths.0.node_mass=2");
  expect(await notice(page)).toMatch(/density.*node_mass|node_mass.*density/);
  expect(await state(page)).toMatchObject({ scene: "hanging", set: {} });
});

test("more nodes than the adapter has room for are refused with both numbers, before anything is taken", async () => {
  const page = await open("?v=1&scene=hanging&nodes=16000");
  expect(await notice(page)).toMatch(
    /^A cloth of 256,000,000 nodes needs a buffer of [\d.]+ GB, more than this adapter's [\d.]+ [MG]B\.$/,
  );
  expect(await state(page)).toMatchObject({ scene: "hanging", nodes: null });
});
