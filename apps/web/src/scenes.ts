// The scenes that the page offers, and their files. Vite gives every file that is there an address on the page's own
// origin, in the build and while developing; what is not there is not offered.
import { meshNames, schemaOf, type Bytes, type Catalog, type Method, type Schema } from "weft-cloth";
import list from "../../shared/scenes.json";
import { MOST_SUBSTEPS } from "./files/limits.js";
import type { PageState } from "./state/page_state.js";
import { cleared, DENSITY, FABRIC, isCleared, LOOK, SOLVER } from "./state/parameters.js";

const SCENE_FILES = import.meta.glob<string>("../../../scenes/*.json", { query: "?url", import: "default",
  eager: true });
const MODEL_FILES = import.meta.glob<string>(
  ["../../../models/{sphere,ball,armadillo,dragon,skirt}.ply", "../../../models/mannequin.glb"],
  { query: "?url", import: "default", eager: true },
);

export interface SceneEntry {
  readonly name: string;
  readonly title: string;
  /** Along the longer side, where the scene's own number is more than a laptop's GPU plays with. */
  readonly nodes?: number;
}

interface SceneGroup {
  readonly title: string;
  readonly scenes: readonly SceneEntry[];
}
const groups: readonly SceneGroup[] = list.groups; // the window's too

export const SCENE_GROUPS: readonly SceneGroup[] = groups.map(({ title, scenes }) => ({ title,
  scenes: scenes.filter(({ name }) => fileOf(SCENE_FILES, name) !== undefined) })
);

export const SCENES: readonly SceneEntry[] = SCENE_GROUPS.flatMap(({ scenes }) => scenes);

export type Grid = readonly [number, number];

/** A scene with all that it needs. */
export interface LoadedScene {
  readonly state: PageState;
  readonly title: string;
  readonly description: string;
  readonly json: string;
  readonly meshes: Record<string, Bytes>;
  /** The first cloth's grid: the scene's own, what the page takes where nothing is asked for, and what is taken. */
  readonly grid: { readonly own: Grid; readonly usual: number; readonly taken: Grid } | null;
  /** How often the first cloth stands. */
  readonly copies: number;
  /** Of its meshes. */
  readonly obstacleTriangles: number;
  readonly set: Record<string, unknown>;
  /** What a solver can be, to ask what each asks for. */
  readonly methods: readonly Method[];
  /** Of a frame; a scene that needs more is not shown. */
  readonly mostSubsteps: number;
  /** What the scene's file says of a key, or else the format. */
  own(key: string): unknown;
  /** The same, with these changes. */
  valueOf(key: string, set: PageState["set"]): unknown;
  /** The same, with those that it was opened with. */
  now(key: string): unknown;
}

/** A scene that the visitor has brought; the page keeps the last. */
export interface OwnScene {
  readonly title: string;
  readonly json: string;
  readonly meshes: Readonly<Record<string, Bytes>>;
}
export const OWN = "own"; // its name in a page's state
let own: OwnScene | null = null;

export const ownScene = (): OwnScene | null => own;
export function keepOwnScene(scene: OwnScene | null): void {
  own = scene;
}

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

interface SceneFile {
  readonly title?: string;
  readonly description?: string;
  readonly cloths?: readonly { readonly grid?: Grid; readonly copies?: { readonly count: number };
    readonly pressure?: object }[];
  readonly colliders?: readonly { readonly mesh?: string }[];
}

