// The scenes that every host of the core simulates to the same bits: each method, both kinds of cloth, contact, bodies.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { createWorld, meshNames, type World } from "weft-cloth";
import { ROOT } from "./chromium.ts";
import { gpu } from "./node_gpu.ts";

export interface Case {
  name: string;
  scene: string;
  frames: number;
  set: Record<string, unknown>;
}
const SPRING_CENTRIC = { kind: "mass_spring", forces: "spring_centric" };
export const CASES: readonly Case[] = [ // 100 steps each, but for the one that looks at what "auto" chooses
  { name: "hanging, node-centric", scene: "hanging", frames: 2,
    set: { "cloths.0.grid": [64, 64], "time.frame": 0.005, "time.substeps": 50 } },
  { name: "hanging, spring-centric", scene: "hanging", frames: 2,
    set: { "cloths.0.grid": [61, 47], "time.frame": 0.005, "time.substeps": 50, solver: SPRING_CENTRIC } },
  { name: "pull over the sphere, proximity", scene: "pull-sphere", frames: 10,
    set: { "cloths.0.grid": [40, 40], "time.substeps": 10,
      "cloths.0.stiffness": { structural: 150, shear: 40, bend: 3 } } },
  { name: "pull over the armadillo, bvh", scene: "pull-armadillo", frames: 10,
    set: { "cloths.0.grid": [40, 40], "time.substeps": 10,
      "cloths.0.stiffness": { structural: 150, shear: 40, bend: 3 } } },
  { name: "breeze", scene: "breeze", frames: 5,
    set: { "cloths.0.grid": [33, 24], "time.substeps": 20,
      "cloths.0.stiffness": { structural: 100, shear: 40, bend: 5 } } },
  { name: "sheet, multigrid", scene: "sheet", frames: 3, set: { "cloths.0.grid": [60, 43] } },
  { name: "a mesh, multigrid", scene: "pull-sphere", frames: 3,
    set: { solver: { kind: "multigrid" }, "contact.method": "none",
      cloths: [{ mesh: "sphere", density: 0.2, pins: [{ nodes: [0] }] }] } },
  { name: "hanging, xpbd", scene: "hanging", frames: 3,
    set: { "cloths.0.grid": [60, 43], solver: { kind: "xpbd", iterations: 2 } } },
  { name: "fabric, xpbd", scene: "fabric", frames: 2,
    set: { "cloths.0.grid": [24, 17], "time.substeps": 8, solver: { kind: "xpbd", iterations: 2 } } },
  { name: "hanging by tethers, pbd", scene: "hanging", frames: 3,
    set: { "cloths.0.grid": [60, 43], "cloths.0.tethers": { slack: 0 }, solver: { kind: "pbd", iterations: 3 } } },
  { name: "hanging, vbd", scene: "hanging", frames: 3,
    set: { "cloths.0.grid": [60, 43], solver: { kind: "vbd", iterations: 2 } } },
  { name: "fabric that creases, vbd", scene: "fabric", frames: 2,
    set: { "cloths.0.grid": [24, 17], "cloths.0.fabric.plastic": { yield_curvature: 0.01 }, "time.substeps": 8,
      solver: { kind: "vbd", iterations: 2 } } },
  { name: "hanging, projective dynamics", scene: "hanging", frames: 3,
    set: { "cloths.0.grid": [60, 43], solver: { kind: "projective_dynamics", iterations: 7 } } },
  { name: "fabric, projective dynamics", scene: "fabric", frames: 2,
    set: { "cloths.0.grid": [24, 17], "time.substeps": 8, solver: { kind: "projective_dynamics", iterations: 11 } } },
  { name: "sheet, fem", scene: "sheet", frames: 2, set: { "cloths.0.grid": [33, 24], solver: { kind: "fem" } } },
  { name: "bodies, vbd", scene: "jelly", frames: 2,
    set: { "cloths.0.grid": [9, 9], "bodies.0.cell": 0.08, "contact.method": "none",
      solver: { kind: "vbd", iterations: 2 } } },
  { name: "bodies, explicit", scene: "jelly", frames: 2,
    set: { "cloths.0.grid": [9, 9], "bodies.0.cell": 0.08, "contact.method": "none", "time.substeps": 64,
      "bodies.0.material.energy": "corotated", solver: { kind: "mass_spring" } } },
  { name: "a balloon, explicit", scene: "balloon", frames: 2,
    set: { "cloths.0.grid": [9, 9], "contact.method": "none", "time.substeps": 50 } },
  { name: "a balloon, multigrid", scene: "balloon", frames: 1,
    set: { "cloths.0.grid": [9, 9], "contact.method": "none", "time.substeps": 4, "time.frame": 0.004,
      solver: { kind: "multigrid" } } },
  { name: "rigid bodies, explicit", scene: "hammock", frames: 2,
    set: { "cloths.0.grid": [9, 9], "time.substeps": 24, "colliders.1.center": [0.02, 1.23, 0.01],
      "colliders.2.center": [0.1, 1.44, 0.05], solver: { kind: "mass_spring" } } },
  { name: "hanging with its own choice of substeps", scene: "hanging", frames: 1, set: { "cloths.0.grid": [24, 24] } },
];

/** Arguments of `weft run`, but for its options. */
export const runOf = (
  { scene, set }: Case,
): string[] => ["run", join(ROOT, `scenes/${scene}.json`), "--json",
  ...Object.entries(set).flatMap(([key, value]) => ["--set", `${key}=${JSON.stringify(value)}`])];

/** The scene in a world of Node's. */
export function worldOf({ scene, set }: Case): Promise<World> {
  const text = readFileSync(join(ROOT, `scenes/${scene}.json`), "utf8");
  const meshes = Object.fromEntries(
    meshNames(text).map((name) => [name, readFileSync(join(ROOT, `models/${name}.ply`))]),
  );
  return createWorld({ scene: text, canvas: null, gpu, meshes, set });
}
