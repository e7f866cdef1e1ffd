import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import stored from "../../../apps/web/methods/sheet_run.json";
import { byNearness, front, kindsOf, milliseconds, overTime, position, sidesOf, storedFrame, summaries, type StoredRow,
  type StoredRun } from "../../../apps/web/methods/stored_run.ts";
import { plainChoice } from "../../../apps/web/methods/offers.ts";
import { significant } from "../../../apps/web/src/digits.ts";
import { ROOT } from "../chromium.ts";

const run: StoredRun = stored;
const page = readFileSync(join(ROOT, "docs/methods.md"), "utf8");
const cells = (line: string) => line.split("|").slice(1, -1).map((cell) => cell.trim().replaceAll("`", ""));
/** The rows of methods in the first table of so many columns, and in those right below it, that counts nodes. */
const lines = (columns: number) => {
  const rows = page.split("\n");
  const is = (row: string | undefined) =>
    row?.startsWith("| ") && cells(row).length === columns && /^[\d,]+$/.test(cells(row)[0]!);
  const first = rows.findIndex(is);
  return rows.slice(first, first + rows.slice(first).findIndex((row) => !is(row))).map(cells)
    .filter((row) => !row[1]!.startsWith("null"));
};

test("the summary says what docs/methods.md says", () => {
  const named = (row: StoredRow | null, text: (row: StoredRow) => string) =>
    row ? `${text(row)} (${row.variant})` : "none";
  const made = summaries(run).map(({ side, kind, nearest, five, one }) => [
    (side * side).toLocaleString("en"),
    kind,
    named(nearest, (row) => `${significant(position(row), 2)} %`),
    named(five, (row) => significant(milliseconds(row))),
    named(one, (row) => significant(milliseconds(row))),
  ]);
  expect(made).toHaveLength(sidesOf(run).length * kindsOf(run).length);
  expect(made).toEqual(lines(5));
});

test("the rows say what docs/methods.md says", () => {
  const made = sidesOf(run).flatMap((side) =>
    run.rows.filter((row) => row.side === side && row.skipped === undefined).map((
      row,
    ) => [(side * side).toLocaleString("en"), row.variant, significant(milliseconds(row)),
      `${significant(row.real_time_factor!)} ×`, significant(row.dispatches_per_step!, 4), overTime(row, (at) =>
        100 * at.position!), overTime(row, (at) => at.normal_degrees)]
    )
  );
  // The energy and the hash are not on the page.
  expect(made).toEqual(lines(9).filter(([, , ms]) => /^[\d.]+$/.test(ms!)).map((line) => line.slice(0, -2)));
});

test("a front has no row that another is both faster and nearer than", () => {
  for (const side of sidesOf(run))
    for (const kind of kindsOf(run)) {
      const rows = front(run, side, kind);
      expect(rows.length).toBeGreaterThan(0);
      rows.slice(1).forEach((row, i) => {
        expect(milliseconds(row)).toBeGreaterThan(milliseconds(rows[i]!));
        expect(position(row)).toBeLessThan(position(rows[i]!));
      });
    }
});

test("rows that were not run, or did not end in numbers, are in no summary", () => {
  const row = (variant: string, ms: number, error: number | null): StoredRow => ({ variant, side: 16,
    ms_per_frame: { median: ms }, error: [{ t: 0.5, position: error, normal_degrees: error }] });
  const made: StoredRun = { adapter: "", driver: "",
    rows: [row("a 1", 20, 0.001), row("a 2", 10, 0.04), row("a 4", 1, null), row("b 1", 5, 0.02), { variant: "c",
      side: 16, skipped: "Refused." }] };
  expect(summaries(made).map(({ kind, nearest, five, one }) => [kind, nearest?.variant, five?.variant, one?.variant]))
    .toEqual([["a", "a 2", "a 2", "a 1"], ["b", "b 1", "b 1", undefined], ["c", undefined, undefined, undefined]]);
  expect(byNearness(made, ["new", "b", "a"])).toEqual(["a", "b", "new"]);
  expect(overTime(made.rows[2]!, (at) => at.position)).toBe("none");
});

test("beside a pane stands the frame of the run that did the same work, or none", () => {
  const frame = (variant: string) => milliseconds(run.rows.find((row) => row.side === 64 && row.variant === variant)!);
  expect(storedFrame(run, 64, plainChoice("multigrid"), 8, 1)).toBe(frame("multigrid 8"));
  expect(storedFrame(run, 64, plainChoice("mass_spring"), 96, 1)).toBe(frame("mass_spring"));
  const four = { kind: "xpbd", substeps: 32, settings: { iterations: 4 } } as const;
  expect(storedFrame(run, 64, four, 32, 4)).toBe(frame("xpbd 32 x 4"));
  expect(storedFrame(run, 64, { ...four, settings: { iterations: 5 } }, 32, 5)).toBe(null);
  expect(storedFrame(run, 63, plainChoice("multigrid"), 8, 1)).toBe(null);
  expect(storedFrame(run, 64, { ...plainChoice("multigrid"), settings: { residual: 0.1 } }, 8, 1)).toBe(null);
  expect(storedFrame(run, 64, { ...plainChoice("mass_spring"), substeps: 200 }, 200, 1)).toBe(null);
});
