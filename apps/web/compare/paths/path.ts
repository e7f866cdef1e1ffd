// The interface of each way of simulating the sheet, for measuring and testing.
import type { Sheet } from "../sheet.js";

/** Size of what is drawn, whatever the window [pixels]. */
export const WIDTH = 960, HEIGHT = 540;

export interface Path {
  /** Steps that a batch without pictures must have, or what comes once a batch would pass for a part of the step. */
  readonly leastSteps: number;
  /** This many steps, nothing drawn; resolves when the last is done, not when it is handed over. */
  simulate(count: number): Promise<void>;
  /** This many times one step and its picture; resolves when all of it is done. */
  animate(count: number): Promise<void>;
  /** x, y, z of every node [m]. */
  positions(): Promise<Float32Array>;
  dispose(): void;
}

/** Opens the sheet at rest, to be drawn on a canvas of WIDTH x HEIGHT that has no context yet. */
export type Open = (sheet: Sheet, canvas: HTMLCanvasElement) => Promise<Path>;

/** This browser lacks what a path stands on; the message says what. */
export class Unavailable extends Error {}
