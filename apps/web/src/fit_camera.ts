// The scenes' cameras are made for a wide picture; in a narrower one they stand further back.
import type { Camera, World } from "weft-cloth";

const SCENE_ASPECT = 16 / 9; // of the picture that the scenes' cameras are made for
const FULL = 0.86; // of half the picture's width, for the cloth at rest: there has to be room to move
const LOOKS = 1024; // nodes that are looked at to see how far the cloth reaches, more or less

/** A busy world cannot be asked for its camera. */
export async function idle(world: World): Promise<void> {
  while (world.busy) await new Promise((wake) => setTimeout(wake));
}

/**
 * In a picture narrower than the scene's, moves the camera back until the cloth is in it from left to right. `cloth`:
 * where its nodes are taken to be [m]; null: where they are.
 */
export async function fitCamera(world: World, aspect: number, cloth: Float32Array | null = null): Promise<void> {
  if (aspect >= SCENE_ASPECT) return;
  const positions = cloth ?? await world.positions();
  await idle(world);
  const stride = 3 * Math.ceil(positions.length / 3 / LOOKS);
  let widest = 0;
  for (let i = 0; i + 2 < positions.length; i += stride)
    widest = Math.max(widest, Math.abs(world.project([positions[i]!, positions[i + 1]!, positions[i + 2]!])[0]));
  if (widest > FULL) world.zoom(FULL / widest);
}

/** Whether two cameras are one but for rounding. */
export function near(a: Camera, b: Camera): boolean {
  const size = Math.hypot(...b.eye.map((value, axis) => value - b.target[axis]!));
  return [a.eye, a.target].every((point, i) =>
    point.every((value, axis) => Math.abs(value - (i === 0 ? b.eye : b.target)[axis]!) < 1e-4 * size)
  );
}
