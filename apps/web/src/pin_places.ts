// Pins from one world to the next, whose nodes may be others: each holds the node that is nearest at rest.
import { WeftError, type Point, type World } from "weft-cloth";
import type { PinPlace } from "./state/page_state.js";

export interface HeldPin extends PinPlace {
  readonly node: number;
}

/** What the world holds now, and why one cannot be held. */
export interface Held {
  readonly held: HeldPin[];
  readonly fault: string | null;
}

/** Grabs what pins hold in a world at rest. Of pins that come to one node the first counts. */
export async function hold(world: World, pins: readonly PinPlace[]): Promise<Held> {
  const places = pins.length > 0 ? await world.restPositions() : new Float32Array();
  const nodes = new Map<number, HeldPin>();
  for (const pin of pins) {
    const node = nearest(places, pin.rest);
    if (!nodes.has(node)) nodes.set(node, { ...pin, node });
  }
  return grabAll(world, [...nodes.values()]);
}

export async function grabAll(world: World, pins: readonly HeldPin[]): Promise<Held> {
  const held: HeldPin[] = [];
  let fault: string | null = null;
  for (const pin of pins) {
    const refused = await refusal(world.grab(pin.node, pin.target));
    if (refused === null) held.push(pin);
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

/** `places`: x, y, z of every node. */
export function pointOf(places: Float32Array, node: number): Point {
  return [places[3 * node]!, places[3 * node + 1]!, places[3 * node + 2]!];
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
