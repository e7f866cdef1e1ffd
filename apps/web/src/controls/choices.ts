// Fields of parameters that are no numbers: one of the schema's words, and a colour.
import { row } from "./fields.js";

/** A word of the schema for people: denim_11oz is "Denim 11oz". */
export function spoken(word: string): string {
  const text = word.replaceAll("_", " ");
  return text[0]!.toUpperCase() + text.slice(1);
}

export interface ChoiceLook {
  readonly label: string;
  readonly hint: string;
  readonly words: readonly string[];
}

export class Choice {
  readonly row: HTMLDivElement;
  private readonly list = document.createElement("select");
  private readonly name: HTMLLabelElement;
  private readonly own = new Option("", "");
  private standing = ""; // what holds where nothing is chosen; "" where that is no word

  /** `act` gets what was chosen; null: what holds where nothing is. */
  constructor({ label, hint, words }: ChoiceLook, act: (word: string | null) => void) {
    const { row: box, id, name } = row(label, hint);
    box.classList.add("choice");
    this.name = name;
    Object.assign(this.list, { id, disabled: true });
    this.list.append(this.own, ...words.map((word) => new Option(spoken(word), word)));
    this.list.addEventListener("change", () => act(this.list.value === this.standing ? null : this.list.value));
    box.append(this.list);
    this.row = box;
  }

  set disabled(on: boolean) {
    this.list.disabled = on;
  }
  set label(text: string) {
    this.name.textContent = text;
  }

  /** `standing`: what holds where nothing is chosen, a word or `otherwise` said. */
  show(value: unknown, standing: unknown, otherwise: string): void {
    const has = (word: unknown) => [...this.list.options].some((one) => one !== this.own && one.value === word);
    this.standing = has(standing) ? String(standing) : "";
    this.own.textContent = otherwise;
    this.own.hidden = this.own.disabled = this.standing !== "";
    this.list.value = has(value) ? String(value) : "";
  }
}

type Color = readonly [number, number, number];

/** sRGB of [0, 1] and as #rrggbb. */
const hexOf = (color: Color): string =>
  `#${color.map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;
const colorOf = (hex: string): Color =>
  [1, 3, 5].map((at) => Number((parseInt(hex.slice(at, at + 2), 16) / 255).toFixed(3))) as unknown as Color;

export class ColorField {
  readonly row: HTMLDivElement;
  private readonly input = document.createElement("input");

  constructor(label: string, hint: string, act: (value: Color) => void) {
    const { row: box, id } = row(label, hint);
    box.classList.add("choice");
    Object.assign(this.input, { type: "color", id, disabled: true });
    this.input.addEventListener("input", () => act(colorOf(this.input.value)));
    box.append(this.input);
    this.row = box;
  }

  set disabled(on: boolean) {
    this.input.disabled = on;
  }

  show(color: Color): void {
    this.input.value = hexOf(color);
  }
}
