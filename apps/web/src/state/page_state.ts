// The page's state apart from the cloth's: its address holds it, its controls show it and its player loads it.
import type { Camera, Point, View } from "weft-cloth";

/** The value of a scene's key. */
export type Value = number | string | readonly number[];

export interface PageState {
  readonly scene: string;
  /** Nodes along the longer side of the first cloth; null: as the page has it for this scene. */
  readonly nodes: number | null;
  /** What is changed in the scene, by dotted key. */
  readonly set: Readonly<Record<string, Value>>;
  readonly view: View;
  /** null: the scene's. */
  readonly camera: Camera | null;
  /** Where the visitor has pinned the cloth. */
  readonly pins: readonly PinPlace[];
  /** null: one cloth is shown, and nothing beside it. */
  readonly compare: Comparison | null;
}

/** A pin whatever the resolution is: it holds the node that is nearest at rest. */
export interface PinPlace {
  /** Of the cloth at rest, in the world [m]. */
  readonly rest: Point;
  /** Where it is held [m]. */
  readonly target: Point;
}

/** The same cloth beside itself, on the right of a divider. */
export interface Comparison {
  /** What is other on the right: at least one of COMPARED (comparison.ts), by its key. */
  readonly other: Readonly<Record<string, Value>>;
  /** Where the divider stands, from the left [% of its way]. */
  readonly divider: number;
}

/** A scene as it is. */
export function plain(scene: string, view: View): PageState {
  return { scene, nodes: null, set: {}, view, camera: null, pins: [], compare: null };
}

/** With a key changed; null: as the scene has it. */
export function withKey(state: PageState, key: string, value: Value | null): PageState {
  const { [key]: _, ...rest } = state.set;
  return { ...state, set: value === null ? rest : { ...rest, [key]: value } };
}

export function equal(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
