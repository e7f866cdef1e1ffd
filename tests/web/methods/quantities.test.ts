import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { Pace } from "../../../apps/web/src/pace.ts";
import { heightEnergy, kineticEnergy, positionError } from "../../../apps/web/methods/quantities.ts";
import { Times } from "../../../apps/web/src/times.ts";
import { ROOT } from "../chromium.ts";

const numbers = (...values: number[]) => Float32Array.from(values);

test("the error is the distance to the reference over the reference's way, of all nodes", () => {
  const start = numbers(0, 0, 0, 1, 0, 0);
  const reference = numbers(0, -3, 0, 1, 0, -4); // ways of 3 and 4 m
  const other = numbers(0, -3, 1, 1, 2, -4); // 1 and 2 m from it
  expect(positionError(other, reference, start)).toBeCloseTo(Math.sqrt((1 + 4) / (9 + 16)), 12);
  expect(positionError(reference, reference, start)).toBe(0);
  expect(positionError(start, reference, start)).toBe(1);
});

test("against a reference that has not moved there is no error", () => {
  const start = numbers(0, 0, 0, 1, 0, 0);
  expect(positionError(numbers(0, 1, 0, 1, 0, 0), start, start)).toBe(null);
});

test("energies are those of the free nodes, in closed form", () => {
  const state = { positions: numbers(0, -2, 0, 5, 7, 0), velocities: numbers(3, 0, 4, 9, 9, 9),
    inverseMasses: numbers(2, 0), hash: "" }; // 0.5 kg, and a node that is held
  const start = numbers(0, 1, 0, 0, 0, 0);
  expect(kineticEnergy(state)).toBeCloseTo(0.5 * 0.5 * 25, 12);
  expect(heightEnergy(state, start, [0, -10, 0])).toBeCloseTo(0.5 * 10 * -3, 12);
  expect(heightEnergy(state, start, [2, 0, 0])).toBeCloseTo(0, 12); // along x it has not moved
});

test("in free fall what is lost in height is what is gained in speed", () => {
  const t = 0.5, g = 8; // exact in binary
  const state = { positions: numbers(0, (-g * t * t) / 2, 0), velocities: numbers(0, -g * t, 0),
    inverseMasses: numbers(4), hash: "" };
  expect(kineticEnergy(state) + heightEnergy(state, numbers(0, 0, 0), [0, -g, 0])).toBe(0);
});

test("frames come due by the clock, a late one is dropped, and the share of real time is what was simulated", () => {
  const pace = new Pace(10);
  const due = (...times: number[]) => times.map((now) => pace.due(now));
  pace.begin(1000);
  expect(pace.share).toBe(null);
  expect(due(1005, 1010, 1014, 1019.6)).toEqual([false, true, false, true]); // half a millisecond early is in time
  expect(due(1030, 1040, 1050)).toEqual([true, true, true]);
  expect(pace.share).toBeCloseTo(1, 12); // four frames from 1010 to 1050
  // A second is due at once, of which two frames at most are kept.
  expect(due(2050, 2050, 2050, 2050)).toEqual([true, true, false, false]);
  pace.begin(5000);
  expect(due(5040, 5080, 5120)).toEqual([true, true, true]); // each frame took four times as long as it lasts
  expect(pace.share).toBeCloseTo(1 / 4, 12);
});

test("a machine that is far slower than real time still has a share", () => {
  const pace = new Pace(10);
  pace.begin(0);
  for (const now of [5000, 10_000, 15_000]) expect(pace.due(now)).toBe(true);
  expect(pace.share).toBeCloseTo(10 / 5000, 12);
});

test("of times the median of the last ones is kept", () => {
  const times = new Times(3);
  expect(times.median).toBe(null);
  times.add(100);
  expect(times.median).toBe(100);
  times.add(1);
  expect(times.median).toBe(50.5);
  for (const time of [2, 3]) times.add(time);
  expect(times.median).toBe(2); // of 1, 2, 3
  times.clear();
  expect(times.median).toBe(null);
});

test("the page's sheet has the springs of weft bench methods", () => {
  const numbersOf = (file: string, start: RegExp) => {
    const text = start.exec(readFileSync(join(ROOT, file), "utf8"))![1]!;
    return Object.fromEntries([...text.matchAll(/(\w+)"?: (\d+)/g)].map(([, key, value]) => [key, Number(value)]));
  };
  const bench = numbersOf("src/bench/methods.cpp", /kSprings = \{[^{]*\{([^}]*)\}/);
  expect(Object.keys(bench).sort()).toEqual(["bend", "shear", "structural"]);
  expect(numbersOf("apps/web/methods/scenes.ts", /SPRINGS = \{([^}]*)\}/)).toEqual(bench);
});
