// Pins from one world to the next, whose nodes may be others: each holds the node that is nearest at rest.
import { WeftError, type Point, type World } from "weft-cloth";
import type { PinPlace } from "./state/page_state.js";

export interface HeldPin extends PinPlace {
  readonly node: number;
}

/** Grabs what pins hold in a world at rest; why one cannot be held. Of pins that come to one node the first counts. */
export async function hold(world: World,
  pins: readonly PinPlace[]): Promise<{ readonly held: HeldPin[]; readonly fault: string | null }> {
  const held: HeldPin[] = [];
  let fault: string | null = null;
  const places = pins.length > 0 ? await world.positions() : new Float32Array();
  for (const pin of pins) {
    const node = nearest(places, pin.rest);
    if (held.some((one) => one.node === node)) continue;
    const refused = await refusal(world.grab(node, pin.target));
    if (refused === null) held.push({ ...pin, node });
    else fault ??= refused;
  }
  return { held, fault };
}

/** Why a node cannot be grabbed: one that the scene pins or moves is no fault of the world. */
export async function refusal(grab: Promise<void>): Promise<string | null> {
  try {
    await grab;
    return null;
  } catch (reason) {
    if (reason instanceof WeftError && (reason.kind === "input" || reason.kind === "limit")) return reason.message;
    throw reason;
  }
}

/** `places`: x, y, z of every node [m]. */
function nearest(places: Float32Array, [x, y, z]: Point): number {
  let [node, least] = [0, Infinity];
  for (let i = 0; 3 * i < places.length; i++) {
    const way = (places[3 * i]! - x) ** 2 + (places[3 * i + 1]! - y) ** 2 + (places[3 * i + 2]! - z) ** 2;
    if (way < least) [node, least] = [i, way];
  }
  return node;
}
