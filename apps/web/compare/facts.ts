// Facts besides the results: the machine, and a description of each path.
import { element } from "../src/elements.js";
import { CATALOG } from "./catalog.js";
import { adapterName, type Hardware } from "./hardware.js";

export function showHardware(machine: Hardware): void {
  const rows: [string, string][] = [
    ["WebGPU", adapterName(machine) ?? "not available: its paths are left out"],
    ["WebGL 2", machine.webgl2 ?? "not available: its paths are left out"],
    ["Processors", String(machine.processors)],
    ["Browser", machine.browser],
    ["Date", machine.date],
  ];
  element("hardware", HTMLDListElement).replaceChildren(...rows.map(([name, value]) => {
    const row = document.createElement("div"), term = document.createElement("dt"), text = document.createElement("dd");
    term.textContent = name;
    text.textContent = value;
    row.append(term, text);
    return row;
  }));
}

export function showAbout(): void {
  const body = element("about", HTMLTableSectionElement);
  for (const { title, computes, draws, waits } of CATALOG) {
    const row = body.insertRow();
    const name = document.createElement("th");
    name.scope = "row";
    name.textContent = title;
    row.append(name);
    for (const text of [computes, draws, waits]) row.insertCell().textContent = text;
  }
}
