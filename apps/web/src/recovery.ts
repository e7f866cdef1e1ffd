// What becomes of a player's world when the GPU fails: a device that is lost is opened again, with the scene at rest.
import { WeftError, type World } from "weft-cloth";
import type { PlayerEvents } from "./player_events.js";
import type { LoadedScene } from "./scenes.js";
import { sentence } from "./sentence.js";
import type { PageState } from "./state/page_state.js";
import { isLive } from "./state/parameters.js";
import { tell } from "./tell.js";

const LOSSES = { most: 3, within: 60_000 }; // a device that is lost more often than this [ms] will be lost again
const LOSS_SHOWS_WITHIN = 250; // [ms]

/** What a player lets be done about it. */
export interface Recovered {
  readonly shown: { readonly world: World | null; readonly loaded: LoadedScene | null; readonly state: PageState };
  /** The world is no more to be asked; the scene that it held. */
  halt(): LoadedScene | null;
  pause(): void;
  /** After what is being loaded. */
  inTurn(action: () => Promise<void>): Promise<void>;
  /** The world holds this scene now. */
  settle(scene: LoadedScene): Promise<void>;
  discard(): void;
}

export class Recovery {
  private recovering = false;
  private losses: number[] = [];

  constructor(private readonly of: Recovered, private readonly events: PlayerEvents) {}

  async fail(reason: unknown): Promise<void> {
    if (reason instanceof WeftError && reason.kind === "device-lost") return this.recover(sentence(reason));
    // A device that goes away can make other faults before its loss is reported; then the loss is what to act on.
    const { device } = this.of.shown.world ?? {};
    const lost = device?.lost.then(({ message }) => `The GPU device is lost: ${message}`);
    const wait = new Promise<null>((wake) => setTimeout(() => wake(null), LOSS_SHOWS_WITHIN));
    const cause = await Promise.race([lost ?? null, wait]);
    if (cause !== null) return this.recover(cause);
    if (this.recovering) return;
    this.of.pause();
    this.events.failed(sentence(reason));
  }

  /** A loss shows in a running world's next frame; a paused one is told by the device itself. */
  watch(world: World): void {
    const device = world.device;
    void device?.lost.then(({ message }) => {
      if (this.of.shown.world === world && world.device === device)
        void this.recover(`The GPU device is lost: ${message}`);
    });
  }

  private async recover(cause: string): Promise<void> {
    if (!this.of.shown.loaded || this.recovering) return; // while a scene is loading, its own failure says it
    this.recovering = true;
    const scene = this.of.halt()!;
    const now = performance.now();
    this.losses = [...this.losses.filter((then) => now - then < LOSSES.within), now];
    try {
      await this.of.inTurn(() => this.reviveOnce(scene, cause.replace(/[.\s]*$/, ".")));
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
      const world = this.of.shown.world!;
      await world.recover();
      this.watch(world);
      // The world starts again with the address's changes, those since undone included.
      const set = () => this.of.shown.state.set;
      await tell(world, scene, set, Object.keys({ ...scene.state.set, ...set() }).filter(isLive));
      await this.of.settle(scene);
      this.events.said(`The GPU device was lost and has been opened again; the scene was restarted. (${cause})`);
    } catch (reason) {
      this.of.discard();
      this.events.empty();
      this.events.failed("The GPU device was lost and could not be opened again. " +
        `Choose a scene or reload the page to try again. (${sentence(reason)})`);
    }
  }
}
