import { button, element } from "../src/elements.js";
import { mark, plot, type Series } from "../src/plot.js";
import { CATALOG, type PathName } from "./catalog.js";
import { chartOf } from "./charts.js";
import { showAbout, showHardware } from "./facts.js";
import { hardware, type Hardware } from "./hardware.js";
import { OptionError, optionsOf, type Options } from "./options.js";
import type { Path } from "./paths/path.js";
import { csvOf, jsonOf, reportOf, textOf, type Report } from "./report.js";
import { freshCanvas, openPath, Runner, type Cell } from "./runner.js";
import { fetchScene } from "./sheet.js";
import { Table, titleOf, verdict } from "./table.js";

/** `window.compare`, for bench/web/compare.ts, tests and the browser's console. */
export interface CompareHandle {
  /** Rejects where the page cannot measure at all. */
  readonly ready: Promise<void>;
  /** Measures everything, as the button does; false where it was stopped. */
  start(): Promise<boolean>;
  report(): Report;
  /** The same as a table for people. */
  text(): string;
  /** A sheet at rest, to be stepped by hand and shown on the page. `scene`: another with the keys of hanging-paper. */
  open(path: PathName, grid: readonly [number, number], scene?: string): Promise<Path>;
}

const start = button("start"), pause = button("pause"), stop = button("stop");
const progress = element("progress", HTMLParagraphElement);
const live = element("live", HTMLDivElement), idle = live.firstElementChild!;

/** All that is known once the page is ready. */
interface Known {
  readonly options: Options;
  readonly scene: string;
  readonly machine: Hardware;
}
let known: Known | null = null;
let runner: Runner | null = null;
let last: readonly Cell[] = []; // of the run that was started last

async function prepare(): Promise<void> {
  showAbout();
  try {
    const options = optionsOf(location.href);
    const [scene, machine] = await Promise.all([fetchScene(), hardware()]);
    known = { options, scene, machine };
    new Table(element("table", HTMLTableElement), options);
    showHardware(machine);
    showResults(known);
    start.disabled = false;
    progress.textContent = `Ready: ${options.paths.length} paths at ${options.sides.length} sizes, ${
      options.budget / 1000
    } s a timing.`;
  } catch (reason) {
    const problem = element("error", HTMLParagraphElement);
    problem.textContent = reason instanceof Error ? reason.message : String(reason);
    problem.hidden = false;
    progress.textContent = reason instanceof OptionError ? "Nothing is measured." : "The page could not be prepared.";
    throw reason;
  }
}

async function measureAll(): Promise<boolean> {
  if (!known) throw new Error("The page is not ready.");
  if (runner) throw new Error("A measurement is under way.");
  const { options, scene } = known;
  const table = new Table(element("table", HTMLTableElement), options);
  const here = new Runner(options, scene, {
    began(cell, canvas) {
      live.replaceChildren(canvas);
      table.show(cell, true);
      progress.textContent = `Measuring ${titleOf(cell.path)}, ${(cell.side ** 2).toLocaleString("en")} nodes.`;
    },
    changed(cell) {
      table.show(cell, cell.step === null);
      if (known) showResults(known);
    },
  });
  runner = here;
  last = here.cells;
  setRunning(true);
  try {
    const whole = await here.run();
    progress.textContent = whole ? "Done." : "Stopped.";
    return whole;
  } finally {
    live.replaceChildren(idle);
    runner = null;
    setRunning(false);
  }
}

function setRunning(on: boolean): void {
  start.disabled = on;
  pause.disabled = stop.disabled = !on;
  pause.setAttribute("aria-pressed", "false");
  for (const id of ["json", "csv", "copy"]) button(id).disabled = on || last.length === 0;
}

function report(): Report {
  if (!known) throw new Error("The page is not ready.");
  return reportOf(known.machine, known.options, known.scene, last);
}

function showResults({ options: { paths } }: Known): void {
  const series = (which: "frame" | "step") =>
    paths.map((path): Series => ({
      order: CATALOG.findIndex(({ name }) => name === path),
      points: last.flatMap((
        cell,
      ) => (cell.path === path && cell[which] ? [[cell.side ** 2, cell[which].median] as const] : [])),
    }));
  element("verdicts", HTMLUListElement).replaceChildren(
    ...(last.length === 0 ? [] : paths.map((path) => item(verdict(path, last)))),
  );
  element("legend", HTMLUListElement).replaceChildren(
    ...series("frame").map(({ order }, i) => item(mark(order), titleOf(paths[i]!))),
  );
  for (const which of ["frame", "step"] as const) {
    const place = element(`${which}-plot`, HTMLDivElement);
    place.replaceChildren(plot(chartOf(which), series(which), Math.max(280, place.clientWidth), 320));
  }
}

function item(...content: (Node | string)[]): HTMLLIElement {
  const made = document.createElement("li");
  made.append(...content);
  return made;
}

function download(name: string, type: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

start.addEventListener("click", () =>
  void measureAll().catch((reason: unknown) => {
    progress.textContent = String(reason);
  }));
pause.addEventListener("click", () => {
  if (!runner) return;
  runner.gate.paused = !runner.gate.paused;
  pause.setAttribute("aria-pressed", String(runner.gate.paused));
});
stop.addEventListener("click", () => runner?.gate.stop());
button("json").addEventListener("click", () => download("weft-compare.json", "application/json", jsonOf(report())));
button("csv").addEventListener("click", () => download("weft-compare.csv", "text/csv", csvOf(report())));
button("copy").addEventListener("click", () => {
  const said = element("copied", HTMLSpanElement);
  navigator.clipboard.writeText(textOf(report())).then(
    () => {
      said.textContent = "Copied.";
    },
    () => {
      said.textContent = "The browser does not allow copying here.";
    },
  );
});
addEventListener("resize", () => {
  if (known) showResults(known);
});

const ready = prepare();
ready.catch(() => undefined); // said on the page already
const handle: CompareHandle = {
  ready,
  report,
  start: measureAll,
  text: () => textOf(report()),
  async open(name, grid, scene) {
    if (!known) throw new Error("The page is not ready.");
    const canvas = freshCanvas();
    live.replaceChildren(canvas);
    return openPath(name, scene ?? known.scene, grid, canvas);
  },
};
Object.assign(window, { compare: handle });
