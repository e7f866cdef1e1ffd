// Between the page's pixels, the picture's clip coordinates and the scene.
import type { Point, World } from "weft-cloth";
import type { Place } from "./hand.js";

/** Where a place of the page is in the picture, in clip coordinates. */
export function clip(canvas: HTMLCanvasElement, { x, y }: Place): Place {
  const box = canvas.getBoundingClientRect();
  return { x: (2 * (x - box.left)) / box.width - 1, y: 1 - (2 * (y - box.top)) / box.height };
}

/** Where a point of the scene is on a layer that covers the picture [CSS pixels]. */
export function onLayer(layer: SVGSVGElement, world: World): (point: Point) => Place {
  const { width, height } = layer.getBoundingClientRect();
  return (point) => {
    const [x, y] = world.project(point);
    return { x: (width * (x + 1)) / 2, y: (height * (1 - y)) / 2 };
  };
}
