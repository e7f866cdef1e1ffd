// What the stored run of the page of methods has of explicit and implicit steps on large sheets.
import { significant } from "../src/digits.js";
import { element } from "../src/elements.js";
import { milliseconds, summaries } from "../methods/stored_run.js";
import { STORED } from "../methods/stored_view.js";
import { BDF2, SEMI_IMPLICIT_EULER } from "./integrators.js";

export function showStoredTimes(): void {
  element("stored-machine", HTMLSpanElement).textContent = STORED.adapter;
  const rows = summaries(STORED);
  const time = (side: number, kind: string): string => {
    const row = rows.find((one) => one.side === side && one.kind === kind)?.five;
    return row ? `${significant(milliseconds(row))}\u00a0ms` : "none";
  };
  const body = element("stored-times", HTMLTableSectionElement);
  for (const side of [...new Set(rows.map((row) => row.side))]) {
    const row = body.insertRow(), head = document.createElement("th");
    head.scope = "row";
    head.textContent = `${side} × ${side}`;
    row.append(head);
    for (const { kind } of [SEMI_IMPLICIT_EULER, BDF2]) row.insertCell().textContent = time(side, kind);
  }
}
