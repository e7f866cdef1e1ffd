// A picture that is turned by dragging it, or by the arrow keys on it.
import { ARROWS } from "./controls/arrows.js";

const HALF_TURN = Math.PI; // of the camera, for a drag over the canvas's height [rad]
const KEY_TURN = 0.1; // of the camera, for an arrow key [rad]

/** `orbit` turns the eye to the right and upwards [rad]. */
export function turnBy(canvas: HTMLCanvasElement, orbit: (dx: number, dy: number) => void): void {
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    const turn = HALF_TURN / canvas.clientHeight;
    orbit(-turn * event.movementX, turn * event.movementY); // what is grabbed is the picture
  });
  canvas.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return;
    orbit(KEY_TURN * arrow[0], KEY_TURN * arrow[1]);
    event.preventDefault();
  });
}
