// Vectors of a scene as a person sets them: so strong, in this direction.

export type Vector = readonly [number, number, number];

const DEGREE = Math.PI / 180;
const rounded = (value: number): number => Number(value.toFixed(4)) + 0; // no -0 in an address

/** `own` made as long as `strength`; down where it has no length. */
export function scaled(own: Vector, strength: number): Vector {
  const length = Math.hypot(...own);
  const [x, y, z] = length > 0 ? own : [0, -1, 0];
  const factor = strength / (length > 0 ? length : 1);
  return [rounded(x * factor), rounded(y * factor), rounded(z * factor)];
}

/** Where the wind blows to, about the vertical: 0° is towards z, 90° towards x. */
export const headingOf = ([x, , z]: Vector): number => (x === 0 && z === 0 ? 0 : Math.round(Math.atan2(x, z) / DEGREE));

/** A wind of this speed and heading that climbs as `own` does. */
export function blowing(speed: number, heading: number, own: Vector): Vector {
  const length = Math.hypot(...own);
  const climb = length > 0 ? own[1] / length : 0;
  const level = speed * Math.sqrt(1 - climb * climb);
  return [rounded(level * Math.sin(heading * DEGREE)), rounded(speed * climb),
    rounded(level * Math.cos(heading * DEGREE))];
}
