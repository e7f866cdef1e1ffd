// Pointers on the canvas. One on the cloth takes hold of it, one beside it turns the camera, the right button or two
// fingers move it, wheel and pinch zoom. A node that is pinned is pulled too, and stays where it is left. Where pins
// are set by click, a drag draws a rectangle in which all nodes are pinned. Moves are gathered and handed on once a
// picture: the world does them in turn.
import type { Point, World } from "weft-cloth";
import { ARROWS } from "./controls/arrows.js";
import type { Pins } from "./controls/pins.js";
import { Hand, type Place } from "./hand.js";
import { Latest } from "./latest.js";
import { refusal } from "./pin_places.js";
import { clip } from "./places.js";
import type { Player } from "./player.js";

/** A node that a hand draws. */
interface Pull {
  readonly node: number;
  /** Where it was taken hold of: the hand stays as far from the camera [m]. */
  readonly point: Point;
  readonly hand: Hand;
  readonly drags: Latest<Point>;
  /** Up to which simulated time the hand has moved [s]. */
  seconds: number;
}

type Gesture =
  | { kind: "none" }
  | { kind: "deciding" } // whether the cloth is under the pointer
  | { kind: "grab"; pull: Pull }
  | { kind: "frame"; from: Place } // a rectangle in which nodes are pinned [CSS pixels]
  | { kind: "orbit" }
  | { kind: "pan" }
  | { kind: "pinch" };

const HALF_TURN = Math.PI; // of the camera, for a drag over the canvas's height [rad]
const STILL = 6; // a drag that is no longer is a click [CSS pixels]
const AT_ONCE = 3; // frames whose reports may come together; time in which the hand rested is no time to move in
const WHEEL = 0.0015; // zoom exponent per pixel of the wheel
const WHEEL_PINCH = 0.01; // a trackpad's pinch comes as a wheel with Ctrl, in smaller numbers
const LINE = 16; // pixels, for wheels that count lines

