// The scene's facts and running figures: the lists of the panel, and all of it as JSON.
import type { Statistics, WorldInfo } from "weft-cloth";
import { element } from "../elements.js";
import { inBytes } from "../memory.js";
import type { Graph } from "./graph.js";

const WINDOW = 1000; // rates are means over this time [ms]
const REFRESH = 250; // numbers that change faster cannot be read [ms]
const NONE = "–";

const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
const fixed = (digits: number) =>
  new Intl.NumberFormat("en", {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
  });
const [one, two] = [fixed(1), fixed(2)];

export function fill(list: HTMLDListElement, rows: readonly (readonly [name: string, value: string])[]): void {
  list.replaceChildren(...rows.map(([name, value]) => {
    const row = document.createElement("div");
    const term = document.createElement("dt");
    const detail = document.createElement("dd");
    [term.textContent, detail.textContent] = [name, value];
    row.append(term, detail);
    return row;
  }));
}

export class Readings {
  private readonly facts = element("facts", HTMLDListElement);
  private readonly readings = element("readings", HTMLDListElement);
  private readonly pulse = element("pulse", HTMLParagraphElement);
  private samples: { at: number; seconds: number; frames: number }[] = [];
  private shownAt = 0;
  private late: ReturnType<typeof setTimeout> | undefined;
  private statistics: Readonly<Statistics> | null = null;

  constructor(private readonly graph: Graph) {}

  /** Facts of the loaded scene; null: none is loaded. */
  showFacts(info: WorldInfo | null): void {
    fill(this.facts, info ?
      [
        ["Adapter", info.adapter],
        ["Method", info.solver],
        ...(info.solverReason === null ? [] : [["Chosen since", info.solverReason] as const]),
        ["Nodes", whole.format(info.nodes)],
        ["Triangles", whole.format(info.triangles)],
        ["Springs", whole.format(info.springs)],
        ["Membranes, hinges", `${whole.format(info.membranes)}, ${whole.format(info.hinges)}`],
        ...(info.tetrahedra > 0 ? [["Tetrahedra", whole.format(info.tetrahedra)] as const] : []),
        ["Substeps per frame", whole.format(info.substeps)],
        ["Step", `${two.format(1000 * info.stepSeconds)} ms`],
        ["Largest stable step", `${two.format(1000 * info.stableStepSeconds)} ms`],
        ["Buffers on the GPU", inBytes(info.gpuBytes)],
      ] :
      []);
    this.statistics = null;
    this.restart();
    this.show();
  }

  /** Restarts the rates: after a pause, a reset, another scene. */
  restart(): void {
    clearTimeout(this.late);
    this.samples = [];
    this.shownAt = 0;
    this.graph.restart();
  }

  /** `host`: what this frame cost the page's thread [ms]; null where none was simulated. */
  frame(now: number, statistics: Readonly<Statistics>, host: number | null): void {
    const { seconds, frames } = statistics;
    const newest = this.samples.at(-1);
    if (newest && frames < newest.frames) this.restart(); // it was reset
    if (!newest || frames > newest.frames) this.samples.push({ at: now, seconds, frames });
    while (this.samples.length > 2 && now - this.samples[0]!.at > WINDOW) this.samples.shift();
    if (host !== null) this.graph.add(now, host);
    this.statistics = statistics;
    clearTimeout(this.late);
    if (now - this.shownAt >= REFRESH) this.show();
    else this.late = setTimeout(() => this.show(), REFRESH); // the last before a pause counts
  }

  /** Mean over the window; null where it is too short to say. */
  private rate(of: "seconds" | "frames"): number | null {
    const [first, last] = [this.samples[0], this.samples.at(-1)];
    if (!first || !last || last.at - first.at < REFRESH) return null;
    return ((last[of] - first[of]) * 1000) / (last.at - first.at);
  }

  /** What is shown, as numbers. */
  get values() {
    const now = this.graph.medians;
    return { statistics: this.statistics && { ...this.statistics }, realTimeFactor: this.rate("seconds"),
      framesPerSecond: this.rate("frames"), medianFrameMilliseconds: now?.interval ?? null,
      medianHostMilliseconds: now?.host ?? null };
  }

  private show(): void {
    this.shownAt = performance.now();
    this.graph.draw();
    const { statistics, realTimeFactor, framesPerSecond, medianHostMilliseconds } = this.values;
    const factor = realTimeFactor === null ? NONE : `${two.format(realTimeFactor)} ×`;
    const rate = framesPerSecond === null ? NONE : one.format(framesPerSecond);
    const stretch = Math.max(0, (statistics?.maxStretch ?? 1) - 1); // 0 before the first frame has reported
    fill(this.readings, [
      ["Simulated time", `${two.format(statistics?.seconds ?? 0)} s`],
      ["Speed against real time", factor],
      ["Frames a second", rate],
      ["CPU per frame", medianHostMilliseconds === null ? NONE : `${two.format(medianHostMilliseconds)} ms`],
      ["Dropped time", `${two.format(statistics?.droppedSeconds ?? 0)} s`],
      ["Largest stretch", `${one.format(100 * stretch)} %`],
      ["Contacts", whole.format(statistics?.contacts ?? 0)],
      ["Pairs, at most", whole.format(statistics?.pairs ?? 0)],
    ]);
    this.pulse.textContent = realTimeFactor === null ? "" : `${factor} · ${rate} fps`;
  }
}
