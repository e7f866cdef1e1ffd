// A scene in this package: JSON of the format weft-scene/1, which the core checks. Names and bytes of its
// meshes are all that is looked at here.

import type { SceneObject } from "./scene_types.js";

/** A scene as JSON text or as the object it stands for (docs/scene.md). */
export type Scene = string | SceneObject;

/** The bytes of a mesh file: .ply, .obj, .stl, .off or .glb, of bodies .msh, .vtk, or .ele and .node; packed with gzip
 * or not. */
export type Bytes = ArrayBuffer | Uint8Array;

/** The meshes that a scene names, each once: what `meshes` must hold. */
export function meshNames(scene: Scene): string[] {
  const json: Readonly<Record<string, unknown>> = typeof scene === "string" ? JSON.parse(scene) : { ...scene };
  const entries = (list: unknown) => (Array.isArray(list) ? list : []) as Partial<Record<string, unknown>>[];
  const parts = [...entries(json["cloths"]),
    ...entries(json["colliders"]).flatMap((part) => [part, ...entries(part?.["keyframes"])])];
  const names = [...parts.map((part) => part?.["mesh"]), ...entries(json["bodies"]).flatMap((
    part,
  ) => [part?.["surface"], part?.["tetrahedra"], nodesBeside(part?.["tetrahedra"])])];
  return [...new Set(names.filter((name) => typeof name === "string"))];
}

/** The file that TetGen's .ele needs beside it. */
function nodesBeside(name: unknown): string | null {
  return typeof name === "string" && /\.ele$/i.test(name) ?
    name.replace(/ele$/i, (end) => (end.endsWith("E") ? "NODE" : "node")) :
    null;
}

export function sceneText(scene: Scene): string {
  return typeof scene === "string" ? scene : JSON.stringify(scene);
}

/** Lines of KEY=JSON, as `weft run --set` takes them. */
export function changeLines(set: Readonly<Record<string, unknown>>): string {
  return Object.entries(set).map(([key, value]) => `${key}=${JSON.stringify(value)}`).join("\n");
}

/** The bytes, unpacked where they are gzip data. */
export async function unpacked(bytes: Bytes): Promise<Uint8Array> {
  const raw = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes);
  if (raw[0] !== 0x1f || raw[1] !== 0x8b) return raw;
  const stream = new Blob([raw as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
