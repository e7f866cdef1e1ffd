import { WeftError } from "./error.js";
import type { Point } from "./world_types.js";

/**
 * Where a rigid thing is, from where the scene puts it: p' = R p + position, with a unit quaternion x, y, z, w. What is
 * left out is as the scene has it. Where the scene puts it at the origin, these are those of a three.js object.
 */
export interface Placement {
  position?: Point;
  quaternion?: readonly [x: number, y: number, z: number, w: number];
}

/** Position and quaternion, or the 16 of a matrix. */
export function numbersOf(placement: Placement | ArrayLike<number>): number[] {
  if ("length" in placement) {
    if (placement.length === 16) return Array.from(placement);
    throw new WeftError("input", `A matrix has 16 numbers, and not ${placement.length}.`);
  }
  const { position = [0, 0, 0], quaternion = [0, 0, 0, 1] } = placement;
  if (position.length === 3 && quaternion.length === 4) return [...position, ...quaternion];
  throw new WeftError("input",
    `A position has 3 numbers and a quaternion 4, and not ${position.length as number} and ${quaternion
      .length as number}.`);
}
