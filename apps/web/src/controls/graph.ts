// How long the last frames took, as a picture: what the host spent on each, and the time from one to the next.
import { element } from "../elements.js";

const FRAMES = 120;
const MARKS = [1000 / 60, 1000 / 30]; // [ms]
const TOP = 50; // of the scale [ms]; what is longer ends there

export class Graph {
  private readonly canvas = element("graph", HTMLCanvasElement);
  private readonly context = this.canvas.getContext("2d");
  private frames: { interval: number; host: number }[] = [];
  private last: number | null = null;

  /** A frame was simulated at `now`, at the expense of `host` [ms]. */
  add(now: number, host: number): void {
    if (this.last !== null) this.frames.push({ interval: now - this.last, host });
    this.last = now;
    if (this.frames.length > FRAMES) this.frames.shift();
  }

  /** What comes next has no frame before it. */
  restart(): void {
    this.last = null;
    this.frames = [];
    this.draw();
  }

  /** Of the frames shown [ms]; null where there are none. */
  get medians(): { interval: number; host: number } | null {
    if (this.frames.length === 0) return null;
    const median = (of: "interval" | "host") =>
      this.frames.map((frame) => frame[of]).sort((a, b) => a - b)[this.frames.length >> 1]!;
    return { interval: median("interval"), host: median("host") };
  }

  draw(): void {
    const { canvas, context, frames } = this;
    if (!context || canvas.clientWidth === 0) return;
    canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
    canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
    const style = getComputedStyle(canvas);
    const color = (name: string) => style.getPropertyValue(name);
    const height = (ms: number) => canvas.height * (1 - Math.min(ms, TOP) / TOP);
    const width = canvas.width / FRAMES;
    context.fillStyle = color("--graph-host");
    frames.forEach(({ host }, i) =>
      context.fillRect(i * width, height(host), Math.max(width - 1, 1), canvas.height - height(host))
    );
    context.lineWidth = devicePixelRatio;
    context.strokeStyle = color("--graph-mark");
    context.setLineDash([3 * devicePixelRatio, 3 * devicePixelRatio]);
    for (const mark of MARKS) {
      context.beginPath();
      context.moveTo(0, Math.round(height(mark)) + 0.5);
      context.lineTo(canvas.width, Math.round(height(mark)) + 0.5);
      context.stroke();
    }
    context.setLineDash([]);
    context.lineWidth = 1.5 * devicePixelRatio;
    context.strokeStyle = color("--graph-interval");
    context.beginPath();
    frames.forEach(({ interval }, i) => context.lineTo((i + 0.5) * width, height(interval)));
    context.stroke();
    const now = this.medians;
    canvas.setAttribute("aria-label", now ?
      `Of the last ${frames.length} frames, half took less than ${now.interval.toFixed(1)} ms ` +
      `from one to the next, and less than ${now.host.toFixed(1)} ms of the host.` :
      "No frames yet.");
  }
}
