// Pins as an address has them. A few are six numbers each, for whoever writes an address by hand. More are packed:
// whole tenths of a millimetre, each less what the two pins before let expect, as neighbours on a cloth differ little.
import { DIGITS, plainPoint } from "./limits.js";
import type { PinPlace } from "./page_state.js";

const BETWEEN = ":";
const UNIT = 10 ** DIGITS;
const MOST_PLAIN = 1000; // characters; longer ones are packed
const MOST = 6000; // characters; many servers take no address of more than 8,000
const PACKED = "~"; // what begins a packed text
const SIGNS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"; // six bits each
const MORE = 32; // the bit of a number's sign after which more come

/** null: they are too many for an address. */
export function textOf(pins: readonly PinPlace[]): string | null {
  const plain = pins.map(({ rest, target }) => `${plainPoint(rest)},${plainPoint(target)}`).join(BETWEEN);
  if (plain.length <= MOST_PLAIN) return plain;
  const text = packed(pins);
  return text.length <= MOST ? text : null;
}

/** Why an address has none of these pins, one sentence; null: it has them. */
export function leftOut(pins: readonly PinPlace[]): string | null {
  if (textOf(pins) !== null) return null;
  return `The page's address is without the pins: ${pins.length} of them take ${packed(pins).length} characters, and ` +
    `there is room for ${MOST}.`;
}

/** Six numbers a pin, as texts; one that is no pin stays what it is. */
export function numbersOf(text: string): readonly (readonly string[])[] {
  return text.startsWith(PACKED) ? unpacked(text) : text.split(BETWEEN).map((pin) => pin.split(","));
}

/** Whole units: the place at rest, and how far from there it is held. */
function rowOf({ rest, target }: PinPlace): number[] {
  const units = [...rest, ...target].map((x) => Math.round(UNIT * x));
  return units.map((x, i) => (i < 3 ? x : x - units[i - 3]!));
}

/** The rows before, of which the next is expected to go on straight: so do neighbours on a cloth. */
class Expected {
  private last = [0, 0, 0, 0, 0, 0];
  private step = [0, 0, 0, 0, 0, 0];

  get row(): number[] {
    return this.last.map((x, i) => x + this.step[i]!);
  }
  came(row: readonly number[]): void {
    this.step = row.map((x, i) => x - this.last[i]!);
    this.last = [...row];
  }
}

/** For each pin a sign whose six bits say which numbers are not as expected, then by how much these are off. */
function packed(pins: readonly PinPlace[]): string {
  const expected = new Expected();
  let text = PACKED;
  for (const pin of pins) {
    const row = rowOf(pin);
    const off = expected.row.map((x, i) => row[i]! - x);
    text += SIGNS[off.reduce((bits, x, i) => bits + (x === 0 ? 0 : 2 ** i), 0)]!;
    for (const x of off) if (x !== 0) text += signsOf(x);
    expected.came(row);
  }
  return text;
}

/** A whole number, its sign last, five bits a sign from the lowest on. */
function signsOf(number: number): string {
  let left = number < 0 ? -2 * number - 1 : 2 * number;
  let signs = "";
  while (left >= MORE) {
    signs += SIGNS[MORE + (left % MORE)]!;
    left = Math.floor(left / MORE);
  }
  return signs + SIGNS[left]!;
}

/** Where it was cut off or spoiled the last is the whole text. */
function unpacked(text: string): string[][] {
  const expected = new Expected();
  const pins: string[][] = [];
  let at = PACKED.length;
  const next = (): number => {
    const value = SIGNS.indexOf(text[at++] ?? " ");
    return value < 0 ? NaN : value;
  };
  const number = (): number => {
    let [sum, scale] = [0, 1];
    for (;; scale *= MORE) {
      const value = next();
      if (!(value >= MORE)) {
        sum += scale * value;
        return sum % 2 === 0 ? sum / 2 : -(sum + 1) / 2;
      }
      sum += scale * (value % MORE);
    }
  };
  while (at < text.length) {
    const bits = next();
    const row = expected.row.map((x, i) => (Math.floor(bits / 2 ** i) % 2 === 1 ? x + number() : x));
    if (Number.isNaN(bits) || !row.every(Number.isFinite)) return [...pins, [text]];
    pins.push(row.map((x, i) => String((i < 3 ? x : x + row[i - 3]!) / UNIT)));
    expected.came(row);
  }
  return pins;
}
