// A visitor's files: meshes and scenes in, shapes, pictures and videos out.
import { readFile } from "node:fs/promises";
import { readMesh } from "weft-cloth";
import type { Download, Page } from "playwright-core";
import { beforeAll, afterAll, expect, test } from "vitest";
import { brightness, difference, expectClean, opened, picture, play, positions, ready, until, visit,
  type Visit } from "./browser.js";
import { dome, glb, obj, off, packed, ply, stl } from "./mesh_bytes.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
const MESH = dome(9); // 81 vertices, 128 triangles

let seen: Visit;
let page: Page;
beforeAll(async () => {
  // Less motion: the page waits for Play, so that what is opened costs this software adapter no frame that is not asked
  // for.
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=24`, { reducedMotion: "reduce" });
  page = seen.page;
  await ready(page);
  await closeNotice(); // that it waits
});
afterAll(async () => {
  expectClean(seen, here.site);
  await page.context().close();
});

const dialog = () => page.locator("#mesh-dialog");
const notice = async () =>
  (await page.locator("#notice").isVisible()) ? (await page.locator("#notice-text").textContent())! : "";
/** 0 while nothing is loaded. */
const nodes = () =>
  page.evaluate(() => {
    try {
      return window.weft.world!.info.nodes;
    } catch {
      return 0;
    }
  });
const closeNotice = () =>
  page.locator("#notice").evaluate((box: HTMLElement) => {
    box.hidden = true;
  });
const give = (...files: readonly [string, Buffer][]) =>
  page.locator("#file-chooser").setInputFiles(files.map(([name, buffer]) => ({ name, mimeType: "", buffer })));

const step = () => page.evaluate(async () => void (await window.weft.world!.step(1)));
/** Chooses a shipped scene, so that what follows is seen to replace it. */
async function openHanging(): Promise<void> {
  await page.locator("#scene").selectOption("hanging");
  await until("hanging is shown", async () => page.url().endsWith("?v=1&scene=hanging"));
  await page.locator("#resolution").selectOption("32");
  await until("32 nodes a side", async () => (await nodes()) === 1024);
}
const title = () =>
  page.evaluate(() => document.querySelector<HTMLSelectElement>("#scene")!.selectedOptions[0]?.textContent ?? "");

for (const [name, bytes, role] of [
  ["dome.obj", obj(MESH), "Cloth"],
  ["dome.ply", ply(MESH), "Obstacle"],
  ["dome.stl", stl(MESH), "Cloth"],
  ["dome.off", off(MESH), "Cloth"],
  ["dome.glb", glb(MESH), "Obstacle"],
  ["dome.GLB", glb(MESH), "Cloth"],
  ["dome.obj.gz", packed(obj(MESH)), "Cloth"],
] as const)
  test(`${name} becomes ${role.toLowerCase()} and moves`, async () => {
    await give([name, bytes]);
    await until("the dialog", () => dialog().isVisible());
    expect(await page.locator("#mesh-title").textContent()).toBe(name);
    expect(await page.locator("#mesh-facts").textContent())
      .toBe("81 vertices, 128 triangles, 2 × 0.354 × 2 in the file's unit.");
    await page.getByRole("radio", { name: role }).check();
    await page.locator("#mesh-length").fill("0.8");
    expect(await page.locator("#mesh-size").textContent()).toBe("0.8 × 0.142 × 0.8 m");
    await page.getByRole("button", { name: "Open", exact: true }).click();
    const expected = role === "Cloth" ? [`${name} as cloth`, 81] : [`Draped over ${name}`, 64 * 64];
    await until("it is shown", async () => (await title()) === expected[0] && (await nodes()) === expected[1]);
    await until("the address names no scene", async () => !page.url().includes("scene="));
    if (role === "Obstacle") { // the sheet can be finer or coarser, as a shipped scene's
      await page.locator("#resolution").selectOption("32");
      await until("32 nodes a side", async () => (await nodes()) === 1024);
    }
    const before = await positions(page);
    if (role === "Cloth") { // as large as was asked for
      const x = before.filter((_, i) => i % 3 === 0);
      expect(Math.max(...x) - Math.min(...x)).toBeCloseTo(0.8, 4);
    }
    await step();
    const after = await positions(page);
    expect(after.every(Number.isFinite)).toBe(true);
    expect(after[1]!).toBeLessThan(before[1]!); // it falls
    expect(await notice()).toBe("");
  });

test("a mesh can be dropped, and what is asked then be declined", async () => {
  await openHanging();
  const before = await nodes();
  const transfer = await page.evaluateHandle((text) => {
    const made = new DataTransfer();
    made.items.add(new File([text], "dome.obj"));
    return made;
  }, obj(MESH).toString());
  await page.dispatchEvent("#canvas", "dragover", { dataTransfer: transfer });
  expect(await page.locator(".drop-hint").isVisible()).toBe(true);
  await page.dispatchEvent("#canvas", "drop", { dataTransfer: transfer });
  expect(await page.locator(".drop-hint").isVisible()).toBe(false);
  await until("the dialog", () => dialog().isVisible());
  await page.locator("#mesh-length").fill("11");
  await page.keyboard.press("Enter");
  expect(await page.locator("#mesh-size").textContent()).toBe("The length is 11 m; it must be from 0.1 to 10 m.");
  await page.keyboard.press("2"); // a digit of the length, and no view
  expect(await page.locator("#mesh-length").inputValue()).toBe("112");
  await page.keyboard.press("Escape");
  expect(await dialog().isVisible()).toBe(false);
  expect([await title(), await nodes()]).toEqual(["Hanging", before]);
});

test("on a phone what is asked is in the window, and can be touched", async () => {
  const { width, height } = page.viewportSize()!;
  await page.setViewportSize({ width: 360, height: 640 });
  await give(["a mesh with a name that is a good deal longer than a phone is wide.obj", obj(MESH)]);
  await until("the dialog", () => dialog().isVisible());
  const box = (await dialog().boundingBox())!;
  expect([box.x >= 0, box.y >= 0, box.x + box.width <= 360, box.y + box.height <= 640]).toEqual([true, true, true,
    true]);
  expect(await dialog().evaluate((element) => element.scrollWidth - element.clientWidth)).toBeLessThanOrEqual(0);
  const small = await dialog().locator("button, input").evaluateAll((controls) =>
    controls
      .map((control) => (control.closest("label") ?? control).getBoundingClientRect())
      .filter(({ width, height }) => Math.min(width, height) < 44)
  );
  expect(small).toEqual([]);
  expect(await page.evaluate(() => document.activeElement?.closest("dialog")?.id)).toBe("mesh-dialog");
  await page.getByRole("button", { name: "Cancel" }).click();
  expect(await dialog().isVisible()).toBe(false);
  await page.setViewportSize({ width, height });
});

const SCENE = (mesh: string, more = {}) =>
  Buffer.from(JSON.stringify({
    format: "weft-scene/1",
    title: "Brought along",
    contact: { method: "none" },
    cloths: [{ mesh, density: 0.3, pins: [{ nodes: [0, 8] }] }],
    ...more,
  }));

test("a scene is opened with the mesh that came along, and can be chosen again", async () => {
  await give(["mine.json", SCENE("meshes/dome.obj")], ["dome.obj.gz", packed(obj(MESH))]);
  await until("it is shown", async () => (await title()) === "Brought along" && (await nodes()) === 81);
  await step();
  await openHanging();
  await page.locator("#scene").selectOption({ label: "Brought along" });
  await until("it is shown again", async () => (await title()) === "Brought along" && (await nodes()) === 81);
  expect(await notice()).toBe("");
});

test("a scene may name a mesh of the page's own", async () => {
  await give(["mine.json", SCENE("sphere", { title: "A sphere of cloth" })]);
  await until("it is shown", async () => (await title()) === "A sphere of cloth" && (await nodes()) === 382);
});

const loop = (json: string) => json.replace(`{"mesh":0}`, `{"mesh":0,"children":[0]}`);
const text = (lines: string) => Buffer.from(lines);
const HOSTILE: readonly [what: string, files: readonly [string, Buffer][], sentence: RegExp][] = [
  ["truncated", [["a.ply", ply(MESH).subarray(0, 900)]], /a\.ply: .*(ends|rows)/],
  ["with a huge count", [["a.ply", text(`${ply(MESH)}`.replace("vertex 81", "vertex 4000000000"))]],
    /4000000000 rows.*at most/],
  ["with NaN", [["a.obj", text("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]], /a\.obj: Line 1 .*nan/],
  ["of an unknown kind", [["a.fbx", text("Kaydara")]], /a\.fbx: The name does not end in \.glb, \.obj/],
  ["without triangles", [["a.obj", text("v 0 0 0\n")]], /no triangles/],
  ["without an area", [["a.obj", text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")]],
    /None of the 1 triangles of the mesh has an area/],
  ["with a ring of nodes", [["a.glb", glb(MESH, loop)]], /nodes\[0\] is reached twice/],
  ["with a count past its bytes", [["a.glb", glb(MESH, (json) => json.replace(`"count":81`, `"count":82`))]],
    /accessors\[0\]\.count is 82; .* 0 to 81/],
  ["with broken gzip data", [["a.obj.gz", Buffer.from([0x1f, 0x8b, 8, 0, 1, 2, 3])]],
    /a\.obj\.gz: its gzip data are broken/],
  ["that unpacks to too much", [["a.obj.gz", packed(Buffer.alloc(70_000_000))]],
    /a\.obj\.gz unpacks to more than the limit of 64\.0 MB/],
  ["that are two meshes", [["a.obj", obj(MESH)], ["b.obj", obj(MESH)]], /one mesh at a time.*2 meshes/],
  ["of a scene that is too long", [["a.json", Buffer.alloc(16_100_000, 32)]],
    /a\.json: 16\.1 MB are more than the limit of 16\.0 MB/],
  ["of JSON that is none", [["a.json", text("{")]], /line 1, column/],
  ["of a scene with a key that is not known", [["a.json", SCENE("dome.obj", { gravty: 1 })], ["dome.obj", obj(MESH)]],
    /gravty/],
  ["of a scene whose mesh is missing", [["a.json", SCENE("dome.obj")]],
    /a\.json names the mesh dome\.obj, which is neither/],
  ["of a scene with too many nodes", [["a.json",
    text(JSON.stringify({ format: "weft-scene/1", cloths: [{ grid: [1500, 1000], size: [1, 1], density: 1 }] }))]],
    /1,500,000 nodes are more than the limit of 1,048,576/],
  ["of a scene with too many steps", [["a.json", text(
    JSON.stringify({ format: "weft-scene/1", time: { substeps: 5000 },
      cloths: [{ grid: [4, 4], size: [1, 1], density: 1 }] }),
  )]], /5000 steps a frame, more than the page's limit of 1024/],
];

test("files that cannot be opened are refused with one sentence, and the scene before stays", async () => {
  await openHanging();
  const before = await nodes();
  for (const [what, files, expected] of HOSTILE) {
    await closeNotice();
    await give(...files);
    await until(`a sentence about a file ${what}`, async () => (await notice()) !== "" || (await dialog().isVisible()));
    const said = await notice();
    expect(said, what).toMatch(expected);
    expect(said.length, what).toBeLessThan(320);
    expect(said, what).toMatch(/[.?]$/);
    await until("the scene before is there", async () =>
      (await title()) === "Hanging" && !(await page.locator("#veil").isVisible()));
    expect(await nodes(), what).toBe(before);
  }
  await step();
});

test("a file that is too large is refused before it is read", async () => {
  await page.evaluate(() => {
    const made = new DataTransfer();
    made.items.add(new File([new Uint8Array(65_000_000)], "big.ply"));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: made, cancelable: true }));
  });
  await until("it is said", async () => (await notice()) === "big.ply: 65.0 MB are more than the limit of 64.0 MB.");
  expect(await title()).toBe("Hanging");
});

test("reading that takes too long is ended, and the cloth moves on meanwhile", async () => {
  await page.route("**/mesh_worker*.js",
    async (route) => route.fulfill({ response: await route.fetch(), body: "for (;;);" }));
  await give(["slow.ply", ply(MESH)]);
  await until("it is being read", () => page.locator("#veil").isVisible());
  await page.getByRole("button", { name: "Play" }).click();
  await play(page, 3);
  await page.getByRole("button", { name: "Pause" }).click();
  await until("it is given up", async () => (await notice()).includes("slow.ply was given up"));
  expect(await notice()).toContain("longer than the limit of 10 s");
  expect(await page.locator("#veil").isVisible()).toBe(false);
  await page.unroute("**/mesh_worker*.js");
  await give(["quick.ply", ply(MESH)]);
  await until("another is read", () => dialog().isVisible());
  await page.keyboard.press("Escape");
});

test("of two files that are read at the same time the one that was chosen last is asked about", async () => {
  let waiting = true;
  await page.route("**/mesh_worker*.js", async (route) => {
    const first = waiting;
    waiting = false;
    if (first) await new Promise((wake) => setTimeout(wake, 2500));
    await route.continue();
  });
  let ended = 0;
  page.on("worker", (worker) =>
    worker.on("close", () => {
      ended += 1;
    }));
  await give(["first.ply", ply(MESH)]);
  await give(["last.ply", ply(MESH)]);
  await until("the dialog", () => dialog().isVisible());
  await until("both have answered", async () => ended === 2);
  expect(await page.locator("#mesh-title").textContent()).toBe("last.ply");
  await page.unroute("**/mesh_worker*.js");
  await page.keyboard.press("Escape");
});

// Out of the page

async function saved(press: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download") as Promise<Download>, press()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** x, y, z of every vertex of a binary PLY. */
function positionsOf(file: Uint8Array): number[] {
  const header = Buffer.from(file).toString("latin1").split("end_header\n")[0]! + "end_header\n";
  const vertices = Number(/element vertex (\d+)/.exec(header)![1]);
  const view = new DataView(file.buffer, file.byteOffset + header.length);
  return Array.from({ length: 3 * vertices }, (_, i) => view.getFloat32(4 * i, true));
}

test("the shape is saved as OBJ, PLY and GLB with the positions of the state", async () => {
  await openHanging();
  await step();
  const state = await positions(page);
  for (const format of ["obj", "ply", "glb"]) {
    const { name, bytes } = await saved(() => page.locator(`#save-${format}`).click());
    expect(name).toBe(`hanging-00001.${format}`);
    const mesh = await readMesh(name, new Uint8Array(bytes));
    expect(mesh.triangles).toBe(2 * 31 * 31);
    expect(positionsOf(mesh.ply)).toEqual(state);
  }
});

