// One core, three hosts: the same scene gives the same bits natively, in Node and in Chromium.
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { openPage, ROOT, type Harness } from "./chromium.ts";
import { CASES, runOf, worldOf, type Case } from "./host_cases.ts";

interface Outcome {
  hash: string;
  substeps: number;
  contacts: number;
  contactHash: number;
}

function native(one: Case): Outcome {
  const out = execFileSync(join(ROOT, "build/weft"), [...runOf(one), "--frames", String(one.frames)], {
    encoding: "utf8",
  });
  const summary = JSON.parse(out) as Record<string, never>;
  return { hash: summary["state_hash"]!, substeps: summary["substeps"]!, contacts: summary["contacts"]!,
    contactHash: summary["contact_hash"]! };
}

async function node(one: Case): Promise<Outcome> {
  const world = await worldOf(one);
  const { contacts, contactHash } = await world.step(one.frames);
  const { hash } = await world.snapshot();
  const { substeps } = world.info;
  world.dispose();
  return { hash, substeps, contacts, contactHash };
}

function chromium(harness: Harness, { scene, frames, set }: Case): Promise<Outcome> {
  return harness.page.evaluate(async ([scene, frames, set]) => {
    const { createWorld, meshNames } = window.weft;
    const text = await (await fetch(`/scenes/${scene}.json`)).text();
    const meshes: Record<string, ArrayBuffer> = {};
    for (const name of meshNames(text)) meshes[name] = await (await fetch(`/models/${name}.ply`)).arrayBuffer();
    const world = await createWorld({ scene: text, canvas: document.querySelector("canvas"), meshes, set });
    const { contacts, contactHash } = await world.step(frames);
    const { hash } = await world.snapshot();
    const { substeps } = world.info;
    world.dispose();
    return { hash, substeps, contacts, contactHash };
  }, [scene, frames, set] as const);
}

/** Chromium's driver compiles for minutes, so in CI's part N every third has a turn. */
const PART = process.env["WEFT_PART"];
const IN_TURN = CASES.filter((_, k) => PART === undefined || (k + 1 + Number(PART)) % 3 === 0);

describe("the same state hash on every host", () => {
  let harness: Harness;
  beforeAll(async () => {
    harness = await openPage();
  });
  afterAll(() => harness.close());

  it.each(IN_TURN)("$name", async (scene) => {
    const expected = native(scene);
    expect(expected.hash).toMatch(/^[0-9a-f]{16}$/);
    if (scene.name.startsWith("pull")) expect(expected.contacts).toBeGreaterThan(100);
    expect(await node(scene)).toEqual(expected);
    expect(await chromium(harness, scene)).toEqual(expected);
    expect(harness.complaints).toEqual([]);
  });
});
