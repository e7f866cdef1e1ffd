// The package within a program that uses the GPU itself: its device comes in, weft's buffers go out, colliders follow
// the program, each frame is told of; and the examples as they stand.
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import { createWorld, DEVICE_LIMITS, type Scene, type SceneCollider, type SceneColliderMotion, type WeftError,
  type Step, type World, type WorldBuffer, type WorldOptions } from "weft-cloth";
import { openPage, ROOT, type Harness } from "./chromium.ts";
import { failure } from "./failure.ts";
import { gpu } from "./node_gpu.ts";

const FRAME = 1 / 64; // s, so that times are exact

/** A sheet of 12 x 12 nodes, soft enough for its substeps; over a ball where this moves it. Without contact a world's
 * kernels compile in a second. */
function scene(motion?: SceneColliderMotion): Scene {
  const ball: SceneCollider = { kind: "sphere", center: [0, -0.21, 0], radius: 0.2, motion };
  return { format: "weft-scene/1", solver: { kind: "mass_spring" }, time: { frame: FRAME, substeps: 8 },
    contact: { method: motion ? "proximity" : "none" },
    cloths: [{ grid: [12, 12], size: [1, 1], plane: "xz", density: 0.2, pins: ["top_left", "top_right"],
      stiffness: { structural: 40, shear: 10, bend: 0.3 }, damping: 0.005 }], colliders: motion ? [ball] : [] };
}

const worlds: World[] = [];
async function open(options: Partial<WorldOptions> = {}): Promise<World> {
  const world = await createWorld({ scene: scene(), canvas: null, gpu, ...options });
  worlds.push(world);
  expect(world.info.unstableStep).toBeNull();
  expect(world.info.solver).toBe("mass_spring");
  expect(world.info.solverReason).toBeNull(); // the scene names it
  return world;
}
afterEach(() => worlds.splice(0).forEach((world) => world.dispose()));

async function ownDevice(): Promise<GPUDevice> {
  const adapter = await gpu.requestAdapter();
  return adapter!.requestDevice();
}

