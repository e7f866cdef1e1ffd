// The page's state as its address has it: ?v=1&scene=hanging&nodes=64&drag=0.5&view=stretch. What an address asks for
// is checked by the core's schema; what does not pass is left out, and said.
import { VIEWS, type Camera, type Schema, type View } from "weft-cloth";
import { COMPARED, MIDDLE, NODES, withOther } from "./comparison.js";
import { DIGITS, parsed, parsedBy, plainPoint } from "./limits.js";
import { plain, type Comparison, type PageState, type PinPlace, type Value } from "./page_state.js";
import { KEYS, SOLVER } from "./parameters.js";
import { numbersOf, textOf } from "./pin_text.js";
import { Refusals } from "./refusals.js";

const VERSION = "1";
const BETWEEN = ":"; // parts of a comparison
const DIVIDER: Schema = { type: "integer", minimum: 0, maximum: 100, description: "Of its way, from the left [%]." };

/** What may be asked for, beside keys of a scene. */
export interface Offer {
  readonly schema: Schema;
  /** What solver.kind may be, of which the schema has a way for each. */
  readonly solvers: readonly string[];
  readonly scenes: readonly string[];
  readonly view: View;
  /** The most nodes along a side. */
  readonly mostNodes: number;
  readonly mostPins: number;
}

export interface Asked {
  readonly state: PageState;
  /** What was refused, one sentence; null where all of it was good. */
  readonly refused: string | null;
}

export function read(address: string, offer: Offer): Asked {
  const { scenes, view } = offer;
  const asked = new URL(address).searchParams;
  const refusals = new Refusals("what the scene has");
  const refuse = (name: string, must: string) => refusals.add(name, asked.get(name) ?? "", must);
  let state = plain(scenes[0] ?? "", view);

  const version = asked.get("v");
  if (version !== null && version !== VERSION) {
    refuse("v", `be ${VERSION}`);
    return { state, refused: refusals.sentence };
  }
  const scene = asked.get("scene");
  if (scene !== null && scenes.includes(scene)) state = { ...state, scene };
  else if (scene !== null) refuse("scene", "be one of the page's list");

  const nodes = asked.get(NODES);
  const count = nodes === null ? null : parsedValue(offer, NODES, nodes);
  if (count && "value" in count) state = { ...state, nodes: Number(count.value) };
  else if (count) refuse(NODES, count.must);

  const set: Record<string, Value> = {};
  for (const key of KEYS) {
    const text = asked.get(key);
    if (text === null) continue;
    const found = parsedValue(offer, key, text);
    if ("value" in found) set[key] = found.value;
    else refuse(key, found.must);
  }
  const shownView = VIEWS.find((one) => one === asked.get("view"));
  if (asked.has("view") && !shownView) refuse("view", `be one of ${VIEWS.join(", ")}`);
  return {
    state: { ...state, set, view: shownView ?? view, camera: cameraOf(asked, offer.schema, refuse),
      pins: pinsOf(asked, offer, refusals), compare: comparisonOf(asked, offer, refusals) },
    refused: refusals.sentence,
  };
}

function parsedValue({ schema, solvers, mostNodes }: Offer, key: string, text: string) {
  if (key === NODES) return parsedBy({ type: "integer", minimum: 2, maximum: mostNodes }, text);
  return key === SOLVER ? parsedBy({ enum: solvers }, text) : parsed(schema, key, text);
}

/** Of pins=0.5,0,0,0.5,0.2,0.1 what is good: six numbers each, the place at rest and where it is held (pin_text.ts). */
function pinsOf(asked: URLSearchParams, { schema, mostPins }: Offer, refusals: Refusals): PinPlace[] {
  const text = asked.get("pins");
  const found = (text === null ? [] : numbersOf(text)).flatMap((numbers): PinPlace[] => {
    const [rest, target] = [numbers.slice(0, 3), numbers.slice(3)].map((three) =>
      parsed(schema, "camera.eye", three.join())
    );
    if (rest && target && "value" in rest && "value" in target)
      return [{ rest: rest.value, target: target.value } as PinPlace];
    refusals.add("a pin", numbers.join(), "be six numbers [m]: its place on the cloth at rest, and where it is held");
    return [];
  });
  if (found.length > mostPins) refusals.add("pins", text ?? "", `be at most ${mostPins}`);
  return found.slice(0, mostPins);
}

/** Of compare=solver.kind=vbd:nodes=32&divider=30 what is good. */
function comparisonOf(asked: URLSearchParams, offer: Offer, refusals: Refusals): Comparison | null {
  let compare: Comparison | null = null;
  for (const part of asked.get("compare")?.split(BETWEEN) ?? []) {
    const [key = "", text = ""] = part.split("=", 2);
    if (!COMPARED.includes(key)) {
      refusals.add("a key of compare", key, `be one of ${COMPARED.join(", ")}`);
      continue;
    }
    const found = parsedValue(offer, key, text);
    if ("value" in found) compare = withOther(compare, key, found.value);
    else refusals.add(`${key} of compare`, text, found.must);
  }
  const divider = asked.get("divider");
  if (divider === null) return compare;
  const place = parsedBy(DIVIDER, divider);
  if ("must" in place) refusals.add("divider", divider, place.must);
  return compare && "value" in place ? { ...compare, divider: Number(place.value) } : compare;
}

function cameraOf(asked: URLSearchParams, schema: Schema, refuse: (name: string, must: string) => void): Camera | null {
  if (!asked.has("eye") && !asked.has("target") && !asked.has("fov")) return null;
  const part = (name: string, key: string): Value | null => {
    const found = parsed(schema, `camera.${key}`, asked.get(name) ?? "");
    if ("value" in found) return found.value;
    refuse(name, found.must);
    return null;
  };
  const [eye, target, fov] = [part("eye", "eye"), part("target", "target"), part("fov", "fov_degrees")];
  if (eye === null || target === null || fov === null) return null;
  if (String(eye) === String(target)) {
    refuse("eye", "be another point than target");
    return null;
  }
  return { eye, target, fov } as Camera;
}

/** `usual`: the view that goes without saying. */
export function write({ scene, nodes, set, view, camera, pins, compare }: PageState, usual: View): string {
  const parts = [`v=${VERSION}`, `scene=${encodeURIComponent(scene)}`];
  if (nodes !== null) parts.push(`nodes=${nodes}`);
  for (const key of KEYS) if (set[key] !== undefined) parts.push(`${key}=${String(set[key])}`);
  if (view !== usual) parts.push(`view=${view}`);
  if (camera)
    parts.push(`eye=${plainPoint(camera.eye)}`, `target=${plainPoint(camera.target)}`,
      `fov=${Number(camera.fov.toFixed(DIGITS))}`);
  const held = pins.length > 0 ? textOf(pins) : null; // leftOut says why it has none
  if (held !== null) parts.push(`pins=${held}`);
  if (compare) {
    const other = Object.entries(compare.other).map(([key, value]) => `${key}=${String(value)}`);
    parts.push(`compare=${other.join(BETWEEN)}`);
    if (compare.divider !== MIDDLE) parts.push(`divider=${compare.divider}`);
  }
  return `?${parts.join("&")}`;
}
