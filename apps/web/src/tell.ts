import type { World } from "weft-cloth";
import type { LoadedScene } from "./scenes.js";
import type { PageState } from "./state/page_state.js";
import { clearedBy } from "./state/parameters.js";

/** Tells a world of that scene what these keys are, and those in whose place they stand. `set`: when it is their turn,
 *  as another may have changed by then. */
export async function tell(world: World, scene: LoadedScene, set: () => PageState["set"],
  keys: readonly string[]): Promise<void> {
  for (const key of new Set(keys.flatMap((one) => [one, ...clearedBy(one)])))
    await world.setParameter(key, scene.valueOf(key, set()) ?? null);
}
