// The keys of a scene that the page lets change, which are those of the window of `weft view`. Limits, units and what
// they mean come from the core's schema.
import type { Catalog } from "weft-cloth";
import list from "../../../shared/parameters.json";

export interface Parameter {
  readonly key: string;
  readonly label: string;
  /** Of one that changes while the cloth moves: the least range of its slider. */
  readonly reach?: number;
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
const [DENSITY, NODE_MASS] = ["cloths.0.density", "cloths.0.node_mass"] as const;
const FABRIC = "cloths.0.fabric";
const SPRINGS = ["cloths.0.stiffness.", "cloths.0.damping"];

export const GROUPS: readonly Group[] = list.groups;

/** What solver.kind may be. */
export const solversOf = ({ methods }: Catalog): string[] => ["auto", ...methods.map(({ kind }) => kind)];

/** All keys that the page changes. */
export const KEYS: readonly string[] = [SOLVER, FORMULATION, CONTACT_METHOD, SUBDIVIDE,
  ...GROUPS.flatMap(({ parameters }) => parameters.map(({ key }) => key))];

const LIVE = new Set(GROUPS.filter(({ live }) => live).flatMap(({ parameters }) => parameters.map(({ key }) => key)));
export const isLive = (key: string): boolean => LIVE.has(key);

/** A cloth has a density or a mass of its nodes, and is of springs or of a fabric, whose numbers may stand in its name;
 *  a scene may be without air. What it is not given, it cannot be asked for. */
export function applies(key: string, own: (key: string) => unknown): boolean {
  if (key === AIR_DENSITY) return own(AIR) !== undefined;
  if (SPRINGS.some((start) => key.startsWith(start))) return own(FABRIC) === undefined;
  const given = key === DENSITY || key === NODE_MASS || key.startsWith(FABRIC);
  return !given || own(key) !== undefined;
}
