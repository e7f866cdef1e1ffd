// The scenes in which methods are compared: the shipped ones, changed here or there so that more methods take them.
import type { Bytes, Catalog, Point } from "weft-cloth";
import { checkRoom, type Limits } from "../src/memory.js";
import { fetchScene, restated, type LoadedScene } from "../src/scenes.js";
import { plain, withKey } from "../src/state/page_state.js";
import { FORMULATION, GRAVITY, SOLVER } from "../src/state/parameters.js";
import type { Choice, MethodsState } from "./state.js";

export interface SceneEntry {
  readonly name: string;
  readonly title: string;
  /** Along the longer side, where nothing else is asked for. */
  readonly nodes: number;
  /** Of scenes/: its own name, where none is given. */
  readonly file?: string;
  /** What differs from the file, by dotted key. */
  readonly set?: Readonly<Record<string, unknown>>;
}

/** Springs that every method takes, in place of the sheet's bending by hinges: kSprings of src/bench/methods.cpp. */
const SPRINGS = { structural: 1500, shear: 750, bend: 15 }; // N/m

export const SCENES: readonly SceneEntry[] = [
  { name: "sheet", title: "Sheet of springs by two clips, as measured below", nodes: 64,
    set: { "cloths.0.stiffness": SPRINGS } },
  { name: "hanging", title: "Stiffer sheet by two corners", nodes: 64 },
  { name: "breeze", title: "Sheet on a line in a breeze", nodes: 64 },
  { name: "drape-sphere", title: "Draped over a ball: contact", nodes: 48 },
  { name: "fabric", title: "Measured fabric by two clips: triangles, not springs", nodes: 64 },
];

/** A scene with all that every method gets of it. */
export interface Comparison {
  readonly entry: SceneEntry;
  readonly loaded: LoadedScene;
  /** [m/s²] */
  readonly gravity: Point;
}

export async function fetchComparison({ scene, nodes }: MethodsState, catalog: Catalog): Promise<Comparison> {
  const entry = SCENES.find(({ name }) => name === scene)!;
  const asked = { ...plain(entry.file ?? entry.name, "textured"), nodes: nodes ?? entry.nodes };
  const loaded = await fetchScene(asked, catalog);
  return { entry, loaded, gravity: loaded.own(GRAVITY) as Point };
}

export interface SceneByMethod {
  readonly scene: string;
  readonly meshes: Readonly<Record<string, Bytes>>;
  readonly set: Readonly<Record<string, unknown>>;
}

/** The scene by this method. Errors  a sentence where it has no room on this adapter. */
export function byMethod({ entry, loaded }: Comparison, choice: Choice, limits: Limits): SceneByMethod {
  const { kind, substeps, settings } = choice;
  const asked = withKey(withKey(loaded.state, SOLVER, kind), FORMULATION, settings["forces"] ?? null);
  checkRoom([restated(loaded, asked)], limits);
  return { scene: loaded.json, meshes: loaded.meshes,
    set: { ...loaded.set, ...entry.set, solver: { kind, ...settings }, "time.substeps": substeps } };
}
