// The stored run on the page: who measured, plots, and both tables.
import { significant } from "../src/digits.js";
import { element } from "../src/elements.js";
import { mark, plot, type Chart } from "../src/plot.js";
import stored from "./sheet_run.json";
import { FRAME, front, methodOf, milliseconds, overTime, position, sidesOf, summaries, type StoredRow,
  type StoredRun } from "./stored_run.js";

export const STORED: StoredRun = stored;

const CHART: Chart = {
  title: "error over the time of a frame",
  x: { name: "ms a frame", empty: [1, 100], label: String },
  y: { name: "off after half a second [%]", empty: [0.1, 100], label: String },
  guides: [{ axis: "x", at: FRAME, name: "60 Hz", before: false }],
};

const nodesOf = (side: number): string => `${(side * side).toLocaleString("en")} nodes`;

/** `kinds`: all that the page gives a colour, in their order. */
export class StoredView {
  private readonly places: readonly { readonly side: number; readonly place: HTMLDivElement }[];

  constructor(private readonly kinds: readonly string[]) {
    element("stored-machine", HTMLSpanElement).textContent = `${STORED.adapter}, driver ${STORED.driver}`;
    element("legend", HTMLUListElement).replaceChildren(...kinds.map((kind, order) => {
      const item = document.createElement("li");
      item.append(mark(order), kind);
      return item;
    }));
    this.places = sidesOf(STORED).map((side) => ({ side, place: placeFor(side) }));
    this.draw();
    addEventListener("resize", () => this.draw());
    showSummaries();
    showRows();
  }

  private draw(): void {
    for (const { side, place } of this.places) {
      const series = this.kinds.map((kind, order) => ({ order, points: front(STORED, side, kind).map((row) =>
        [milliseconds(row), position(row)] as const
      ) }));
      place.replaceChildren(
        plot({ ...CHART, title: `${CHART.title}, ${nodesOf(side)}` }, series, Math.max(280, place.clientWidth), 340),
      );
    }
  }
}

function placeFor(side: number): HTMLDivElement {
  const figure = document.createElement("figure"), caption = document.createElement("figcaption");
  const place = document.createElement("div");
  caption.textContent = nodesOf(side);
  place.className = "plot";
  figure.append(caption, place);
  element("stored-plots", HTMLDivElement).append(figure);
  return place;
}

/** Of a row: substeps, and sweeps of those that sweep. */
const stepsOf = (row: StoredRow): string => row.variant.slice(methodOf(row).length).trim().replace("x", "×");

/** A cell with the steps that its number was made by. */
function named(cell: HTMLTableCellElement, row: StoredRow | null, text: (row: StoredRow) => string): void {
  cell.textContent = row ? text(row) : "none";
  if (row) cell.append(small(stepsOf(row)));
}

function small(text: string): HTMLSpanElement {
  const made = document.createElement("span");
  made.textContent = text;
  return made;
}

function heading(row: HTMLTableRowElement, text: string, under: string): void {
  const made = document.createElement("th");
  made.scope = "row";
  const parts = text.split(/(?<=_)/).flatMap((part) => [document.createElement("wbr"), part]);
  made.append(...parts.slice(1), small(under)); // a long name may be broken behind an underscore
  row.append(made);
}

function showSummaries(): void {
  const body = element("stored-summary", HTMLTableSectionElement);
  for (const { side, kind, nearest, five, one } of summaries(STORED)) {
    const row = body.insertRow();
    heading(row, kind, nodesOf(side));
    named(row.insertCell(), nearest, (found) => significant(position(found), 2));
    for (const fastest of [five, one])
      named(row.insertCell(), fastest, (found) => significant(milliseconds(found)));
  }
}

function showRows(): void {
  const body = element("stored-rows", HTMLTableSectionElement);
  for (const side of sidesOf(STORED))
    for (const found of STORED.rows.filter((one) => one.side === side)) {
      const row = body.insertRow();
      heading(row, found.variant, nodesOf(side));
      if (found.skipped !== undefined) Object.assign(row.insertCell(), { colSpan: 5, textContent: found.skipped });
      else for (const text of figures(found)) row.insertCell().textContent = text;
    }
}

const figures = (row: StoredRow): string[] => [
  significant(milliseconds(row)),
  `${significant(row.real_time_factor ?? NaN)} ×`,
  significant(row.dispatches_per_step ?? NaN, 4),
  overTime(row, (at) => (at.position === null ? null : 100 * at.position)),
  overTime(row, (at) => at.normal_degrees),
];
