// The sheet that every path simulates: scenes/hanging-paper.json at any resolution, as plain numbers in SI units. What
// the core makes of the same scene is in src/scene/scene.cpp (places) and src/mesh/grid_springs.cpp (springs, uniform
// weights).
import sceneAddress from "../../../scenes/hanging-paper.json?url";

type Vector = readonly [x: number, y: number, z: number];

export interface Sheet {
  /** The scene's JSON, for the core. */
  readonly scene: string;
  /** Nodes in rows: i from 0 to nx - 1 along x, j from 0 to ny - 1 downwards. Node (i, j) has the number j nx + i. */
  readonly nx: number;
  readonly ny: number;
  /** [m] */
  readonly size: readonly [width: number, height: number];
  /** Of every node [kg]. */
  readonly nodeMass: number;
  /** [m/s²] */
  readonly gravity: Vector;
  /** [s] */
  readonly step: number;
  /** Of every spring [N·s/m]. */
  readonly damping: number;
  readonly springs: readonly SpringKind[];
  /** Numbers of the nodes that stay where they are. */
  readonly pinned: readonly number[];
  readonly camera: { readonly eye: Vector; readonly target: Vector; readonly fov_degrees: number };
}

/** Springs from each node (i, j) to (i + di, j + dj), wherever both are on the sheet. */
export interface SpringKind {
  readonly di: number;
  readonly dj: number;
  /** [m] */
  readonly restLength: number;
  /** [N/m] */
  readonly stiffness: number;
}

interface PaperScene {
  gravity: Vector;
  time: { frame: number; substeps: number };
  cloths: [
    { size: [number, number]; node_mass: number; damping: number;
      stiffness: { structural: number; shear: number; bend: number } },
  ];
  camera: Sheet["camera"];
}

export async function fetchScene(): Promise<string> {
  const answer = await fetch(sceneAddress);
  if (!answer.ok) throw new Error(`The scene hanging-paper cannot be fetched: the server answers ${answer.status}.`);
  return answer.text();
}

export function sheetOf(scene: string, nx: number, ny: number): Sheet {
  const { gravity, time, cloths: [cloth], camera } = JSON.parse(scene) as PaperScene;
  const { structural, shear, bend } = cloth.stiffness;
  const dx = cloth.size[0] / (nx - 1), dy = cloth.size[1] / (ny - 1);
  const diagonal = Math.sqrt(dx * dx + dy * dy);
  return {
    scene,
    nx,
    ny,
    gravity,
    camera,
    size: cloth.size,
    nodeMass: cloth.node_mass,
    damping: cloth.damping,
    step: time.frame / time.substeps,
    pinned: [0, nx - 1],
    springs: [
      { di: 1, dj: 0, restLength: dx, stiffness: structural },
      { di: 0, dj: 1, restLength: dy, stiffness: structural },
      { di: 1, dj: 1, restLength: diagonal, stiffness: shear },
      { di: -1, dj: 1, restLength: diagonal, stiffness: shear },
      { di: 2, dj: 0, restLength: 2 * dx, stiffness: bend },
      { di: 0, dj: 2, restLength: 2 * dy, stiffness: bend },
    ],
  };
}

export function springCount({ nx, ny, springs }: Sheet): number {
  return springs.reduce((sum, { di, dj }) => sum + (nx - Math.abs(di)) * (ny - dj), 0);
}

/** x, y, z of every node, flat and centred on the origin in the plane z = 0 [m]. */
export function restPositions({ nx, ny, size }: Sheet): Float64Array {
  const positions = new Float64Array(3 * nx * ny);
  for (let j = 0, at = 0; j < ny; j++)
    for (let i = 0; i < nx; i++, at += 3) {
      positions[at] = size[0] * (i / (nx - 1) - 0.5);
      positions[at + 1] = -size[1] * (j / (ny - 1) - 0.5);
    }
  return positions;
}

/** Two triangles a cell; the diagonal alternates, as the core's does (src/mesh/grid.hpp). */
export function triangles(nx: number, ny: number): Uint32Array {
  const out = new Uint32Array(6 * (nx - 1) * (ny - 1));
  for (let j = 0, at = 0; j + 1 < ny; j++)
    for (let i = 0; i + 1 < nx; i++, at += 6) {
      const a = j * nx + i, b = a + 1, c = a + nx, d = c + 1;
      out.set((i + j) % 2 === 0 ? [a, c, d, a, d, b] : [a, c, b, b, c, d], at);
    }
  return out;
}
