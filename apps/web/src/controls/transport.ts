// Play, step, reset, and on a phone the button that unfolds the rest of the panel.
import { button, element } from "../elements.js";
import type { Player } from "../player.js";

export class Transport {
  private readonly buttons = ["play", "step", "reset"].map(button);

  constructor(player: Player) {
    button("play").addEventListener("click", () => player.play(!player.playing));
    button("step").addEventListener("click", () => void player.step());
    button("reset").addEventListener("click", () => void player.reset());
    const more = button("more");
    more.addEventListener("click", () => {
      const unfolded = element("controls", HTMLElement).classList.toggle("unfolded");
      more.setAttribute("aria-expanded", String(unfolded));
      element("more-label", HTMLSpanElement).textContent = unfolded ? "Less" : "More";
    });
  }

  enable(on: boolean): void {
    for (const each of this.buttons) each.disabled = !on;
  }

  playing(on: boolean): void {
    element("play-label", HTMLSpanElement).textContent = on ? "Pause" : "Play";
    button("play").dataset["playing"] = String(on);
  }
}