test("the picture is saved as it is drawn", async () => {
  await closeNotice(); // it would lie over the picture
  const { name, bytes } = await saved(() => page.getByRole("button", { name: "Save the picture" }).click());
  expect(name).toMatch(/^hanging-\d{5}\.png$/);
  const image = await page.evaluate(async (base64) => {
    const file = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([file], { type: "image/png" }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
    context.drawImage(bitmap, 0, 0);
    const { data, width, height } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const canvas = document.querySelector<HTMLCanvasElement>("#canvas")!;
    let letters = "";
    for (let i = 0; i < data.length; i += 4096) letters += String.fromCharCode(...data.subarray(i, i + 4096));
    return { data: btoa(letters), sizes: [width, height, canvas.width, canvas.height] };
  }, bytes.toString("base64"));
  expect(image.sizes.slice(0, 2)).toEqual(image.sizes.slice(2));
  const drawn = new Uint8Array(Buffer.from(image.data, "base64"));
  const { mean, deviation } = brightness(drawn);
  expect(mean).toBeGreaterThan(30); // of 255: neither black
  expect(deviation).toBeGreaterThan(8); // nor a single colour
  expect(difference(drawn, await picture(page))).toBeLessThan(0.02); // and what the page shows
});

/** Width, height and duration of a video, as this Chromium plays it. */
async function played(bytes: Buffer,
  type: string): Promise<{ width: number; height: number; seconds: number; bright: number }> {
  const other = await here.browser.newPage(); // not ours: its policy plays nothing that was made there
  try {
    return await other.evaluate(async ([base64, type]) => {
      const file = Uint8Array.from(atob(base64!), (letter) => letter.charCodeAt(0));
      const video = document.createElement("video");
      const event = (name: string) =>
        new Promise((done, fail) => {
          video.addEventListener(name, done, { once: true });
          video.addEventListener("error", () => fail(new Error(video.error?.message)), { once: true });
        });
      const loaded = event("loadeddata");
      video.src = URL.createObjectURL(new Blob([file], { type: type! }));
      await loaded;
      const sought = event("seeked");
      video.currentTime = 1e6; // a recording does not state its duration before its end is known
      await sought; // at its last picture
      const context = new OffscreenCanvas(video.videoWidth, video.videoHeight).getContext("2d")!;
      let bright = 0; // of 255; the picture may come a little after the event
      for (let tries = 0; bright === 0 && tries < 60; tries++) {
        await new Promise((wake) => setTimeout(wake, 50));
        context.drawImage(video, 0, 0);
        const { data } = context.getImageData(0, 0, video.videoWidth, video.videoHeight);
        bright = data.reduce((most, value, i) => (i % 4 < 3 ? Math.max(most, value) : most), 0);
      }
      return { width: video.videoWidth, height: video.videoHeight, seconds: video.currentTime, bright };
    }, [bytes.toString("base64"), type] as const);
  } finally {
    await other.close();
  }
}

test("a video is recorded, started and stopped by hand, and plays", async () => {
  await page.getByRole("button", { name: "Play" }).click();
  await page.getByRole("button", { name: "Record a video" }).click();
  await play(page, 4);
  await until("time is shown",
    async () => /Stop: 0:0[1-9] of 1:00/.test((await page.locator("#record").textContent())!));
  const { name, bytes } = await saved(() => page.getByRole("button", { name: "Stop:" }).click());
  expect(name).toMatch(/^hanging-\d{5}\.webm$/);
  const video = await played(bytes, "video/webm");
  expect([video.width, video.height]).toEqual(await page.locator("#canvas")
    .evaluate((canvas: HTMLCanvasElement) => [canvas.width, canvas.height]));
  expect(video.seconds).toBeGreaterThan(0); // of its last picture
  expect(video.bright).toBeGreaterThan(60);
  await until("it can be recorded again", () => page.getByRole("button", { name: "Record a video" }).isVisible());
});

test("a recording that is stopped at once still has a picture", async () => {
  await page.getByRole("button", { name: "Record a video" }).click();
  const { bytes } = await saved(() => page.getByRole("button", { name: "Stop:" }).click());
  expect((await played(bytes, "video/webm")).bright).toBeGreaterThan(60);
});

test("a recording ends by itself when the longest time is over", async () => {
  await page.getByRole("button", { name: "Record a video" }).click();
  await play(page, 4);
  await until("time is shown", async () => /Stop: 0:0[1-9]/.test((await page.locator("#record").textContent())!));
  const { bytes } = await saved(() =>
    page.evaluate(() => {
      const now = performance.now.bind(performance);
      performance.now = () => now() + 60_000;
    })
  );
  expect(bytes.length).toBeGreaterThan(1000);
  await until("it says so", () => page.getByRole("button", { name: "Record a video" }).isVisible());
});

test("where the browser cannot record, a sentence says so", async () => {
  await page.evaluate(() => {
    Reflect.deleteProperty(window, "MediaRecorder");
  });
  await page.getByRole("button", { name: "Record a video" }).click();
  expect(await notice()).toBe("This browser cannot record a canvas: it has no MediaRecorder for it.");
});
