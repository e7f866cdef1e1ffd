// A sheet on a slope: it sticks as long as the slope is flatter than the friction angle, and slides beyond.
import type { Curve } from "../../src/line_plot.js";
import { slide } from "../laws.js";
import { accelerationOf } from "../measured.js";
import { recorded, type Course, type Pen } from "../course.js";
import { drawArrow } from "../drawings.js";
import { FRAME, GRAVITY, slope } from "../scenes.js";

const FRAMES = 60;
const SEEN = 1.6; // of the slope [m]
const TRIED = [0, 6, 12, 18, 24, 30, 36, 42, 48, 54, 60]; // degrees, for the plot

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** How far the sheet has come on average at the start and after each frame [m]. */
async function ways(degrees: number, friction: number): Promise<number[]> {
  const places = await recorded(slope(radians(degrees), friction), FRAMES, (reference) => {
    const positions = reference.positions();
    let sum = 0;
    for (let at = 0; at < positions.length; at += 3) sum += positions[at]!;
    return (3 * sum) / positions.length;
  });
  return places.map((place) => place - places[0]!);
}

/** What each slope of TRIED measures, by the coefficient: another slope of the visitor's needs them again. */
const measuredBy = new Map<number, Curve["points"]>();

async function triedBy(coefficient: number): Promise<Curve["points"]> {
  const known = measuredBy.get(coefficient);
  if (known) return known;
  const dots: (readonly [number, number])[] = [];
  for (const tried of TRIED) dots.push([tried, accelerationOf(await ways(tried, coefficient), FRAME)]);
  measuredBy.set(coefficient, dots);
  return dots;
}

export async function friction(degrees: number, coefficient: number): Promise<Course> {
  const way = await ways(degrees, coefficient);
  const measured = accelerationOf(way, FRAME);
  const byLaw = slide(radians(degrees), coefficient, GRAVITY);
  const angle = (Math.atan(coefficient) * 180) / Math.PI;
  const dots = await triedBy(coefficient);
  const all = Array.from({ length: 121 }, (_, i) => i / 2);
  const slides = way.at(-1)! > 1e-3;
  return {
    readings: {
      "friction-angle": { value: angle, unit: "°" },
      "friction-measured": { value: Math.max(0, measured) < 5e-5 ? 0 : measured, unit: "m/s²" },
      "friction-law": { value: byLaw, unit: "m/s²" },
      "friction-way": { value: 100 * way.at(-1)! < 5e-3 ? 0 : 100 * way.at(-1)!, unit: "cm" },
    },
    verdict: slides ?
      "It slides: the force from the slope would have to lean out of the cone of friction." :
      "It sticks: the force from the slope stays inside the cone of friction.",
    curves: [
      { order: 1, name: "by the formula", formula: true,
        points: all.map((tried) => [tried, slide(radians(tried), coefficient, GRAVITY)]) },
      { order: 0, name: "measured", dots: true, points: [...dots, [degrees, measured]] },
    ],
    duration: FRAMES * FRAME + 0.6,
    at: () => degrees,
    draw(pen, seconds) {
      const frame = Math.min(FRAMES, Math.round(seconds / FRAME));
      drawSlope(pen, radians(degrees), Math.atan(coefficient), way[frame]!, slides);
    },
  };
}

function drawSlope({ context, width, height, color }: Pen, angle: number, cone: number, way: number,
  slides: boolean): void {
  const scale = Math.min(width / Math.cos(angle), height / Math.max(Math.sin(angle), 0.3)) * 0.8 / SEEN;
  const half = (scale * SEEN) / 2;
  context.save();
  context.translate(width / 2, 0.56 * height);
  context.rotate(angle); // its right end is down
  context.strokeStyle = color("--soft");
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(-half, 0);
  context.lineTo(half, 0);
  context.stroke();
  const x = -0.55 * half + scale * way, long = Math.min(95, 0.4 * height);
  context.translate(x, -3);
  context.fillStyle = color("--series-2"); // the cone about the slope's normal
  context.globalAlpha = 0.28;
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(-long * Math.sin(cone), -long * Math.cos(cone));
  context.lineTo(long * Math.sin(cone), -long * Math.cos(cone));
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = color(slides ? "--series-4" : "--series-0");
  context.lineWidth = 6;
  context.beginPath();
  context.moveTo(-0.15 * scale, 0);
  context.lineTo(0.15 * scale, 0);
  context.stroke();
  context.lineWidth = 2.5;
  drawArrow(context, [0, 0], [-long * Math.sin(angle), -long * Math.cos(angle)]); // straight up: against the weight
  context.restore();
}
