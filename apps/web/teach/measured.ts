// What is measured of a course of numbers, each with its time.

/** The mean time from one rise through `middle` to the next, between samples by straight lines; NaN: fewer than two. */
export function periodOf(times: readonly number[], values: readonly number[], middle: number): number {
  const rises: number[] = [];
  for (let i = 1; i < values.length; i++) {
    const before = values[i - 1]! - middle, now = values[i]! - middle;
    if (before < 0 && now >= 0) rises.push(times[i - 1]! + ((times[i]! - times[i - 1]!) * before) / (before - now));
  }
  return rises.length < 2 ? NaN : (rises.at(-1)! - rises[0]!) / (rises.length - 1);
}

/** How fast the speed of evenly timed places grows from their first third to their last [per square of `interval`]. */
export function accelerationOf(places: readonly number[], interval: number): number {
  const speed = (at: number) => (places[at]! - places[at - 1]!) / interval;
  const first = Math.ceil(places.length / 3), last = places.length - 1;
  return (speed(last) - speed(first)) / ((last - first) * interval);
}

/** Where `holds` turns from false to true between the two, to 1 part in 2^rounds of their distance. */
export async function turningPoint(low: number, high: number, rounds: number,
  holds: (at: number) => Promise<boolean>): Promise<number> {
  let [below, above] = [low, high];
  for (let round = 0; round < rounds; round++) {
    const middle = (below + above) / 2;
    if (await holds(middle)) above = middle;
    else below = middle;
  }
  return (below + above) / 2;
}
