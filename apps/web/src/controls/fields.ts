// The two kinds of field that parameters have: a slider for what changes while the cloth moves, a number for the rest.

let made = 0; // for ids

/** A row with its name, and the id that its control takes. */
export function row(label: string, hint: string): { row: HTMLDivElement; id: string; name: HTMLLabelElement } {
  const row = document.createElement("div");
  row.className = "field";
  const name = document.createElement("label");
  const id = `field-${++made}`;
  name.htmlFor = id;
  name.textContent = label;
  if (hint) name.title = hint;
  row.append(name);
  return { row, id, name };
}

export interface SliderLook {
  readonly label: string;
  readonly unit: string;
  readonly hint: string;
  readonly step: number;
}

export class Slider {
  readonly row: HTMLDivElement;
  private readonly input = document.createElement("input");
  private readonly output = document.createElement("output");

  constructor(private readonly look: SliderLook, act: (value: number) => void) {
    const { row: box, id } = row(look.label, look.hint);
    box.classList.add("slider");
    Object.assign(this.input, { type: "range", id, step: String(look.step), disabled: true });
    this.output.setAttribute("for", id);
    this.input.addEventListener("input", () => {
      this.tell();
      act(Number(this.input.value));
    });
    box.append(this.input, this.output);
    this.row = box;
  }

  set disabled(on: boolean) {
    this.input.disabled = on;
  }
  get value(): number {
    return Number(this.input.value);
  }

  show(value: number, least: number, most: number): void {
    this.input.min = String(least);
    this.input.max = String(most);
    if (document.activeElement !== this.input) this.input.value = String(value); // else it is ahead of the world
    this.tell();
  }

  private tell(): void {
    const digits = Math.max(0, -Math.floor(Math.log10(this.look.step)));
    const text = `${this.value.toFixed(digits)}${this.look.unit === "°" ? "" : "\u00a0"}${this.look.unit}`.trim();
    this.output.textContent = text;
    this.input.setAttribute("aria-valuetext", text);
  }
}

export interface NumberLook {
  readonly label: string;
  readonly unit: string;
  readonly hint: string;
  readonly least: number;
  readonly most: number;
  readonly whole: boolean;
  /** A word that may stand for a number: nothing in the field. */
  readonly word: string | null;
}

export class NumberField {
  readonly row: HTMLDivElement;
  private readonly input = document.createElement("input");
  private shown = "";

  /** `act` gets the text of what was entered, and says whether it was taken. */
  constructor(look: NumberLook, act: (text: string) => boolean) {
    const { row: box, id } = row(look.label, look.hint);
    box.classList.add("inline");
    const { least, most, whole, word } = look;
    Object.assign(this.input, { type: "number", id, inputMode: "decimal", min: String(least), max: String(most),
      step: whole ? "1" : "any", placeholder: word ?? "", disabled: true });
    const unit = document.createElement("span");
    unit.className = "unit";
    unit.textContent = look.unit;
    this.input.addEventListener("change", () => {
      if (this.input.value === this.shown && !this.input.validity.badInput) return;
      if (!act(this.input.value === "" && word !== null && !this.input.validity.badInput ? word : this.input.value))
        this.input.value = this.shown;
    });
    box.append(this.input, unit);
    this.row = box;
  }

  set disabled(on: boolean) {
    this.input.disabled = on;
  }

  /** A number; anything else is the word that stands for one. */
  show(value: unknown): void {
    this.shown = typeof value === "number" ? String(value) : "";
    this.input.value = this.shown;
  }
}
