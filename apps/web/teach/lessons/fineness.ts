// The same sheet on finer and finer grids: what a frame takes by explicit steps, and by as few implicit ones as an
// error allows.
import { positionError } from "../../methods/quantities.js";
import { Times } from "../../src/times.js";
import { ClothSketch } from "../../src/cloth_sketch.js";
import { withReference, type Course } from "../course.js";
import { BDF2, SEMI_IMPLICIT_EULER, type Integrator } from "../integrators.js";
import { FRAME, sheet } from "../scenes.js";

export const SIZES = [8, 12, 16, 24, 32] as const; // nodes along a side
const IMPLICIT = [1, 2, 4, 8] as const; // substeps of a frame
const FRAMES = 30; // half a second
const SHOWN = 16; // nodes of the picture

interface Run {
  readonly positions: readonly Float32Array[];
  readonly triangles: Uint32Array;
  readonly substeps: number;
  /** Of a frame, the median. */
  readonly milliseconds: number;
}

interface Trial {
  readonly size: number;
  readonly explicit: Run;
  readonly implicit: readonly (Run & { readonly error: number })[];
}

/** All frames' positions; what is timed is the simulation alone. */
function run(size: number, solver: Integrator, substeps: number | "auto"): Promise<Run> {
  return withReference(sheet(size, solver, substeps), (reference) => {
    const positions = [reference.positions()];
    const times = new Times(FRAMES);
    for (let frame = 0; frame < FRAMES; frame++) {
      const start = performance.now();
      reference.advance();
      times.add(performance.now() - start);
      positions.push(reference.positions());
    }
    return { positions, triangles: reference.triangles, substeps: reference.info.substeps,
      milliseconds: times.median! };
  });
}

/** Errors are measured against explicit steps of half the length. */
async function tried(size: number): Promise<Trial> {
  const explicit = await run(size, SEMI_IMPLICIT_EULER, "auto");
  const nearest = await run(size, SEMI_IMPLICIT_EULER, 2 * explicit.substeps);
  const start = nearest.positions[0]!, end = nearest.positions.at(-1)!;
  const implicit = [];
  for (const substeps of IMPLICIT) {
    const made = await run(size, BDF2, substeps);
    implicit.push({ ...made, error: positionError(made.positions.at(-1)!, end, start)! });
  }
  return { size, explicit, implicit };
}

/** Measured once a visit; `progress` is told of each size, so that the page can say where it is. */
export class Fineness {
  private trials: readonly Trial[] | null = null;

  async measure(progress: (size: number) => void): Promise<void> {
    const trials: Trial[] = [];
    for (const size of SIZES) {
      progress(size);
      await new Promise((done) => setTimeout(done, 30)); // or the page could not show it
      trials.push(await tried(size));
    }
    this.trials = trials;
  }

  course(percent: number): Course | null {
    const { trials } = this;
    if (!trials) return null;
    const rows = trials.map(({ size, explicit, implicit }) => ({ size, explicit,
      implicit: implicit.find(({ error }) => 100 * error <= percent) ?? null })
    );
    const good = rows.flatMap((row) => (row.implicit ? [{ ...row, implicit: row.implicit }] : []));
    const cheaper = good.find(({ explicit, implicit }) => implicit.milliseconds < explicit.milliseconds);
    const coarse = rows[0]!, fine = rows.at(-1)!;
    const shown = rows.find(({ size }) => size === SHOWN)!;
    const pictured = shown.implicit ?? shown.explicit;
    let sketch: ClothSketch | null = null;
    return {
      readings: {
        "fineness-explicit":
          `${coarse.explicit.substeps} substeps at ${coarse.size}², ${fine.explicit.substeps} at ${fine.size}²`,
        "fineness-implicit": [coarse, fine].map(({ implicit, size }) =>
          implicit === null ? `more than ${IMPLICIT.at(-1)} at ${size}²` : `${implicit.substeps} at ${size}²`
        ).join(", "),
        "fineness-times": { value: fine.explicit.milliseconds, unit: "ms" },
        "fineness-implicit-times": fine.implicit === null ?
          "none is near enough" :
          { value: fine.implicit.milliseconds, unit: "ms" },
      },
      verdict: cheaper ?
        `At this error implicit steps take less time than explicit ones from ${cheaper.size} × ${cheaper.size} ` +
        "nodes on, on this machine." :
        `At this error explicit steps take less time up to ${fine.size} × ${fine.size} nodes, on this machine.`,
      curves: [
        { order: 0, name: "explicit", points: rows.map(({ size, explicit }) => [size, explicit.milliseconds]) },
        { order: 2, name: "implicit, within the error",
          points: good.map(({ size, implicit }) => [size, implicit.milliseconds] as const) },
      ],
      duration: FRAMES * FRAME,
      slowed: 2,
      at: () => null,
      draw(pen, seconds) {
        sketch ??= new ClothSketch(pen.context.canvas, pen.context, pictured.triangles, [SHOWN, SHOWN], {
          eye: [2.9, 0.3, 3.3],
          target: [-0.1, -0.7, -0.3],
          fov: 42,
        });
        pen.context.setTransform(1, 0, 0, 1, 0, 0); // a sketch draws in device pixels
        sketch.draw(pictured.positions[Math.min(FRAMES, Math.round(seconds / FRAME))]!);
      },
    };
  }
}
