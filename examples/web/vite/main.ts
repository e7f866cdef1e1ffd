// A flag in the wind, bundled by Vite: the core's .wasm and the worker become files of the page.
import { createWorld, type Scene } from "weft-cloth";

const scene: Scene = {
  format: "weft-scene/1",
  wind: { velocity: [0, 0, 4], gusts: 0.5 },
  drag: 1,
  contact: { method: "none" },
  cloths: [{ grid: [48, 32], size: [1.5, 1], density: 0.2, pins: ["left"] }],
};
const canvas = document.querySelector("canvas")!;
const line = document.querySelector("output")!;

const checker = new Worker(new URL("./checker.ts", import.meta.url), { type: "module" });
checker.onmessage = async ({ data }: MessageEvent<string>) => {
  line.value = data;
  try {
    const world = await createWorld({ scene, canvas });
    world.on("step", ({ seconds }) => line.value = `${data}, ${seconds.toFixed(2)} s`);
    world.run();
  } catch (error) {
    line.value = String(error); // one sentence: without WebGPU, what is missing
  }
};
checker.postMessage(scene);