/** What a buffer of weft's holds, copied by commands of this program's own. */
async function read(device: GPUDevice, { buffer, offset, stride, count, format }: WorldBuffer): Promise<number[][]> {
  const size = stride * count;
  const target = device.createBuffer({ size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
  const encoder = device.createCommandEncoder();
  encoder.copyBufferToBuffer(buffer, offset, target, 0, size);
  device.queue.submit([encoder.finish()]);
  await target.mapAsync(GPUMapMode.READ);
  const bytes = target.getMappedRange();
  const numbers = format.startsWith("uint32") ? new Uint32Array(bytes) : new Float32Array(bytes);
  const each = format.endsWith("x3") ? 3 : 1;
  return Array.from({ length: count }, (_, i) => [...numbers.subarray(stride / 4 * i, stride / 4 * i + each)]);
}

describe("a device of the program's own", () => {
  it("carries a world to the bits of one on a device of its own, and outlives it", async () => {
    const device = await ownDevice();
    const [alone, shared] = [await open(), await open({ device })];
    expect(shared.device).toBe(device);
    expect(shared.info.adapter).toBe(alone.info.adapter);
    for (const world of [alone, shared]) await world.step(8);
    expect((await shared.snapshot()).hash).toBe((await alone.snapshot()).hash);
    const { position } = shared.buffers();
    shared.dispose();
    const next = await open({ device }); // a second world on it, and commands of the program's own
    await next.step(8);
    expect((await next.snapshot()).hash).toBe((await alone.snapshot()).hash);
    expect(await read(device, next.buffers().position)).toHaveLength(144);
    expect(await Promise.race([device.lost, Promise.resolve("not lost")])).toBe("not lost");
    expect(position.buffer.mapState).toBe("unmapped");
    device.pushErrorScope("validation"); // the first world's are gone
    const encoder = device.createCommandEncoder();
    encoder.clearBuffer(position.buffer);
    device.queue.submit([encoder.finish()]);
    expect((await device.popErrorScope())?.message).toContain("destroyed");
  });

  it("has its errors apart from weft's", async () => {
    const device = await ownDevice();
    const uncaptured: string[] = [];
    device.addEventListener("uncapturederror", (event) => {
      uncaptured.push((event as GPUUncapturedErrorEvent).error.message);
      event.preventDefault();
    });
    device.pushErrorScope("validation");
    const opening = open({ device });
    device.createBuffer({ label: "the program's", size: 16, usage: 0 }); // wrong, and none of weft's business
    const world = await opening;
    await world.step(2);
    device.createBuffer({ label: "another", size: 16, usage: 0 });
    await world.step(2);
    expect((await device.popErrorScope())?.message).toContain("the program's");
    device.createBuffer({ label: "a third", size: 16, usage: 0 });
    await world.step(2);
    expect(uncaptured).toHaveLength(1);
    expect(uncaptured[0]).toContain("a third");

    const make = device.createBuffer.bind(device); // weft's own fault comes to weft's caller alone
    device.createBuffer = (descriptor) => make({ ...descriptor, usage: 0 });
    const error = await failure(world.load(scene()));
    expect(error.kind).toBe("shader");
    device.createBuffer = make;
    await world.load(scene());
    await world.step(1);
    expect(uncaptured).toHaveLength(1);
  });

  it("is refused where a limit is too small, with both numbers; those of WebGPU itself are enough", async () => {
    const device = await ownDevice();
    const source = readFileSync(join(ROOT, "src/gpu/native/given_device.cpp"), "utf8");
    const native = [...source.matchAll(/\{"(max\w+)", limits\.\1, (\d+)\}/g)].map(([, name, needed]) =>
      [name, Number(needed)] as const
    );
    expect(DEVICE_LIMITS).toEqual(Object.fromEntries(native)); // one list, in two languages
    for (const [name, needed] of native) {
      const small = new Proxy(device, {
        get: (target, key) => {
          if (key !== "limits") return Reflect.get(target, key) as unknown;
          return new Proxy(target.limits, {
            get: (limits, limit) => limit === name ? needed - 1 : limits[limit as keyof GPUSupportedLimits],
          });
        },
      });
      const error = await failure(open({ device: small }));
      expect([error.kind, error.message]).toEqual(["limit",
        `The device's ${name} is ${needed - 1}, and weft's shaders need ${needed}.`]);
    }
    expect((await failure(open({ device, adapter: "no such" }))).message).toContain("No adapter's name contains");
  });

  it("takes its world with it where it is lost, and only a new world goes on", async () => {
    const device = await ownDevice();
    const world = await open({ device });
    const lost = new Promise<WeftError>((tell) => world.on("error", tell));
    device.destroy();
    expect((await lost).kind).toBe("device-lost");
    expect((await failure(world.recover())).message)
      .toBe("The lost device is the page's own; make a new world on a new one.");
  });
});

describe("the buffers", () => {
  it("have the state at the end of the last frame, as they say", async () => {
    const device = await ownDevice();
    const world = await open({ device, set: { "time.substeps": 7 } }); // odd: positions and velocities take turns
    const used = new Set<GPUBuffer>();
    for (let frame = 0; frame < 3; frame++) {
      await world.step(1);
      const { position, velocity, normal, stretch, triangles } = world.buffers();
      used.add(position.buffer);
      const { positions, velocities } = await world.snapshot();
      expect((await read(device, position)).flat()).toEqual([...positions]);
      expect((await read(device, velocity)).flat()).toEqual([...velocities]);
      for (const [x, y, z] of await read(device, normal)) expect(Math.hypot(x!, y!, z!)).toBeCloseTo(1, 5);
      const corners = await read(device, triangles);
      expect(corners).toHaveLength(world.info.triangles);
      const apart = (a: number, b: number) =>
        Math.hypot(...[0, 1, 2].map((axis) => positions[3 * a + axis]! - positions[3 * b + axis]!));
      const most = new Float64Array(144);
      for (const [a, b, c] of corners as [number, number, number][])
        for (const [i, j] of [[a, b], [b, c], [c, a]] as const) {
          if (i % 12 !== j % 12 && Math.floor(i / 12) !== Math.floor(j / 12)) continue; // a diagonal
          for (const node of [i, j]) most[node] = Math.max(most[node]!, 11 * apart(i, j));
        }
      (await read(device, stretch)).forEach(([value], node) => expect(value).toBeCloseTo(most[node]!, 4));
      for (const { buffer } of [position, velocity, normal, stretch])
        expect(buffer.usage & GPUBufferUsage.VERTEX).toBe(GPUBufferUsage.VERTEX);
      expect(triangles.buffer.usage & GPUBufferUsage.INDEX).toBe(GPUBufferUsage.INDEX);
    }
    expect(used.size).toBe(2);
  });

  it("are not there without a scene", async () => {
    const world = await open();
    await failure(world.load("{}"));
    expect(() => world.buffers()).toThrow("No scene is loaded.");
  });
});

describe("setCollider", () => {
  const given: SceneColliderMotion = { kind: "given", speed: 1.5 };

  let world: World; // for all, so that its kernels are compiled once
  beforeAll(async () => {
    world = await createWorld({ scene: scene(given), canvas: null, gpu });
  });
  afterAll(() => world.dispose());

  it("carries cloth to the bits of the same path of a scene, by a placement and by a matrix", async () => {
    const frames = 4;
    for (let frame = 1; frame <= frames; frame++) {
      const y = 1.5 * frame * FRAME;
      await world.setCollider(0, frame % 2 === 0 ?
        [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1] :
        { position: [0, y, 0] });
      await world.step(1);
    }
    const { hash } = await world.snapshot();
    const { contacts } = world.statistics;
    expect(contacts).toBeGreaterThan(0);
    await world.load(scene({ kind: "path", points: [[1, [0, 1.5, 0]]] }));
    expect((await world.step(frames)).contacts).toBe(contacts);
    expect((await world.snapshot()).hash).toBe(hash);
    await world.load(scene(given));
  });

  it("refuses what is no place of a given collider, and what is too fast", async () => {
    const said = async (call: Promise<void>) => {
      const { kind, message } = await failure(call);
      expect(kind).toBe("input");
      return message;
    };
    expect(await said(world.setCollider(0, { position: [0, 1, 0] })))
      .toBe("Collider 0 would go up to 1 m in a frame, at 64 m/s; its motion has a speed of 1.5 m/s.");
    expect(await said(world.setCollider(1, {})))
      .toBe("Collider 1 is not one of the 1 that a motion of kind \"given\" moves.");
    expect(await said(world.setCollider(-1, {}))).toBe("Collider -1 is no index.");
    expect(await said(world.setCollider(0, { quaternion: [0, 0, 0, 2] })))
      .toBe("The rotation has length 2; a unit quaternion's is within 0.001 of 1.");
    expect(await said(world.setCollider(0, { position: [NaN, 0, 0] }))).toContain("is not finite.");
    expect(await said(world.setCollider(0, [1, 2, 3]))).toBe("A matrix has 16 numbers, and not 3.");
    expect(await said(world.setCollider(0, [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])))
      .toBe("Column 0 of the matrix has length 2; a placement does not scale, to 0.001.");
    expect(await said(world.setCollider(0, { position: [0, 1] as unknown as [number, number, number] })))
      .toBe("A position has 3 numbers and a quaternion 4, and not 2 and 4.");
  });
});

it("every frame is told of once, in order, with its own totals", async () => {
  const world = await open();
  const steps: Step[] = [];
  const off = world.on("step", (step) => steps.push(step));
  await world.step(7);
  world.run();
  while (steps.length < 10) await new Promise((done) => setTimeout(done, 5));
  world.pause();
  await world.step(0); // what is under way
  const told = steps.length;
  expect(steps.map(({ frame }) => frame)).toEqual(Array.from({ length: told }, (_, k) => k + 1));
  for (const { frame, seconds, totals } of steps) {
    expect(seconds).toBe(frame * FRAME);
    expect(totals.frames).toBe(frame);
  }
  expect(steps.at(-1)!.totals).toMatchObject({ contacts: world.statistics.contacts,
    contactHash: world.statistics.contactHash, maxStretch: world.statistics.maxStretch });
  for (let k = 1; k < told; k++)
    expect(steps[k]!.totals.contacts).toBeGreaterThanOrEqual(steps[k - 1]!.totals.contacts);
  await world.reset();
  await world.step(1);
  expect(steps.at(-1)!).toMatchObject({ frame: 1, seconds: FRAME });
  off();
  await world.step(2);
  expect(steps).toHaveLength(told + 1);
});

describe("the examples", () => {
  const TYPES: Record<string, string> = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css",
    ".wasm": "application/wasm" };
  let harness: Harness;
  beforeAll(async () => {
    harness = await openPage();
  });
  afterAll(() => harness.close());

  /** Opens a page that is served with these folders of the checkout under these paths. */
  async function visit(path: string, folders: Readonly<Record<string, string>>): Promise<void> {
    const origin = new URL(harness.page.url()).origin;
    for (const [under, folder] of Object.entries(folders))
      await harness.page.route(`${origin}${under}**`, (route) => {
        const name = new URL(route.request().url()).pathname.slice(under.length);
        const text = readFileSync(join(ROOT, folder, name || "index.html"));
        const body = extname(name) === ".js" ? // as a bundler would have it
          text.toString().replaceAll(`"weft-cloth"`, `"/packages/weft/build/index.js"`)
            .replaceAll(`"three/webgpu"`, `"/node_modules/three/build/three.webgpu.js"`) :
          text;
        return route.fulfill({ body, contentType: TYPES[extname(name) || ".html"]! });
      });
    await harness.page.goto(`${origin}${path}`);
  }
  /** The canvas's picture, made smaller, as RGBA. */
  async function picture(): Promise<number[]> {
    const png = (await harness.page.locator("canvas").screenshot()).toString("base64");
    return harness.page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const context = new OffscreenCanvas(64, 40).getContext("2d")!;
      context.drawImage(image, 0, 0, 64, 40);
      return [...context.getImageData(0, 0, 64, 40).data];
    }, png);
  }
  /** The part of a picture's pixels for which this holds. */
  function part(rgba: number[], holds: (r: number, g: number, b: number, at: number) => boolean): number {
    let count = 0;
    for (let at = 0; at < rgba.length; at += 4) if (holds(rgba[at]!, rgba[at + 1]!, rgba[at + 2]!, at)) count += 1;
    return (4 * count) / rgba.length;
  }

  it("embed.html has twenty lines, and a cloth", async () => {
    const lines = readFileSync(join(ROOT, "examples/web/embed.html"), "utf8").trimEnd().split("\n");
    expect(lines).toHaveLength(20);
    await visit("/embed/embed.html", { "/embed/": "examples/web/", "/embed/weft-cloth/": "packages/weft/build/" });
    const far = (a: number[], b: number[]) =>
      part(a, (red, green, blue, at) =>
        Math.abs(red - b[at]!) + Math.abs(green - b[at + 1]!) + Math.abs(blue - b[at + 2]!) > 60);
    const page = await picture(); // white
    let first = page;
    while (far(first, page) < 0.05) first = await picture();
    let later = first;
    while (far(later, first) < 0.01) later = await picture(); // it moves
    expect(await harness.page.locator("body").innerText()).toBe(""); // no sentence of what is missing
    expect(harness.complaints).toEqual([]);
  });

  it("three.js draws weft's buffers on one device, and nothing of them is read back", async () => {
    await harness.page.addInitScript(() => {
      const mapped: number[] = [];
      Object.assign(window, { mapped });
      const map = GPUBuffer.prototype.mapAsync;
      GPUBuffer.prototype.mapAsync = function(this: GPUBuffer, ...args) {
        mapped.push(args[2] ?? this.size);
        return map.apply(this, args);
      };
    });
    await visit("/three/", { "/three/": "examples/web/three/" });
    await harness.page.waitForFunction(() => Number(document.documentElement.dataset["frame"]) >= 3);
    const shown = await picture();
    // Level, seen 12 degrees from above at 2.3 m with 40 degrees in height, 1.44 m² of cloth fill 7 % of the picture.
    expect(part(shown, (red, green, blue) => red > 30 + Math.max(green, blue))).toBeGreaterThan(0.035);
    expect(part(shown, (red, _, blue) => blue > 30 + red)).toBeGreaterThan(0.01); // the ball below it
    const mapped = await harness.page.evaluate(() => (window as unknown as { mapped: number[] }).mapped);
    expect(Math.max(...mapped)).toBeLessThan(1024); // reports of frames; the positions alone have 17,424 bytes
    expect(harness.complaints).toEqual([]);
  });
});
