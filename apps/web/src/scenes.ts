// The scenes that the page offers, and their files. Vite gives every file that is there an address on the page's own
// origin, in the build and while developing; what is not there is not offered.
import { meshNames, type Bytes } from "weft";
import { MOST_SUBSTEPS } from "./files/limits.js";

const SCENE_FILES = import.meta.glob<string>(
  "../../../scenes/{breeze,hanging,pull-sphere,pull-armadillo,pull-dragon,drag}.json",
  { query: "?url", import: "default", eager: true });
const MODEL_FILES = import.meta.glob<string>("../../../models/{sphere,armadillo,dragon}.ply",
  { query: "?url", import: "default", eager: true });

export interface SceneEntry { name: string; title: string; }

export const SCENES: readonly SceneEntry[] = [
  { name: "breeze", title: "Breeze" },
  { name: "hanging", title: "Hanging" },
  { name: "pull-sphere", title: "Pulled over a sphere" },
  { name: "pull-armadillo", title: "Pulled over the armadillo" },
  { name: "pull-dragon", title: "Pulled over the dragon" },
  { name: "drag", title: "A corner drawn up" },
].filter(({ name }) => fileOf(SCENE_FILES, name) !== undefined);

/** Nodes along the longer side that the page offers; a scene's own number comes on top. */
export const RESOLUTIONS = [32, 64, 100, 128, 200, 256] as const;
const MOST_NODES = 1024; // along a side, by an address; the core says what the GPU cannot hold

/** What to show. */
export interface Choice {
  name: string;
  /** Along the longer side; null: as the scene says. */
  nodes: number | null;
}

export type Grid = readonly [number, number];

/** A scene with all that it needs. */
export interface LoadedScene {
  choice: Choice;
  title: string;
  json: string;
  meshes: Record<string, Bytes>;
  /** The scene's own grid of its first cloth; null where that is a mesh. */
  ownGrid: Grid | null;
  set: Record<string, unknown>;
  /** [m/s]; null where nothing blows. */
  wind: readonly [number, number, number] | null;
  /** Of a frame; a scene that needs more is not shown. */
  mostSubsteps: number;
}

/** A scene that the visitor has brought; the page keeps the last. */
export interface OwnScene { title: string; json: string; meshes: Record<string, Bytes>; }
export const OWN = "own"; // its name in a choice
let own: OwnScene | null = null;

export const ownScene = (): OwnScene | null => own;
export function keepOwnScene(scene: OwnScene | null): void { own = scene; }

function fileOf(files: Record<string, string>, name: string): string | undefined {
  return Object.entries(files).find(([path]) => path.replace(/^.*\/|\.\w+$/g, "") === name)?.[1];
}

async function fetched(address: string | undefined, what: string): Promise<Response> {
  if (address === undefined) throw new Error(`${what} is not part of this page.`);
  let answer: Response;
  try {
    answer = await fetch(address);
  } catch {
    throw new Error(`${what} cannot be fetched: the server does not answer.`);
  }
  if (!answer.ok) throw new Error(`${what} cannot be fetched: the server answers ${answer.status}.`);
  return answer;
}

/** A mesh of the page's own. */
export async function fetchModel(name: string): Promise<ArrayBuffer> {
  return (await fetched(fileOf(MODEL_FILES, name), `The model ${name}`)).arrayBuffer();
}

export async function fetchScene(choice: Choice): Promise<LoadedScene> {
  const brought = choice.name === OWN ? own : null;
  const json = brought?.json ?? await (await fetched(fileOf(SCENE_FILES, choice.name), `The scene ${choice.name}`)).text();
  const models = meshNames(json).map(async (name) => [name, brought?.meshes[name] ?? await fetchModel(name)] as const);
  const parsed = JSON.parse(json) as {
    cloths?: { grid?: Grid }[]; wind?: { velocity?: [number, number, number] } };
  const ownGrid = parsed.cloths?.[0]?.grid ?? null;
  const grid = ownGrid && choice.nodes !== null ? gridOf(ownGrid, choice.nodes) : null;
  return {
    choice, json, ownGrid,
    title: brought?.title ?? SCENES.find(({ name }) => name === choice.name)?.title ?? choice.name,
    meshes: Object.fromEntries(await Promise.all(models)),
    set: grid ? { "cloths.0.grid": grid } : {},
    wind: parsed.wind?.velocity ?? null,
    mostSubsteps: brought ? MOST_SUBSTEPS : Infinity,
  };
}

/** A grid of the scene's aspect with this many nodes along its longer side. */
export function gridOf(own: Grid, nodes: number): Grid {
  const longer = Math.max(...own);
  const along = (count: number) => Math.max(2, 1 + Math.round(((count - 1) * (nodes - 1)) / (longer - 1)));
  return [along(own[0]), along(own[1])];
}

/** What the page's address asks for, as ?scene=hanging&nodes=64; the first scene at its own size where it says nothing. */
export function choiceOf(address: string): Choice {
  const asked = new URL(address).searchParams;
  const name = SCENES.find((scene) => scene.name === asked.get("scene"))?.name ?? SCENES[0]?.name ?? "";
  const nodes = Number(asked.get("nodes"));
  return { name, nodes: Number.isInteger(nodes) && nodes >= 2 && nodes <= MOST_NODES ? nodes : null };
}

export function addressOf({ name, nodes }: Choice): string {
  if (name === OWN) return location.pathname; // another visitor does not have it
  return `?scene=${name}${nodes === null ? "" : `&nodes=${nodes}`}`;
}