export async function fetchScene(state: PageState, catalog: Catalog): Promise<LoadedScene> {
  const { schema, methods } = catalog;
  const brought = state.scene === OWN ? own : null;
  const json = brought?.json ??
    await (await fetched(fileOf(SCENE_FILES, state.scene), `The scene ${state.scene}`)).text();
  const models = meshNames(json).map(async (name) => [name, brought?.meshes[name] ?? await fetchModel(name)] as const);
  const meshes = Object.fromEntries(await Promise.all(models));
  const file = JSON.parse(json) as SceneFile;
  const entry = SCENES.find(({ name }) => name === state.scene);
  const valueOf = (key: string): unknown => valueAt(file, key) ?? fallbackOf(schema, key);
  /** What a cloth has by its fabric's name, or without one. */
  const byFabric = (key: string, set: PageState["set"]): unknown => {
    if (key !== DENSITY && key !== LOOK) return undefined;
    const given = set[FABRIC] ?? valueAt(file, `${FABRIC}.name`) ?? valueAt(file, FABRIC);
    const fabric = catalog.fabrics.find(({ name }) => name === given);
    if (key === DENSITY) return fabric?.density;
    return file.cloths?.[0] && (file.cloths[0].pressure ? "rubber" : fabric?.look ?? catalog.looks[0]!.name);
  };
  const ownGrid = file.cloths?.[0]?.grid ?? null;
  const usual = entry?.nodes ?? (ownGrid ? Math.max(...ownGrid) : 0);
  return restated({
    state,
    json,
    own: valueOf,
    valueOf: (key, set) =>
      set[key] ?? (isCleared(key, set) ? null : valueOf(key)) ?? byFabric(key, set) ??
        fallbackOf(schema, key),
    methods,
    grid: ownGrid && { own: ownGrid, usual, taken: gridOf(ownGrid, state.nodes ?? usual) },
    title: brought?.title ?? entry?.title ?? state.scene,
    description: file.description ?? "",
    meshes,
    obstacleTriangles: (file.colliders ?? []).reduce((sum, { mesh }) => sum + trianglesOf(meshes[mesh ?? ""]), 0),
    copies: file.cloths?.[0]?.copies?.count ?? 1,
    mostSubsteps: brought ? MOST_SUBSTEPS : Infinity,
  }, state);
}

/** Another method has none of the settings of the scene's own, so it takes the place of all of them. */
function solverSet({ [SOLVER]: kind, ...set }: PageState["set"]): Record<string, unknown> {
  return { ...(kind !== undefined && { solver: { kind } }), ...set };
}

/** The scene with other changes to its keys; its grid stays. */
export function restated(scene: Omit<LoadedScene, "set" | "now">, state: PageState): LoadedScene {
  const gone = Object.fromEntries(cleared(state.set).map((key) => [key, null]));
  return { ...scene, state,
    set: { ...(scene.grid && { "cloths.0.grid": scene.grid.taken }), ...gone, ...solverSet(state.set) },
    now: (key) => scene.valueOf(key, state.set) };
}

/** A grid of the scene's aspect with this many nodes along its longer side. */
export function gridOf(own: Grid, nodes: number): Grid {
  const longer = Math.max(...own);
  const along = (count: number) => Math.max(2, 1 + Math.round(((count - 1) * (nodes - 1)) / (longer - 1)));
  return [along(own[0]), along(own[1])];
}

/** As its file's beginning says: a PLY's, or a GLB's, of which each mesh counts once. */
function trianglesOf(mesh: Bytes | undefined): number {
  if (mesh === undefined) return 0;
  const bytes = mesh instanceof Uint8Array ? mesh : new Uint8Array(mesh);
  const beginning = new TextDecoder("latin1").decode(bytes.slice(0, 1024));
  if (!beginning.startsWith("glTF")) return Number(/^element face (\d+)/m.exec(beginning)?.[1] ?? 0);
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const file = JSON.parse(new TextDecoder().decode(bytes.slice(20, 20 + length))) as GltfFile;
  const corners = (file.meshes ?? []).flatMap(({ primitives }) => primitives)
    .map(({ indices }) => (indices === undefined ? 0 : file.accessors[indices]?.count ?? 0));
  return corners.reduce((sum, count) => sum + Math.floor(count / 3), 0);
}

interface GltfFile {
  readonly meshes?: readonly { readonly primitives: readonly { readonly indices?: number }[] }[];
  readonly accessors: readonly { readonly count: number }[];
}

function valueAt(file: unknown, key: string): unknown {
  return key.split(".").reduce<unknown>(
    (at, part) => (typeof at === "object" && at !== null ? (at as Record<string, unknown>)[part] : undefined),
    file,
  );
}

const fallbackOf = (schema: Schema, key: string): unknown => schemaOf(schema, key)?.default;
