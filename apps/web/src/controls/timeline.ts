// Back by up to ten seconds: states are saved while the cloth moves, and the slider opens one. From there it goes on.
import { WeftError } from "weft-cloth";
import { element, input } from "../elements.js";
import { Latest } from "../latest.js";
import { Paced } from "../paced.js";
import type { Player } from "../player.js";
import { Past } from "../state/past.js";
import type { PageState } from "../state/page_state.js";

const PACE = { calm: 150, share: 0.05 }; // of saving

export class Timeline {
  private readonly slider = input("past");
  private readonly time = element("past-time", HTMLOutputElement);
  private readonly past = new Past();
  private readonly wanted: Latest<number>;
  private readonly saving = new Paced(() => this.keep(), PACE);
  private tooLarge = false; // a state of this scene
  private set = ""; // what the scene was changed by: states are of one scene

  constructor(private readonly player: Player, private readonly say: (sentence: string) => void) {
    this.wanted = new Latest((index) => this.open(index));
    this.slider.addEventListener("input", () => {
      const index = Number(this.slider.value); // pausing keeps one more behind it
      if (player.playing) player.play(false);
      this.tell(index);
      this.wanted.set(index);
    });
  }

  enable(on: boolean): void {
    this.slider.disabled = !on || this.past.moments.length < 2;
  }

  /** Another scene, or none. */
  restart(): void {
    this.past.clear();
    this.tooLarge = false;
    this.show();
  }

  changed({ set }: PageState): void {
    const now = JSON.stringify(set);
    if (now === this.set) return;
    this.set = now;
    this.restart();
  }

  /** The end of what has been played is kept too. */
  playing(on: boolean): void {
    if (!on) void this.saving.carryOut();
  }

  /** A frame has been simulated or drawn. */
  frame(now: number): void {
    if (this.player.playing) this.saving.frame(now);
    else this.saving.stop();
  }

  private async keep(): Promise<void> {
    if (this.tooLarge || this.player.beside.world) return;
    const { loaded } = this.player;
    const set = this.set;
    const moment = await this.player.ask(async (world) => {
      try {
        const bytes = await world.saveState();
        return { bytes, seconds: world.statistics.seconds };
      } catch (reason) {
        if (reason instanceof WeftError && reason.kind === "diverged") return null; // the frame has said so
        throw reason;
      }
    });
    if (!moment || this.player.loaded !== loaded || this.set !== set) return;
    this.tooLarge = !Past.takes(moment.bytes.length);
    if (!this.tooLarge) this.past.keep(moment);
    this.show();
  }

  private async open(index: number): Promise<void> {
    const moment = this.past.moments[index];
    if (!moment) return;
    const outcome = await this.player.openState(moment.bytes);
    if (!(outcome instanceof WeftError)) return;
    this.restart(); // of a scene that is not there any more
    this.say(outcome.message);
  }

  /** The slider at its end: now. */
  private show(): void {
    const last = this.past.moments.length - 1;
    const held = this.slider === document.activeElement && !this.player.playing;
    this.slider.max = String(Math.max(last, 0));
    if (!held) this.slider.value = this.slider.max;
    this.slider.disabled = last < 1 || !this.player.live;
    this.tell(Number(this.slider.value));
  }

  private get whyNone(): string {
    if (this.player.beside.world) return "not while comparing";
    return this.tooLarge ? "too large to keep" : "";
  }

  private tell(index: number): void {
    const moment = this.past.moments[index];
    this.time.textContent = moment ? `${moment.seconds.toFixed(2)} s` : this.whyNone;
    this.slider.setAttribute("aria-valuetext", this.time.textContent);
  }
}
