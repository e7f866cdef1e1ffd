// The comparison that the page's state asks for: the other side is made beside the player's world, is told what
// changes, and is taken away where it fails.
import type { Catalog, World } from "weft-cloth";
import { Beside, isDiverged } from "./beside.js";
import { checkRoom, type Limits } from "./memory.js";
import { fetchScene, type LoadedScene } from "./scenes.js";
import { sentence } from "./sentence.js";
import { rightOf } from "./state/comparison.js";
import type { Comparison, PageState } from "./state/page_state.js";
import { isLive } from "./state/parameters.js";

/** The player, as far as a comparison goes. */
export interface LeftSide {
  readonly shown: { readonly live: World | null; readonly loaded: LoadedScene | null; readonly state: PageState };
  change(state: PageState): void;
  /** Runs or stands, as is wanted now. */
  follow(): void;
  /** Both sides back to rest, where the left one's pins hold again. */
  restart(): Promise<void>;
  pause(): void;
  failed(reason: unknown): void;
}

export interface ComparerEvents {
  /** The other side is being built; null: it is there, or has been refused. */
  preparing(sentence: string | null): void;
  /** There is another side now, or none any more. */
  compared(): void;
  failed(sentence: string): void;
}

export class Comparer {
  readonly beside: Beside;
  private preparing_ = false;

  constructor(canvas: HTMLCanvasElement, private readonly offers: Catalog, private readonly limits: Limits,
    private readonly left: LeftSide, private readonly events: ComparerEvents) {
    this.beside = new Beside(canvas, { leftFailed: (reason) => left.failed(reason),
      rightFailed: (reason) => this.fail(reason) });
  }

  /** Whether the left side waits for the other one. */
  get preparing(): boolean {
    return this.preparing_;
  }

  /** Makes the other side, and begins at rest. Where it is refused it is said why, and all stays as it was. */
  async open(compare: Comparison): Promise<void> {
    const { live, loaded } = this.left.shown;
    if (!live || !loaded) return;
    this.preparing_ = true;
    this.left.follow();
    this.events.preparing("Preparing the other side …");
    try {
      const right = await fetchScene(rightOf({ ...this.left.shown.state, compare }, loaded), this.offers);
      checkRoom([loaded, right], this.limits);
      await this.beside.open(live, right, this.left.shown.state.view);
      this.left.change({ ...this.left.shown.state, compare });
      await this.catchUp(right);
      await this.left.restart();
    } catch (reason) {
      this.events.failed(`The other side cannot be shown. ${sentence(reason)}`);
      if (!this.beside.world) this.left.change({ ...this.left.shown.state, compare: null });
    } finally {
      this.preparing_ = false;
      this.events.preparing(null);
      this.events.compared();
    }
  }

  /** What has been changed while it was made. */
  private async catchUp(right: LoadedScene): Promise<void> {
    const { state, loaded } = this.left.shown;
    if (!loaded) return;
    await this.tell(Object.keys({ ...right.state.set, ...rightOf(state, loaded).set }).filter(isLive));
    if (this.beside.world?.view !== state.view) await this.beside.setView(state.view);
  }

  /** Tells the other side what these keys are. */
  async tell(keys: readonly string[]): Promise<void> {
    const { loaded } = this.left.shown;
    if (loaded) await this.beside.tell(() => rightOf(this.left.shown.state, loaded).set, keys);
  }

  /** The other side goes; the state may ask for it again. */
  close(): void {
    if (!this.beside.world) return;
    this.beside.close();
    this.events.compared();
  }

  /** Nothing is compared any more. */
  end(): void {
    this.left.change({ ...this.left.shown.state, compare: null });
    this.close();
  }

  private fail(reason: unknown): void {
    if (isDiverged(reason)) this.left.pause();
    else {
      this.end();
      this.left.follow();
    }
    this.events.failed(`On the right: ${sentence(reason)}`);
  }
}
