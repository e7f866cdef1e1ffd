// The world that the page shows: which scene is in it, whether it runs, and what becomes of it when the GPU fails.
import { createWorld, WeftError, type Camera, type Catalog, type OpenedState, type Pick, type Statistics, type View,
  type World, type WorldInfo } from "weft-cloth";
import type { Beside } from "./beside.js";
import { Comparer } from "./comparer.js";
import { fitCamera, idle } from "./fit_camera.js";
import type { Place } from "./hand.js";
import { Latest } from "./latest.js";
import { checkRoom, type Limits } from "./memory.js";
import { hold, pointOf, type HeldPin } from "./pin_places.js";
import { fetchScene, restated, type LoadedScene } from "./scenes.js";
import { sentence } from "./sentence.js";
import { equal, withKey, type Comparison, type PageState, type PinPlace, type Value } from "./state/page_state.js";
import { isLive } from "./state/parameters.js";
import { tell } from "./tell.js";

export interface PlayerEvents {
  /** The world is being built; its grabs are void. */
  opening(title: string): void;
  opened(scene: LoadedScene, info: WorldInfo): void;
  /** The other side of a comparison is being built; null: it is there, or has been refused. */
  preparing(title: string | null): void;
  /** There is another side now, or none any more. */
  compared(): void;
  /** No scene could be opened, nor the one before. */
  empty(): void;
  playing(on: boolean): void;
  viewed(view: View): void;
  /** The state differs from before: another scene, parameter, view or camera. */
  changed(state: PageState): void;
  /** The cloth is at rest again, and nothing of it is grabbed. */
  rested(): void;
  /** The cloth goes on from a saved state. */
  wentBack(): void;
  /** These nodes are pinned, and no other. */
  held(pins: readonly HeldPin[]): void;
  /** `host`: what a frame cost the page's thread [ms]; null where it was only drawn. */
  frame(statistics: Readonly<Statistics>, host: number | null): void;
  said(sentence: string): void;
  failed(sentence: string): void;
}

interface LiveChange {
  readonly scene: LoadedScene;
  readonly before: Value | null;
}

const LOSSES = { most: 3, within: 60_000 }; // a device that is lost more often than this [ms] will be lost again
const LOSS_SHOWS_WITHIN = 250; // [ms]

export class Player {
  private open_: World | null = null;
  private scene: LoadedScene | null = null; // what the world holds; null while it must not be asked
  private wantsToPlay = false;
  private hidden = false;
  private state_: PageState;
  private readonly comparer: Comparer;
  private readonly latest = new Map<string, Latest<LiveChange>>(); // by key
  private home_: Camera | null = null; // the camera that the scene came with
  private turn: Promise<void> = Promise.resolve(); // loading and recovery, one after the other
  private newest = 0;
  private recovering = false;
  private losses: number[] = [];

  /** `first`: what is asked for before any scene is open. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly offers: Catalog,
    private readonly limits: Limits, first: PageState, private readonly events: PlayerEvents) {
    this.state_ = first;
    this.comparer = new Comparer(canvas, offers, limits, {
      shown: this,
      change: (state) => this.change(state),
      follow: () => this.follow(),
      restart: () => this.restart(),
      pause: () => {
        if (this.wantsToPlay) this.play(false);
      },
      failed: (reason) => void this.fail(reason),
    }, events);
  }

  get world(): World | null {
    return this.open_;
  }
  /** The world, while it holds a scene. */
  get live(): World | null {
    return this.scene ? this.open_ : null;
  }
  get playing(): boolean {
    return this.wantsToPlay;
  }
  get shownView(): View {
    return this.state_.view;
  }
  /** What is shown; while another scene loads, what was shown before. */
  get state(): PageState {
    return this.state_;
  }
  /** The other side of a comparison. */
  get beside(): Beside {
    return this.comparer.beside;
  }
  /** The camera that the scene came with. */
  get home(): Camera | null {
    return this.home_;
  }
  /** What the world holds. */
  get loaded(): LoadedScene | null {
    return this.scene;
  }

  /** Shows a scene, or the previous one if it cannot be opened. Rejects only the first time, with nothing to show. */
  open(state: PageState): Promise<void> {
    const number = ++this.newest;
    return this.inTurn(async () => {
      if (number !== this.newest) return; // another was chosen meanwhile
      this.events.opening("Loading the scene …");
      const before = this.scene;
      try {
        const scene = await fetchScene(state, this.offers);
        checkRoom([scene], this.limits);
        await this.load(scene);
      } catch (reason) {
        await this.reopen(before, reason);
      }
    });
  }

