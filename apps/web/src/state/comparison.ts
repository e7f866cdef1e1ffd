// What is other on the right side of a comparison, and the state of a page that shows that side alone.
import type { LoadedScene } from "../scenes.js";
import type { Comparison, PageState, Value } from "./page_state.js";
import { FABRIC, ownMethod, SOLVER, withChoice, withMethod, withNodes } from "./parameters.js";

/** Nodes along the longer side, as the address names them too. */
export const NODES = "nodes";
/** What may be other. */
export const COMPARED: readonly string[] = [SOLVER, FABRIC, NODES];
/** Where the divider stands at first [% of its way]. */
export const MIDDLE = 50;

/** With another choice on the right; null: as on the left. Where nothing is other, nothing is compared. */
export function withOther(compare: Comparison | null, key: string, value: Value | null): Comparison | null {
  const { [key]: _, ...rest } = compare?.other ?? {};
  const other = value === null ? rest : { ...rest, [key]: value };
  return Object.keys(other).length === 0 ? null : { other, divider: compare?.divider ?? MIDDLE };
}

/** The right side by itself. A fabric comes first, as it brings a method of its own. */
export function rightOf(state: PageState, scene: LoadedScene): PageState {
  const { [SOLVER]: method, [FABRIC]: fabric, [NODES]: nodes } = state.compare?.other ?? {};
  let right: PageState = { ...state, compare: null };
  if (fabric !== undefined) right = withChoice(right, FABRIC, fabric);
  if (method !== undefined) right = withMethod(right, method === ownMethod(scene, right) ? null : String(method));
  if (nodes !== undefined) right = withNodes(right, Number(nodes));
  return right;
}
