// The reference on the CPU: the same bits natively, in Node and in Chromium, and what it says where it cannot run.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { createReference, meshNames, WeftError, type Reference } from "weft-cloth";
import { openPage, ROOT, type Harness } from "./chromium.ts";

interface Case {
  scene: string;
  frames: number;
  set: Record<string, unknown>;
}
const CASES: Case[] = [
  { scene: "hanging", frames: 5, set: { "cloths.0.grid": [16, 16] } },
  { scene: "pull-sphere", frames: 12, set: { "cloths.0.grid": [16, 16], "contact.method": "bvh" } }, // 200 contacts
  { scene: "pull-sphere", frames: 12, set: { "cloths.0.grid": [16, 16], "contact.method": "proximity" } },
  { scene: "sheet", frames: 5, set: { "cloths.0.grid": [16, 16] } },
  { scene: "breeze", frames: 10, set: { "cloths.0.grid": [24, 16] } },
  { scene: "drag", frames: 40, set: { "cloths.0.grid": [16, 16] } }, // the corner is taken after 30
];
const text = (scene: string) => readFileSync(join(ROOT, `scenes/${scene}.json`), "utf8");

function native({ scene, frames, set }: Case): string {
  const changes = Object.entries(set).map(([key, value]) => `${key}=${JSON.stringify(value)}`);
  return execFileSync(join(ROOT, "build/reference_hash"), [join(ROOT, `scenes/${scene}.json`), String(frames),
    ...changes], { encoding: "utf8" }).trim();
}

async function node({ scene, frames, set }: Case): Promise<string> {
  const meshes = Object.fromEntries(
    meshNames(text(scene)).map((name) => [name, readFileSync(join(ROOT, `models/${name}.ply`))]),
  );
  const reference = await createReference({ scene: text(scene), meshes, set });
  reference.advance(frames);
  const hash = reference.hash();
  reference.dispose();
  return hash;
}

function chromium({ page }: Harness, { scene, frames, set }: Case): Promise<string> {
  return page.evaluate(async ([scene, frames, set]) => {
    const { createReference, meshNames } = window.weft;
    const text = await (await fetch(`/scenes/${scene}.json`)).text();
    const meshes: Record<string, ArrayBuffer> = {};
    for (const name of meshNames(text)) meshes[name] = await (await fetch(`/models/${name}.ply`)).arrayBuffer();
    const reference = await createReference({ scene: text, meshes, set });
    reference.advance(frames);
    const hash = reference.hash();
    reference.dispose();
    return hash;
  }, [scene, frames, set] as const);
}

describe("the reference has the same bits on every host", () => {
  let harness: Harness;
  beforeAll(async () => {
    harness = await openPage([]);
  }); // it needs no GPU
  afterAll(() => harness.close());

  it.each(CASES)("$scene", async (scene) => {
    const expected = native(scene);
    expect(expected).toMatch(/^[0-9a-f]{16}$/);
    expect(await node(scene)).toBe(expected);
    expect(await chromium(harness, scene)).toBe(expected);
    expect(harness.complaints).toEqual([]);
  });
});

describe("a reference", () => {
  const small = { "cloths.0.grid": [12, 12] };
  const open = (set: Record<string, unknown> = {}): Promise<Reference> =>
    createReference({ scene: text("hanging"), set: { ...small, ...set } });
  const failed = (reason: unknown): WeftError => {
    expect(reason).toBeInstanceOf(WeftError);
    return reason as WeftError;
  };
  const failure = (promise: Promise<unknown>) =>
    promise.then(() => {
      throw new Error("It did not fail.");
    }, failed);

  it("goes back to the exact rest state, and takes the same way again", async () => {
    const reference = await open();
    const rest = reference.hash();
    reference.advance(4);
    const moved = reference.hash();
    expect(moved).not.toBe(rest);
    expect(reference.seconds).toBeCloseTo(4 / 60, 12);
    reference.reset();
    expect([reference.hash(), reference.seconds]).toEqual([rest, 0]);
    reference.advance(4);
    expect(reference.hash()).toBe(moved);
    reference.dispose();
    expect(() => reference.advance()).toThrow(WeftError);
  });

  it("has the energy of its motion, of its springs and in gravity, in closed form", async () => {
    // Two nodes of 0.1 kg, each below a pin at 0.15 m on a spring of 20 N/m and 0.3 m; steps of 10 ms.
    const [mass, stiffness, gravity, step] = [0.1, 20, 10, 0.01];
    const reference = await createReference({
      scene: { format: "weft-scene/1", gravity: [0, -gravity, 0], time: { frame: step, substeps: 1 },
        solver: { kind: "mass_spring" }, contact: { method: "none" },
        cloths: [{ grid: [2, 2], size: [0.3, 0.3], node_mass: mass, damping: 0,
          stiffness: { structural: stiffness, shear: 0, bend: 0 }, pins: ["top"] }] },
    });
    expect(reference.energy).toBeCloseTo(2 * mass * gravity * -0.15, 7);
    reference.advance(); // each is then as fast as g h, and g h² lower
    const fallen = gravity * step ** 2;
    expect(reference.energy).toBeCloseTo(
      2 * ((mass * (gravity * step) ** 2) / 2 + (stiffness * fallen ** 2) / 2 - mass * gravity * (0.15 + fallen)),
      7,
    );
    reference.reset();
    expect(reference.energy).toBeCloseTo(2 * mass * gravity * -0.15, 7);
    reference.dispose();
    expect(() => reference.energy).toThrow(WeftError);
  });

  it("says what is wrong with a scene, by kind and in a sentence", async () => {
    const key = await failure(open({ "cloths.0.gird": [4, 4] }));
    expect(key.kind).toBe("input");
    expect(key.message).toMatch(/gird.*grid/s);
    expect((await failure(createReference({ scene: "{" }))).kind).toBe("input");
    const mesh = await failure(createReference({ scene: text("pull-sphere") }));
    expect([mesh.kind, mesh.message.includes("sphere")]).toEqual(["input", true]);
  });

  it("refuses a scene that has no room in the module, before it is built", async () => {
    const limit = await failure(open({ "cloths.0.grid": [8000, 8000], "time.substeps": 1 }));
    expect(limit.kind).toBe("limit");
    expect(limit.message).toMatch(/64000000 nodes.*\d{9}/);
  });

  it("keeps the last finite state where the cloth leaves all bounds, and says so", async () => {
    const reference = await open({ "time.substeps": 1 });
    let before = "";
    const run = () => {
      for (let frame = 0; frame < 5000; frame++) {
        before = reference.hash();
        reference.advance();
      }
    };
    let error: WeftError | null = null;
    try {
      run();
    } catch (reason) {
      error = failed(reason);
    }
    expect(error?.kind).toBe("diverged");
    expect(error?.message).toMatch(/^In frame \d+ /);
    expect(reference.hash()).toBe(before);
    reference.dispose();
  });
});
