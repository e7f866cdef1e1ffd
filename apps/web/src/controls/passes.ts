// The GPU time of each kernel, measured on demand.
import type { PassTime, WorldInfo } from "weft-cloth";
import { button, element } from "../elements.js";
import type { Player } from "../player.js";
import { fill } from "./readings.js";

export class Passes {
  private readonly note = element("passes-note", HTMLParagraphElement);
  private readonly list = element("passes", HTMLDListElement);
  private times_: readonly PassTime[] | null = null;

  constructor(private readonly player: Player) {
    button("measure").addEventListener("click", () => void this.measure());
  }

  /** The last measurement of this scene. */
  get times(): readonly PassTime[] | null {
    return this.times_;
  }

  /** null: nothing is loaded. */
  show(info: WorldInfo | null): void {
    this.times_ = null;
    fill(this.list, []);
    button("measure").disabled = !info?.timestamps;
    this.note.textContent = !info || info.timestamps ?
      "Plays a few frames with a pass for each kernel, and puts the cloth back: shares, not totals." :
      "This adapter offers no timestamp queries, so passes cannot be timed here.";
  }

  private async measure(): Promise<void> {
    const { playing } = this.player;
    this.player.play(false);
    button("measure").disabled = true;
    const times = await this.player.ask(async (world) => {
      if (world.statistics.frames === 0) await world.step(); // nothing can be timed at rest
      return world.passTimes();
    });
    button("measure").disabled = false;
    if (playing) this.player.play(true);
    if (!times) return;
    this.times_ = times;
    const longest = [...times].sort((a, b) => b.milliseconds - a.milliseconds);
    fill(this.list, longest.map(({ kernel, per, dispatches, milliseconds }) => [
      kernel.replaceAll("_", " "),
      `${milliseconds.toPrecision(2)} ms a ${per}${dispatches > 1 ? `, ${dispatches} dispatches` : ""}`,
    ]));
  }
}
