// Inspects a user's file before a world gets it. Each call has a module of its own and no device, so
// that it can be made in a worker, which can be ended where a file takes too long.
import { Core } from "./core.js";
import { sceneText, unpacked, type Bytes, type Scene } from "./scene.js";
import type { Point } from "./world_types.js";

export interface MeshFile {
  vertices: number;
  triangles: number;
  /** Triangles without area that were left out. */
  dropped: number;
  /** The corners of the box around it, in the file's unit. */
  low: Point;
  high: Point;
  /** Of all triangles, in the square of the file's unit. */
  area: number;
  /** The same mesh as binary PLY, which a world reads fastest. */
  ply: Uint8Array<ArrayBuffer>;
}

/**
 * Reads a mesh file; its format is that of the name's end (.glb, .obj, .off, .stl, .ply). `cleaned`: without what a
 * cloth cannot use, triangles without area and vertices without triangles.
 */
export async function readMesh(name: string, bytes: Bytes, { cleaned = false } = {}): Promise<MeshFile> {
  const core = await Core.create();
  core.withBytes(await unpacked(bytes), (at, size) => core.check("read_mesh", name, at, size, cleaned ? 1 : 0));
  const facts = JSON.parse(core.text()) as Omit<MeshFile, "ply">;
  const at = core.call("mesh_file") >>> 0;
  return { ...facts, ply: core.module.HEAPU8.slice(at, at + core.call("mesh_file_size")) as Uint8Array<ArrayBuffer> };
}

export interface SceneSize {
  /** Of all cloths together. */
  nodes: number;
  /** Of all meshes, boxes and convex hulls among the obstacles. */
  obstacleTriangles: number;
}

/** Reads and checks a scene and its meshes as `createWorld` would, but makes nothing. */
export async function checkScene(scene: Scene, meshes: Readonly<Record<string, Bytes>> = {}): Promise<SceneSize> {
  const core = await Core.create();
  await core.addMeshes(meshes);
  core.check("check_scene", sceneText(scene));
  return JSON.parse(core.text()) as SceneSize;
}
