// The comparison's part of the panel, and what stands on the picture: the divider, and what each side is.
import type { Catalog, WorldInfo } from "weft-cloth";
import { short } from "../digits.js";
import { button, element, input, select } from "../elements.js";
import type { Limits } from "../memory.js";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import { NODES, withOther } from "../state/comparison.js";
import type { Comparison, PageState, Value } from "../state/page_state.js";
import { FABRIC, SOLVER, solversOf } from "../state/parameters.js";
import { spoken } from "./choices.js";
import { resolutionsOf } from "./resolutions.js";

const REFRESH = 500; // times that change faster cannot be read [ms]
const SAME = ""; // of a list: as on the left

export class Comparing {
  private readonly lists: readonly (readonly [list: HTMLSelectElement, key: string])[] = [
    [select("other-solver"), SOLVER],
    [select("other-fabric"), FABRIC],
    [select("other-resolution"), NODES],
  ];
  private readonly end = button("compare-end");
  private readonly stage = element("stage", HTMLElement);
  private readonly sides = element("sides", HTMLDivElement);
  private readonly divider = input("divider");
  private readonly labels = { left: element("left-side", HTMLSpanElement),
    right: element("right-side", HTMLSpanElement) };
  private shownAt = 0; // when the labels were written last [ms]
  private late: ReturnType<typeof setTimeout> | undefined;

  constructor(catalog: Catalog, private readonly limits: Limits, private readonly player: Player) {
    this.fill(SOLVER, solversOf(catalog).map((word) => new Option(word, word)));
    this.fill(FABRIC, catalog.fabrics.map(({ name }) => new Option(spoken(name), name)));
    for (const [list, key] of this.lists)
      list.addEventListener("change", () => {
        const value: Value = key === NODES ? Number(list.value) : list.value;
        void player.compare(withOther(player.state.compare, key, list.value === SAME ? null : value));
      });
    this.end.addEventListener("click", () => {
      this.lists[0]![0].focus(); // the button will be disabled
      void player.compare(null);
    });
    this.divider.addEventListener("input", () => player.divide(Number(this.divider.value)));
  }

  private fill(wanted: string, options: readonly HTMLOptionElement[]): void {
    const list = this.lists.find(([, key]) => key === wanted)![0];
    list.replaceChildren(new Option("As on the left", SAME), ...options);
  }

  enable(on: boolean): void {
    for (const [list, key] of this.lists) list.disabled = !on || (key === NODES && !this.player.loaded?.grid);
    this.end.disabled = !on || !this.player.state.compare;
  }

  opened(scene: LoadedScene): void {
    const chosen = scene.state.compare?.other[NODES];
    this.fill(NODES, resolutionsOf(scene, chosen === undefined ? null : Number(chosen), this.limits));
  }

  /** What is other, and where the divider stands. */
  show({ compare }: PageState): void {
    for (const [list, key] of this.lists) list.value = String(compare?.other[key] ?? SAME);
    this.end.disabled = !compare || !this.player.live;
    if (compare) this.place(compare);
  }

  private place({ divider }: Comparison): void {
    this.stage.style.setProperty("--part", String(divider / 100));
    this.divider.value = String(divider);
    this.divider.setAttribute("aria-valuetext", `${divider} % left, ${100 - divider} % right`);
  }

  /** There is another side now, or none any more. */
  compared(): void {
    const on = this.player.beside.world !== null;
    this.sides.hidden = !on;
    this.stage.dataset["compared"] = String(on);
    this.show(this.player.state);
    this.tell();
  }

  /** A frame has been simulated or drawn. */
  frame(now: number): void {
    clearTimeout(this.late);
    if (now - this.shownAt >= REFRESH) this.tell();
    else this.late = setTimeout(() => this.tell(), REFRESH); // the last before a pause counts
  }

  private tell(): void {
    const { live, loaded, beside } = this.player;
    const { world, scene, milliseconds } = beside;
    this.shownAt = performance.now();
    if (!live || !loaded || !world || !scene) return;
    const other = this.player.state.compare?.other ?? {};
    const words = (of: LoadedScene, info: WorldInfo, time: number | null) =>
      [
        ...(FABRIC in other ? [spoken(String(of.now(FABRIC) ?? "springs"))] : []),
        ...(SOLVER in other || live.info.solver !== world.info.solver ? [info.solver] : []),
        ...(NODES in other && of.grid ? [`${of.grid.taken.join(" × ")} nodes`] : []),
        `${info.substeps} substeps`,
        ...(time === null ? [] : [`${short(time)} ms`]),
      ].map((part) => part.replaceAll(" ", "\u00a0")).join(", ");
    this.labels.left.textContent = words(loaded, live.info, milliseconds.left);
    this.labels.right.textContent = words(scene, world.info, milliseconds.right);
  }
}
