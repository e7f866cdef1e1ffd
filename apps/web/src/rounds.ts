// Worlds in lock step: in each round each of them simulates one frame. What else is done with them has its turn between
// two rounds.
import { Pace } from "./pace.js";

export interface RoundEvents {
  /** When all that the worlds have been asked to draw is done: before a round, so that pictures delay no frame. */
  drained(): Promise<void>;
  /** A round is due. `now`: the display's time [ms]. Does not reject. */
  round(now: number): Promise<void>;
}

export class Rounds {
  private turn: Promise<void> = Promise.resolve();
  private wanted = false;
  private looping = false;
  private pace = new Pace(0);

  constructor(private readonly events: RoundEvents) {
    document.addEventListener("visibilitychange", () => this.pace.begin(performance.now())); // hidden, nothing ticks
  }

  get playing(): boolean {
    return this.wanted;
  }
  /** Simulated over passed time while it plays; null before it is known. */
  get share(): number | null {
    return this.wanted ? this.pace.share : null;
  }
  /** When all that has been asked for so far is done. */
  get settled(): Promise<void> {
    return this.turn;
  }

  /** There are other worlds now. `frameSeconds`: simulated time of a round [s]. */
  begin(frameSeconds: number): void {
    this.pace = new Pace(1000 * frameSeconds);
    this.pace.begin(performance.now());
  }

  /** Plays in real time, as far as the machine can: what is late by more than a frame is dropped. */
  play(on: boolean): void {
    this.wanted = on;
    this.pace.begin(performance.now());
    if (on && !this.looping) void this.loop();
  }

  inTurn(action: () => Promise<void>): Promise<void> {
    const done = this.turn.then(action);
    this.turn = done.catch(() => undefined);
    return done;
  }

  private async loop(): Promise<void> {
    this.looping = true;
    while (this.wanted) {
      const now = await new Promise<number>(requestAnimationFrame);
      if (this.wanted) await this.inTurn(() => this.tick(now));
    }
    this.looping = false;
  }

  private async tick(now: number): Promise<void> {
    await this.events.drained();
    if (this.wanted && this.pace.due(now)) await this.events.round(now);
  }
}
