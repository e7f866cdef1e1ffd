// All lanes at the same simulated time. In each round every lane in turn simulates one frame, alone on the GPU; then
// all of them are drawn together.
import type { Point, Snapshot } from "weft-cloth";
import { Rounds } from "../src/rounds.js";
import { sentence } from "../src/sentence.js";
import { Times } from "../src/times.js";
import { KEPT, type Lane, type Opening, type Turned } from "./lane.js";
import { heightEnergy, kineticEnergy, positionError } from "./quantities.js";

const READ_EVERY = 250; // ms: reading a state back takes time of its own

export interface Reading {
  /** Of a frame; null before the first. */
  readonly milliseconds: number | null;
  readonly substeps: number;
  /** Off from the first lane; null where that has no state, or has not moved. */
  readonly error: number | null;
  /** [J] */
  readonly kinetic: number;
  readonly height: number;
}

export interface LockStepEvents {
  /** A lane is being made; null: all of them are. */
  preparing(lane: Lane | null): void;
  failed(sentence: string): void;
  playing(on: boolean): void;
  /** null: a lane has no state. */
  read(readings: ReadonlyMap<Lane, Reading | null>): void;
}

/** What is to be compared. */
export interface Plan {
  readonly lanes: readonly { readonly lane: Lane; readonly opening: Opening }[];
  /** [m/s²] */
  readonly gravity: Point;
}

export class LockStep {
  private lanes: readonly Lane[] = [];
  private gravity: Point = [0, 0, 0];
  private newest = 0;
  private readonly rounds = new Rounds({ drained: () => this.drained(), round: (now) => this.round(now) });
  private frameSeconds = 0;
  private frames_ = 0;
  private readAt = 0;
  private readonly waits = new Times(KEPT);
  /** What the cameras of all lanes are turned by, and what they are still to be turned by. */
  readonly turned: Turned = { dx: 0, dy: 0 };
  private turning: Turned = { dx: 0, dy: 0 };

  constructor(private readonly events: LockStepEvents) {}

  get playing(): boolean {
    return this.rounds.playing;
  }
  get frames(): number {
    return this.frames_;
  }
  /** Simulated [s]. */
  get seconds(): number {
    return this.frames_ * this.frameSeconds;
  }
  /** Simulated over passed time while it plays; null before it is known. */
  get share(): number | null {
    return this.rounds.share;
  }
  /** What a wait for a GPU that has nothing to do takes [ms]; null before the first frame. */
  get wait(): number | null {
    return this.waits.median;
  }
  /** When all that has been asked for so far is done. */
  get settled(): Promise<void> {
    return this.rounds.settled;
  }

  /** Puts all lanes at rest, at time 0. */
  open(plan: () => Promise<Plan>): Promise<void> {
    const number = ++this.newest;
    return this.rounds.inTurn(async () => {
      if (number !== this.newest) return; // something else was chosen meanwhile
      try {
        const { lanes, gravity } = await plan();
        this.lanes = lanes.map(({ lane }) => lane);
        this.gravity = gravity;
        for (const { lane, opening } of lanes) {
          if (number !== this.newest) return;
          this.events.preparing(lane);
          await lane.open(opening);
        }
      } catch (reason) {
        this.lanes = [];
        this.events.failed(sentence(reason));
      }
      this.frames_ = 0;
      this.frameSeconds = this.lanes.find(({ live }) => live)?.live?.info.frameSeconds ?? 0;
      this.rounds.begin(this.frameSeconds);
      this.events.preparing(null);
      await this.read();
    });
  }

  play(on: boolean): void {
    this.rounds.play(on);
    this.events.playing(on);
    if (!on) void this.look();
  }

  /** One frame. */
  step(): Promise<void> {
    if (this.playing) this.play(false);
    return this.rounds.inTurn(async () => {
      await this.drained();
      await this.advance();
      await this.read();
      this.draw();
    });
  }

  /** Turns all cameras about their targets [rad]: at once, or between two frames. */
  orbit(dx: number, dy: number): void {
    this.turning = { dx: this.turning.dx + dx, dy: this.turning.dy + dy };
    if (!this.playing) void this.rounds.inTurn(async () => this.draw());
  }

  /** Reads the states again: a lane has changed by itself. */
  look(): Promise<void> {
    return this.rounds.inTurn(() => this.read());
  }

  /** The scenes' own cameras, from the next opening on. */
  resetCameras(): void {
    Object.assign(this.turned, { dx: 0, dy: 0 });
  }

  private async round(now: number): Promise<void> {
    if (!this.lanes.some(({ live }) => live)) return this.play(false);
    await this.advance();
    if (now - this.readAt >= READ_EVERY) {
      this.readAt = now;
      await this.read();
    }
    this.draw(); // at last: worlds draw in the display's next tick, before the next round, unless they are busy then
  }

  private async advance(): Promise<void> {
    await this.drained(); // of what the browser itself does to show the pictures
    await this.waits.measure(() => this.drained()); // of nothing: the way to the GPU and back
    for (const lane of this.lanes) await lane.step();
    this.frames_ += 1;
  }

  /** When what was drawn is done. */
  private async drained(): Promise<void> {
    await Promise.all(this.lanes.map((lane) => lane.drained()));
  }

  private draw(): void {
    const { dx, dy } = this.turning;
    this.turning = { dx: 0, dy: 0 };
    Object.assign(this.turned, { dx: this.turned.dx + dx, dy: this.turned.dy + dy });
    for (const { live } of this.lanes) {
      if (dx !== 0 || dy !== 0) live?.orbit(dx, dy);
      live?.redraw();
    }
  }

  private async read(): Promise<void> {
    const states = new Map<Lane, Snapshot | null>();
    for (const lane of this.lanes) states.set(lane, await lane.read());
    this.events.read(new Map(this.lanes.map((lane) => [lane, this.readingOf(lane, states)])));
  }

  private readingOf(lane: Lane, states: ReadonlyMap<Lane, Snapshot | null>): Reading | null {
    const state = states.get(lane), { live, start } = lane;
    if (!state || !live || !start) return null;
    const first = this.lanes[0]!, reference = states.get(first);
    return {
      milliseconds: lane.milliseconds,
      substeps: live.info.substeps,
      error: reference && first.start ?
        positionError(state.positions, reference.positions, first.start.positions) :
        null,
      kinetic: kineticEnergy(state),
      height: heightEnergy(state, start.positions, this.gravity),
    };
  }
}
