// Scenes from what a visitor brings: a mesh as obstacle or as cloth, or a whole scene. Lengths in metres, masses in kg.
import type { MeshFile } from "weft-cloth";
import type { OwnScene } from "../scenes.js";

export type Role = "obstacle" | "cloth";

const MESH = "own.ply"; // one name for all, so that the core keeps the last one only
const GRID = 64; // nodes a side of the sheet; the panel offers more
const DENSITY = 0.3; // [kg/m²]
// [N/m] for a mesh of 1 m; scaled with the length, so that a mesh of any size sags by the same fraction.
const STIFFNESS = { structural: 375, shear: 50, bend: 1.7 };
const DAMPING = 0.09; // of a spring, as a part of sqrt(stiffness * mass): the same at any resolution

const number = (value: number): number => Number(value.toPrecision(6));
const point = (...values: number[]): number[] => values.map(number);

export const sides = (
  { low, high }: MeshFile,
): [number, number, number] => [high[0] - low[0], high[1] - low[1], high[2] - low[2]];

/** Centred over the origin, its longest side this long and its lowest point at `floor`. */
function placed({ low, high }: MeshFile, scale: number, floor: number): Record<string, unknown> {
  const middle = (axis: 0 | 2) => -scale * 0.5 * (low[axis] + high[axis]);
  return { scale: number(scale), translate: point(middle(0), floor - scale * low[1], middle(2)) };
}

const stiffnessOf = (length: number) =>
  Object.fromEntries(Object.entries(STIFFNESS).map(([kind, value]) => [kind, number(value * length)]));
const dampingOf = (length: number, nodeMass: number) =>
  number(DAMPING * Math.sqrt(STIFFNESS.structural * length * nodeMass));

const common = (title: string, thickness: number) => ({
  format: "weft-scene/1",
  title: title.slice(0, 200),
  drag: 0.5,
  time: { substeps: "auto", frames: 150 },
  contact: { method: "proximity", thickness: number(thickness) },
});
const FLOOR = { kind: "plane", point: [0, 0, 0], normal: [0, 1, 0] };

/** A square sheet falls on the mesh, which stands on a floor. */
function overObstacle(title: string, mesh: MeshFile, length: number): object {
  const scale = length / Math.max(...sides(mesh));
  const height = scale * sides(mesh)[1];
  const width = 1.7 * length;
  return {
    ...common(title, 0.003 * width),
    cloths: [{
      name: "sheet",
      grid: [GRID, GRID],
      size: point(width, width),
      plane: "xz",
      transform: { translate: point(0, height + 0.08 * length, 0) },
      density: DENSITY,
      stiffness: stiffnessOf(length),
      friction: 0.4,
      damping: dampingOf(length, (DENSITY * width * width) / (GRID * GRID)),
    }],
    colliders: [{ kind: "mesh", mesh: MESH, transform: placed(mesh, scale, 0) }, FLOOR],
    camera: {
      eye: point(1.35 * length, height + 0.45 * length, 2.1 * length),
      target: point(0, 0.42 * height, 0),
      fov_degrees: 38,
    },
  };
}

/** The mesh is a cloth that falls on a ball. All nodes weigh the same, so that small triangles need no smaller step. */
function asCloth(title: string, mesh: MeshFile, length: number): object {
  const scale = length / Math.max(...sides(mesh));
  const area = mesh.area * scale * scale;
  const nodeMass = (DENSITY * area) / mesh.vertices;
  const edge = 1.5 * Math.sqrt(area / mesh.triangles); // of an equilateral triangle of the mean area
  const radius = 0.25 * length;
  const floor = 2 * radius + 0.08 * length; // of the mesh, above the ball
  const top = floor + scale * sides(mesh)[1];
  const distance = 1.9 * top; // a fifth more than what its field of view holds
  return {
    ...common(title, Math.min(0.005 * length, 0.3 * edge)),
    cloths: [{
      name: "mesh",
      mesh: MESH,
      transform: placed(mesh, scale, floor),
      node_mass: number(nodeMass),
      stiffness: stiffnessOf(length),
      friction: 0.4,
      damping: dampingOf(length, nodeMass),
    }],
    colliders: [{ kind: "sphere", center: point(0, radius, 0), radius: number(radius) }, FLOOR],
    camera: {
      eye: point(0.44 * distance, 0.5 * top + 0.25 * distance, 0.86 * distance),
      target: point(0, 0.5 * top, 0),
      fov_degrees: 38,
    },
  };
}

/** `length`: of the mesh's longest side [m]. */
export function sceneOfMesh(name: string, mesh: MeshFile, role: Role, length: number): OwnScene {
  const title = role === "obstacle" ? `Draped over ${name}` : `${name} as cloth`;
  const scene = role === "obstacle" ? overObstacle(title, mesh, length) : asCloth(title, mesh, length);
  return { title, json: JSON.stringify(scene), meshes: { [MESH]: mesh.ply } };
}

/** A scene that the core has accepted, with the meshes that came with it, which are PLY now whatever they were. */
export function sceneOfJson(name: string, json: string,
  meshes: Readonly<Record<string, Uint8Array<ArrayBuffer>>>): OwnScene {
  const names = new Map(Object.keys(meshes).map((from, index) => [from, `own-${index}.ply`]));
  const scene = JSON.parse(json,
    (key, value: unknown) => key === "mesh" && typeof value === "string" ? names.get(value) ?? value : value) as {
      title?: string;
    };
  return {
    title: scene.title ?? name,
    json: JSON.stringify(scene),
    meshes: Object.fromEntries(Object.entries(meshes).map(([from, bytes]) => [names.get(from)!, bytes])),
  };
}
