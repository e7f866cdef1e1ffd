// Nodes that the page holds at their places, as a hand would: one under the pointer, or all under a rectangle.
import type { Point, World } from "weft-cloth";
import { button, element } from "../elements.js";
import type { Place } from "../hand.js";
import { grabAll, pointOf, refusal, type HeldPin } from "../pin_places.js";
import { clip } from "../places.js";
import type { Player } from "../player.js";
import { leftOut } from "../state/pin_text.js";
import { ClickMode } from "./click_mode.js";
import { PinFrame } from "./pin_frame.js";
import { PinMarkers } from "./pin_markers.js";

const CALM = 300; // from a pull to when the page's state has it [ms]
const MIDDLE = 0.5; // of the picture's width and height, which a key pins

/** What has come of pinning: these are pinned now, those no longer, or why nothing has. */
type Outcome = { readonly held: readonly HeldPin[] } | { readonly released: readonly number[] } | {
  readonly fault: string;
};

export class Pins {
  private readonly pins = new Map<number, HeldPin>();
  private readonly markers = new PinMarkers();
  private readonly frame = new PinFrame();
  private readonly mode: ClickMode;
  private late: ReturnType<typeof setTimeout> | undefined; // when a pull will be noted

  /** `most`: nodes that the world holds at once; the hand needs one of them. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly player: Player,
    private readonly most: number, private readonly say: (sentence: string) => void) {
    this.mode = new ClickMode(canvas, "pin-mode", (place) => void this.toggle(place));
    canvas.addEventListener("dblclick", (event) => {
      if (!ClickMode.any) void this.toggle(clip(canvas, event)); // else each click has done something
    });
    button("unpin").addEventListener("click", () => void this.removeAll());
    this.tell();
  }

  get count(): number {
    return this.pins.size;
  }
  /** Pinned nodes and their places [m]. */
  get pinned(): { node: number; point: Point }[] {
    return [...this.pins.values()].map(({ node, target }) => ({ node, point: target }));
  }
  has(node: number): boolean {
    return this.pins.has(node);
  }

  enable(on: boolean): void {
    this.mode.enable(on);
  }

  toggleUnderPointer(): Promise<void> {
    return this.toggle(this.mode.pointer);
  }

  /** Pins the node under a place on the canvas where it is now, or lets it go. */
  toggle({ x, y }: Place): Promise<void> {
    return this.carryOut(async (world) => {
      const picked = await this.player.pick(world, x, y);
      if (!picked) return { fault: "There is no cloth to pin there." };
      const { node } = picked;
      if (this.pins.has(node)) return this.release(world, [node]);
      const full = this.refusalOf(1);
      if (full !== null) return { fault: full };
      const { position, rest } = await world.probe(node);
      const fault = await refusal(world.grab(node, position));
      return fault === null ? { held: [{ node, rest, target: position }] } : { fault };
    });
  }

  // By a rectangle

  /** Whether a drag that begins at a place of the page draws a rectangle: pins are set by click, and none is there. */
  frames(place: Place): boolean {
    return this.mode.on && !this.markers.near(place);
  }

  /** A drag is under way between two places of the page. */
  showFrame(a: Place, b: Place): void {
    this.frame.show(a, b);
  }
  hideFrame(): void {
    this.frame.hide();
  }

  /** All nodes in the middle of the picture. */
  toggleMiddle(): Promise<void> {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const corner = (part: number): Place => ({ x: left + part * width, y: top + part * height });
    const [a, b] = [corner((1 - MIDDLE) / 2), corner((1 + MIDDLE) / 2)];
    this.frame.flash(a, b);
    return this.toggleWithin(a, b);
  }

