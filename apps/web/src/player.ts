// The world that the page shows: which scene is in it, and whether it runs.
import { createWorld, WeftError, type Camera, type Catalog, type OpenedState, type Pick, type View,
  type World } from "weft-cloth";
import type { Beside } from "./beside.js";
import { Comparer } from "./comparer.js";
import { fitCamera, idle, near } from "./fit_camera.js";
import type { Place } from "./hand.js";
import { Latest } from "./latest.js";
import { checkRoom, type Limits } from "./memory.js";
import { hold, pointOf, type HeldPin } from "./pin_places.js";
import type { PlayerEvents } from "./player_events.js";
import { Recovery } from "./recovery.js";
import { fetchScene, restated, type LoadedScene } from "./scenes.js";
import { sentence } from "./sentence.js";
import { equal, withKey, type Comparison, type PageState, type PinPlace, type Value } from "./state/page_state.js";
import { tell } from "./tell.js";

interface LiveChange {
  readonly scene: LoadedScene;
  readonly before: Value | null;
}

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
  private readonly recovery: Recovery;

  /** `first`: what is asked for before any scene is open. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly offers: Catalog,
    private readonly limits: Limits, first: PageState, private readonly events: PlayerEvents) {
    this.state_ = first;
    this.comparer = new Comparer(canvas, offers, limits, {
      shown: this,
      change: (state) => this.change(state),
      follow: () => this.follow(),
      restart: () => this.restart(),
      pause: () => this.pause(),
      failed: (reason) => void this.fail(reason),
    }, events);
    this.recovery = new Recovery({
      shown: this,
      halt: () => this.halt(),
      pause: () => this.pause(),
      inTurn: (action) => this.inTurn(action),
      settle: (scene) => this.settle(scene, this.state_),
      discard: () => this.discard(),
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
    this.halt();
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
    this.recovery.watch(world);
  }

  /** The world is no more to be asked; the scene that it held. */
  private halt(): LoadedScene | null {
    const { scene } = this;
    this.scene = null;
    this.comparer.close();
    this.open_?.pause();
    return scene;
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

  private pause(): void {
    if (this.wantsToPlay) this.play(false);
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

  private fail(reason: unknown): Promise<void> {
    return this.recovery.fail(reason);
  }

  private inTurn(action: () => Promise<void>): Promise<void> {
    const done = this.turn.then(action);
    this.turn = done.catch(() => undefined);
    return done;
  }
}

const placesOf = (held: readonly HeldPin[]): PinPlace[] => held.map(({ rest, target }) => ({ rest, target }));
