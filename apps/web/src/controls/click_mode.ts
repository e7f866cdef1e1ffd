// What a click on the cloth does where it neither pulls nor turns: at most one of these at a time.
import { button } from "../elements.js";
import type { Place } from "../hand.js";
import { clip } from "../places.js";

const STILL = 6; // a click that has moved no farther [CSS pixels]

export class ClickMode {
  private static readonly all: ClickMode[] = [];
  private down: Place = { x: 0, y: 0 }; // of the last press [CSS pixels]
  /** Where the pointer is on the canvas, or was, in clip coordinates; at first in its middle. */
  pointer: Place = { x: 0, y: 0 };
  private readonly button: HTMLButtonElement;

  /** `id`: of the button that turns it on and off; `act` gets clip coordinates. */
  constructor(private readonly canvas: HTMLCanvasElement, id: string, act: (place: Place) => void) {
    this.button = button(id);
    this.button.addEventListener("click", () => this.set(!this.on));
    ClickMode.all.push(this);
    canvas.addEventListener("pointermove", (event) => {
      this.pointer = clip(canvas, event);
    });
    canvas.addEventListener("pointerdown", ({ clientX, clientY }) => {
      this.down = { x: clientX, y: clientY };
    });
    canvas.addEventListener("click", (event) => {
      const way = Math.hypot(event.clientX - this.down.x, event.clientY - this.down.y);
      if (this.on && way < STILL) act(clip(canvas, event)); // else it was a pull, or turned the camera
    });
  }

  /** Whether one of them is on: a single click has a meaning. */
  static get any(): boolean {
    return ClickMode.all.some(({ on }) => on);
  }

  get on(): boolean {
    return this.button.getAttribute("aria-pressed") === "true";
  }

  enable(on: boolean): void {
    this.button.disabled = !on;
  }

  private set(on: boolean): void {
    for (const mode of ClickMode.all) mode.button.setAttribute("aria-pressed", String(on && mode === this));
    this.canvas.dataset["clicks"] = String(on);
  }
}
