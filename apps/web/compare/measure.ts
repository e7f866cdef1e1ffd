// Time a step, drained and not held back by the display.
//
// Steps are handed over in batches without waiting, then the last is waited for: on WebGPU by onSubmittedWorkDone, on
// WebGL by readPixels of one pixel. WebGL's own fence would be the milder way, but its state may change only between
// two tasks of the page, and a timer's 4 ms are longer than many a batch; readPixels returns when all that was asked
// before is done. No batch waits for the display's next picture, so frames a second may well exceed its rate.
import type { Gate } from "./gate.js";

/** Of one step, or of one step and its picture [ms]. */
export interface Timing {
  readonly median: number;
  readonly min: number;
  readonly batches: number;
  /** Steps in each. */
  readonly batch: number;
}

const LEAST_BATCHES = 3;
const MOST_STEPS = 4096; // in a batch
const LONGEST_BATCH = 120; // ms: the page answers between batches, and what a wait costs is small beside it

/** `run` takes this many steps and waits for them; the first call with another number than before may take longer. */
export async function measure(run: (steps: number) => Promise<void>, budget: number, gate: Gate,
  least = 1): Promise<Timing> {
  const timed = async (steps: number) => {
    await gate.pass();
    const start = performance.now();
    await run(steps);
    return performance.now() - start;
  };
  const wanted = Math.min(LONGEST_BATCH, budget / 8);
  let batch = least;
  await timed(batch); // compiles
  let took = await timed(batch);
  for (let round = 0; round < 3 && took < wanted / 2 && batch < MOST_STEPS; round++) { // of one step, most is the wait
    batch = Math.min(MOST_STEPS, 2 ** Math.floor(Math.log2((batch * wanted) / Math.max(took, 0.1))));
    await timed(batch);
    took = await timed(batch);
  }
  const times: number[] = [];
  let spent = 0;
  while (spent < budget || (times.length < LEAST_BATCHES && spent < 2 * budget)) {
    const time = await timed(batch);
    spent += time;
    times.push(time / batch);
  }
  times.sort((a, b) => a - b);
  const middle = times.length >> 1;
  const median = times.length % 2 === 1 ? times[middle]! : (times[middle - 1]! + times[middle]!) / 2;
  return { median, min: times[0]!, batches: times.length, batch };
}
