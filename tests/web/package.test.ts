// The package as its users have it: the README's examples, and what each call promises.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from "vitest";
import { catalog, checkScene, createReference, createWorld, meshNames, readMesh, schemaOf, type Measures,
  type SceneObject, type World, type WorldOptions } from "weft-cloth";
import { openPage, ROOT, type Harness } from "./chromium.ts";
import { failure } from "./failure.ts";
import { gpu } from "./node_gpu.ts";

const readme = readFileSync(join(ROOT, "packages/weft/README.md"), "utf8");
const [browserExample, nodeExample] = [...readme.matchAll(/```js\n(.*?)```/gs)].map((block) => block[1]!);
const scene = (name: string) => readFileSync(join(ROOT, `scenes/${name}.json`), "utf8");

describe("the README's example", () => {
  let harness: Harness;
  beforeAll(async () => {
    harness = await openPage();
  });
  afterAll(() => harness.close());

  it("has ten lines, and runs as it stands in a page", async () => {
    expect(browserExample!.trim().split("\n")).toHaveLength(10);
    await harness.script(`${browserExample}\nwindow.world = world;`);
    await harness.page.waitForFunction(() => "world" in window);
    const moved = await harness.page.evaluate(async () => {
      const { world } = window as unknown as { world: World };
      const before = await world.positions();
      while (world.statistics.frames < 3) await new Promise((done) => setTimeout(done, 20));
      const after = await world.positions();
      return Math.max(...after.map((value, i) => Math.abs(value - before[i]!)));
    });
    expect(moved).toBeGreaterThan(1e-3);
    expect(harness.complaints).toEqual([]);
  });

  it("draws every frame of a step where that is asked for, or else the last, or none before a redraw", async () => {
    const pictures = await harness.page.evaluate(async () => {
      const { world } = window as unknown as { world: World };
      world.pause();
      await new Promise((done) => world.on("frame", done)); // what the pause has left to be drawn is drawn
      const context = document.querySelector("canvas")!.getContext("webgpu")!;
      const texture = context.getCurrentTexture.bind(context);
      let count = 0;
      context.getCurrentTexture = () => {
        count += 1;
        return texture();
      };
      const drawn = async (draw: boolean | null, due: number, redraw = false) => {
        count = 0;
        await world.step(8, { draw });
        if (redraw) world.redraw();
        while (count < due) await new Promise((done) => setTimeout(done, 20));
        await new Promise((done) => setTimeout(done, 1500)); // for pictures too many: some ticks of the page
        return count;
      };
      return [await drawn(true, 8), await drawn(false, 1), await drawn(null, 0), await drawn(null, 1, true)];
    });
    expect(pictures).toEqual([8, 1, 0, 1]);
    expect(harness.complaints).toEqual([]);
  });
});

it("the README's example for Node runs", async () => {
  expect(nodeExample).toContain("world.step(60)");
  const text = nodeExample!.replace(/^import .*$/gm, "").replace("step(60)", "step(2)").replace("create([])", "gpu")
    .replace("Object.assign(globalThis, globals);", "");
  const run = new Function("createWorld", "gpu0", "scene",
    `return (async () => { ${
      text.replace("const gpu = gpu;", "const gpu = gpu0;")
    } return { world, maxStretch, positions, hash }; })();`) as (make: typeof createWorld, gpu0: GPU,
      scene: string) => Promise<{ world: World; maxStretch: number; positions: Float32Array; hash: string }>;
  const { world, maxStretch, positions, hash } = await run(createWorld, gpu, scene("hanging"));
  expect(maxStretch).toBeGreaterThan(1);
  expect(positions).toHaveLength(3 * 64 * 64);
  expect(hash).toMatch(/^[0-9a-f]{16}$/);
  world.dispose();
});

it("a scene names the meshes of its cloths, its colliders and their keyframes, each once", () => {
  const wrong: object = { format: "weft-scene/1", cloths: [{ mesh: "shirt" }, { grid: [2, 2] }],
    colliders: [{ kind: "plane" }, null, { kind: "mesh", mesh: "body",
      keyframes: [{ time: 1, mesh: "bent" }, { time: 2, mesh: "body" }, null] }, { kind: "mesh", mesh: "chair",
      keyframes: 3 }] };
  const names = meshNames(wrong as SceneObject);
  expect(names).toEqual(["shirt", "body", "bent", "chair"]);
});

