// The world on the right of a comparison: the player's scene with another method, fabric or resolution, drawn on a
// canvas of its own over the player's. Both go in lock step: in a round one simulates a frame, then the other, so that
// each is timed alone on the GPU; then both are drawn.
import { createWorld, WeftError, type View, type World } from "weft-cloth";
import { element } from "./elements.js";
import { Latest } from "./latest.js";
import { clip } from "./places.js";
import { Rounds } from "./rounds.js";
import type { LoadedScene } from "./scenes.js";
import { equal, type PageState } from "./state/page_state.js";
import { tell } from "./tell.js";
import { Times } from "./times.js";

const KEPT = 30; // frames over which the median of their times is taken

/** Both sides of a comparison. */
interface Pair {
  readonly left: World;
  readonly right: World;
  /** What the right one holds. */
  readonly scene: LoadedScene;
  readonly canvas: HTMLCanvasElement;
}

export interface BesideEvents {
  /** Something is wrong with the player's own world. */
  leftFailed(reason: unknown): void;
  rightFailed(reason: unknown): void;
}

export class Beside {
  private readonly place = element("beside", HTMLDivElement);
  private readonly line = element("divider-line", HTMLDivElement);
  private pair: Pair | null = null;
  private readonly rounds: Rounds;
  private readonly times = { left: new Times(KEPT), right: new Times(KEPT) };
  private readonly cameras = new Latest(() => this.matchCamera());

  constructor(private readonly own: HTMLCanvasElement, private readonly events: BesideEvents) {
    this.rounds = new Rounds({ drained: () => this.drained(), round: () => this.round() });
  }

  /** null: nothing is compared. */
  get world(): World | null {
    return this.pair?.right ?? null;
  }
  get scene(): LoadedScene | null {
    return this.pair?.scene ?? null;
  }
  /** What a frame of each side takes, the median of the last ones [ms]; null before the first. */
  get milliseconds(): { readonly left: number | null; readonly right: number | null } {
    return { left: this.times.left.median, right: this.times.right.median };
  }
  /** How far the left side goes, in clip coordinates; without a comparison to the picture's edge. */
  get edge(): number {
    return this.pair === null ? 1 : clip(this.own, { x: this.line.getBoundingClientRect().left, y: 0 }).x;
  }
  /** Whether a place of the picture is on the right. `x`: in clip coordinates. */
  covers(x: number): boolean {
    return x > this.edge;
  }

  /** Makes the world, at rest beside `left`; where that fails, rejects, and what was there before is there still. */
  async open(left: World, scene: LoadedScene, view: View): Promise<void> {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [this.own.width, this.own.height];
    const right = await createWorld({ scene: scene.json, meshes: scene.meshes, set: scene.set, canvas, view });
    try {
      const { substeps } = right.info;
      if (substeps > scene.mostSubsteps)
        throw new Error(`It needs ${substeps} steps a frame, more than the page's limit of ${scene.mostSubsteps}.`);
      const { width, height } = this.own; // it may have changed since
      if (canvas.width !== width || canvas.height !== height) await right.resize(width, height);
    } catch (reason) {
      right.dispose();
      throw reason;
    }
    this.close();
    right.on("error", (reason) => {
      if (this.pair?.right === right) this.events.rightFailed(reason);
    });
    this.pair = { left, right, scene, canvas };
    this.rounds.begin(right.info.frameSeconds);
    this.place.replaceChildren(canvas);
    this.followCamera();
  }

  close(): void {
    this.rounds.play(false);
    this.pair?.right.dispose();
    this.pair?.canvas.remove();
    this.pair = null;
    this.times.left.clear();
    this.times.right.clear();
  }

  // Time

  play(on: boolean): void {
    if (on !== this.rounds.playing) this.rounds.play(on);
  }

  step(): Promise<void> {
    return this.rounds.inTurn(async () => {
      await this.drained();
      await this.round();
    });
  }

  /** Both back to rest, at time 0. */
  reset(): Promise<void> {
    return this.rounds.inTurn(async () => {
      await this.pair?.left.reset();
      await this.atRight(({ right }) => right.reset());
    });
  }

  private async drained(): Promise<void> {
    const { left, right } = this.pair ?? {};
    await Promise.all([left, right].map((world) => world?.device?.queue.onSubmittedWorkDone()));
  }

  private async round(): Promise<void> {
    const { pair } = this;
    if (!pair) return;
    try {
      await this.times.left.measure(() => pair.left.step(1, { draw: null }));
    } catch (reason) {
      return this.events.leftFailed(reason);
    }
    await this.atRight(({ right }) => this.times.right.measure(() => right.step(1, { draw: null })));
    if (this.pair !== pair) return;
    pair.left.redraw();
    pair.right.redraw();
  }

  // Change and look

  /** `set`: what the right side has changed in its scene, when it is told. */
  async tell(set: () => PageState["set"], keys: readonly string[]): Promise<void> {
    await this.atRight(({ right, scene }) => tell(right, scene, set, keys));
  }

  async setView(view: View): Promise<void> {
    await this.atRight(({ right }) => right.setView(view));
  }

  async resize(width: number, height: number): Promise<void> {
    await this.atRight(({ right }) => right.resize(width, height));
  }

  /** The left camera may be another one now. */
  followCamera(): void {
    if (this.pair) this.cameras.set(undefined);
  }

  private async matchCamera(): Promise<void> {
    const { pair } = this;
    if (!pair) return;
    const { left, right } = pair;
    while (left.busy || right.busy) await new Promise((wake) => setTimeout(wake)); // neither can be asked then
    if (this.pair !== pair || left.stopped || right.stopped || equal(left.camera, right.camera)) return;
    right.camera = left.camera;
  }

  /** Does something with the right world, if there is one; its faults are told, and nothing rejects. */
  private async atRight(action: (pair: Pair) => Promise<unknown>): Promise<void> {
    const { pair } = this;
    if (!pair) return;
    try {
      await action(pair);
    } catch (reason) {
      if (this.pair === pair) this.events.rightFailed(reason);
    }
  }
}

/** Whether a comparison goes on after that: a cloth that has diverged stays in its last good state. */
export const isDiverged = (reason: unknown): boolean => reason instanceof WeftError && reason.kind === "diverged";
