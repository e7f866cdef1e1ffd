// Options from the page's address: ?paths=weft-node,cpu&most=65536&budget=1000. An address that asks for something odd
// is refused with a sentence, not bent into something else: a measurement that was not asked for would be worse than
// none.
import { CATALOG, type PathName } from "./catalog.js";

export interface Options {
  readonly paths: readonly PathName[];
  /** Nodes along a side of the square sheets, ascending. */
  readonly sides: readonly number[];
  /** For the batches of one timing, warm-up not counted [ms]. */
  readonly budget: number;
}

const NAMES: readonly PathName[] = CATALOG.map(({ name }) => name);
/** The paper's 4K to 640K nodes. */
const SIDES = [64, 100, 128, 200, 256, 400, 512, 800];
const BUDGET = 1500;
const LONGEST_SHOWN = 40; // letters of an address that a sentence repeats

export class OptionError extends Error {}

const shown = (text: string) => JSON.stringify(text.length > LONGEST_SHOWN ? `${text.slice(0, LONGEST_SHOWN)}…` : text);

function whole(key: string, text: string, least: number, most: number): number {
  const value = /^\d{1,9}$/.test(text) ? Number(text) : NaN;
  if (!(value >= least && value <= most))
    throw new OptionError(`In the address, ${key} is ${shown(text)}, not a whole number from ${least} to ${most}.`);
  return value;
}

/** Errors  OptionError. */
export function optionsOf(address: string): Options {
  const asked = new URL(address).searchParams;
  for (const key of new Set(asked.keys())) {
    if (!["paths", "sizes", "most", "budget"].includes(key))
      throw new OptionError(`The address has an option ${shown(key)}; there are paths, sizes, most and budget.`);
    if (asked.getAll(key).length > 1) throw new OptionError(`The address says ${key} more than once.`);
  }
  const paths = asked.get("paths")?.split(",") ?? NAMES;
  for (const path of paths)
    if (!NAMES.some((name) => name === path))
      throw new OptionError(`There is no path ${shown(path)}; there are ${NAMES.join(", ")}.`);
  const sizes = asked.get("sizes")?.split(",").map((side) => whole("a side of sizes", side, 4, 1024)) ?? SIDES;
  const most = asked.has("most") ? whole("most", asked.get("most")!, 16, 1_048_576) : Infinity;
  const sides = [...new Set(sizes)].sort((a, b) => a - b).filter((side) => side * side <= most);
  if (sides.length === 0)
    throw new OptionError(`No size has at most ${most} nodes; the smallest has ${Math.min(...sizes) ** 2}.`);
  return { paths: NAMES.filter((name) => paths.includes(name)), sides,
    budget: asked.has("budget") ? whole("budget", asked.get("budget")!, 10, 60_000) : BUDGET };
}
