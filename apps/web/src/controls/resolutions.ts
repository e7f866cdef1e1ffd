// How fine a scene's grid can be, and what memory each choice takes.
import { demand, inBytes, tooLarge, type Limits } from "../memory.js";
import { gridOf, type LoadedScene } from "../scenes.js";

const USUAL = [32, 64, 100, 128, 200, 256, 400, 512, 800, 1024, 1600, 2048] as const;

/** Of a scene with a grid: by nodes along the longer side, the usual ones, its own, and what is chosen. */
export function resolutionsOf(scene: LoadedScene, chosen: number | null, limits: Limits): HTMLOptionElement[] {
  const { grid, copies } = scene;
  if (!grid) return [];
  const { own, usual } = grid;
  const counts = new Set([...USUAL, usual, Math.max(...own), chosen ?? usual]);
  return [...counts].sort((a, b) => a - b).map((count) => {
    const [along, down] = gridOf(own, count);
    const asked = demand(along * down * copies, scene);
    const fault = tooLarge(asked, limits);
    const sheets = copies > 1 ? ` × ${copies} sheets` : "";
    const option = new Option(
      `${along} × ${down}${sheets}, ${fault ? "too large" : `about ${inBytes(asked.gpu)}`}`,
      String(count),
    );
    option.disabled = fault !== null;
    return option;
  });
}
