// What a player tells the page.
import type { Statistics, View, WorldInfo } from "weft-cloth";
import type { HeldPin } from "./pin_places.js";
import type { LoadedScene } from "./scenes.js";
import type { PageState } from "./state/page_state.js";

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
