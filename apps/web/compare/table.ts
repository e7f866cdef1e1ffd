// The table on the page: a row a size, a column a path.
import { short } from "../src/digits.js";
import { CATALOG, type PathName } from "./catalog.js";
import type { Options } from "./options.js";
import { framesASecond, type Cell } from "./runner.js";

export class Table {
  private readonly places = new Map<string, HTMLTableCellElement>();

  /** Without figures, in the place of what the table had before. */
  constructor(table: HTMLTableElement, { paths, sides }: Options) {
    for (const part of [table.tHead, ...table.tBodies]) part?.remove();
    const head = table.createTHead().insertRow();
    head.append(heading("Nodes", "col"), ...paths.map((path) => heading(titleOf(path), "col")));
    const body = table.createTBody();
    for (const side of sides) {
      const row = body.insertRow();
      row.append(heading((side * side).toLocaleString("en"), "row", `${side} × ${side}`));
      for (const path of paths) {
        const place = row.insertCell();
        place.textContent = "–";
        this.places.set(`${path} ${side}`, place);
      }
    }
  }

  show(cell: Cell, measuring: boolean): void {
    const place = this.places.get(`${cell.path} ${cell.side}`);
    if (!place) return;
    const rate = framesASecond(cell);
    const lines = [
      rate !== null ? part("strong", `${short(rate)} fps`) : null,
      cell.frame ? part("span", `${short(cell.frame.median)} ms a frame`) : null,
      cell.step ? part("span", `${short(cell.step.median)} ms a step`) : null,
      cell.note !== null ? part("em", cell.note) : measuring ? part("em", "measuring") : null,
    ];
    place.replaceChildren(...lines.filter((line) => line !== null));
    place.dataset["pace"] = rate === null ? "" : rate >= 30 ? "real-time" : "slow";
  }
}

export const titleOf = (path: PathName): string => CATALOG.find(({ name }) => name === path)!.title;

function part(tag: "strong" | "span" | "em", text: string): HTMLElement {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

function heading(text: string, scope: "row" | "col", small?: string): HTMLTableCellElement {
  const made = document.createElement("th");
  made.scope = scope;
  made.append(text, ...(small === undefined ? [] : [part("span", small)]));
  return made;
}

/** Where a path first falls under 30 frames a second, in a sentence. */
export function verdict(path: PathName, cells: readonly Cell[]): string {
  const own = cells.filter((cell) => cell.path === path);
  const measured = own.filter((cell) => cell.frame !== null);
  const name = titleOf(path);
  if (measured.length === 0) return `${name}: ${own[0]?.note ?? "not measured yet."}`;
  const slow = measured.find((cell) => framesASecond(cell)! < 30);
  const rate = (cell: Cell) => `${short(framesASecond(cell)!)} fps at ${(cell.side ** 2).toLocaleString("en")} nodes`;
  return slow ?
    `${name} first falls under 30 fps with ${rate(slow)}.` :
    `${name} stays above 30 fps: ${rate(measured.at(-1)!)}.`;
}
