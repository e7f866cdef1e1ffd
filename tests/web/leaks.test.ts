// Switching scenes leaves nothing behind: not in the module's memory, not on the GPU.
import { afterAll, beforeAll, expect, it } from "vitest";
import { openPage, type Harness } from "./chromium.ts";

const SWITCHES = 100;

let harness: Harness;
beforeAll(async () => {
  harness = await openPage();
});
afterAll(() => harness.close());

it(`${SWITCHES} scene switches leave WASM memory and GPU bytes where they were`, async () => {
  const { uses, times } = await harness.page.evaluate(async (switches) => {
    const { createWorld } = window.weft;
    const sphere = await (await fetch("/models/sphere.ply")).arrayBuffer();
    const texts = await Promise.all(
      ["hanging", "pull-sphere", "breeze"].map(async (name) => (await fetch(`/scenes/${name}.json`)).text()),
    );
    const set = { "cloths.0.grid": [16, 16], "time.substeps": 4, "time.frame": 0.001 };
    const world = await createWorld({ scene: texts[0]!, canvas: document.querySelector("canvas"), meshes: { sphere },
      set });
    const uses = [];
    const times = [];
    for (let i = 0; i <= switches; i++) {
      const start = performance.now();
      await world.load(texts[i % 3]!, { set });
      await world.step(2);
      times.push(performance.now() - start);
      if (i % 3 === 1 && i > 3) uses.push(world.memory()); // the same scene each time
    }
    world.dispose();
    return { uses, times };
  }, SWITCHES);
  console.log(`${(times.reduce((sum, time) => sum + time, 0) / times.length).toFixed(0)} ms a switch`);
  expect(uses.length).toBeGreaterThan(SWITCHES / 3 - 2);
  expect(uses[0]!.gpuObjects).toBeGreaterThan(50);
  for (const { wasmHeap, ...use } of uses) {
    expect(use).toEqual({ wasmSize: uses[0]!.wasmSize, gpuBytes: uses[0]!.gpuBytes, gpuObjects: uses[0]!.gpuObjects });
    // The allocator's own rounding moves by some hundred bytes; a leak of one small object a switch makes 3 KB.
    expect(Math.abs(wasmHeap - uses[0]!.wasmHeap)).toBeLessThan(1024);
  }
  expect(harness.complaints).toEqual([]);
});
