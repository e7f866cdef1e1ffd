// weft on WebGPU, by its package, as any page uses it: no baseline, the thing compared.
import { createWorld, type World } from "weft-cloth";
import type { Sheet } from "../sheet.js";
import { Unavailable, type Open, type Path } from "./path.js";

/** Steps in one submit at most, where nothing is drawn. */
const MOST_SUBSTEPS = 256;

class WeftPath implements Path {
  readonly leastSteps = 32; // a frame ends with normals, stretch, a copy of the state and a report
  private world: World | null = null;
  private opened = ""; // what `world` was opened for

  constructor(private readonly sheet: Sheet, private readonly canvas: HTMLCanvasElement,
    private readonly forces: string) {}

  /** Without a picture weft takes its steps as substeps of a frame, in one submit. */
  async simulate(count: number): Promise<void> {
    const substeps = Math.min(count, MOST_SUBSTEPS);
    if (count % substeps !== 0) throw new Error(`${count} steps are not a multiple of ${substeps}.`);
    await (await this.open(null, substeps)).step(count / substeps);
  }

  async animate(count: number): Promise<void> {
    await (await this.open(this.canvas, 1)).step(count, { draw: true });
  }

  async positions(): Promise<Float32Array> {
    return (this.world ?? await this.open(null, 1)).positions();
  }

  dispose(): void {
    this.world?.dispose();
  }

  /** A world for drawing draws by itself too, whenever something is stale; so there is another one for steps alone. */
  private async open(canvas: HTMLCanvasElement | null, substeps: number): Promise<World> {
    const wanted = `${canvas ? "drawn" : "bare"} ${substeps}`;
    if (this.world && this.opened === wanted) return this.world;
    this.world?.dispose();
    const { scene, nx, ny, step } = this.sheet;
    this.world = await createWorld({ scene, canvas, view: "normals",
      set: { "cloths.0.grid": [nx, ny], "solver.forces": this.forces, "time.frame": step * substeps,
        "time.substeps": substeps } });
    this.opened = wanted;
    return this.world;
  }
}

const open = (forces: string): Open => async (sheet, canvas) => {
  if (!(await (navigator as { gpu?: GPU }).gpu?.requestAdapter().catch(() => null)))
    throw new Unavailable("This browser offers no WebGPU adapter.");
  return new WeftPath(sheet, canvas, forces);
};

export const openNodeCentric = open("node_centric");
export const openSpringCentric = open("spring_centric");