it("the catalog has the schema, the colour map and the limits of the core, without a device", async () => {
  const { schema, colors, ranges, mostGrabs, fabrics, looks } = await catalog();
  expect(schemaOf(schema, "contact.method")!.enum).toEqual(["none", "paper", "bvh", "proximity"]);
  expect(schemaOf(schema, "solver.forces")!.enum).toContain("spring_centric"); // of a variant
  expect(schemaOf(schema, "cloths.0.stiffness.shear")).toMatchObject({ minimum: 0, maximum: 1e12, default: 2000 });
  expect(schemaOf(schema, "camera.eye")).toMatchObject({ type: "array", minItems: 3,
    description: "Where the camera is [m]." });
  for (const key of ["cloths.0.colour", "cloths.x", "constructor", "gravity.0.1"])
    expect(schemaOf(schema, key)).toBeNull();
  expect(colors[0]!.map((part) => Math.round(255 * part))).toEqual([68, 1, 84]); // viridis
  expect(colors.at(-1)!.map((part) => Math.round(255 * part))).toEqual([253, 231, 37]);
  expect(ranges.stretch).toEqual([0.95, 1.15]);
  expect(mostGrabs).toBe(1024);
  expect(fabrics.find(({ name }) => name === "denim_11oz")).toMatchObject({ density: 0.324, look: "denim" });
  expect(schemaOf(schema, "cloths.0.look")!.anyOf!.flatMap((way) => way.enum ?? []))
    .toEqual(looks.map(({ name }) => name));
  expect(looks.find(({ name }) => name === "silk")!.color.map((part) => Number(part.toFixed(2))))
    .toEqual([0.72, 0.15, 0.2]);
  expect(schemaOf(schema, "cloths.0.fabric.name")!.enum).toEqual(fabrics.map(({ name }) => name));
  expect(schemaOf(schema, "cloths.0.fabric.warp")).toMatchObject({ type: "number", minimum: 0.001 });
});

it("is packed with its licence, its notices, types and the module, and nothing else", () => {
  const [packed] = JSON.parse(
    execFileSync("npm", ["pack", "--dry-run", "--json", "--loglevel=error"], { cwd: join(ROOT, "packages/weft"),
      encoding: "utf8" }),
  ) as [{ name: string; files: { path: string }[] }];
  expect(packed.name).toBe("weft-cloth");
  const paths = packed.files.map(({ path }) => path);
  expect(paths.filter((path) => !path.startsWith("build/")).sort())
    .toEqual(["LICENSE", "NOTICE", "README.md", "THIRD_PARTY.md", "package.json"]);
  expect(paths).toEqual(
    expect.arrayContaining(
      ["index.js", "index.d.ts", "core_module.js", "core_module.wasm", "reference_module.js", "reference_module.wasm"]
        .map((name) => `build/${name}`),
    ),
  );
});

