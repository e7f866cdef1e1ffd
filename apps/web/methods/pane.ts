// What stands around a lane: which method it is, its picture, what is read of it, and its settings.
import { short, significant } from "../src/digits.js";
import { followSize, setFirstSize } from "../src/canvas_size.js";
import { NumberField } from "../src/controls/fields.js";
import { mark } from "../src/plot.js";
import { choicesOf, meaningOf, rangeOf } from "../src/state/limits.js";
import { svg } from "../src/svg.js";
import { turnBy } from "../src/turning.js";
import type { Schema } from "weft-cloth";
import { Lane, type Turned } from "./lane.js";
import type { Reading } from "./lock_step.js";
import type { Offer } from "./offers.js";
import type { Choice } from "./state.js";

export interface PaneEvents {
  chosen(kind: string): void;
  /** The text of a setting's field; false: it is no value of it. */
  set(key: string, text: string): boolean;
  removed(): void;
  orbit(dx: number, dy: number): void;
  /** The lane has failed by itself. */
  failed(): void;
}

export interface PaneLook {
  readonly offers: readonly Offer[];
  readonly substeps: Schema;
  readonly turned: Turned;
  /** The place of a method's colour. */
  order(kind: string): number;
}

const LABELS: Readonly<Record<string, string>> = { substeps: "Substeps a frame" };
const labelOf = (key: string): string => LABELS[key] ?? key[0]!.toUpperCase() + key.slice(1).replaceAll("_", " ");

export class Pane {
  readonly box = document.createElement("div");
  readonly lane: Lane;
  private readonly canvas = document.createElement("canvas");
  private readonly kind = document.createElement("select");
  private readonly mark = document.createElement("span");
  private readonly over = document.createElement("p"); // in front of the picture: what is under way, or what failed
  private readonly facts = document.createElement("dl");
  private readonly settings = document.createElement("div");
  private readonly remove = document.createElement("button");
  private choice: Choice | null = null;

  constructor(private readonly look: PaneLook, private readonly events: PaneEvents) {
    this.box.className = "pane";
    this.box.setAttribute("role", "group");
    this.kind.replaceChildren(...look.offers.map(({ kind }) => new Option(kind, kind)));
    this.kind.addEventListener("change", () => events.chosen(this.kind.value));
    this.mark.className = "pane-mark";
    this.over.className = "pane-over";
    this.settings.className = "pane-settings";
    const head = document.createElement("div"), picture = document.createElement("div");
    head.className = "pane-head";
    head.append(this.mark, this.kind, this.remove);
    picture.className = "pane-picture";
    picture.append(this.canvas, this.over);
    this.prepareButton();
    this.prepareCanvas();
    this.box.append(head, picture, this.facts, this.settings);
    this.lane = new Lane(this.canvas, look.turned, () => events.failed());
  }

  private prepareButton(): void {
    this.remove.type = "button";
    this.remove.className = "icon";
    this.remove.append(
      svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: "M6 6l12 12M18 6L6 18" })),
    );
    this.remove.addEventListener("click", () => this.events.removed());
  }

  private prepareCanvas(): void {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-describedby", "turn-help");
    turnBy(this.canvas, (dx, dy) => this.events.orbit(dx, dy));
  }

  /** Called when the pane is on the page: its canvas has a size then. */
  placed(): void {
    setFirstSize(this.canvas);
    followSize(this.canvas, (width, height) => this.lane.resize(width, height));
  }

  /** `index`: among `count` panes. */
  show(choice: Choice, index: number, count: number): void {
    const name = `Method ${index + 1}`;
    this.box.setAttribute("aria-label", `${name}: ${choice.kind}`);
    this.kind.setAttribute("aria-label", name);
    this.kind.value = choice.kind;
    this.canvas.setAttribute("aria-label", `The cloth by ${choice.kind}, drawn as it moves`);
    this.remove.setAttribute("aria-label", `Remove method ${index + 1}, ${choice.kind}`);
    this.remove.hidden = count === 1;
    if (JSON.stringify(choice) === JSON.stringify(this.choice)) return;
    this.choice = choice;
    this.mark.replaceChildren(mark(this.look.order(choice.kind)));
    this.showSettings(choice);
  }

  private showSettings(choice: Choice): void {
    const { settings } = this.look.offers.find(({ kind }) => kind === choice.kind)!;
    const field = (key: string, schema: Schema, value: unknown) =>
      rangeOf(schema) ? this.numberField(key, schema, value) : this.choiceField(key, schema, value);
    this.settings.replaceChildren(field("substeps", this.look.substeps, choice.substeps),
      ...Object.entries(settings).map(([key, schema]) => field(key, schema, choice.settings[key])));
  }

  private numberField(key: string, schema: Schema, value: unknown): HTMLElement {
    const { least, most, whole } = rangeOf(schema)!;
    const field = new NumberField({ label: labelOf(key), unit: "", hint: meaningOf(schema), least, most, whole,
      word: String(schema.default) }, (text) => this.events.set(key, text));
    field.disabled = false;
    field.show(value);
    return field.row;
  }

  private choiceField(key: string, schema: Schema, value: unknown): HTMLElement {
    const row = document.createElement("label"), list = document.createElement("select");
    row.className = "field choice";
    row.title = meaningOf(schema);
    list.replaceChildren(...choicesOf(schema).map((word) => new Option(word, word)));
    list.value = String(value ?? schema.default);
    list.addEventListener("change", () => this.events.set(key, list.value));
    row.append(labelOf(key), list);
    return row;
  }

  /** In front of the picture; null: nothing is. */
  private say(sentence: string | null): void {
    this.over.hidden = sentence === null;
    this.over.textContent = sentence ?? "";
  }

  /** The lane is being made. */
  preparing(): void {
    this.canvas.hidden = false;
    this.say(`Preparing ${this.choice!.kind} …`);
  }

  /**
   * `first`: whether the others are compared with this one. null: there is nothing to read. `stored`: what a frame of
   * the same work takes where the stored run is from [ms].
   */
  read(reading: Reading | null, first: boolean, stored: { adapter: string; milliseconds: number } | null): void {
    const { fault } = this.lane;
    this.say(fault);
    this.box.dataset["fault"] = String(fault !== null);
    this.canvas.hidden = fault !== null;
    const none = "–";
    const rows: readonly (readonly [string, string])[] = [
      ["A frame", reading?.milliseconds != null ? `${short(reading.milliseconds)} ms` : none],
      ...(stored ? [[`On ${stored.adapter}`, `${short(stored.milliseconds)} ms`] as const] : []),
      ["Substeps", reading ? String(reading.substeps) : none],
      ["Off from the first", first && reading ? "the first" : percent(reading?.error ?? null) ?? none],
      ["Kinetic energy", reading ? `${significant(reading.kinetic)} J` : none],
      ["Height energy", reading ? `${significant(reading.height)} J`.replace("-", "−") : none],
    ];
    this.facts.replaceChildren(...rows.map(([name, value]) => {
      const row = document.createElement("div"), term = document.createElement("dt");
      const text = document.createElement("dd");
      term.textContent = name;
      text.textContent = value;
      row.append(term, text);
      return row;
    }));
  }

  dispose(): void {
    this.lane.dispose();
    this.box.remove();
  }
}

const percent = (part: number | null): string | null => (part === null ? null : `${significant(100 * part)} %`);
