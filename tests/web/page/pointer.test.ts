import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, test } from "vitest";
import type { Point } from "weft-cloth";
import { expectClean, opened, play, ready, until, visit, type Visit } from "./browser.js";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const here = opened();
let seen: Visit;
let page: Page;
beforeEach(async () => {
  seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=${NODES}`, { reducedMotion: "reduce" });
  page = seen.page;
  await ready(page);
});
afterEach(async () => {
  expectClean(seen, here.site);
  await page.context().close();
});

const NODES = 24;
interface Pull {
  seconds: number;
  target: Point;
}
const gesture = () => page.locator("#canvas").getAttribute("data-gesture");
const camera = () =>
  page.evaluate(async () => {
    while (window.weft.world!.busy) await new Promise((wake) => setTimeout(wake, 5));
    return window.weft.world!.camera;
  });
const distance = (from: readonly number[], to: readonly number[]) =>
  Math.hypot(...from.map((value, i) => value - to[i]!));

/** Where nodes are seen on the page [CSS pixels]. */
function places(nodes: readonly number[]): Promise<{ x: number; y: number }[]> {
  return page.evaluate(async (asked) => {
    const world = window.weft.world!;
    const { positions } = await world.snapshot();
    while (world.busy) await new Promise((wake) => setTimeout(wake, 5));
    const box = document.querySelector("canvas")!.getBoundingClientRect();
    return asked.map((node) => {
      const [x, y] = world.project([positions[3 * node]!, positions[3 * node + 1]!, positions[3 * node + 2]!]);
      return { x: box.left + (box.width * (x + 1)) / 2, y: box.top + (box.height * (1 - y)) / 2 };
    });
  }, nodes);
}

/** The node that the page will hold if the pointer goes down here. */
function nodeAt(place: { x: number; y: number }): Promise<number | null> {
  return page.evaluate(async ({ x, y }) => {
    const box = document.querySelector("canvas")!.getBoundingClientRect();
    const picked = await window.weft.world!.pick((2 * (x - box.left)) / box.width - 1,
      1 - (2 * (y - box.top)) / box.height);
    return picked?.node ?? null;
  }, place);
}

test("dragging the cloth takes the node to the pointer and its neighbours along", async () => {
  await page.locator("#canvas").focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press("ArrowUp"); // the sheet is seen edge on from its own camera
  const middle = (NODES / 2) * NODES + NODES / 2;
  const [centre] = await places([middle]);
  const start = { x: centre!.x + 3, y: centre!.y + 2 }; // inside a triangle: a ray through a node may pass between them
  const node = (await nodeAt(start))!;
  expect(node).not.toBeNull();
  const around = [node - 1, node + 1, node - NODES, node + NODES];
  const before = await places(around);

  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await until("the cloth is grabbed", async () => (await gesture()) === "grab");
  await page.keyboard.press("Space");
  const goal = { x: start.x + 10, y: start.y - 40 };
  await page.mouse.move(goal.x, goal.y, { steps: 8 });
  await until("the node is at the pointer", async () => {
    const [now] = await places([node]);
    return Math.hypot(now!.x - goal.x, now!.y - goal.y) < 3;
  });
  const after = await places(around);
  for (const [i, now] of after.entries()) expect(before[i]!.y - now.y).toBeGreaterThan(15); // of 40 pixels
  await page.mouse.up();
  await until("the cloth is let go", async () => (await gesture()) === "none");
  await play(page, 4);
  await until("it falls, as nothing holds it", async () => (await places([node]))[0]!.y > goal.y + 1);
});

test("on a machine that is slower than real time a pull is in slow motion too", async () => {
  const TICK = 100; // ms, so a frame of 1/60 s takes six times as long
  await page.addInitScript((tick) => {
    globalThis.requestAnimationFrame = (call) => setTimeout(() => call(performance.now()), tick) as unknown as number;
    globalThis.cancelAnimationFrame = (timer) => clearTimeout(timer);
  }, TICK);
  await page.reload();
  await ready(page);
  await page.locator("#canvas").focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press("ArrowUp");
  const [centre] = await places([(NODES / 2) * NODES + NODES / 2]);
  const start = { x: centre!.x + 3, y: centre!.y + 2 };
  await page.evaluate(() => {
    const world = window.weft.world!;
    const drag = world.drag.bind(world);
    const pulls: Pull[] = [];
    Object.assign(window, { pulls });
    world.drag = (node, target) => {
      pulls.push({ seconds: world.statistics.seconds, target });
      return drag(node, target);
    };
  });
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await until("the cloth is grabbed", async () => (await gesture()) === "grab");
  await page.keyboard.press("Space");
  await play(page, 1);
  const [MOVES, WAY, PAUSE] = [13, 10, 60]; // pixels and ms of a move: 130 pixels in 0.8 s or more
  for (let i = 1; i <= MOVES; i++) {
    await page.mouse.move(start.x, start.y - WAY * i);
    await page.waitForTimeout(PAUSE);
  }
  const pulls = () =>
    page.evaluate(async () => {
      const world = window.weft.world!;
      while (world.busy) await new Promise((wake) => setTimeout(wake, 5));
      const { height } = document.querySelector("canvas")!.getBoundingClientRect();
      return (window as unknown as { pulls: Pull[] }).pulls.map(({ seconds, target }) => ({ seconds,
        y: (height * (1 - world.project(target)[1])) / 2 })
      );
    });
  await until("the hand is at the pointer", async () => {
    const all = await pulls();
    return start.y - all.at(-1)!.y > MOVES * WAY - 1; // the first pull may come after the first move
  });
  await page.mouse.up();
  // No 50 ms, over which the page takes the pointer's speed, hold more than one move.
  const fastest = (1.5 * WAY) / 0.05; // pixels/s
  const all = await pulls();
  const early = 3 / 60; // s: where the hand begins, three frames may have been reported at once
  for (const { seconds, y } of all) expect(start.y - y).toBeLessThan(fastest * (seconds + early) + 0.01);
});

test("a pointer that is up before the cloth answers holds nothing", async () => {
  await page.locator("#canvas").focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press("ArrowUp");
  const [start] = await places([(NODES / 2) * NODES + NODES / 2]);
  await page.locator("#canvas").evaluate((canvas, place) => {
    const at = { clientX: place.x, clientY: place.y, pointerId: 1, button: 0, bubbles: true };
    canvas.setPointerCapture = () => undefined; // there is no real pointer behind these events
    canvas.dispatchEvent(new PointerEvent("pointerdown", at));
    canvas.dispatchEvent(new PointerEvent("pointercancel", at));
  }, start!);
  await page.keyboard.press("Space");
  await play(page, 2);
  expect(await gesture()).toBe("none");
});

test("beside the cloth a drag turns the camera, the right button moves it, the wheel zooms, F resets it", async () => {
  const first = await camera();
  await page.mouse.move(60, 370);
  await page.mouse.down();
  await until("the camera is held", async () => (await gesture()) === "orbit");
  await page.mouse.move(140, 350, { steps: 4 });
  await page.mouse.up();
  const turned = await camera();
  expect(distance(turned.eye, first.eye)).toBeGreaterThan(0.5);
  expect(distance(turned.target, first.target)).toBeLessThan(1e-6);

  await page.mouse.down({ button: "right" });
  await page.mouse.move(200, 350, { steps: 4 });
  await page.mouse.up({ button: "right" });
  const moved = await camera();
  expect(distance(moved.target, turned.target)).toBeGreaterThan(0.1);

  await page.mouse.wheel(0, -300);
  await until("it is nearer", async () => {
    const near = await camera();
    return distance(near.eye, near.target) < 0.8 * distance(moved.eye, moved.target);
  });
  await page.keyboard.press("f");
  const back = await camera();
  expect(distance(back.eye, first.eye)).toBeLessThan(1e-6);
});

test("two fingers zoom and move the camera, and let go of the cloth", async () => {
  const touch = await page.context().newCDPSession(page);
  const fingers = (type: "touchStart" | "touchMove" | "touchEnd", ...points: { x: number; y: number }[]) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
  const first = await camera();
  await fingers("touchStart", { x: 200, y: 200 });
  await fingers("touchStart", { x: 200, y: 200 }, { x: 260, y: 200 });
  expect(await gesture()).toBe("pinch");
  for (let i = 1; i <= 6; i++) {
    await fingers("touchMove", { x: 200 - 5 * i, y: 200 + 5 * i }, { x: 260 + 5 * i, y: 200 + 5 * i });
    await page.waitForTimeout(40);
  }
  await fingers("touchEnd");
  await until("the fingers are gone", async () => (await gesture()) === "none");
  const last = await camera();
  const zoom = distance(first.eye, first.target) / distance(last.eye, last.target);
  expect(zoom).toBeCloseTo(2, 1); // the fingers are twice as far apart
  expect(distance(last.target, first.target)).toBeGreaterThan(0.05);
});
