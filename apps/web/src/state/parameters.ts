// The keys of a scene that the page lets change, which are those of the window of `weft view`, and the sun's direction.
// Limits, units and what they mean come from the core's schema.
import type { Catalog } from "weft-cloth";
import list from "../../../shared/parameters.json";
import type { LoadedScene } from "../scenes.js";
import { withKey, type PageState, type Value } from "./page_state.js";

export interface Parameter {
  readonly key: string;
  readonly label: string;
  /** Of one that changes while the cloth moves: the least range of its slider. */
  readonly reach?: number;
  /** Keys of the scene in whose place it stands: where it is chosen they go, unless they are chosen too. */
  readonly clears?: readonly string[];
}

export interface Group {
  readonly name: string;
  readonly title: string;
  /** Whether its keys change while the cloth moves; else they restart the scene. */
  readonly live: boolean;
  readonly parameters: readonly Parameter[];
}

export const SOLVER = "solver.kind";
export const FORMULATION = "solver.forces"; // of the explicit solver
export const CONTACT_METHOD = "contact.method";
export const GRAVITY = "gravity";
export const WIND = "wind.velocity";
export const SUBSTEPS = "time.substeps";
export const DRAG = "drag";
export const AIR = "air"; // of a scene whose air pushes on triangles
export const AIR_DENSITY = "air.density";
export const SUBDIVIDE = "render.subdivide"; // in the address alone
export const DENSITY = "cloths.0.density";
const NODE_MASS = "cloths.0.node_mass";
export const FABRIC = "cloths.0.fabric";
export const LOOK = "cloths.0.look";
export const COLOR = "cloths.0.color";
export const SUN = "render.light.direction";
const CLOTH = "cloths.0";
const COLLIDER = /^(colliders\.\d+)\.material$/;
const SPRINGS = ["cloths.0.stiffness.", "cloths.0.damping"];

/** Of the page alone, as the window has no field for a direction. */
const PAGE_ONLY: Readonly<Record<string, readonly Parameter[]>> = { look: [{ key: SUN, label: "Sun" }] };

export const GROUPS: readonly Group[] = list.groups.map((group: Group) => ({ ...group,
  parameters: [...group.parameters, ...(PAGE_ONLY[group.name] ?? [])] })
);

/** What solver.kind may be. */
export const solversOf = ({ methods }: Catalog): string[] => ["auto", ...methods.map(({ kind }) => kind)];

/** All keys that the page changes. */
export const KEYS: readonly string[] = [SOLVER, FORMULATION, CONTACT_METHOD, SUBDIVIDE,
  ...GROUPS.flatMap(({ parameters }) => parameters.map(({ key }) => key))];

const LIVE = new Set(GROUPS.filter(({ live }) => live).flatMap(({ parameters }) => parameters.map(({ key }) => key)));
export const isLive = (key: string): boolean => LIVE.has(key);

/** A cloth has a density or a mass of its nodes, and is of springs or of a fabric, whose numbers may stand in its name;
 *  a scene may be without air, cloth or obstacles. What it is not given, it cannot be asked for. */
export function applies(key: string, now: (key: string) => unknown): boolean {
  if (key === AIR_DENSITY) return now(AIR) !== undefined;
  if (key === FABRIC || key === LOOK || key === COLOR) return now(CLOTH) !== undefined;
  const collider = COLLIDER.exec(key);
  if (collider) return now(collider[1]!) !== undefined;
  if (SPRINGS.some((start) => key.startsWith(start))) return now(FABRIC) === undefined;
  const given = key === DENSITY || key === NODE_MASS || key.startsWith(`${FABRIC}.`);
  return !given || now(key) !== undefined;
}

type Changes = PageState["set"];

const CLEARS = new Map(GROUPS.flatMap(({ parameters }) => parameters).map(({ key, clears }) => [key, clears ?? []]));
/** In whose place a key stands. */
export const clearedBy = (key: string): readonly string[] => CLEARS.get(key) ?? [];

/** What goes out of the scene with these changes. */
export function cleared(set: Changes): string[] {
  return [...new Set(Object.keys(set).flatMap(clearedBy))].filter((key) => !(key in set));
}

const within = (key: string, other: string): boolean => key === other || key.startsWith(`${other}.`);

/** Whether the scene's own value of a key does not hold, since another key was chosen. */
export function isCleared(key: string, set: Changes): boolean {
  return cleared(set).some((one) => within(key, one)) || Object.keys(set).some((one) => key.startsWith(`${one}.`));
}

/** The method that holds where none is chosen: the scene's own, or what a fabric has in its place. */
export function ownMethod(scene: LoadedScene, state: PageState): string {
  return String(scene.valueOf(SOLVER, withKey(state, SOLVER, null).set));
}

/** With another method, which has other settings and other steps; null: the scene's own. */
export function withMethod(state: PageState, kind: string | null): PageState {
  return withKey(withKey(withKey(state, FORMULATION, null), SUBSTEPS, null), SOLVER, kind);
}

/** With so many nodes along the longer side: other nodes, of which "auto" chooses the steps again. */
export function withNodes(state: PageState, nodes: number): PageState {
  return { ...withKey(state, SUBSTEPS, null), nodes };
}

/** With a key chosen in whose place others stood: of these stay those that only look. Steps are chosen again. */
export function withChoice(state: PageState, key: string, value: Value | null): PageState {
  const gone = [key, ...clearedBy(key), SUBSTEPS];
  const kept = Object.entries(state.set).filter(([one]) => isLive(one) || !gone.some((other) => within(one, other)));
  return { ...state, set: { ...Object.fromEntries(kept), ...(value !== null && { [key]: value }) } };
}
