// A scene's memory, estimated before it is allocated: from measured bytes, with the limits of adapter and module.
import type { Method } from "weft-cloth";
import type { LoadedScene } from "./scenes.js";
import { CONTACT_METHOD, FORMULATION, SOLVER } from "./state/parameters.js";

/** What a grid asks for [bytes]. */
export interface Demand {
  readonly nodes: number;
  /** The buffers on the GPU. */
  readonly gpu: number;
  /** The largest of them. */
  readonly buffer: number;
  /** Of the WebAssembly module, beside what it has empty: while a file of the shape is made. */
  readonly module: number;
}

/** The most that there is [bytes]. */
export interface Limits {
  /** The adapter's maxStorageBufferBindingSize. */
  readonly buffer: number;
  readonly module: number;
}

const MODULE_MOST = 2 ** 31; // Emscripten's own limit
const MODULE_NODE = 490; // kWorldBytesPerNode of src/model/assets.hpp

/** What the adapter gives at most; the module's limit is the same everywhere. */
export async function adapterLimits(): Promise<Limits> {
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
  return { buffer: adapter?.limits.maxStorageBufferBindingSize ?? 0, module: MODULE_MOST };
}

// Bytes a node, and a triangle of an obstacle, measured at 32² to 256² nodes; tests/web/page/memory.test.ts holds the
// sum to info.gpuBytes within 10 %.
const NODE = { all: 189, proximity: 273, pushes: 17 }; // beside what the solver asks for: catalog().methods
const OBSTACLE = { drawn: 29, proximity: 112, pushes: 71 };
// The lists of first_room (src/contact/scene_contact.cpp). They grow where they are short.
const LISTS = {
  pairs: { least: 32_768, triangle: 2, entry: 32 },
  near: { least: 16_384, triangle: 1 / 2, entry: 128 },
  candidates: { least: 131_072, triangle: 12, entry: 8 },
} as const;
const KEPT = 64; // of a near pair: the forces that ContactPairs::kept has room for, beside the table over them
const HELD = { near: 96, node: 32 }; // of pairs in a solver's matrix: ContactPairs::pair_holds, pair_sums
const POSITION = 16; // of a node

/** The methods that the scene's solver is; where that is "auto", may become. */
function chosenMethods(scene: LoadedScene): readonly Method[] {
  const asked = scene.now(SOLVER);
  return scene.methods.filter(({ kind }) => kind === asked || asked === "auto");
}

/** What the scene's solver asks for a node, at most. */
function solverMemory(scene: LoadedScene): { readonly node: number; readonly buffer: number } {
  const chosen = chosenMethods(scene)
    .map(({ memory }) => memory[String(scene.now(FORMULATION))] ?? memory[""]!);
  return { node: Math.max(...chosen.map(({ node }) => node)), buffer: Math.max(...chosen.map(({ buffer }) => buffer)) };
}

/** The buffers of proximity's lists over so many triangles of cloth; `held`: also of pairs that a matrix has. */
function listBuffers(triangles: number, held: boolean): number[] {
  const entries = (list: keyof typeof LISTS) =>
    Math.max(LISTS[list].least, Math.floor(triangles * LISTS[list].triangle));
  const near = entries("near");
  const table = 4 * 2 ** Math.ceil(Math.log2(2 * near));
  return [
    ...(["pairs", "near", "candidates"] as const).map((list) => entries(list) * LISTS[list].entry),
    near * KEPT + table,
    held ? near * HELD.near : 0,
  ];
}

/** What `nodes` nodes in all ask for, in this scene with its methods. */
export function demand(nodes: number, scene: LoadedScene): Demand {
  const method = scene.now(CONTACT_METHOD);
  const [proximity, pushes] = [method === "proximity", method === "bvh" || method === "paper"];
  const held = proximity && chosenMethods(scene).some(({ holdsContact }) => holdsContact);
  const lists = proximity ? listBuffers(2 * nodes, held) : [];
  const solver = solverMemory(scene);
  const contact = proximity ? NODE.proximity + (held ? HELD.node : 0) : pushes ? NODE.pushes : 0;
  const node = NODE.all + solver.node + contact;
  const obstacle = OBSTACLE.drawn + (proximity ? OBSTACLE.proximity : pushes ? OBSTACLE.pushes : 0);
  return {
    nodes,
    gpu: lists.reduce((sum, bytes) => sum + bytes, nodes * node + scene.obstacleTriangles * obstacle),
    buffer: Math.max(Math.max(POSITION, solver.buffer) * nodes, ...lists),
    module: MODULE_NODE * nodes,
  };
}

/** The demand of a loaded scene as it is. */
export function demandOf(scene: LoadedScene): Demand | null {
  return scene.grid && demand(scene.grid.taken[0] * scene.grid.taken[1] * scene.copies, scene);
}

/** Why a demand cannot be met; null where it can. `cloths`: in how many worlds it is. */
export function tooLarge({ nodes, buffer, module }: Demand, limits: Limits, cloths = 1): string | null {
  const who = cloths === 1 ?
    `A cloth of ${nodes.toLocaleString("en")} nodes needs` :
    `${cloths} cloths of ${nodes.toLocaleString("en")} nodes together need`;
  if (buffer > limits.buffer)
    return `${who} ${cloths === 1 ? "a buffer" : "buffers"} of ${inBytes(buffer)}, more than this adapter's ${
      inBytes(limits.buffer)
    }.`;
  if (module > limits.module)
    return `${who} ${inBytes(module)} of the module's memory, more than its ${inBytes(limits.module)}.`;
  return null;
}

/** Throws a sentence where scenes, each in a world of its own, have no room together. */
export function checkRoom(scenes: readonly LoadedScene[], limits: Limits): void {
  const asked = scenes.map(demandOf).filter((one) => one !== null);
  const fault = asked.length > 0 ? tooLarge(asked.reduce(together), limits, asked.length) : null;
  if (fault !== null) throw new Error(fault);
}

/** What two worlds ask for: the limits of one hold for both. */
function together(a: Demand, b: Demand): Demand {
  return { nodes: a.nodes + b.nodes, gpu: a.gpu + b.gpu, buffer: a.buffer + b.buffer, module: a.module + b.module };
}

/** As in 12 MB. */
export function inBytes(bytes: number): string {
  const [unit, name] = bytes < 1e6 ? [1e3, "kB"] : bytes < 1e9 ? [1e6, "MB"] : [1e9, "GB"];
  const value = bytes / unit;
  return `${value.toFixed(value < 10 ? 1 : 0)} ${name}`;
}