describe("a world", () => {
  const small = { "cloths.0.grid": [12, 12] };
  const worlds: World[] = [];
  const open = async (options: Partial<WorldOptions> = {}) => {
    const world = await createWorld({ scene: scene("hanging"), canvas: null, gpu, set: small, ...options });
    worlds.push(world);
    return world;
  };
  afterEach(() => worlds.splice(0).forEach((world) => world.dispose()));

  it("measures energies, which are those of the reference in double and obey what energy does", async () => {
    const set = { ...small, "cloths.0.damping": 0, "wind.velocity": [0, 0, 0], drag: 0 };
    const world = await open({ set });
    const reference = await createReference({ scene: scene("hanging"), set });
    const sum = ({ kinetic, potential, springs, membranes, bending, tetrahedra, gas }: Measures) =>
      kinetic + potential + springs + membranes + bending + tetrahedra + gas;
    const rest = await world.measure();
    expect(rest).toMatchObject({ frame: 0, seconds: 0, kinetic: 0, membranes: 0, tetrahedra: 0, gas: 0, contacts: 0 });
    expect(sum(rest)).toBeCloseTo(reference.energy, 4);
    await world.step(20);
    for (let frame = 0; frame < 20; frame++) reference.advance();
    const later = await world.measure();
    expect(later.frame).toBe(20);
    const moved = later.kinetic + later.springs; // all of it has come from the height
    expect(moved).toBeGreaterThan(0.1);
    expect(sum(later)).toBeCloseTo(reference.energy, 2);
    expect(Math.abs(sum(later) - sum(rest))).toBeLessThan(0.05 * moved); // nothing damps it; the steps do a little
    expect(later.maxStretch).toBeLessThanOrEqual(world.statistics.maxStretch); // the most of all frames so far
    expect(later.maxStretch).toBeGreaterThan(1);
    // By the state itself: mass times speed, and mass times height.
    const { positions, velocities, inverseMasses } = await world.snapshot();
    let kinetic = 0, potential = 0;
    inverseMasses.forEach((inverse, node) => {
      if (inverse === 0) return;
      kinetic += [0, 1, 2].reduce((all, axis) => all + velocities[3 * node + axis]! ** 2, 0) / (2 * inverse);
      potential += 9.81 * positions[3 * node + 1]! / inverse;
    });
    expect(later.kinetic / kinetic).toBeCloseTo(1, 6);
    expect(later.potential / potential).toBeCloseTo(1, 6);
    reference.dispose();
  });

  it("takes looks and light while it moves, without a change of its state, and refuses what shapes the cloth",
    async () => {
      const world = await open();
      const { hash } = await world.snapshot();
      await world.setParameter("cloths.0.look", "silk");
      await world.setParameter("render.light.environment", "sky");
      await world.setParameter("cloths.0.look", null);
      expect((await world.snapshot()).hash).toBe(hash);
      await expect(world.setParameter("cloths.0.look", "tweed")).rejects.toThrow(/cloths\[0\]\.look is "tweed"/);
      await expect(world.setParameter("cloths.0.density", null)).rejects.toThrow(/density/);
    });

  it("goes back to the exact rest state, and takes the same way again", async () => {
    const world = await open();
    const rest = (await world.snapshot()).hash;
    await world.step(5);
    const moved = (await world.snapshot()).hash;
    expect(moved).not.toBe(rest);
    await world.reset();
    expect((await world.snapshot()).hash).toBe(rest);
    expect(world.statistics.frames).toBe(0);
    await world.step(5);
    expect((await world.snapshot()).hash).toBe(moved);
  });

  it("tells the inverse masses of its nodes: 0 at pins, and elsewhere the sheet's density by area", async () => {
    const world = await open({ set: { "cloths.0.grid": [5, 9] } }); // 2 m by 2 m, 0.2 kg/m², held at two corners
    const { inverseMasses } = await world.snapshot();
    const area = (2 / 4) * (2 / 8); // of a cell [m²]
    const held = [...inverseMasses.keys()].filter((node) => inverseMasses[node] === 0);
    expect(held).toEqual([0, 4]);
    const inner = inverseMasses[2 * 5 + 2]!; // a node with the area of a cell
    expect(1 / inner).toBeCloseTo(0.2 * area, 6);
  });

  it("carries out what is asked at once one after the other, each with its own answer", async () => {
    const world = await open();
    const [first, stepped, , second, third] = await Promise.all([world.snapshot(), world.step(20),
      world.setParameter("drag", 2), world.snapshot(), world.snapshot()]);
    expect(stepped.frames).toBe(20);
    expect(second.hash).toBe(third.hash);
    expect([first, second].map(({ positions }) => positions.length)).toEqual([432, 432]);
    const [, info, shape] = await Promise.all([world.load(scene("hanging"), { set: { "cloths.0.grid": [9, 7] } }),
      world.step(1), world.exportMesh("obj")]);
    expect(info.frames).toBe(1);
    expect(new TextDecoder().decode(shape).match(/^v /gm)).toHaveLength(63);
    expect(world.info.nodes).toBe(63);
  });

  it("answers every call without a scene, and after it is disposed of", async () => {
    const world = await open();
    await failure(world.load("{}"));
    for (const call of [() => world.step(), () => world.snapshot(), () => world.reset(), () => world.pick(0, 0),
      () => world.grab(0, [0, 0, 0]), () => world.exportMesh("obj"), () => world.setParameter("drag", 1),
      () => world.saveState(), () => world.openState(new Uint8Array(64))])
      expect((await failure(call())).message).toBe("No scene is loaded.");
    expect(() => world.run()).toThrow("No scene is loaded.");
    world.pause();
    await world.load(scene("hanging"), { set: small });
    expect(() => world.camera).toThrow("canvas");
    expect((await failure(world.grab(NaN, [0, 0, 0]))).kind).toBe("input");
    expect((await failure(world.setView("wire" as "wireframe"))).message).toContain("wireframe");
    const stepping = failure(world.step(500));
    world.dispose();
    expect((await stepping).message).toBe("No scene is loaded.");
    expect((await failure(world.snapshot())).kind).toBe("failure");
  });

  it("tells a lack of memory from a fault in a shader, and a failed load leaves the next one alone", async () => {
    const world = await open();
    const device = world.device!;
    const create = device.createBuffer.bind(device);
    let left = 5;
    device.createBuffer = (descriptor) => { // the sixth buffer is larger than any machine's memory
      left -= 1;
      return create(
        left === 0 ? { ...descriptor, size: device.limits.maxBufferSize, usage: descriptor.usage } : descriptor,
      );
    };
    const before = world.memory().gpuObjects;
    const error = await failure(world.load(scene("hanging"), { set: small }));
    expect(error.kind).toBe("out-of-memory");
    device.createBuffer = create;
    await world.load(scene("hanging"), { set: small });
    expect(world.memory().gpuObjects).toBe(before);
    expect((await world.step(1)).frames).toBe(1);
  });

  it("takes a slider's thousand changes without growing", async () => {
    const world = await open({ scene: scene("breeze"), set: { "cloths.0.grid": [24, 18] } });
    const set = async (times: number) => {
      for (let i = 0; i < times; i++) await world.setParameter("wind.velocity", [0, 0, 1 + i / times]);
      return world.memory().wasmHeap;
    };
    const before = await set(10);
    expect(Math.abs((await set(1000)) - before)).toBeLessThan(2048);
  });

  it("counts frames and simulated time", async () => {
    const world = await open();
    const { frames, seconds } = await world.step(7);
    expect([frames, seconds]).toEqual([7, 7 / 60]);
    expect(world.info).toMatchObject({ nodes: 144, triangles: 242 });
  });

  it("times its passes, and goes on as if it had not", async () => {
    const options = { scene: scene("pull-sphere"), meshes: { sphere: readFileSync(join(ROOT, "models/sphere.ply")) },
      set: { "cloths.0.grid": [16, 16], "time.substeps": 4, "time.frame": 0.001 } };
    const world = await open(options);
    expect(world.info.timestamps).toBe(true);
    expect((await failure(world.passTimes())).message).toContain("after a frame");
    const end = async () => {
      const { contacts, contactHash } = await world.step(3);
      return [contacts, contactHash, (await world.snapshot()).hash];
    };
    await world.step(2);
    const untimed = await end();
    await world.reset();
    await world.step(2);
    const times = await world.passTimes();
    expect(times.map(({ kernel, per }) => `${kernel} a ${per}`)).toEqual(
      expect.arrayContaining(["find_candidates a search", "advance_grid a step"]),
    );
    for (const { milliseconds, dispatches } of times)
      expect([milliseconds >= 0, dispatches >= 1]).toEqual([true, true]);
    expect(await end()).toEqual(untimed);
    await world.load(scene("hanging"), { set: { ...small, "time.substeps": 1, "time.frame": 1e-4 } });
    await world.step(1);
    expect((await failure(world.passTimes())).message).toContain("1 step");
  });

  it("counts the time that it leaves out where it is late", async () => {
    const world = await open();
    let clock = 0; // ms
    const now = vi.spyOn(performance, "now").mockImplementation(() => clock);
    try {
      let simulated = 0;
      world.on("frame", () => {
        simulated += 1;
      });
      world.run();
      const ticks = async (frames: number) => {
        while (simulated < frames) await new Promise((wake) => setTimeout(wake, 2));
      };
      for (let frame = 1; frame <= 4; frame++) {
        clock += 1000 / 60;
        await ticks(frame);
      }
      expect(world.statistics.droppedSeconds).toBeCloseTo(0, 9);
      clock += 1000;
      await ticks(6); // two frames are made up for
      expect(world.statistics.droppedSeconds).toBeCloseTo(1 - 2 / 60, 9);
    } finally {
      now.mockRestore();
    }
    await world.reset();
    expect(world.statistics.droppedSeconds).toBe(0);
  });

  it("goes on from a saved state to the bits of a run that never stopped, with what was grabbed", async () => {
    const target = [0.9, -0.2, 0.4] as const;
    const [world, other] = [await open(), await open()];
    await world.step(3);
    await world.grab(140, target);
    await world.step(2);
    const bytes = await world.saveState();
    await world.step(4);
    const whole = await world.snapshot();
    expect(await other.openState(bytes)).toEqual({ grabs: [{ node: 140, target: [...target] }], otherOrigin: null });
    expect(other.statistics).toMatchObject({ frames: 5, seconds: 5 / 60 });
    expect(Buffer.from(await other.saveState()).equals(bytes)).toBe(true);
    await other.step(4);
    expect(await other.snapshot()).toEqual(whole);
    await other.release(140);
    await other.openState(bytes.buffer); // what it went on to is forgotten
    await other.step(4);
    expect((await other.snapshot()).hash).toBe(whole.hash);
  });

  it("refuses a state that it cannot go on from, and stays as it was", async () => {
    const world = await open();
    await world.step(2);
    const bytes = await world.saveState();
    await world.step(1);
    const [hash, frames] = [(await world.snapshot()).hash, 3];
    const spoiled = Uint8Array.from(bytes);
    spoiled[500]! ^= 1;
    const newer = Uint8Array.from(bytes);
    newer[8] = 9;
    const finer = await open({ set: { "cloths.0.grid": [13, 12] } });
    const refused: [Uint8Array, RegExp][] = [
      [new Uint8Array(), /^A saved state begins with 32 bytes; here there are 0\.$/],
      [bytes.subarray(0, 31), /^A saved state begins with 32 bytes; here there are 31\.$/],
      [bytes.subarray(0, 4000), /^The saved state should have \d+ bytes; it has 4000\.$/],
      [new TextEncoder().encode("no state at all, but long enough to be one"), /^This is no saved state of weft: /],
      [spoiled, /^The saved state is damaged: its checksum is [0-9a-f]{16} instead of [0-9a-f]{16}\.$/],
      [newer, /^The saved state is of version 9; this weft reads version 5\.$/],
      [await finer.saveState(), /^The saved state is of another scene: its hash is [0-9a-f]{16}, that of this one /],
      [new Uint8Array(20_000_000),
        /^There are 20000000 bytes, more than a saved state of this scene has: at most \d+\.$/],
    ];
    for (const [file, sentence] of refused) {
      const error = await failure(world.openState(file));
      expect(error.message).toMatch(sentence);
      expect(error.kind).toBe("input");
      expect([(await world.snapshot()).hash, world.statistics.frames]).toEqual([hash, frames]);
    }
    await world.setParameter("drag", 2); // another scene, until it is the same again
    expect((await failure(world.openState(bytes))).message).toContain("of another scene");
    await world.setParameter("drag", (JSON.parse(scene("hanging")) as { drag?: number }).drag ?? 0);
    await world.openState(bytes);
    expect(world.statistics.frames).toBe(2);
    await world.step(1);
    expect((await world.snapshot()).hash).toBe(hash);
  });

  it("saves and opens states without growing, and saves whole frames while it steps", async () => {
    const world = await open({ scene: scene("breeze"), set: { "cloths.0.grid": [24, 18] } });
    await world.step(1);
    const again = async (times: number) => {
      for (let i = 0; i < times; i++) await world.openState(await world.saveState());
      return world.memory();
    };
    const before = await again(3);
    const after = await again(100);
    expect(Math.abs(after.wasmHeap - before.wasmHeap)).toBeLessThan(2048);
    expect([after.gpuBytes, after.gpuObjects]).toEqual([before.gpuBytes, before.gpuObjects]);
    const [, between] = await Promise.all([world.step(6), world.saveState()]);
    const { hash } = await world.snapshot();
    await world.openState(between); // of whole frames, whichever it is
    const { frames } = world.statistics;
    expect(frames).toBeLessThanOrEqual(7);
    await world.step(7 - frames);
    expect((await world.snapshot()).hash).toBe(hash);
  });

  it("probes the force on a node: at rest its weight, and hanging the pins hold the sheet's", async () => {
    const world = await open({ set: { ...small, drag: 4 } });
    const { inverseMasses } = await world.snapshot();
    const nodes = [...inverseMasses.keys()];
    const pinned = nodes.filter((node) => inverseMasses[node] === 0);
    const weights: number[] = [];
    for (const node of nodes) {
      const { force, mass } = await world.probe(node);
      expect(Math.hypot(force[0], force[1] + 9.81 * mass, force[2])).toBeLessThan(1e-3); // of f32 in stiff springs [N]
      weights.push(9.81 * mass);
    }
    await world.step(400);
    const held = [0, 0, 0];
    for (const node of pinned) (await world.probe(node)).force.forEach((x, axis) => held[axis]! += x);
    const weight = weights.reduce((sum, one) => sum + one, 0);
    expect(Math.hypot(held[0]!, held[1]! + weight, held[2]!)).toBeLessThan(0.03 * weight);
  });

  it("says where nodes are at rest, also once they have moved", async () => {
    const world = await open();
    const rest = await world.restPositions();
    expect(rest.length).toBe(3 * world.info.nodes);
    const node = world.info.nodes - 5;
    const probed = await world.probe(node);
    expect([...rest.subarray(3 * node, 3 * node + 3)]).toEqual(probed.rest.map(Math.fround));
    await world.step(5);
    expect((await world.probe(node)).position).not.toEqual(probed.position);
    expect(await world.restPositions()).toEqual(rest);
  });

  it("pulls a grabbed node to its target, and lets it go", async () => {
    const world = await open();
    const node = 12 * 12 - 1; // the free corner at the right
    const rest = await world.positions();
    const target = [rest[3 * node]!, rest[3 * node + 1]! + 0.3, rest[3 * node + 2]!] as const;
    const distance = (positions: Float32Array) =>
      Math.hypot(...target.map((value, axis) => value - positions[3 * node + axis]!));
    await world.grab(node, [target[0], target[1], target[2] + 0.1]);
    await world.drag(node, target);
    await world.step(60);
    expect(distance(await world.positions())).toBeLessThan(1e-3); // exp(-20/s * 1 s) of 0.3 m
    expect((await failure(world.grab(node, target))).kind).toBe("input");
    await world.release(node);
    await world.step(20);
    expect(distance(await world.positions())).toBeGreaterThan(0.05); // it falls
    expect((await failure(world.drag(node, target))).message).toContain(String(node));
  });

  it("changes gravity while it moves, and refuses what shapes the cloth", async () => {
    const world = await open();
    await world.setParameter("gravity", [0, 9.81, 0]);
    await world.step(10);
    const positions = await world.positions();
    expect(positions[3 * 143 + 1]).toBeGreaterThan(0.05); // it falls upwards
    const error = await failure(world.setParameter("cloths.0.density", 3));
    expect(error.kind).toBe("input");
    expect(error.message).toContain("density");
    await world.step(1); // and goes on
  });

  it("takes another scene on the same device", async () => {
    const world = await open();
    const meshes = { sphere: readFileSync(join(ROOT, "models/sphere.ply")) };
    await world.load(scene("pull-sphere"), { meshes, set: { "cloths.0.grid": [20, 20], "time.substeps": 12 } });
    expect((await world.step(12)).contacts).toBeGreaterThan(0);
  });

  it("exports the present shape", async () => {
    const world = await open();
    await world.step(1);
    const obj = new TextDecoder().decode(await world.exportMesh("obj"));
    expect(obj.match(/^v /gm)).toHaveLength(144);
    expect(obj.match(/^f /gm)).toHaveLength(242);
    expect(new TextDecoder().decode((await world.exportMesh("ply")).slice(0, 3))).toBe("ply");
    expect(new TextDecoder().decode((await world.exportMesh("glb")).slice(0, 4))).toBe("glTF");
    expect((await failure(world.exportMesh("stl" as "obj"))).message).toBe(
      "The format stl is not known; there are obj, ply and glb.",
    );
  });

  it("reads a mesh file without a world, and gives its size and the mesh as PLY", async () => {
    // The second triangle is degenerate: its corners lie on a line.
    const obj = new TextEncoder().encode("v 0 0 0\nv 2 0 0\nv 0 3 0\nv 9 9 9\nv 1 0 0\nf 1 2 3\nf 1 5 2\n");
    const whole = await readMesh("a.obj", obj);
    expect([whole.vertices, whole.triangles, whole.dropped, whole.area, whole.low, whole.high]).toEqual([5, 2, 0, 3, [0,
      0, 0], [9, 9, 9]]);
    const cleaned = await readMesh("a.obj", obj, { cleaned: true });
    expect([cleaned.vertices, cleaned.triangles, cleaned.dropped, cleaned.area, cleaned.high]).toEqual([3, 1, 1, 3, [2,
      3, 0]]);
    expect(await readMesh("a.ply", cleaned.ply)).toEqual({ ...cleaned, dropped: 0 });
    expect((await failure(readMesh("a.glb", obj))).message)
      .toBe("While reading mesh a.glb: The file begins with 0x20302076, not with the 0x46546c67 of a GLB file.");
  });

  it("checks a scene without a world, and gives its size", async () => {
    const models = { sphere: readFileSync(join(ROOT, "models/sphere.ply")) };
    expect(await checkScene(scene("pull-sphere"), models)).toEqual({ nodes: 10_000, obstacleTriangles: 760 });
    expect((await failure(checkScene(scene("pull-sphere")))).message).toContain("sphere was not handed over");
  });

  it("says what is wrong with a scene, by kind and in a sentence", async () => {
    const key = await failure(open({ set: { "cloths.0.gird": [4, 4] } }));
    expect(key.kind).toBe("input");
    expect(key.message).toMatch(/gird.*grid/s);
    const mesh = await failure(open({ scene: scene("pull-dragon") }));
    expect([mesh.kind, mesh.message.includes("dragon")]).toEqual(["input", true]);
    const limit = await failure(open({ set: { "cloths.0.grid": [8000, 8000], "time.substeps": 1 } }));
    expect(limit.kind).toBe("limit");
    expect(limit.message).toMatch(/\d{9}/);
    const adapter = await failure(open({ adapter: "no such card" }));
    expect([adapter.kind, adapter.message.includes("no such card")]).toEqual(["no-adapter", true]);
  });

  it("says that there is no WebGPU", async () => {
    const none = { requestAdapter: async () => null } as unknown as GPU;
    expect((await failure(open({ gpu: none }))).kind).toBe("no-adapter");
  });

  it("reports the loss of its device, and starts again on a new one", async () => {
    const world = await open();
    await world.step(2);
    const before = (await world.snapshot()).hash;
    world.device!.destroy();
    expect((await failure(world.step(100))).kind).toBe("device-lost");
    await world.recover();
    await world.step(2);
    expect((await world.snapshot()).hash).toBe(before);
  });

  it("freezes where the cloth leaves all bounds, and says so", async () => {
    const world = await open({ set: { ...small, "time.substeps": 1 } });
    const error = await failure(world.step(400));
    expect(error.kind).toBe("diverged");
    expect((await failure(world.step(0))).message).toBe(error.message); // not that of a later frame
    expect((await world.positions()).every(Number.isFinite)).toBe(true);
  });
});