export class Pointer {
  private readonly down = new Map<number, Place>();
  private gesture: Gesture = { kind: "none" };
  private hand = new Hand({ x: 0, y: 0 }); // of the pointer that went down last
  private readonly trailing = new Set<Pull>(); // of pins that the pointer has left before the hand was there
  private last: Place = { x: 0, y: 0 }; // up to where the gesture has been handed on
  private spread = 0; // of two fingers [CSS pixels]
  private due = false;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly player: Player,
    private readonly pins: Pins) {
    canvas.addEventListener("pointerdown", (event) => this.onDown(event));
    canvas.addEventListener("pointermove", (event) => this.onMove(event));
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      canvas.addEventListener(name, (event) => this.onUp(event));
    canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    window.addEventListener("blur", () => this.cancel());
  }

  /** Lets go of everything. The pointers that are down do nothing more. */
  cancel(): void {
    this.down.clear();
    this.begin({ kind: "none" });
  }

  /** The world is another one: nothing is grabbed in it. */
  forget(): void {
    this.down.clear();
    this.trailing.clear();
    this.pins.hideFrame();
    this.gesture = { kind: "none" };
    this.mark();
  }

  private onDown(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.last = this.centre();
    this.hand = new Hand(this.last);
    if (this.down.size === 2) {
      this.spread = this.span();
      this.begin({ kind: "pinch" });
    } else if (this.down.size > 2) this.begin({ kind: "none" });
    else if (event.button === 0 && !event.shiftKey && this.pins.frames(this.last))
      this.begin({ kind: "frame", from: this.last });
    else if (event.button === 0 && !event.shiftKey) void this.decide();
    else if (event.button <= 2) this.begin({ kind: "pan" });
  }

  private onMove(event: PointerEvent): void {
    if (!this.down.has(event.pointerId)) return;
    this.down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const all = event.getCoalescedEvents(); // the browser hands on one a picture
    for (const { clientX: x, clientY: y, timeStamp } of all.length > 0 ? all : [event])
      this.hand.follow({ x, y }, timeStamp);
    this.schedule();
  }

  private onUp(event: PointerEvent): void {
    if (!this.down.has(event.pointerId)) return;
    if (event.type === "pointerup") {
      this.down.set(event.pointerId, { x: event.clientX, y: event.clientY });
      this.hand.follow({ x: event.clientX, y: event.clientY }, event.timeStamp);
    }
    if (this.down.size === 1) this.handOn(); // the way of the last few moves
    if (event.type === "pointerup") this.endFrame();
    this.down.delete(event.pointerId);
    if (this.gesture.kind === "pinch" && this.down.size === 1) {
      this.last = this.centre();
      this.begin({ kind: "orbit" }); // the finger that stays goes on
    } else if (this.down.size === 0) {
      this.begin({ kind: "none" });
    }
  }

  /** The rectangle has its second corner. */
  private endFrame(): void {
    if (this.gesture.kind !== "frame") return;
    const { from } = this.gesture;
    const to = this.centre();
    this.begin({ kind: "none" });
    if (Math.hypot(to.x - from.x, to.y - from.y) >= STILL) void this.pins.toggleWithin(from, to);
  }

  /** Takes hold of the cloth if it is under the pointer, else turns the camera. */
  private async decide(): Promise<void> {
    const mine: Gesture = { kind: "deciding" };
    this.begin(mine);
    const { x, y } = clip(this.canvas, this.last);
    const grabbed = await this.player.ask(async (world) => {
      const picked = await this.player.pick(world, x, y);
      if (picked && this.pins.has(picked.node)) return picked; // grabbed already
      return picked && this.gesture === mine && (await refusal(world.grab(picked.node, picked.point))) === null ?
        picked :
        null;
    });
    if (this.gesture !== mine) { // the pointer is up again, or another came
      if (grabbed && !this.pins.has(grabbed.node)) void this.player.ask((world) => world.release(grabbed.node));
      return;
    }
    if (!grabbed) {
      this.last = this.centre();
      return this.begin({ kind: "orbit" });
    }
    this.begin({ kind: "grab", pull: this.pullOf(grabbed.node, grabbed.point) });
    this.schedule(); // it may have moved meanwhile
  }

  private pullOf(node: number, point: Point): Pull {
    for (const pull of this.trailing) if (pull.node === node) this.trailing.delete(pull);
    const pull: Pull = {
      node,
      point,
      hand: this.hand,
      seconds: this.player.live?.statistics.seconds ?? 0,
      drags: new Latest((target) =>
        this.player.ask(async (world) => {
          if (this.draws(pull)) await world.drag(node, target); // else it has been let go meanwhile
        })
      ),
    };
    return pull;
  }

  /** Whether the node is still grabbed by the pointer or by its pin. */
  private draws(pull: Pull): boolean {
    return (this.gesture.kind === "grab" && this.gesture.pull === pull) || this.pins.has(pull.node);
  }

  /** Every change of gesture goes through here, so that a grabbed node is let go. */
  private begin(next: Gesture): void {
    const before = this.gesture;
    this.gesture = next;
    if (before.kind === "frame") this.pins.hideFrame();
    if (before.kind === "grab") {
      const { pull } = before;
      if (!this.pins.has(pull.node)) void this.player.ask((world) => world.release(pull.node));
      else if (!pull.hand.arrived) this.trailing.add(pull);
    }
    this.mark();
  }

  private mark(): void {
    this.canvas.dataset["gesture"] = this.gesture.kind;
  }

  // Once a picture

  private schedule(): void {
    if (this.due) return;
    this.due = true;
    // Asked for in a pointer event, this comes after the world's own tick and does not hold it up.
    requestAnimationFrame(() => {
      this.due = false;
      this.handOn();
    });
  }

  private handOn(): void {
    const world = this.player.live;
    if (!world) return;
    for (const pull of this.trailing) this.draw(world, pull);
    if (this.down.size === 0) return;
    if (this.gesture.kind === "grab") return this.draw(world, this.gesture.pull);
    if (this.gesture.kind === "frame") return this.pins.showFrame(this.gesture.from, this.centre());
    const { height } = this.canvas.getBoundingClientRect();
    const centre = this.centre();
    const [dx, dy] = [(centre.x - this.last.x) / height, (centre.y - this.last.y) / height];
    if (this.gesture.kind === "deciding") return; // these moves are the camera's if nothing is under the pointer
    this.last = centre;
    if (this.gesture.kind === "orbit") world.orbit(-HALF_TURN * dx, HALF_TURN * dy); // what is grabbed is the picture
    if (this.gesture.kind === "pan" || this.gesture.kind === "pinch") world.pan(dx, -dy);
    if (this.gesture.kind === "pinch") {
      const spread = this.span();
      if (spread > 0 && this.spread > 0) world.zoom(spread / this.spread);
      this.spread = spread;
    }
  }

  private draw(world: World, pull: Pull): void {
    if (!this.draws(pull)) return void this.trailing.delete(pull);
    if (world.busy) return this.schedule(); // a place on the canvas can be asked for only between the world's calls
    const { seconds } = world.statistics;
    const passed = Math.min(Math.max(0, seconds - pull.seconds), AT_ONCE * world.info.frameSeconds);
    pull.seconds = seconds;
    // In a world that stands still, no hand is too fast.
    const { x, y } = clip(this.canvas, pull.hand.after(this.player.playing ? passed : Infinity));
    const target = world.pointAt(x, y, pull.point);
    pull.drags.set(target);
    this.pins.moved(pull.node, target);
    if (pull.hand.arrived) this.trailing.delete(pull);
    else this.schedule();
  }

  // Wheel and keys

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : LINE);
    this.player.live?.zoom(Math.exp(-pixels * (event.ctrlKey ? WHEEL_PINCH : WHEEL)));
  }

  private onKey(event: KeyboardEvent): void {
    const world = this.player.live;
    if (!world || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape" && this.gesture.kind === "frame") return this.cancel();
    const arrow = ARROWS[event.key];
    if (arrow && event.shiftKey) world.pan(-0.05 * arrow[0], -0.05 * arrow[1]);
    else if (arrow) world.orbit(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (event.key === "+" || event.key === "=") world.zoom(1.1);
    else if (event.key === "-") world.zoom(1 / 1.1);
    else return;
    event.preventDefault();
  }

  // Places

  /** Of the pointers that are down. */
  private centre(): Place {
    const places = [...this.down.values()];
    const sum = places.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }), { x: 0, y: 0 });
    return { x: sum.x / places.length, y: sum.y / places.length };
  }

  private span(): number {
    const [a, b] = [...this.down.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }
}
