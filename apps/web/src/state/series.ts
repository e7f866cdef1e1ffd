// What has been measured of a run, in the order of its frames.
import type { Measures } from "weft-cloth";

const MOST = 600; // rows; then every second goes

/** The columns, as frames.csv of weft run calls them. */
const COLUMNS: readonly (readonly [name: string, key: keyof Measures])[] = [["frame", "frame"], ["time_s", "seconds"], [
  "kinetic_J",
  "kinetic",
], ["potential_J", "potential"], ["springs_J", "springs"], ["membranes_J", "membranes"], ["bending_J", "bending"], [
  "tetrahedra_J",
  "tetrahedra",
], ["gas_J", "gas"], ["max_stretch", "maxStretch"], ["contacts", "contacts"], ["residual", "residual"]];

export class Series {
  private kept: Measures[] = [];

  get rows(): readonly Measures[] {
    return this.kept;
  }

  clear(): void {
    this.kept = [];
  }

  /** Whether it is a row more: a frame counts once, and one before the last begins the run anew. */
  add(row: Measures): boolean {
    const last = this.kept.at(-1);
    if (last && row.frame === last.frame) return false;
    if (last && row.frame < last.frame) this.clear();
    if (this.kept.length >= MOST) this.kept = this.kept.filter((_, i) => i % 2 === 0);
    this.kept.push(row);
    return true;
  }

  csv(): string {
    const lines = [COLUMNS.map(([name]) => name), ...this.kept.map((row) => COLUMNS.map(([, key]) => row[key]))];
    return lines.map((line) => `${line.join()}\n`).join("");
  }
}
