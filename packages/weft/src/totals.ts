// Made by scripts/make_statistics.py from src/state/statistics.txt.
/** What the frames so far have reported; up to three frames old. */
export interface Totals {
  /** Frames that have reported, but for one that diverged. */
  frames: number;
  /** Frames that were run again with longer lists or more iterations. */
  repeatedFrames: number;
  /** Narrow-phase hits, summed over substeps. */
  contacts: number;
  /** Wrapping sum of hash_pair over all hits: the same for every method that finds the same. */
  contactHash: number;
  /** The largest length of a triangle's edge over its rest length, at the end of a frame, the most of any. */
  maxStretch: number;
  /** Contacts that a list had no room for; anything but 0 means that contact is incomplete. */
  contactOverflow: number;
  /** Searches for pairs of features (proximity). */
  detections: number;
  /** Edges through triangles that they do not touch at rest, the most of a search (proximity), the most of any. */
  crossings: number;
  /** Vertices truncated by contact, summed over substeps (proximity). */
  truncated: number;
  /** Of these, vertices that an obstacle has passed since cloth behind them did not give way. */
  driven: number;
  /** Substeps that ended before their time for all cloth, so that nothing passes through cloth (proximity). */
  slowed: number;
  /** The time that these were short of. */
  delayS: number;
  /** Pairs of features that are listed at the end of a frame (proximity), the most of any. */
  pairs: number;
  /** Pairs of triangles that the last search of a frame has listed (proximity), the most of any. */
  candidates: number;
  /** Of the pairs, those near enough to have a record, at the end of a frame (proximity), the most of any. */
  near: number;
  /** Iterations that the linear systems of a substep took, the most (implicit solver), the most of any. */
  iterations: number;
  /** The largest part of its residual that a linear system kept (implicit solver), the most of any. */
  residual: number;
  /** Linear systems that were left with a larger residual than wanted (implicit solver). */
  unsolved: number;
  /** Tetrahedra with less than a twentieth of their volume, or inside out, at a frame's end, the most of any. */
  flattened: number;
  /** Nodes that are not finite; 0 but where a run diverged. */
  nonfinite: number;
  /** Edges through triangles that they do not touch at rest, of the last search (proximity). */
  crossingsLeft: number;
}

/** Their names, in the order in which the core gives them. */
export const TOTALS = [
  "frames",
  "repeatedFrames",
  "contacts",
  "contactHash",
  "maxStretch",
  "contactOverflow",
  "detections",
  "crossings",
  "truncated",
  "driven",
  "slowed",
  "delayS",
  "pairs",
  "candidates",
  "near",
  "iterations",
  "residual",
  "unsolved",
  "flattened",
  "nonfinite",
  "crossingsLeft",
] as const satisfies readonly (keyof Totals)[];

/** Before the first frame. */
export function noTotals(): Totals {
  return {
    frames: 0,
    repeatedFrames: 0,
    contacts: 0,
    contactHash: 0,
    maxStretch: 0,
    contactOverflow: 0,
    detections: 0,
    crossings: 0,
    truncated: 0,
    driven: 0,
    slowed: 0,
    delayS: 0,
    pairs: 0,
    candidates: 0,
    near: 0,
    iterations: 0,
    residual: 0,
    unsolved: 0,
    flattened: 0,
    nonfinite: 0,
    crossingsLeft: 0,
  };
}
