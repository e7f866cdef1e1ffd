// What a lesson has computed: numbers, curves, and a picture at each time. The states are the reference's.
import { createReference, WeftError, type Reference, type Scene } from "weft-cloth";
import type { Curve } from "../src/line_plot.js";

/** A number that is shown, with its unit. */
export interface Quantity {
  readonly value: number;
  readonly unit: string;
}

export interface Course {
  /** By the id that the page has for each; a text stands as it is. */
  readonly readings: Readonly<Record<string, Quantity | string>>;
  /** What it comes to, one sentence. */
  readonly verdict: string;
  readonly curves: readonly Curve[];
  /** Of the plot's height; what is outside is cut off. Without it, all that the curves have. */
  readonly range?: readonly [low: number, high: number];
  /** Of what is played [s]. */
  readonly duration: number;
  /** How much slower it is played than it happens. */
  readonly slowed?: number;
  /** The x of the plot that is at this time; null: none is. */
  at(seconds: number): number | null;
  draw(pen: Pen, seconds: number): void;
}

/** A canvas to draw on, in CSS pixels. */
export interface Pen {
  readonly context: CanvasRenderingContext2D;
  readonly width: number;
  readonly height: number;
  /** A colour of the style sheet. */
  color(name: string): string;
}

/** A scene at rest, for as long as `use` takes. */
export async function withReference<T>(scene: Scene, use: (reference: Reference) => T): Promise<T> {
  const reference = await createReference({ scene });
  try {
    return use(reference);
  } finally {
    reference.dispose();
  }
}

/** What `read` finds at the start and after each frame. It ends early where the cloth is no longer finite. */
export function recorded<T>(scene: Scene, frames: number, read: (reference: Reference) => T): Promise<T[]> {
  return withReference(scene, (reference) => {
    const found = [read(reference)];
    try {
      for (let frame = 0; frame < frames; frame++) {
        reference.advance();
        found.push(read(reference));
      }
    } catch (reason) {
      if (!(reason instanceof WeftError && reason.kind === "diverged")) throw reason;
    }
    return found;
  });
}
