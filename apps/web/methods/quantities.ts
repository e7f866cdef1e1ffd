// What is read of a state, in doubles.
import type { Point, Snapshot } from "weft-cloth";

/**
 * How far a state is off: RMS of the distance of all nodes to a reference over RMS of the reference's way from the
 * start, as error[].position in docs/cli.md. null: the reference has not moved. All are x, y, z of every node [m].
 */
export function positionError(positions: Float32Array, reference: Float32Array, start: Float32Array): number | null {
  const way = squares(reference, start);
  return way > 0 ? Math.sqrt(squares(positions, reference) / way) : null;
}

/** Of the nodes that are free to move [J]. */
export function kineticEnergy({ velocities, inverseMasses }: Snapshot): number {
  let twice = 0;
  inverseMasses.forEach((inverse, node) => {
    if (inverse === 0) return;
    const [x, y, z] = at(velocities, node);
    twice += (x * x + y * y + z * z) / inverse;
  });
  return twice / 2;
}

/** Of the same nodes in gravity [m/s²], less than at the start, so negative where cloth has come down [J]. */
export function heightEnergy({ positions, inverseMasses }: Snapshot, start: Float32Array, gravity: Point): number {
  let energy = 0;
  inverseMasses.forEach((inverse, node) => {
    if (inverse === 0) return;
    const place = at(positions, node), before = at(start, node);
    gravity.forEach((g, axis) => {
      energy -= (g * (place[axis]! - before[axis]!)) / inverse;
    });
  });
  return energy;
}

function squares(a: Float32Array, b: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i]! - b[i]!) ** 2;
  return sum;
}

const at = (vectors: Float32Array,
  node: number): Point => [vectors[3 * node]!, vectors[3 * node + 1]!, vectors[3 * node + 2]!];
