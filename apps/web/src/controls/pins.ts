// Nodes that the page holds at their places, as a hand would; each has a marker over the picture.
import type { Point } from "weft-cloth";
import { button, element } from "../elements.js";
import type { Place } from "../hand.js";
import { refusal, type HeldPin } from "../pin_places.js";
import { clip, onLayer } from "../places.js";
import type { Player } from "../player.js";
import { ClickMode } from "./click_mode.js";

const SVG = "http://www.w3.org/2000/svg";
const CALM = 300; // from a pull to when the page's state has it [ms]

interface Pin {
  held: HeldPin;
  readonly marker: SVGCircleElement;
}

export class Pins {
  private readonly pins = new Map<number, Pin>();
  private readonly layer = element("pins", SVGSVGElement);
  private readonly mode: ClickMode;
  private late: ReturnType<typeof setTimeout> | undefined; // when a pull will be noted

  /** `most`: nodes that the world holds at once; the hand needs one of them. */
  constructor(canvas: HTMLCanvasElement, private readonly player: Player, private readonly most: number,
    private readonly say: (sentence: string) => void) {
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
    return [...this.pins.values()].map(({ held: { node, target } }) => ({ node, point: target }));
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
  async toggle({ x, y }: Place): Promise<void> {
    const found = await this.player.ask(async (world) => {
      const picked = await this.player.pick(world, x, y);
      if (!picked) return { fault: "There is no cloth to pin there." };
      const { node } = picked;
      if (this.pins.has(node)) {
        await world.release(node);
        return { released: node };
      }
      if (this.pins.size + 1 >= this.most)
        return {
          fault: `${this.pins.size} nodes are pinned, and there can be ${
            this.most - 1
          }: the core holds ${this.most}, and the hand needs one.`,
        };
      const { position, rest } = await world.probe(node);
      const fault = await refusal(world.grab(node, position));
      return fault === null ? { node, rest, target: position } : { fault };
    });
    if (!found) return;
    if ("fault" in found) return this.say(found.fault);
    if ("released" in found) this.drop(found.released);
    else this.put(found);
    this.note();
  }

  /** A pinned node was pulled elsewhere, and stays there. */
  moved(node: number, target: Point): void {
    const pin = this.pins.get(node);
    if (!pin) return;
    pin.held = { ...pin.held, target };
    this.draw();
    clearTimeout(this.late);
    this.late = setTimeout(() => this.note(), CALM);
  }

  async removeAll(): Promise<void> {
    const nodes = [...this.pins.keys()];
    this.forget();
    this.note();
    await this.player.ask(async (world) => {
      for (const node of nodes) await world.release(node);
    });
  }

  /** The page's state gets what is pinned. */
  note(): void {
    clearTimeout(this.late);
    this.player.notePins([...this.pins.values()].map(({ held: { rest, target } }) => ({ rest, target })));
  }

  /** The world holds nothing any more. */
  forget(): void {
    clearTimeout(this.late);
    for (const node of [...this.pins.keys()]) this.drop(node);
  }

  /** The world holds these, and no other. */
  take(held: readonly HeldPin[]): void {
    this.forget();
    for (const pin of held) this.put(pin);
  }

  private put(held: HeldPin): void {
    const marker = document.createElementNS(SVG, "circle");
    marker.setAttribute("r", "6");
    this.layer.append(marker);
    this.pins.set(held.node, { held, marker });
    this.tell();
    this.draw();
  }

  private drop(node: number): void {
    this.pins.get(node)?.marker.remove();
    this.pins.delete(node);
    this.tell();
  }

  private tell(): void {
    const count = this.pins.size;
    element("pin-count", HTMLParagraphElement).textContent = count === 0 ?
      `Double-click the cloth, or press P over it: up to ${this.most - 1} nodes stay where they are.` :
      `${count} of ${Math.max(count, this.most - 1)} pinned. Drag a pin to move it.`;
    button("unpin").disabled = count === 0;
  }

  /** Brings the markers to their nodes. */
  draw(): void {
    const world = this.player.live;
    if (!world || world.busy || this.pins.size === 0) return;
    const place = onLayer(this.layer, world);
    for (const { held, marker } of this.pins.values()) {
      const { x, y } = place(held.target);
      marker.setAttribute("cx", String(x));
      marker.setAttribute("cy", String(y));
    }
  }
}
