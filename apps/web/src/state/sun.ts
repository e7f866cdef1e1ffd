// Where the light comes from, as a person sets it: around the vertical and above the horizon.
import type { Camera } from "weft-cloth";
import { headingOf, type Vector } from "./air.js";

const DEGREE = Math.PI / 180;
const rounded = (value: number): number => Number(value.toFixed(4)) + 0; // no -0 in an address

/** About the vertical: from z at 0°, from x at 90°. */
export const azimuthOf = headingOf;

/** Above the horizon [degrees]. */
export const elevationOf = ([x, y, z]: Vector): number => Math.round(Math.atan2(y, Math.hypot(x, z)) / DEGREE);

/** The direction to a light there. */
export function shining(azimuth: number, elevation: number): Vector {
  const level = Math.cos(elevation * DEGREE);
  return [rounded(level * Math.sin(azimuth * DEGREE)), rounded(Math.sin(elevation * DEGREE)),
    rounded(level * Math.cos(azimuth * DEGREE))];
}

/** The light of a scene that says none: from the camera's left, above (default_light of src/render/camera.cpp). */
export function besideCamera({ eye, target }: Camera): Vector {
  const [x, z] = [eye[0] - target[0], eye[2] - target[2]];
  const level = Math.hypot(x, z);
  const [backX, backZ] = level > 0 ? [x / level, z / level] : [0, 1]; // right of the camera is (backZ, 0, -backX)
  return [-0.85 * backZ + 0.4 * backX, 0.9, 0.85 * backX + 0.4 * backZ];
}
