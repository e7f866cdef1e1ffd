// What is loaded, and how it goes: the lists of the panel.
import type { Statistics, WorldInfo } from "weft";
import { element } from "./elements.js";

const WINDOW = 1000; // rates are means over this time [ms]
const REFRESH = 250; // numbers that change faster cannot be read [ms]
const NONE = "–";

const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
const fixed = (digits: number) => new Intl.NumberFormat("en", {
  minimumFractionDigits: digits, maximumFractionDigits: digits });
const [one, two] = [fixed(1), fixed(2)];

function fill(list: HTMLDListElement, rows: readonly (readonly [name: string, value: string])[]): void {
  list.replaceChildren(...rows.map(([name, value]) => {
    const row = document.createElement("div");
    const term = document.createElement("dt");
    const detail = document.createElement("dd");
    [term.textContent, detail.textContent] = [name, value];
    row.append(term, detail);
    return row;
  }));
}

export class Status {
  private readonly facts = element("facts", HTMLDListElement);
  private readonly readings = element("readings", HTMLDListElement);
  private readonly pulse = element("pulse", HTMLParagraphElement);
  private samples: { at: number; seconds: number; frames: number }[] = [];
  private shownAt = 0;
  private late: ReturnType<typeof setTimeout> | undefined;

  /** What was loaded; null: nothing is. */
  showFacts(info: WorldInfo | null): void {
    fill(this.facts, info ? [
      ["Adapter", info.adapter],
      ["Nodes", whole.format(info.nodes)],
      ["Triangles", whole.format(info.triangles)],
      ["Springs", whole.format(info.springs)],
      ["Steps a frame", whole.format(info.substeps)],
    ] : []);
    clearTimeout(this.late);
    this.restart();
    this.show({ frames: 0, seconds: 0, contacts: 0, contactHash: 0, contactOverflow: 0, maxStretch: 1, nonfinite: 0 });
  }

  /** Rates begin anew: after a pause, a reset, another scene. */
  restart(): void {
    this.samples = [];
    this.shownAt = 0;
  }

  frame(now: number, statistics: Readonly<Statistics>): void {
    const { seconds, frames } = statistics;
    const newest = this.samples.at(-1);
    if (newest && frames < newest.frames) this.restart(); // it was reset
    if (!newest || frames > newest.frames) this.samples.push({ at: now, seconds, frames });
    while (this.samples.length > 2 && now - this.samples[0]!.at > WINDOW) this.samples.shift();
    clearTimeout(this.late);
    if (now - this.shownAt >= REFRESH) this.show(statistics);
    else this.late = setTimeout(() => this.show(statistics), REFRESH); // the last before a pause counts
  }

  /** Mean over the window; null where it is too short to say. */
  private rate(of: "seconds" | "frames"): number | null {
    const [first, last] = [this.samples[0], this.samples.at(-1)];
    if (!first || !last || last.at - first.at < REFRESH) return null;
    return ((last[of] - first[of]) * 1000) / (last.at - first.at);
  }

  private show(statistics: Readonly<Statistics>): void {
    this.shownAt = performance.now();
    const [speed, pictures] = [this.rate("seconds"), this.rate("frames")];
    const factor = speed === null ? NONE : `${two.format(speed)} ×`;
    const rate = pictures === null ? NONE : one.format(pictures);
    const stretch = Math.max(0, statistics.maxStretch - 1); // 0 before the first frame has reported
    fill(this.readings, [
      ["Simulated time", `${two.format(statistics.seconds)} s`],
      ["Speed against real time", factor],
      ["Frames a second", rate],
      ["Largest stretch", `${one.format(100 * stretch)} %`],
      ["Contacts", whole.format(statistics.contacts)],
    ]);
    this.pulse.textContent = speed === null ? "" : `${factor} · ${rate} fps`;
  }
}
