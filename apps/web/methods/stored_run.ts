// What a stored run of `weft bench methods` (docs/cli.md) has of the sheet, and what docs/methods.md says of it: the
// same rows by the same rules as scripts/make_methods.py.
import { significant } from "../src/digits.js";
import type { Choice } from "./state.js";

interface ErrorAt {
  /** [s] */
  readonly t: number;
  /** A part of the reference's way; null: not finite. */
  readonly position: number | null;
  readonly normal_degrees: number | null;
}

export interface StoredRow {
  readonly variant: string;
  readonly side: number;
  /** Missing where the row was not run. */
  readonly skipped?: string;
  readonly ms_per_frame?: { readonly median: number };
  readonly real_time_factor?: number;
  readonly dispatches_per_step?: number;
  readonly error?: readonly ErrorAt[];
}

export interface StoredRun {
  readonly adapter: string;
  readonly driver: string;
  readonly rows: readonly StoredRow[];
}

export const FRAME = 1000 / 60; // ms
const TIME = 0.5; // of the errors that are plotted and graded [s]

/** The word of its method. */
export const methodOf = ({ variant }: StoredRow): string => variant.split(" ")[0]!;

/** Of a frame, the median [ms]. */
export const milliseconds = (row: StoredRow): number => row.ms_per_frame?.median ?? NaN;

/** How far places are off after half a second [%]. */
export const position = (row: StoredRow): number => 100 * (row.error?.find(({ t }) => t === TIME)?.position ?? NaN);

/** Whether it was run, and ended in numbers. */
const isNumber = (row: StoredRow): boolean =>
  row.error !== undefined && row.error.every(({ position: off }) => off !== null);

export const sidesOf = ({ rows }: StoredRun): number[] =>
  [...new Set(rows.map(({ side }) => side))].sort((a, b) => a - b);

/** The methods in the order of the run. */
export const kindsOf = ({ rows }: StoredRun): string[] => [...new Set(rows.map(methodOf))];

/** The rows of a method on a sheet, those that were run to their end. */
const measured = ({ rows }: StoredRun, side: number, kind: string): StoredRow[] =>
  rows.filter((row) => row.side === side && methodOf(row) === kind && isNumber(row));

const least = (rows: readonly StoredRow[], by: (row: StoredRow) => number): StoredRow | null =>
  rows.reduce<StoredRow | null>((best, row) => (best === null || by(row) < by(best) ? row : best), null);

/** Those that no other of the method's is both faster and nearer than, the fastest first. */
export function front(run: StoredRun, side: number, kind: string): StoredRow[] {
  let best = Infinity;
  return measured(run, side, kind).sort((a, b) => milliseconds(a) - milliseconds(b)).filter((row) => {
    const nearer = position(row) < best;
    if (nearer) best = position(row);
    return nearer;
  });
}

export interface Summary {
  readonly side: number;
  readonly kind: string;
  /** The nearest within a frame at 60 Hz. */
  readonly nearest: StoredRow | null;
  /** The fastest that is as near as 5 % and 1 %. */
  readonly five: StoredRow | null;
  readonly one: StoredRow | null;
}

/** A line for each method and sheet. */
export function summaries(run: StoredRun): Summary[] {
  return sidesOf(run).flatMap((side) =>
    kindsOf(run).map((kind) => {
      const rows = measured(run, side, kind);
      const within = (error: number) => least(rows.filter((row) => position(row) <= error), milliseconds);
      return { side, kind, five: within(5), one: within(1),
        nearest: least(rows.filter((row) => milliseconds(row) <= FRAME), position) };
    })
  );
}

/** Kinds, those first that came nearest to the run's reference on its smallest sheet; then those it does not know. */
export function byNearness(run: StoredRun, kinds: readonly string[]): string[] {
  const side = sidesOf(run)[0]!;
  const nearness = (kind: string) => Math.min(...measured(run, side, kind).map(position));
  return kinds.toSorted((a, b) => (nearness(a) === nearness(b) ? 0 : nearness(a) - nearness(b)));
}

/** What a frame of the same work took in the run, the median [ms]; null: it has no such row. */
export function storedFrame(run: StoredRun, side: number, choice: Choice, substeps: number, sweeps: number):
  | number
  | null {
  const { kind, settings } = choice;
  const { iterations, ...others } = settings;
  if (Object.keys(others).length > 0) return null; // the run leaves them as they are
  // The explicit method has its own steps there, and sweeps are named where they differ from row to row.
  const names = [`${kind} ${substeps} x ${sweeps}`, ...(iterations === undefined ? [`${kind} ${substeps}`] : []),
    ...(choice.substeps === "auto" ? [kind] : [])];
  const row = measured(run, side, kind).find(({ variant }) => names.includes(variant));
  return row ? milliseconds(row) : null;
}

/** Of all times, "0.304 / 0.255 / 1.41". */
export const overTime = (row: StoredRow, value: (error: ErrorAt) => number | null): string =>
  (row.error ?? []).map((error) => {
    const read = value(error);
    return read === null ? "none" : significant(read);
  }).join(" / ");
