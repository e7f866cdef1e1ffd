// Springs, slopes and arrows on a 2D canvas.
import type { Pen } from "./course.js";

const TURNS = 9; // of a spring's zigzag
const HALF_WIDTH = 9; // of it [pixel]

/** A chain that hangs from (x, top): heights below its pin [pixel], as far as the picture goes. */
export function drawChain({ context, height, color }: Pen, x: number, top: number, depths: readonly number[],
  radius: number, dye: string): void {
  const seen = (depth: number) => Math.min(height + 40, Math.max(-40, top + depth));
  context.strokeStyle = color("--soft");
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x - 26, top);
  context.lineTo(x + 26, top);
  context.stroke();
  depths.slice(1).forEach((depth, i) => drawSpring(context, x, seen(depths[i]!), seen(depth)));
  context.fillStyle = color(dye);
  for (const depth of depths.slice(1)) {
    context.beginPath();
    context.arc(x, seen(depth), radius, 0, 2 * Math.PI);
    context.fill();
  }
}

function drawSpring(context: CanvasRenderingContext2D, x: number, from: number, to: number): void {
  const end = (to - from) / 8; // straight at both ends
  context.beginPath();
  context.moveTo(x, from);
  context.lineTo(x, from + end);
  for (let turn = 0; turn < TURNS; turn++) {
    const side = turn % 2 === 0 ? HALF_WIDTH : -HALF_WIDTH;
    context.lineTo(x + side, from + end + ((to - from - 2 * end) * (turn + 0.5)) / TURNS);
  }
  context.lineTo(x, to - end);
  context.lineTo(x, to);
  context.stroke();
}

export function drawArrow(context: CanvasRenderingContext2D, from: readonly [number, number],
  to: readonly [number, number]): void {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  for (const turn of [2.6, -2.6]) {
    context.moveTo(...to);
    context.lineTo(to[0] + 9 * Math.cos(angle + turn), to[1] + 9 * Math.sin(angle + turn));
  }
  context.stroke();
}