  private async reopen(before: LoadedScene | null, reason: unknown): Promise<void> {
    this.events.failed(sentence(reason));
    try {
      if (reason instanceof WeftError && reason.kind === "device-lost") this.discard();
      if (!before) throw reason;
      await this.load(restated(before, this.state_)); // with what has been changed since it was opened
    } catch {
      this.events.empty();
      if (!before) throw reason;
    }
  }

  private async load(scene: LoadedScene): Promise<void> {
    const options = { scene: scene.json, meshes: scene.meshes, set: scene.set };
    this.scene = null;
    this.comparer.close();
    this.open_?.pause();
    if (this.open_?.stopped) this.discard();
    if (this.open_) await this.open_.load(scene.json, options);
    else this.adopt(await createWorld({ ...options, canvas: this.canvas, view: this.state_.view }));
    const { substeps } = this.open_!.info;
    if (substeps > scene.mostSubsteps)
      throw new Error(
        `${scene.title} needs ${substeps} steps a frame, more than the page's limit of ${scene.mostSubsteps}.`,
      );
    await this.settle(scene, scene.state);
  }

  /** The world holds this scene now. */
  private async settle(scene: LoadedScene, asked: PageState): Promise<void> {
    const world = this.open_!;
    await this.fit(world);
    await idle(world);
    this.home_ = world.camera;
    if (asked.camera) world.camera = asked.camera;
    const view = world.view === asked.view ? asked.view : await this.viewFor(world, asked.view);
    const { held, fault } = await hold(world, asked.pins);
    const state = { ...asked, view, pins: placesOf(held) };
    this.scene = scene;
    this.state_ = state;
    this.events.viewed(view);
    this.events.opened(scene, world.info);
    this.events.held(held);
    this.events.changed(state);
    if (fault !== null) this.events.said(`A pin could not be set again. ${fault}`);
    if (state.compare) await this.comparer.open(state.compare);
    this.follow();
  }

  // Compare

  /** Shows the scene beside itself, both at rest; null: by itself again, as it is. Refused, all stays as it was. */
  compare(wanted: Comparison | null): Promise<void> {
    const number = ++this.newest;
    return this.inTurn(async () => {
      if (number !== this.newest) return;
      if (wanted) await this.comparer.open(wanted);
      else this.comparer.end();
      this.follow();
    });
  }

  /** Moves the divider of a comparison. */
  divide(divider: number): void {
    const { compare } = this.state_;
    if (compare) this.change({ ...this.state_, compare: { ...compare, divider } });
  }

  /** The view that is asked for; where the scene has nothing to show in it, the world's. */
  private async viewFor(world: World, view: View): Promise<View> {
    try {
      await world.setView(view);
    } catch (reason) {
      if (!(reason instanceof WeftError && reason.kind === "input")) throw reason;
      this.events.said(sentence(reason));
    }
    return world.view;
  }

  private change(state: PageState): void {
    if (equal(state, this.state_)) return;
    this.state_ = state;
    this.events.changed(state);
  }

  private adopt(world: World): void {
    this.open_ = world;
    world.on("frame", (statistics) => {
      this.beside.followCamera();
      this.events.frame(statistics, world.running ? world.hostMilliseconds : null);
    });
    world.on("error", (error) => { // what the scene before still has to say is of no interest while another loads
      if (this.scene || error.kind === "device-lost") void this.fail(error);
    });
    world.on("news", (sentence) => this.events.said(sentence));
    this.watch(world);
  }

  private discard(): void {
    this.comparer.close();
    this.open_?.dispose();
    this.open_ = null;
    this.scene = null;
  }

  // Time

  play(on: boolean): void {
    this.wantsToPlay = on;
    this.follow();
    this.events.playing(on);
    if (!on) void this.ask((world) => world.step(0)); // waits for the frames under way: the numbers are the picture's
  }

  /** A page that nobody sees does not simulate. */
  setHidden(hidden: boolean): void {
    this.hidden = hidden;
    this.follow();
  }

