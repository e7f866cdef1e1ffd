// The result as JSON, as CSV and as text.
import { short } from "../src/digits.js";
import { CATALOG, type PathName } from "./catalog.js";
import { adapterName, type Hardware } from "./hardware.js";
import type { Timing } from "./measure.js";
import type { Options } from "./options.js";
import { HEIGHT, WIDTH } from "./paths/path.js";
import { framesASecond, type Cell } from "./runner.js";
import { sheetOf, springCount } from "./sheet.js";

interface Summary {
  median: number;
  min: number;
  batches: number;
  steps_per_batch: number;
}

export interface Row {
  path: PathName;
  side: number;
  nodes: number;
  springs: number;
  ms_per_step: Summary | null;
  ms_per_frame: Summary | null;
  fps: number | null;
  note: string | null;
}

export interface Report {
  bench: "compare";
  /** WebGPU's, or else WebGL's. */
  adapter: string;
  scene: "hanging-paper";
  canvas: readonly [number, number];
  budget_ms: number;
  hardware: Hardware;
  rows: Row[];
}

const summary = (timing: Timing | null): Summary | null =>
  timing && { median: timing.median, min: timing.min, batches: timing.batches, steps_per_batch: timing.batch };

export function reportOf(hardware: Hardware, { budget }: Options, scene: string, cells: readonly Cell[]): Report {
  return {
    bench: "compare",
    adapter: adapterName(hardware) ?? hardware.webgl2 ?? "none",
    scene: "hanging-paper",
    canvas: [WIDTH, HEIGHT],
    budget_ms: budget,
    hardware,
    rows: cells.map((cell) => ({
      path: cell.path,
      side: cell.side,
      nodes: cell.side ** 2,
      springs: springCount(sheetOf(scene, cell.side, cell.side)),
      ms_per_step: summary(cell.step),
      ms_per_frame: summary(cell.frame),
      fps: framesASecond(cell),
      note: cell.note,
    })),
  };
}

export const jsonOf = (report: Report): string => `${JSON.stringify(report, null, 2)}\n`;

export function csvOf({ rows }: Report): string {
  const field = (value: string | number | null | undefined) =>
    typeof value === "string" ? `"${value.replaceAll("\"", "\"\"")}"` : String(value ?? "");
  const head = "path,side,nodes,springs,step_ms_median,step_ms_min,frame_ms_median,frame_ms_min,fps,note";
  const lines = rows.map((row) =>
    [row.path, row.side, row.nodes, row.springs, row.ms_per_step?.median, row.ms_per_step?.min,
      row.ms_per_frame?.median, row.ms_per_frame?.min, row.fps, row.note].map(field).join(",")
  );
  return `${[head, ...lines].join("\r\n")}\r\n`;
}

/** A table for people: ms a step, ms a frame, frames a second. */
export function textOf(report: Report): string {
  const { rows, hardware } = report;
  const paths = CATALOG.filter(({ name }) => rows.some(({ path }) => path === name));
  const sides = [...new Set(rows.map(({ side }) => side))];
  const cell = (row: Row | undefined) =>
    row?.ms_per_frame && row.ms_per_step && row.fps !== null ?
      `${short(row.ms_per_step.median)} / ${short(row.ms_per_frame.median)} / ${short(row.fps)}` :
      "–";
  const line = (cells: readonly string[]) => `| ${cells.join(" | ")} |`;
  return [
    "ms a step / ms a frame / frames a second",
    "",
    line(["nodes", ...paths.map(({ title }) => title)]),
    line(["---:", ...paths.map(() => "---:")]),
    ...sides.map((side) =>
      line([(side ** 2).toLocaleString("en"), ...paths.map(({ name }) =>
        cell(rows.find((row) => row.path === name && row.side === side))
      )])
    ),
    "",
    `WebGPU: ${adapterName(hardware) ?? "none"}. WebGL 2: ${
      hardware.webgl2 ?? "none"
    }. ${hardware.browser}. ${hardware.date}.`,
  ].join("\n");
}
