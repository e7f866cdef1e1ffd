// The cloth's state, saved on the page and opened there again, and in the package.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, test } from "vitest";
import { createWorld } from "weft-cloth";
import { ROOT } from "../chromium.ts";
import { gpu } from "../node_gpu.ts";
import { expectClean, frames, hash, opened, play, ready, running, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
const NODES = 24;

let seen: Visit;
let page: Page;
let chosen: { name: string; mimeType: string; buffer: Buffer };
beforeAll(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=${NODES}`, { reducedMotion: "reduce" });
  page = seen.page;
  await ready(page);
  page.on("filechooser", (chooser) => void chooser.setFiles(chosen)); // from now on none is the browser's own
});
beforeEach(async () => {
  await page.keyboard.press("r");
  await until("it is at rest", async () => (await frames(page)) === 0);
  await closeNotice();
});
afterAll(async () => {
  expectClean(seen, here.site);
  await page.context().close();
});

const closeNotice = async () => {
  if (await page.locator("#notice").isVisible()) await page.locator("#notice-close").click();
};
const notice = async () =>
  (await page.locator("#notice").isVisible()) ? (await page.locator("#notice-text").textContent())! : "";
const said = () => page.locator("#announcer").textContent();
const step = (count: number) => page.evaluate((n) => window.weft.world!.step(n).then(() => undefined), count);
const pins = () => page.evaluate(() => [...window.weft.pins]);

/** By the keyboard alone. */
async function save(): Promise<{ name: string; bytes: Buffer }> {
  await page.locator("#save-state").focus();
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** As a visitor who presses the button and chooses the file. */
async function open(name: string, buffer: Buffer): Promise<void> {
  chosen = { name, mimeType: "", buffer };
  await page.locator("#open-state").focus();
  await page.keyboard.press("Enter");
}

/** Presses twice where a node is drawn. */
async function doubleClick(node: number): Promise<void> {
  const [x, y] = await page.evaluate(async (n) => {
    const world = window.weft.world!;
    const [x, y, z] = (await world.positions()).subarray(3 * n, 3 * n + 3);
    const [right, up] = world.project([x!, y!, z!]);
    const box = document.querySelector("#canvas")!.getBoundingClientRect();
    return [box.left + (box.width * (right + 1)) / 2, box.top + (box.height * (1 - up)) / 2] as const;
  }, node);
  await page.mouse.dblclick(x, y);
}

test("a saved state goes on to the same bits on the page and in Node", async () => {
  await step(3);
  const { name, bytes } = await save();
  expect(name).toBe("hanging-00003.weft");
  await until("it is said", async () => (await said()) === "Saved hanging-00003.weft.");
  await step(2);
  const whole = await hash(page);
  await open(name, bytes);
  await until("it is said", async () => (await said()) === "Opened hanging-00003.weft.");
  expect(await notice()).toBe(""); // it is of this very browser
  expect(await frames(page)).toBe(3);
  await step(2);
  expect(await hash(page)).toBe(whole);

  const world = await createWorld({ scene: readFileSync(join(ROOT, "scenes/hanging.json"), "utf8"), canvas: null, gpu,
    set: { "cloths.0.grid": [NODES, NODES] } });
  await world.openState(bytes);
  await world.step(2);
  expect((await world.snapshot()).hash).toBe(whole);
  const fromNode = Buffer.from(await world.saveState());
  world.dispose();
  await open("from-node.weft", fromNode);
  await until("it is opened", async () => (await said()) === "Opened from-node.weft.");
  expect([await hash(page), await frames(page)]).toEqual([whole, 5]);
});

test("what was pinned is pinned again, and nothing else", async () => {
  await doubleClick(12 * NODES + 12);
  await until("it is pinned", async () => (await pins()).length === 1);
  const [node] = await pins();
  await step(2);
  const { name, bytes } = await save();
  await page.keyboard.press("u");
  await until("it is free", async () => (await pins()).length === 0);
  await doubleClick(16 * NODES + 6);
  await until("another is pinned", async () => (await pins()).length === 1 && (await pins())[0] !== node);
  await open(name, bytes);
  await until("the first is pinned again", async () => (await pins())[0] === node);
  expect(await pins()).toHaveLength(1);
  expect(await page.locator("#pins circle").count()).toBe(1);
  expect(await page.locator("#pin-count").textContent()).toMatch(/^1 of 1,023 pinned/);
  await page.locator("#unpin").click(); // the world holds it too, or it would refuse to let it go
  await until("it is free", async () => (await pins()).length === 0);
  await step(1);
  expect(await notice()).toBe("");
});

test("a state can be dropped, or chosen where meshes are, while the cloth plays", async () => {
  await step(2);
  const { name, bytes } = await save();
  await page.locator("#file-chooser").setInputFiles({ name: "chosen.weft", mimeType: "", buffer: bytes });
  await until("it is opened", async () => (await said()) === "Opened chosen.weft.");
  await page.getByRole("button", { name: "Play" }).click();
  await play(page, 4);
  const transfer = await page.evaluateHandle(([name, base64]) => {
    const made = new DataTransfer();
    made.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
    return made;
  }, [name, bytes.toString("base64")] as const);
  await page.dispatchEvent("#canvas", "drop", { dataTransfer: transfer });
  await until("it is opened", async () => (await said()) === `Opened ${name}.`);
  expect(await running(page)).toBe(true);
  await play(page, 1);
  await page.getByRole("button", { name: "Pause" }).click();
  await step(0);
  const at = await frames(page);
  const end = await hash(page);
  await open(name, bytes);
  await until("it is back", async () => (await frames(page)) === 2);
  await step(at - 2);
  expect(await hash(page)).toBe(end);
});

test("a checkpoint of the command line goes on to its bits, and the page warns of others", async () => {
  const folder = mkdtempSync(join(tmpdir(), "weft-page-"));
  const weft = (...more: string[]) =>
    JSON.parse(
      execFileSync(join(ROOT, "build/weft"), ["run", join(ROOT, "scenes/hanging.json"), "--json", "--nodes",
        String(NODES), ...more], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }),
    ) as Record<string, string>;
  weft("--frames", "2", "--out", folder, "--no-pictures", "--checkpoint-every", "2");
  const bytes = readFileSync(join(folder, "checkpoint_00002.weft"));
  rmSync(folder, { recursive: true });
  await open("checkpoint_00002.weft", bytes);
  await until("it is opened", async () => (await frames(page)) === 2);
  expect(await notice()).toMatch(/^The state was saved by weft .*: bits may differ from those of a run that goes on /);
  expect(await page.locator("#notice").getAttribute("data-tone")).toBe("warning");
  await step(2);
  expect(await hash(page)).toBe(weft("--frames", "4")["state_hash"]);
});

test("a state of another scene, broken ones and a mesh are refused by a sentence, and the cloth plays on", async () => {
  await step(1);
  const { bytes } = await save();
  await page.locator("#resolution").selectOption("32");
  await until("32 nodes a side", () =>
    page.evaluate(() => {
      try {
        return window.weft.world!.info.nodes === 32 * 32;
      } catch {
        return false;
      }
    }));
  await step(2);
  await page.getByRole("button", { name: "Play" }).click();
  for (const [name, file, sentence] of [
    ["coarse.weft", bytes, /^coarse\.weft: The saved state is of another scene: its hash is [0-9a-f]{16}, that of /],
    ["cut.weft", bytes.subarray(0, 900), /^cut\.weft: The saved state should have \d+ bytes; it has 900\.$/],
    ["mesh.obj", Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), /^mesh\.obj: This is no saved state of weft: /],
    ["empty.weft", Buffer.alloc(0), /^empty\.weft: A saved state begins with 32 bytes; here there are 0\.$/],
  ] as const) {
    const from = await frames(page);
    await open(name, file);
    await until(`a sentence about ${name}`, async () => (await notice()) !== "");
    expect(await notice()).toMatch(sentence);
    expect(await page.locator("#notice").getAttribute("data-tone")).toBe("error");
    expect(await running(page)).toBe(true);
    await play(page, 1);
    expect(await frames(page)).toBeGreaterThan(from);
    await closeNotice();
  }
  await page.getByRole("button", { name: "Pause" }).click();
});