  private follow(): void {
    const goes = this.live !== null && this.wantsToPlay && !this.hidden && !this.comparer.preparing;
    const compared = this.beside.world !== null;
    this.beside.play(goes && compared);
    if (goes && !compared) this.live?.run();
    else this.open_?.pause();
  }

  async step(): Promise<void> {
    this.play(false);
    await this.ask(async (world) => void await (this.beside.world ? this.beside.step() : world.step()));
  }

  /** Back to rest, and all pins go. Where a comparison is being made, once it is: that begins at rest too. */
  async reset(): Promise<void> {
    if (!this.live) return;
    await this.inTurn(async () => {
      if (await this.rest()) this.notePins([]);
    });
  }

  /** Whether all that is shown is at rest now, and nothing of it is grabbed. */
  private async rest(): Promise<boolean> {
    const done = await this.ask((world) => (this.beside.world ? this.beside : world).reset().then(() => true));
    if (done) this.events.rested();
    return done ?? false;
  }

  /** Goes on from a saved state, playing or not. Why not, where it does not fit: then all stays as it was. */
  async openState(bytes: ArrayBuffer | Uint8Array): Promise<OpenedState | WeftError | null> {
    let held: HeldPin[] = [];
    const outcome = await this.ask(async (world) => {
      try {
        const opened = await world.openState(bytes);
        const rest = opened.grabs.length > 0 ? await world.restPositions() : new Float32Array();
        held = opened.grabs.map((grab) => ({ ...grab, rest: pointOf(rest, grab.node) }));
        return opened;
      } catch (reason) {
        if (reason instanceof WeftError && reason.kind === "input") return reason;
        throw reason;
      }
    });
    if (outcome && "grabs" in outcome) {
      this.events.wentBack();
      this.events.held(held);
      this.notePins(placesOf(held));
    }
    return outcome;
  }

  // Pins

  /** What is pinned has changed. */
  notePins(pins: readonly PinPlace[]): void {
    if (this.live) this.change({ ...this.state_, pins });
  }

  /** Begins at rest, where what is pinned now holds again. */
  private async restart(): Promise<void> {
    if (!(await this.rest())) return;
    const held = await this.ask(async (world) => (await hold(world, this.state_.pins)).held) ?? [];
    this.events.held(held);
    this.notePins(placesOf(held));
  }

  // Change and look

  // The state changes at once and the world after it: what is asked for next builds on the state.

  async setView(view: View): Promise<void> {
    const before = this.state_.view;
    this.change({ ...this.state_, view });
    this.events.viewed(view);
    const shown = await this.ask((world) => this.viewFor(world, view));
    if (shown) await this.beside.setView(shown);
    if (shown === view || !this.live || this.state_.view !== view) return;
    this.change({ ...this.state_, view: shown ?? before }); // it has been said why
    this.events.viewed(shown ?? before);
  }

  /** Changes a key of the scene while it moves; null: as the scene has it. */
  setLive(key: string, value: Value | null): void {
    const scene = this.scene;
    if (!scene) return;
    const before = this.state_.set[key] ?? null;
    this.change(withKey(this.state_, key, value));
    let latest = this.latest.get(key);
    if (!latest) this.latest.set(key, latest = new Latest((change) => this.carryOut(key, change)));
    latest.set({ scene, before });
  }

  private async carryOut(key: string, { scene, before }: LiveChange): Promise<void> {
    if (this.scene !== scene) return; // what was loaded meanwhile has it already, or is another scene
    const done = await this.ask((world) => tell(world, scene, () => this.state_.set, [key]).then(() => true));
    if (done) await this.comparer.tell([key]);
    else if (this.scene === scene) this.change(withKey(this.state_, key, before)); // it has been said why
  }

  /** Takes up where the camera is: it is turned without the player. A busy or stopped world cannot be asked. */
  noteCamera(): PageState {
    const world = this.live;
    if (world && !world.busy && !world.stopped) {
      const { camera } = world;
      this.change({ ...this.state_, camera: this.home_ && near(camera, this.home_) ? null : camera });
    }
    return this.state_;
  }

  async resetCamera(): Promise<void> {
    await this.ask((world) => {
      world.resetCamera();
      return this.fit(world);
    });
  }

  private fit(world: World): Promise<void> {
    return fitCamera(world, this.canvas.width / this.canvas.height);
  }