  /**
   * Pins all nodes under a rectangle between two places of the page, seen or hidden, where they are now; where all of
   * them are pinned that can be, lets them go.
   */
  toggleWithin(a: Place, b: Place): Promise<void> {
    return this.carryOut(async (world) => {
      const nodes = await this.player.pickWithin(world, clip(this.canvas, a), clip(this.canvas, b));
      const { positions, inverseMasses } = await world.snapshot();
      const loose = nodes.filter((node) => inverseMasses[node] !== 0 && !this.pins.has(node));
      const pinned = nodes.filter((node) => this.pins.has(node));
      if (loose.length === 0 && pinned.length === 0) return { fault: "There is no cloth to pin in the rectangle." };
      const full = this.refusalOf(loose.length);
      if (full !== null && loose.length > 0) return { fault: full };
      const rest = await world.restPositions();
      const { held, fault } = await grabAll(world,
        loose.map((node) => ({ node, rest: pointOf(rest, node), target: pointOf(positions, node) })));
      if (held.length > 0) return { held };
      return pinned.length > 0 ? this.release(world, pinned) : { fault: fault! };
    });
  }

  private async carryOut(action: (world: World) => Promise<Outcome>): Promise<void> {
    const outcome = await this.player.ask(action);
    if (!outcome) return;
    if ("fault" in outcome) return this.say(outcome.fault);
    if ("held" in outcome) this.put(outcome.held);
    else this.drop(outcome.released);
    this.note();
    const without = leftOut(this.player.state.pins);
    if (without !== null) this.say(without);
  }

  private async release(world: World, nodes: readonly number[]): Promise<Outcome> {
    for (const node of nodes) await world.release(node);
    return { released: nodes };
  }

  /** Why no so many more can be pinned. */
  private refusalOf(more: number): string | null {
    const most = this.most - 1;
    if (this.pins.size + more <= most) return null;
    const count = (number: number) => number.toLocaleString("en");
    const asked = more === 1 ? "" : `, and the rectangle has ${count(more)} more`;
    return `${count(this.pins.size)} nodes are pinned${asked}; there can be ${count(most)}: the core holds ` +
      `${count(this.most)}, and the hand needs one.`;
  }

  /** A pinned node was pulled elsewhere, and stays there. */
  moved(node: number, target: Point): void {
    const pin = this.pins.get(node);
    if (!pin) return;
    this.put([{ ...pin, target }]);
    clearTimeout(this.late);
    this.late = setTimeout(() => this.note(), CALM);
  }

  async removeAll(): Promise<void> {
    const nodes = [...this.pins.keys()];
    this.forget();
    this.note();
    await this.player.ask((world) => this.release(world, nodes));
  }

  /** The page's state gets what is pinned. */
  note(): void {
    clearTimeout(this.late);
    this.player.notePins([...this.pins.values()].map(({ rest, target }) => ({ rest, target })));
  }

  /** The world holds nothing any more. */
  forget(): void {
    clearTimeout(this.late);
    this.drop([...this.pins.keys()]);
  }

  /** The world holds these, and no other. */
  take(held: readonly HeldPin[]): void {
    this.forget();
    this.put(held);
  }

  private put(held: readonly HeldPin[]): void {
    for (const pin of held) {
      this.pins.set(pin.node, pin);
      this.markers.put(pin.node, pin.target);
    }
    this.tell();
    this.draw();
  }

  private drop(nodes: readonly number[]): void {
    for (const node of nodes) {
      this.pins.delete(node);
      this.markers.drop(node);
    }
    this.tell();
  }

  private tell(): void {
    const count = this.pins.size;
    const most = Math.max(count, this.most - 1).toLocaleString("en");
    element("pin-count", HTMLParagraphElement).textContent = count === 0 ?
      `Double-click the cloth, or press P over it: up to ${most} nodes stay where they are. With “Pin by click” a ` +
      "drag pins all nodes under a rectangle." :
      `${count.toLocaleString("en")} of ${most} pinned. Drag a pin to move it.`;
    button("unpin").disabled = count === 0;
  }

  /** Brings the markers to their nodes. */
  draw(): void {
    const world = this.player.live;
    if (world && !world.busy) this.markers.draw(world);
  }
}
