// The cloth's state as a file: saved, and opened to go on from.
import { WeftError, type OpenedState, type World } from "weft-cloth";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import { download, fileName } from "./export.js";
import { checkLimit, MOST_STATE_BYTES } from "./limits.js";

const END = "weft"; // as the command line names its checkpoints

export const isState = ({ name }: File): boolean => name.toLowerCase().endsWith(`.${END}`);

export async function saveState(world: World, scene: LoadedScene): Promise<string> {
  const bytes = await world.saveState();
  const name = fileName(scene, world.statistics.frames, END);
  download(name, new Blob([bytes], { type: "application/octet-stream" }));
  return name;
}

/** Null: it could not be opened for want of a working world, and that has been said. Throws where it is refused. */
export async function openState(file: File, player: Player): Promise<OpenedState | null> {
  checkLimit(file.name, file.size, MOST_STATE_BYTES);
  const bytes = await file.arrayBuffer();
  if (!player.live) throw new Error(`${file.name} cannot be opened: no scene is shown that it could go on in.`);
  if (player.beside.world)
    throw new Error(`${file.name} cannot be opened while two sides are compared: it is the state of one.`);
  const outcome = await player.openState(bytes);
  if (outcome instanceof WeftError) throw new Error(`${file.name}: ${outcome.message}`);
  return outcome;
}