  async resize(width: number, height: number): Promise<void> {
    if (this.live) {
      await this.ask((world) => world.resize(width, height));
      await this.beside.resize(width, height);
    } else [this.canvas.width, this.canvas.height] = [width, height]; // where a world that opens now looks
  }

  /** The node under a place on the canvas, in clip coordinates; null where the other side of a comparison is seen. */
  async pick(world: World, x: number, y: number): Promise<Pick | null> {
    return this.beside.covers(x) ? null : world.pick(x, y);
  }

  /** The nodes between two places on the canvas, as far as the other side of a comparison is not seen there. */
  async pickWithin(world: World, a: Place, b: Place): Promise<number[]> {
    const { edge } = this.beside;
    const [left, right] = [Math.min(a.x, b.x), Math.min(Math.max(a.x, b.x), edge)];
    return left < right ? [...(await world.pickWithin(left, a.y, right, b.y))] : [];
  }

  /** Asks the world for something, if there is one; errors are reported. */
  async ask<T>(action: (world: World) => Promise<T>): Promise<T | null> {
    const world = this.live;
    if (!world) return null;
    try {
      return await action(world);
    } catch (reason) {
      void this.fail(reason);
      return null;
    }
  }

  // Faults

  private async fail(reason: unknown): Promise<void> {
    if (reason instanceof WeftError && reason.kind === "device-lost") return this.recover(sentence(reason));
    // A device that goes away can make other faults before its loss is reported; then the loss is what to act on.
    const lost = this.open_?.device?.lost.then(({ message }) => `The GPU device is lost: ${message}`);
    const wait = new Promise<null>((wake) => setTimeout(() => wake(null), LOSS_SHOWS_WITHIN));
    const cause = await Promise.race([lost ?? null, wait]);
    if (cause !== null) return this.recover(cause);
    if (this.recovering) return;
    if (this.wantsToPlay) this.play(false);
    this.events.failed(sentence(reason));
  }

  /** A loss shows in a running world's next frame; a paused one is told by the device itself. */
  private watch(world: World): void {
    const device = world.device;
    void device?.lost.then(({ message }) => {
      if (this.open_ === world && world.device === device) void this.recover(`The GPU device is lost: ${message}`);
    });
  }

  private async recover(cause: string): Promise<void> {
    const scene = this.scene;
    if (!scene || this.recovering) return; // while a scene is loading, its own failure says it
    this.recovering = true;
    this.scene = null;
    this.comparer.close();
    this.open_?.pause();
    const now = performance.now();
    this.losses = [...this.losses.filter((then) => now - then < LOSSES.within), now];
    try {
      await this.inTurn(() => this.reviveOnce(scene, cause.replace(/[.\s]*$/, ".")));
    } finally {
      this.recovering = false;
    }
  }

  private async reviveOnce(scene: LoadedScene, cause: string): Promise<void> {
    if (this.losses.length > LOSSES.most) {
      this.events.empty();
      return this.events.failed(`The GPU device was lost ${this.losses.length} times within a minute; ` +
        `reload the page to try again. (${cause})`);
    }
    this.events.opening("The GPU device was lost; opening it again …");
    try {
      const world = this.open_!;
      await world.recover();
      this.watch(world);
      // The world starts again with the address's changes, those since undone included.
      const set = () => this.state_.set;
      await tell(world, scene, set, Object.keys({ ...scene.state.set, ...set() }).filter(isLive));
      await this.settle(scene, this.state_);
      this.events.said(`The GPU device was lost and has been opened again; the scene was restarted. (${cause})`);
    } catch (reason) {
      this.discard();
      this.events.empty();
      this.events.failed("The GPU device was lost and could not be opened again. " +
        `Choose a scene or reload the page to try again. (${sentence(reason)})`);
    }
  }

  private inTurn(action: () => Promise<void>): Promise<void> {
    const done = this.turn.then(action);
    this.turn = done.catch(() => undefined);
    return done;
  }
}

const placesOf = (held: readonly HeldPin[]): PinPlace[] => held.map(({ rest, target }) => ({ rest, target }));

/** Whether two cameras are one but for rounding. */
function near(a: Camera, b: Camera): boolean {
  const size = Math.hypot(...b.eye.map((value, axis) => value - b.target[axis]!));
  return [a.eye, a.target].every((point, i) =>
    point.every((value, axis) => Math.abs(value - (i === 0 ? b.eye : b.target)[axis]!) < 1e-4 * size)
  );
}
