// The ways that are compared, in the order of the table's columns.
import type { Open } from "./paths/path.js";

export interface Entry {
  readonly name: string;
  readonly title: string;
  /** What computes, and what draws. */
  readonly computes: string;
  readonly draws: string;
  /** How a batch is known to be done. */
  readonly waits: string;
  /** Loaded only where it is asked for. */
  load(): Promise<Open>;
}

const WEBGPU_WAIT = "onSubmittedWorkDone of the queue";

export const CATALOG = [
  { name: "weft-node", title: "weft, by node",
    computes: "WebGPU: one invocation a node gathers its springs; no lists, no atomics",
    draws: "weft, with its shadow map and its check of the state",
    waits: `${WEBGPU_WAIT}, and the reports of all frames`,
    load: async () => (await import("./paths/weft.js")).openNodeCentric },
  { name: "weft-spring", title: "weft, by spring",
    computes: "WebGPU: the paper's algorithm, one invocation a spring, fixed-point atomics", draws: "as by node",
    waits: "as by node", load: async () => (await import("./paths/weft.js")).openSpringCentric },
  { name: "three-webgpu", title: "three.js, WebGPU",
    computes: "WebGPU: three.js r187's kernels in TSL, as in its cloth example: " +
      "a kernel over springs, then one over nodes with lists", draws: "three.js on WebGPU, from the same buffer",
    waits: WEBGPU_WAIT, load: async () => (await import("./paths/three_webgpu.js")).open },
  { name: "webgl2", title: "WebGL 2 shaders",
    computes: "WebGL 2: a fragment a node gathers its springs; the state in float textures",
    draws: "WebGL 2, from the same textures", waits: "readPixels of one pixel",
    load: async () => (await import("./paths/webgl2.js")).open },
  { name: "cpu", title: "CPU, JavaScript",
    computes: "one thread of the processor: JavaScript over typed arrays, in doubles",
    draws: "three.js on WebGL; positions and normals are uploaded for each frame",
    waits: "readPixels of one pixel; steps alone need no wait",
    load: async () => (await import("./paths/cpu.js")).open },
] as const satisfies readonly Entry[];

export type PathName = (typeof CATALOG)[number]["name"];
