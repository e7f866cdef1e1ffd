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

/** What a world has gone on from. */
export interface OpenedState {
  /** The nodes that it has grabbed, and where they are drawn to [m]: `drag` and `release` take them. */
  grabs: { node: number; target: Point }[];
  /** Where it comes from, one sentence, if not from this version of the package and this adapter: bits may differ from
   * those of a run that goes on there. null: they do not. */
  otherOrigin: string | null;
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

/** What a world tells its listeners. */
export interface Events {
  /** After a tick of run in which a frame was simulated or drawn. */
  frame: Readonly<Statistics>;
  /**
   * Something failed that no promise tells of: while running, or the device was lost. The world is paused. After
   * "device-lost", `recover` starts again.
   */
  error: WeftError;
}
