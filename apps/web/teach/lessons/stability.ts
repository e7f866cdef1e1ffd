// A chain of masses by explicit steps of any length: where they blow up.
import { highestFrequency, longestStep } from "../laws.js";
import { turningPoint } from "../measured.js";
import { recorded, withReference, type Course } from "../course.js";
import { drawChain } from "../drawings.js";
import { SEMI_IMPLICIT_EULER } from "../integrators.js";
import { chain, column } from "../scenes.js";

const [MASS, STIFFNESS, LENGTH] = [0.1, 20, 0.1]; // kg, N/m, m
const GRAVITY = 0.05; // m/s², so weak that the springs hardly stretch before they blow up
const STEPS = 300; // that are shown
const TRIED = 2000; // in each of the runs that look for the limit
const ROUNDS = 12; // of them
const SHOWN_SECOND = 40; // steps

const scene = (masses: number, step: number) =>
  chain({ masses, mass: MASS, stiffness: STIFFNESS, length: LENGTH, gravity: GRAVITY, step,
    solver: SEMI_IMPLICIT_EULER });

const farthest = (now: readonly number[], start: readonly number[]): number =>
  Math.max(...now.map((height, node) => Math.abs(height - start[node]!)));

/** Whether a node goes farther than the chain is long. */
function blowsUp(masses: number, step: number): Promise<boolean> {
  return withReference(scene(masses, step), (reference) => {
    const start = column(reference.positions());
    for (let done = 0; done < TRIED; done++) {
      reference.advance();
      if (farthest(column(reference.positions()), start) > masses * LENGTH) return true;
    }
    return false;
  });
}

export async function stability(masses: number, percent: number): Promise<Course> {
  const frequency = highestFrequency(masses, MASS, STIFFNESS), limit = longestStep(frequency);
  const step = (percent / 100) * limit;
  const heights = await recorded(scene(masses, step), STEPS, (reference) => column(reference.positions()));
  const ways = heights.map((now) => farthest(now, heights[0]!));
  const measured = await turningPoint(0.5 * limit, 1.5 * limit, ROUNDS, (tried) => blowsUp(masses, tried));
  const grown = ways.some((way) => way > masses * LENGTH);
  return {
    readings: {
      "stability-step": { value: 1000 * step, unit: "ms" },
      "stability-law": { value: 1000 * limit, unit: "ms" },
      "stability-measured": { value: 1000 * measured, unit: "ms" },
      "stability-frequency": { value: frequency, unit: "rad/s" },
    },
    verdict: grown ?
      "This step is too long: each step makes the fastest swing larger, and the chain blows up." :
      "This step is short enough: the chain swings and stays as it is.",
    curves: [{ order: grown ? 4 : 0, name: "farthest mass from its start",
      points: ways.flatMap((way, i) => way > 0 ? [[i, Math.log10(way)] as const] : []) }],
    range: [-5, 2],
    duration: (heights.length - 1) / SHOWN_SECOND,
    at: (seconds) => seconds * SHOWN_SECOND,
    draw(pen, seconds) {
      const frame = Math.min(heights.length - 1, Math.floor(seconds * SHOWN_SECOND));
      const scale = (pen.height - 60) / (masses * LENGTH);
      const top = heights[0]![0]!;
      drawChain(pen, pen.width / 2, 20, heights[frame]!.map((now) => scale * (top - now)), 7,
        grown ? "--series-4" : "--series-0");
    },
  };
}
