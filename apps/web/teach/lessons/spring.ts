// A mass on a spring, let go where the spring is not stretched: its period.
import { period } from "../laws.js";
import { periodOf } from "../measured.js";
import { recorded, type Course } from "../course.js";
import { drawChain } from "../drawings.js";
import { SEMI_IMPLICIT_EULER } from "../integrators.js";
import { chain, column, GRAVITY } from "../scenes.js";

const SECONDS = 6; // of the longest period some three
const STEP = 1 / 600; // s
const LENGTH = 0.3; // m

export async function spring(mass: number, stiffness: number): Promise<Course> {
  const scene = chain({ masses: 1, mass, stiffness, length: LENGTH, gravity: GRAVITY, step: STEP,
    solver: SEMI_IMPLICIT_EULER });
  const heights = await recorded(scene, SECONDS / STEP, (reference) => column(reference.positions()));
  const [pin, start] = heights[0]! as [number, number];
  const sag = (mass * GRAVITY) / stiffness; // of the mass at rest
  const byLaw = period(mass, stiffness);
  const times = heights.map((_, frame) => frame * STEP), fallen = heights.map(([, now]) => start - now!);
  const measured = periodOf(times, fallen, sag);
  const formula = times.map((time) => sag * (1 - Math.cos((2 * Math.PI * time) / byLaw)));
  const off = 100 * Math.abs(measured / byLaw - 1);
  return {
    readings: { "spring-measured": { value: measured, unit: "s" }, "spring-law": { value: byLaw, unit: "s" } },
    verdict: `Measured and computed period differ by ${off < 0.01 ? "less than 0.01" : off.toFixed(2)} %.`,
    curves: [
      { order: 0, name: "measured", points: times.map((time, i) => [time, 100 * fallen[i]!]) },
      { order: 1, name: "by the formula", formula: true, points: times.map((time, i) => [time, 100 * formula[i]!]) },
    ],
    duration: SECONDS,
    at: (seconds) => seconds,
    draw(pen, seconds) {
      const frame = Math.min(heights.length - 1, Math.round(seconds / STEP));
      const scale = (pen.height - 60) / (LENGTH + 2 * sag);
      const radius = 8 + 20 * Math.sqrt(mass);
      const { context } = pen;
      context.strokeStyle = pen.color("--series-1");
      context.setLineDash([5, 4]);
      context.beginPath();
      const computed = 16 + scale * (LENGTH + formula[frame]!);
      context.moveTo(pen.width / 2 - 60, computed);
      context.lineTo(pen.width / 2 + 60, computed);
      context.stroke();
      context.setLineDash([]);
      drawChain(pen, pen.width / 2, 16, heights[frame]!.map((now) => scale * (pin - now)), radius, "--series-0");
    },
  };
}
