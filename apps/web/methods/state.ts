// What the page compares: its address holds it, its controls show it.
import type { Value } from "../src/state/page_state.js";

export interface Choice {
  readonly kind: string;
  readonly substeps: number | "auto";
  /** Those that differ from what the method has by itself, by the word that scenes have for each. */
  readonly settings: Readonly<Record<string, Value>>;
}

export interface MethodsState {
  readonly scene: string;
  /** Nodes along the longer side; null: as the page has it for this scene. */
  readonly nodes: number | null;
  /** One to MOST_CHOICES; the others are compared with the first. */
  readonly choices: readonly Choice[];
}

export const MOST_CHOICES = 4;
/** In a frame, or substeps where a method has no sweeps: beyond, a browser may take the GPU for hung. */
export const MOST_SWEEPS = 4096;
/** Along a side: every method has a device of its own, and all of them step one after the other. */
export const NODES = { least: 4, most: 512 } as const;
