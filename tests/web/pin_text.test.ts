// How the page's address has pins.
import { expect, test } from "vitest";
import type { PinPlace } from "../../apps/web/src/state/page_state.js";
import { leftOut, numbersOf, textOf } from "../../apps/web/src/state/pin_text.js";

/** A sheet of so many nodes a side, 2 m wide, and how far it has moved. */
function grid(side: number, moved: (x: number, z: number) => readonly [number, number, number]): PinPlace[] {
  return Array.from({ length: side * side }, (_, node) => {
    const [x, z] = [(2 * (node % side)) / (side - 1) - 1, (2 * Math.floor(node / side)) / (side - 1) - 1];
    const [dx, dy, dz] = moved(x, z);
    return { rest: [x, 0.5, z], target: [x + dx, 0.5 + dy, z + dz] };
  });
}
const rest = () => [0, 0, 0] as const;
const waves = (x: number, z: number) =>
  [0.1 * Math.sin(5 * x), 0.3 * Math.cos(7 * z), 0.2 * Math.sin(4 * x + z)] as const;

/** The farthest that a coordinate is from what was written [m]. */
function farthest(pins: readonly PinPlace[], text: string): number {
  const read = numbersOf(text);
  expect(read.length).toBe(pins.length);
  return Math.max(
    ...pins.flatMap(({ rest, target }, k) => [...rest, ...target].map((x, i) => Math.abs(x - Number(read[k]![i])))),
  );
}

test("a few pins are numbers that anyone can read, and go there and back within rounding", () => {
  const pins = grid(2, waves);
  expect(textOf(pins.slice(0, 1))).toBe(
    `-1,0.5,-1,${pins[0]!.target.map((x) => Number(x.toFixed(4))).join()}`,
  );
  expect(farthest(pins, textOf(pins)!)).toBeLessThanOrEqual(0.5001e-4);
});

test("many are packed: 961 on a sheet at rest into 2,100 characters, in waves into 6,000", () => {
  for (const [pins, most] of [[grid(31, rest), 2100], [grid(31, waves), 6000]] as const) {
    const text = textOf(pins)!;
    expect(text).toMatch(/^~[\w-]+$/); // no character that an address has to escape
    expect(text.length).toBeLessThan(most);
    expect(farthest(pins, text)).toBeLessThanOrEqual(0.5001e-4 * 2); // two roundings: of the place and of the way
    expect(leftOut(pins)).toBeNull();
  }
});

test("places of any size are kept, also those beyond 32 bits", () => {
  const pins = Array.from({ length: 30 },
    (_, k): PinPlace => ({ rest: [1e6 - k, -1e6 + k / 3, k * 12345.6789], target: [-1e6, 1e6, 0] }));
  expect(farthest(pins, textOf(pins)!)).toBeLessThanOrEqual(1.001e-4);
});

test("more than an address takes are left out, and it is said with both numbers", () => {
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const pins = Array.from({ length: 1023 },
    (): PinPlace => ({ rest: [random(), random(), random()], target: [random(), random(), random()] }));
  expect(textOf(pins)).toBeNull();
  expect(leftOut(pins)).toMatch(
    /^The page's address is without the pins: 1023 of them take \d{5} characters, and there is room for 6000\.$/,
  );
});

test("a text that was cut off or spoiled keeps the pins before, and what is left is no pin", () => {
  const pins = grid(9, waves);
  const text = textOf(pins)!;
  for (const spoiled of [text.slice(0, -1), `${text.slice(0, 200)}!`, `${text}B`, "~", "~~", `~B${"g".repeat(40)}`]) {
    const read = numbersOf(spoiled);
    const good = read.filter((pin) => pin.length === 6);
    expect(good.length).toBeGreaterThanOrEqual(Math.max(0, read.length - 1));
    expect(good).toEqual(numbersOf(text).slice(0, good.length));
  }
});
