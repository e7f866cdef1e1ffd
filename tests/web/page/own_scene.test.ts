// The scene of a mesh that a visitor brings is that of the window of `weft view`, which tests/window holds to the same
// file.
import { expect, it } from "vitest";
import { sceneOfMesh } from "../../../apps/web/src/files/own_scene.js";
import stored from "../../window/own_scenes.json";

it("makes the scene that a dropped mesh makes in the window", () => {
  const { name, vertices, triangles, area } = stored.mesh;
  const point = ([x, y, z]: number[]) => [x!, y!, z!] as [number, number, number];
  const mesh = { vertices, triangles, area, dropped: 0, low: point(stored.mesh.low), high: point(stored.mesh.high),
    ply: new Uint8Array() };
  for (const role of ["obstacle", "cloth"] as const)
    expect(JSON.parse(sceneOfMesh(name, mesh, role, stored.length).json)).toEqual(stored[role]);
});
