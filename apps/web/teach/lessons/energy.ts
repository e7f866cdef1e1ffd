// The same oscillation by three integrators of the engine: what each does to its energy.
import { significant } from "../../src/digits.js";
import { backwardEuler, bdf2, period } from "../laws.js";
import { recorded, type Course } from "../course.js";
import { drawChain } from "../drawings.js";
import { BDF2, IMPLICIT_EULER, SEMI_IMPLICIT_EULER } from "../integrators.js";
import { chain, column, GRAVITY } from "../scenes.js";

const [MASS, STIFFNESS, LENGTH] = [0.1, 20, 0.3]; // kg, N/m, m
const PERIODS = 10;
const SHOWN_SECOND = 1; // periods

/** Methods of the engine, of which each is this integrator on a single spring. */
const WAYS = [
  { id: "symplectic", name: "semi-implicit Euler", order: 0, solver: SEMI_IMPLICIT_EULER },
  { id: "bdf2", name: "BDF2", order: 2, solver: { ...BDF2, residual: 1e-5 } },
  { id: "backward", name: "implicit Euler", order: 3, solver: IMPLICIT_EULER },
] as const;

const inPercent = (part: number): string => `${significant(100 * part, 2)}\u00a0%`;

interface State {
  readonly heights: readonly number[];
  /** Of what there was at the start, above rest. */
  readonly left: number;
}

export async function energy(steps: number): Promise<Course> {
  const whole = period(MASS, STIFFNESS), step = whole / steps, phase = (2 * Math.PI) / steps;
  const count = PERIODS * steps;
  const start = (MASS * GRAVITY) ** 2 / STIFFNESS; // above rest, of both columns [J]
  const runs: State[][] = [];
  for (const { solver } of WAYS) {
    const states = await recorded(
      chain({ masses: 1, mass: MASS, stiffness: STIFFNESS, length: LENGTH, gravity: GRAVITY, step, solver }),
      count,
      (reference) => ({ heights: column(reference.positions()), energy: reference.energy }),
    );
    runs.push(
      states.map((state) => ({ heights: state.heights, left: 1 + (state.energy - states[0]!.energy) / start })),
    );
  }
  const left = (i: number) => runs[i]!.at(-1)!.left;
  const forward = Array.from({ length: count + 1 }, (_, i) => [i / steps, backwardEuler(phase) ** -i] as const);
  const percent = (part: number) => ({ value: 100 * part, unit: "%" });
  // BDF2 begins with a step of implicit Euler, whose error it keeps: its formula is of what each later period leaves.
  const bdf2Later = left(1) / runs[1]![steps]!.left;
  return {
    readings: {
      "energy-symplectic": percent(left(0)),
      "energy-backward": percent(left(2)),
      "energy-backward-period": percent(runs[2]![steps]!.left),
      "energy-backward-law": percent(backwardEuler(phase) ** steps),
      "energy-bdf2": percent(left(1)),
      "energy-bdf2-period": percent(bdf2Later ** (1 / (PERIODS - 1))),
      "energy-bdf2-law": percent(bdf2(phase) ** steps),
      "energy-forward-law": percent(backwardEuler(phase) ** -count),
    },
    verdict: `After ${PERIODS} periods implicit Euler has ${inPercent(left(2))} of the energy left, BDF2 ` +
      `${inPercent(left(1))}; semi-implicit Euler swings about all of it.`,
    curves: [
      ...WAYS.map(({ name, order }, i) => ({ order, name,
        points: runs[i]!.map(({ left: part }, at) => [at / steps, 100 * part] as const) })
      ),
      { order: 4, name: "explicit Euler, by its formula", formula: true,
        points: forward.map(([at, part]) => [at, 100 * part] as const) },
    ],
    range: [0, 150],
    duration: PERIODS / SHOWN_SECOND,
    at: (seconds) => seconds * SHOWN_SECOND,
    draw(pen, seconds) {
      const frame = Math.min(count, Math.round(seconds * SHOWN_SECOND * steps));
      const scale = (pen.height - 60) / (LENGTH + (2.4 * MASS * GRAVITY) / STIFFNESS);
      WAYS.forEach(({ order }, i) => {
        const { heights } = runs[i]![frame]!;
        drawChain(pen, ((i + 0.5) * pen.width) / WAYS.length, 16, heights.map((now) => scale * (heights[0]! - now)), 12,
          `--series-${order}`);
      });
    },
  };
}
