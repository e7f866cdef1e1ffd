// The page's state as its address has it: ?v=1&scene=hanging&nodes=64&drag=0.5&view=stretch. What an address asks for
// is checked by the core's schema; what does not pass is left out, and said.
import { VIEWS, type Camera, type Schema, type View } from "weft-cloth";
import { parsed, parsedBy } from "./limits.js";
import { plain, type PageState, type Value } from "./page_state.js";
import { KEYS, SOLVER } from "./parameters.js";
import { Refusals } from "./refusals.js";

const VERSION = "1";
const DIGITS = 4; // of a camera's coordinates, in metres

/** What may be asked for, beside keys of a scene. */
export interface Offer {
  readonly schema: Schema;
  /** What solver.kind may be, of which the schema has a way for each. */
  readonly solvers: readonly string[];
  readonly scenes: readonly string[];
  readonly view: View;
  /** The most nodes along a side. */
  readonly mostNodes: number;
}

export interface Asked {
  readonly state: PageState;
  /** What was refused, one sentence; null where all of it was good. */
  readonly refused: string | null;
}

export function read(address: string, { schema, solvers, scenes, view, mostNodes }: Offer): Asked {
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

  const nodes = asked.get("nodes");
  if (nodes !== null && /^\d+$/.test(nodes) && Number(nodes) >= 2 && Number(nodes) <= mostNodes)
    state = { ...state, nodes: Number(nodes) };
  else if (nodes !== null) refuse("nodes", `be a whole number from 2 to ${mostNodes}`);

  const set: Record<string, Value> = {};
  for (const key of KEYS) {
    const text = asked.get(key);
    if (text === null) continue;
    const found = key === SOLVER ? parsedBy({ enum: solvers }, text) : parsed(schema, key, text);
    if ("value" in found) set[key] = found.value;
    else refuse(key, found.must);
  }
  const shownView = VIEWS.find((one) => one === asked.get("view"));
  if (asked.has("view") && !shownView) refuse("view", `be one of ${VIEWS.join(", ")}`);
  return { state: { ...state, set, view: shownView ?? view, camera: cameraOf(asked, schema, refuse) },
    refused: refusals.sentence };
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

const point = (values: readonly number[]): string => values.map((value) => Number(value.toFixed(DIGITS))).join();

/** `usual`: the view that goes without saying. */
export function write({ scene, nodes, set, view, camera }: PageState, usual: View): string {
  const parts = [`v=${VERSION}`, `scene=${encodeURIComponent(scene)}`];
  if (nodes !== null) parts.push(`nodes=${nodes}`);
  for (const key of KEYS) if (set[key] !== undefined) parts.push(`${key}=${String(set[key])}`);
  if (view !== usual) parts.push(`view=${view}`);
  if (camera)
    parts.push(`eye=${point(camera.eye)}`, `target=${point(camera.target)}`,
      `fov=${Number(camera.fov.toFixed(DIGITS))}`);
  return `?${parts.join("&")}`;
}
