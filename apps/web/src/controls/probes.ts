// What one node of the cloth does, or two and how far they are apart; each has a marker over the picture.
import { WeftError, type Probe } from "weft-cloth";
import { button, element } from "../elements.js";
import type { Place } from "../hand.js";
import { Paced } from "../paced.js";
import { onLayer } from "../places.js";
import type { Player } from "../player.js";
import { put, svg } from "../svg.js";
import { ClickMode } from "./click_mode.js";
import { fill } from "./readings.js";

const PACE = { calm: 30, share: 0.2 }; // of measurements
const NAMES = ["A", "B"] as const; // there are no more than these

interface Mark {
  readonly node: number;
  readonly circle: SVGCircleElement;
  readonly letter: SVGTextElement;
  found: Probe | null;
}

export class Probes {
  private marks: Mark[] = [];
  private readonly layer = element("pins", SVGSVGElement);
  private readonly line = this.part("line", "ruler");
  private readonly mode: ClickMode;
  private readonly measuring = new Paced(() => this.measure(), PACE);

  constructor(canvas: HTMLCanvasElement, private readonly player: Player,
    private readonly say: (sentence: string) => void) {
    this.mode = new ClickMode(canvas, "probe-mode", (place) => void this.toggle(place));
    button("unprobe").addEventListener("click", () => this.forget());
    this.tell();
  }

  /** The nodes that are measured. */
  get nodes(): readonly number[] {
    return this.marks.map(({ node }) => node);
  }

  enable(on: boolean): void {
    this.mode.enable(on);
  }

  toggleUnderPointer(): Promise<void> {
    return this.toggle(this.mode.pointer);
  }

  /** Measures the node under a place on the canvas, or no longer; of more than two the first goes. */
  async toggle({ x, y }: Place): Promise<void> {
    const picked = await this.player.ask(async (world) => (await this.player.pick(world, x, y)) ?? "none");
    if (!picked) return;
    if (picked === "none") return this.say("There is no cloth to measure there.");
    const known = this.marks.find(({ node }) => node === picked.node);
    if (known) this.drop(known);
    else {
      if (this.marks.length === NAMES.length) this.drop(this.marks[0]!);
      this.marks.push({ node: picked.node, circle: this.part("circle", "probe"), letter: this.part("text", ""),
        found: null });
    }
    await this.measuring.carryOut();
    this.tell();
  }

  forget(): void {
    for (const mark of [...this.marks]) this.drop(mark);
    this.tell();
  }

  /** A frame has been simulated or drawn. */
  frame(now: number): void {
    if (this.marks.length === 0) return this.measuring.stop();
    this.draw();
    this.measuring.frame(now);
  }

  private async measure(): Promise<void> {
    for (const mark of [...this.marks]) {
      const found = await this.player.ask((world) => world.probe(mark.node).catch(absent));
      if (found === "none") this.drop(mark);
      else if (found) mark.found = found;
    }
    this.draw();
    this.tell();
  }

  private drop(mark: Mark): void {
    mark.circle.remove();
    mark.letter.remove();
    this.marks = this.marks.filter((one) => one !== mark);
    this.draw();
  }

  /** Brings the markers to their nodes. */
  draw(): void {
    const world = this.player.live;
    if (!world || world.busy) return;
    const placeOf = onLayer(this.layer, world);
    const places = this.marks.flatMap(({ circle, letter, found }, order) => {
      if (!found) return [];
      const at = placeOf(found.position);
      place(circle, { r: 5, cx: at.x, cy: at.y });
      place(letter, { x: at.x + 9, y: at.y - 9 });
      letter.textContent = NAMES[order]!;
      return [at];
    });
    const [a, b] = places;
    this.line.style.display = a && b ? "" : "none";
    if (a && b) place(this.line, { x1: a.x, y1: a.y, x2: b.x, y2: b.y });
  }

  private tell(): void {
    const count = this.marks.length;
    element("probes-note", HTMLParagraphElement).textContent = [
      "Press M over the cloth to measure it there, at a second place to see how far they are apart.",
      "Press M at a second place to see how far they are apart.",
      "Apart: straight through space, now and at rest.",
    ][count]!;
    button("unprobe").disabled = count === 0;
    const [a, b] = this.marks.map(({ found }) => found);
    fill(element("probe-readings", HTMLDListElement), [
      ...this.marks.flatMap(({ node, found }, order) => found ? rowsOf(NAMES[order]!, node, found) : []),
      ...(a && b ?
        [["Apart", `${metres(apart(a.position, b.position))} m`], ["At rest",
          `${metres(apart(a.rest, b.rest))} m`]] as const :
        []),
    ]);
  }

  private part<Name extends "circle" | "line" | "text">(name: Name, kind: string): SVGElementTagNameMap[Name] {
    const made: SVGElementTagNameMap[Name] = svg(name, kind === "" ? {} : { class: kind });
    this.layer.append(made);
    return made;
  }
}

const metres = (value: number): string => value.toFixed(3);
const apart = (a: readonly number[], b: readonly number[]): number => Math.hypot(...a.map((x, i) => x - b[i]!));

function rowsOf(name: string, node: number, { position, velocity, stretch, tension, force }: Probe) {
  return [
    [`${name}: node`, String(node)],
    ["Place", `${position.map(metres).join(", ")} m`],
    ["Speed", `${Math.hypot(...velocity).toFixed(3)} m/s`],
    ["Stretch", `${(100 * (stretch - 1)).toFixed(1)} %`],
    ["Tension", `${tension.toPrecision(3)} N/m`],
    ["Force", `${Math.hypot(...force).toPrecision(3)} N`],
  ] as const;
}

function place(part: SVGElement, numbers: Readonly<Record<string, number>>): void {
  put(part, Object.fromEntries(Object.entries(numbers).map(([name, value]) => [name, value.toFixed(1)])));
}

/** A reset sews and heals: the node may be gone. */
function absent(reason: unknown): "none" {
  if (reason instanceof WeftError && reason.kind === "input") return "none";
  throw reason;
}
