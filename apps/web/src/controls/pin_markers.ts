// A marker over the picture for each pin. They are drawn only where the camera, the picture's size or a pin has
// changed: a thousand of them take some milliseconds.
import type { Point, World } from "weft-cloth";
import { element } from "../elements.js";
import type { Place } from "../hand.js";
import { onLayer } from "../places.js";
import { put, svg } from "../svg.js";

const MANY = 50; // markers, of which each is smaller
const REACH = 10; // how far from its middle a marker is still meant [CSS pixels]

interface Marker {
  readonly circle: SVGCircleElement;
  target: Point;
  at: Place; // on the layer [CSS pixels]
}

export class PinMarkers {
  private readonly layer = element("pins", SVGSVGElement);
  private readonly markers = new Map<number, Marker>();
  private drawn = ""; // the camera and the size for which they are drawn

  /** The pin of this node, at a place [m]. */
  put(node: number, target: Point): void {
    const known = this.markers.get(node);
    if (known) known.target = target;
    else {
      const circle = svg("circle", { r: 6 });
      this.markers.set(node, { circle, target, at: { x: NaN, y: NaN } });
      this.layer.append(circle);
    }
    this.changed();
  }

  drop(node: number): void {
    this.markers.get(node)?.circle.remove();
    this.markers.delete(node);
    this.changed();
  }

  private changed(): void {
    this.drawn = "";
    this.layer.classList.toggle("many", this.markers.size > MANY);
  }

  /** Whether there is a marker at a place of the page [CSS pixels]. */
  near({ x, y }: Place): boolean {
    const { left, top } = this.layer.getBoundingClientRect();
    return [...this.markers.values()].some(({ at }) => Math.hypot(at.x + left - x, at.y + top - y) < REACH);
  }

  /** Brings them to their pins. */
  draw(world: World): void {
    if (this.markers.size === 0) return;
    const { width, height } = this.layer.getBoundingClientRect();
    const seen = JSON.stringify([world.camera, width, height]);
    if (seen === this.drawn) return;
    this.drawn = seen;
    const place = onLayer(this.layer, world);
    for (const marker of this.markers.values()) {
      marker.at = place(marker.target);
      put(marker.circle, { cx: marker.at.x, cy: marker.at.y });
    }
  }
}
