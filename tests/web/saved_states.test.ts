// A state that one host has saved goes on in every other, to the bits of a run that never stopped.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { OpenedState } from "weft-cloth";
import { openPage, ROOT, type Harness } from "./chromium.ts";
import { CASES, runOf, worldOf, type Case } from "./host_cases.ts";

const AFTER = 2; // frames from where the state was saved
const PART = process.env["WEFT_PART"];
/** Rigid bodies' kernels take Chromium's driver more than a minute, and hosts.test.ts has them. */
const ours = CASES.filter(({ scene }) => scene !== "hammock");
const inTurn = ours.filter((_, k) => PART === undefined || k % 3 === Number(PART) % 3);

interface Outcome {
  hash: string;
  frames: number;
  contacts: number;
  contactHash: number;
}

describe("a saved state", () => {
  let harness: Harness;
  let folder: string;
  beforeAll(async () => {
    harness = await openPage();
    folder = mkdtempSync(join(tmpdir(), "weft-states-"));
  });
  afterAll(async () => {
    await harness.close();
    rmSync(folder, { recursive: true });
  });

  function native(one: Case, frames: number, more: string[] = []): Outcome {
    const out = execFileSync(join(ROOT, "build/weft"), [...runOf(one), "--frames", String(frames), ...more], {
      encoding: "utf8",
      stdio: ["ignore", "pipe", "ignore"],
    });
    const summary = JSON.parse(out) as Record<string, never>;
    return { hash: summary["state_hash"]!, frames: summary["frames"]!, contacts: summary["contacts"]!,
      contactHash: summary["contact_hash"]! };
  }

  /** From `bytes`: the outcome, and what the world saves where it goes on from. */
  async function node(one: Case, bytes: Uint8Array): Promise<Outcome & { opened: OpenedState; again: Uint8Array }> {
    const world = await worldOf(one);
    const opened = await world.openState(bytes);
    const again = await world.saveState();
    const { frames, contacts, contactHash } = await world.step(AFTER);
    const { hash } = await world.snapshot();
    world.dispose();
    return { hash, frames, contacts, contactHash, opened, again };
  }

  /** The same, as base64. */
  function chromium(one: Case, bytes: Uint8Array): Promise<Outcome & { again: string }> {
    return harness.page.evaluate(async ([scene, set, after, base64]) => {
      const { createWorld, meshNames } = window.weft;
      const text = await (await fetch(`/scenes/${scene}.json`)).text();
      const meshes: Record<string, ArrayBuffer> = {};
      for (const name of meshNames(text)) meshes[name] = await (await fetch(`/models/${name}.ply`)).arrayBuffer();
      const world = await createWorld({ scene: text, canvas: document.querySelector("canvas"), meshes, set });
      await world.openState(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
      let again = "";
      for (const byte of await world.saveState()) again += String.fromCharCode(byte);
      const { frames, contacts, contactHash } = await world.step(after);
      const { hash } = await world.snapshot();
      world.dispose();
      return { hash, frames, contacts, contactHash, again: btoa(again) };
    }, [one.scene, one.set, AFTER, Buffer.from(bytes).toString("base64")] as const);
  }

  it.each(inTurn)("of $name goes on natively, in Node and in Chromium", async (one) => {
    const before = one.frames;
    const whole = native(one, before + AFTER);
    expect(whole.frames).toBe(before + AFTER);
    native(one, before, ["--out", folder, "--no-pictures", "--checkpoint-every", String(before)]);
    const file = join(folder, `checkpoint_${String(before).padStart(5, "0")}.weft`);

    const { opened, again, ...inNode } = await node(one, readFileSync(file));
    expect(inNode).toEqual(whole);
    expect(opened.grabs).toEqual([]);
    expect(opened.otherOrigin).toMatch(
      /^The state was saved by weft \S+ \(commit .*: bits may differ from those of a run /,
    );

    const { again: last, ...inChromium } = await chromium(one, again);
    expect(inChromium).toEqual(whole);
    expect(harness.complaints).toEqual([]);

    writeFileSync(file, Buffer.from(last, "base64"));
    expect(native(one, before + AFTER, ["--resume", file])).toEqual(whole);
  });
});
