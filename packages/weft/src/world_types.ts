// The arguments and results of a world. Lengths are metres, times seconds.
import type { WeftError } from "./error.js";
import type { Bytes, Scene } from "./scene.js";
import type { Totals } from "./totals.js";

export const VIEWS = ["textured", "wireframe", "normals", "stretch", "velocity", "contacts"] as const;
export type View = (typeof VIEWS)[number];
/** Metres. */
export type Point = readonly [x: number, y: number, z: number];

export interface SceneOptions {
  /** Mesh files by the name that the scene gives them; those of earlier scenes are still known. */
  meshes?: Readonly<Record<string, Bytes>>;
  /** Changes before the scene is checked, by dotted key: `{ "cloths.0.grid": [128, 128] }`. */
  set?: Readonly<Record<string, unknown>>;
}

export interface WorldOptions extends SceneOptions {
  scene: Scene;
  /** Where to draw; null: nowhere, as in Node and in tests. */
  canvas: HTMLCanvasElement | OffscreenCanvas | null;
  /** Default: that of the browser. In Node: `create([])` of the package `webgpu`. */
  gpu?: GPU;
  /**
   * A device of the page's own, which the world shares: `DEVICE_LIMITS` has what it needs, and no feature. The world
   * never destroys it; its own errors stay away from the device's `uncapturederror`. Default: one of the world's own,
   * with all that the adapter has.
   */
  device?: GPUDevice;
  /** Part of the adapter's name; another adapter is refused. */
  adapter?: string;
  view?: View;
}

export interface StepOptions {
  /**
   * Whether to draw every frame; false: what the last has left, in the next tick; null: nothing before `redraw`, so
   * that no picture is drawn while something else is timed. Without a canvas, nothing is drawn.
   */
  draw?: boolean | null;
}

/** What was loaded. */
export interface WorldInfo {
  adapter: string;
  /** What is drawn: that of before, but "textured" where the scene has no pairs to show as "contacts". */
  view: View;
  /** Why a view has nothing to show in this scene, of those for which it is so; none without a canvas. */
  refusedViews: Partial<Record<View, string>>;
  /** The method that moves the cloth; why solver.kind "auto" took it, null where the scene names it. */
  solver: string;
  solverReason: string | null;
  nodes: number;
  triangles: number;
  springs: number;
  /** Of cloths of fabric. */
  membranes: number;
  hinges: number;
  /** Of the membranes, those far thinner than a neighbour: they bend freely. */
  slivers: number;
  /** Of bodies. */
  tetrahedra: number;
  /** Whether cloth may tear or is sewn: nodes and triangles then become others while it runs, and `mesh` is told. */
  changesMesh: boolean;
  /** Steps a frame, and how long each is and may be [s]. */
  substeps: number;
  stepSeconds: number;
  stableStepSeconds: number;
  /** Why the steps are too long, one sentence: the cloth may blow up. null: they are not. */
  unstableStep: string | null;
  /** Simulated time of a frame [s]. */
  frameSeconds: number;
  /** Frames that the scene asks for. */
  frames: number;
  /** Triangles of obstacles without area, left out. */
  droppedTriangles: number;
  gpuBytes: number;
  /** Whether the adapter can time passes. */
  timestamps: boolean;
}

/** The totals, and times of the host. */
export interface Statistics extends Totals {
  /** Simulated time of the frames that have reported [s]. */
  seconds: number;
  /** Simulated time that came due while running and was left out, since the machine was late [s]. */
  droppedSeconds: number;
}

/** What the dispatches of one kernel took together. */
export interface PassTime {
  kernel: string;
  /** Of a search for pairs, a step, or the end of a frame. */
  per: "search" | "step" | "frame";
  dispatches: number;
  milliseconds: number;
}

export interface Snapshot {
  /** x, y, z of every node in model order [m], then [m/s]. */
  positions: Float32Array;
  velocities: Float32Array;
  /** One a node [1/kg]; 0: pinned, or moved by the scene. */
  inverseMasses: Float32Array;
  /** XXH3-64 of the bits of the state: equal on every host with the same adapter. */
  hash: string;
}

