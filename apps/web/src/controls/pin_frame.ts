// The rectangle over the picture in which a drag pins all nodes.
import { element } from "../elements.js";
import type { Place } from "../hand.js";
import { put, svg } from "../svg.js";

const SHOWN = 600; // one that a key has drawn [ms]

export class PinFrame {
  private readonly layer = element("pins", SVGSVGElement);
  private readonly rectangle = svg("rect", { class: "frame" });

  constructor() {
    this.hide();
    this.layer.append(this.rectangle);
  }

  /** Between two places of the page [CSS pixels]. */
  show(a: Place, b: Place): void {
    const { left, top } = this.layer.getBoundingClientRect();
    put(this.rectangle, { x: Math.min(a.x, b.x) - left, y: Math.min(a.y, b.y) - top, width: Math.abs(a.x - b.x),
      height: Math.abs(a.y - b.y) });
    this.rectangle.style.display = "";
  }

  /** For a moment. */
  flash(a: Place, b: Place): void {
    this.show(a, b);
    setTimeout(() => this.hide(), SHOWN);
  }

  hide(): void {
    this.rectangle.style.display = "none";
  }
}
