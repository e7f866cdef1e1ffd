import { expect, test } from "vitest";
import { Hand } from "../../../apps/web/src/hand.js";

const FRAME = 1 / 60; // s
const start = { x: 0, y: 0 };

test("in real time the hand is where the pointer is", () => {
  const hand = new Hand(start);
  for (let i = 1; i <= 60; i++) {
    hand.follow({ x: 7 * i, y: 0 }, (1000 * i) / 60);
    const { x } = hand.after(FRAME);
    if (i > 3) expect(x).toBeCloseTo(7 * i, 9); // by then the window of 50 ms has been made up for
  }
});

test("in slow motion it comes to the pointer too, at most half as fast again as the pointer went", () => {
  const hand = new Hand(start);
  for (let i = 1; i <= 20; i++) hand.follow({ x: 0, y: 6.5 * i }, 10 * i); // 650 pixels/s
  let y = 0;
  for (let frame = 1; !hand.arrived; frame++) {
    const next = hand.after(FRAME).y;
    expect(next - y).toBeLessThan(1.5 * 650 * FRAME + 1e-9);
    expect(frame).toBeLessThanOrEqual(Math.ceil(130 / (650 * FRAME)));
    y = next;
  }
  expect(y).toBe(130);
});

test("a hand that has arrived forgets how fast the pointer was", () => {
  const hand = new Hand(start);
  hand.follow({ x: 100, y: 0 }, 0);
  hand.after(Infinity);
  hand.follow({ x: 101, y: 0 }, 1000);
  expect(hand.after(FRAME).x).toBeCloseTo(100 + (1.5 * FRAME) / 0.05, 9); // a pixel in the window of 50 ms
});

test("without simulated time it stays, and where the world stands still it is with the pointer", () => {
  const hand = new Hand(start);
  hand.follow({ x: 30, y: 40 }, 5);
  expect(hand.after(0)).toEqual(start);
  expect(hand.after(Infinity)).toEqual({ x: 30, y: 40 });
});