/** A frame in numbers: energies [J] and what the frame has reported. */
export interface Measures {
  /** How many frames there were, and the simulated time at the end of the last [s]. */
  frame: number;
  seconds: number;
  /** Of free nodes. */
  kinetic: number;
  /** Of the same in gravity and the external force, 0 at the origin. */
  potential: number;
  /** Elastic, by what is stretched and bent; those of tetrahedra are of bodies. */
  springs: number;
  membranes: number;
  bending: number;
  tetrahedra: number;
  /** Of what closed cloths enclose and of the air around it, 0 at rest. */
  gas: number;
  /** The largest length of an edge over its rest length. */
  maxStretch: number;
  /** Summed over the frame's substeps. */
  contacts: number;
  /** The largest part of its residual that a linear system kept (implicit solver). */
  residual: number;
}

/** A node at the end of the last frame. */
export interface Probe {
  /** [m] */
  position: Point;
  /** Of the cloth's shape at rest, in the world [m]. */
  rest: Point;
  /** [m/s] */
  velocity: Point;
  /** [kg] */
  mass: number;
  /** The largest length of an edge at it, over that at rest. */
  stretch: number;
  /** Force per width at rest, along the direction that bears most [N/m]; of a body with volume 0. */
  tension: number;
  /**
   * Of its elements, of what a closed cloth encloses, and of its weight [N]: a node that is pinned, moved or grabbed is
   * held with the opposite. What air, drag and contact do to it is not in it.
   */
  force: Point;
}

/** What a world has gone on from. */
export interface OpenedState {
  /** The nodes that it has grabbed, and where they are drawn to [m]: `drag` and `release` take them. */
  grabs: { node: number; target: Point }[];
  /** Where it comes from, one sentence, if not from this version of the package and this adapter: bits may differ from
   * those of a run that goes on there. null: they do not. */
  otherOrigin: string | null;
}

/** A buffer of the world's: an element begins every `stride` bytes from `offset` on, with numbers of `format`. */
export interface WorldBuffer {
  readonly buffer: GPUBuffer;
  readonly offset: number;
  readonly stride: number;
  /** Elements. */
  readonly count: number;
  readonly format: "float32x3" | "float32" | "uint32x3";
}

/**
 * The state at the end of the last frame, where it lies on the GPU. The numbers of an element beyond its format are
 * weft's own. All have the usages STORAGE, COPY_SRC, COPY_DST and VERTEX, but triangles INDEX instead of VERTEX.
 */
export interface WorldBuffers {
  /** Of every node in model order [m]. */
  readonly position: WorldBuffer;
  /** [m/s] */
  readonly velocity: WorldBuffer;
  /** Unit vectors. */
  readonly normal: WorldBuffer;
  /** Length over rest length of the most stretched edge at a node. */
  readonly stretch: WorldBuffer;
  /** Three nodes each; the buffer serves as an index buffer of format "uint32". */
  readonly triangles: WorldBuffer;
}

export interface Pick {
  node: number;
  /** Where the ray meets the cloth [m]. */
  point: Point;
}

export interface Camera {
  eye: Point;
  target: Point;
  /** Vertical field of view [degrees]. */
  fov: number;
}

/** Bytes and objects that are in use. */
export interface MemoryUse {
  wasmHeap: number;
  wasmSize: number;
  gpuBytes: number;
  gpuObjects: number;
}

/** A frame that was simulated, and what it has reported. */
export interface Step {
  /** Its number, from 1. */
  frame: number;
  /** Simulated time at its end [s]. */
  seconds: number;
  /** Of the frames up to this one. */
  totals: Totals;
}

/** What a world tells its listeners. */
export interface Events {
  /** After a tick of run in which a frame was simulated or drawn: what `buffers` gives has it. */
  frame: Readonly<Statistics>;
  /** Every frame once, in their order, by run or by step: when the GPU has reported it, up to three frames later. */
  step: Readonly<Step>;
  /** Cloth was sewn or has torn before a frame, or is whole again: `info` has other nodes and triangles from now on. */
  mesh: WorldInfo;
  /** A sentence about it: cloth begins to tear, a seam is closed or does not close. */
  news: string;
  /**
   * Something failed that no promise tells of: while running, or the device was lost. The world is paused. After
   * "device-lost", `recover` starts again.
   */
  error: WeftError;
}
