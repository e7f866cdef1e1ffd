// The views and the legend of their colours.
import { VIEWS, type Catalog, type View, type WorldInfo } from "weft-cloth";
import { button, element } from "../elements.js";
import type { Player } from "../player.js";

/** Of the views that show a quantity by colour; the ends of the scale come from the core. */
const LEGENDS: Readonly<Partial<Record<string, { readonly title: string; readonly unit: string }>>> = {
  stretch: { title: "Length over rest length", unit: "" },
  velocity: { title: "Speed", unit: "m/s" },
  contacts: { title: "Contacts of a node", unit: "" },
};

const titleOf = (view: string): string => view[0]!.toUpperCase() + view.slice(1);

export class Views {
  private beforeWireframe: View = VIEWS[0];
  private readonly radios: readonly HTMLInputElement[];
  private readonly remark = element("refused-views", HTMLParagraphElement);
  private refused: WorldInfo["refusedViews"] = {};

  constructor(private readonly player: Player, private readonly catalog: Catalog,
    private readonly say: (sentence: string) => void) {
    this.radios = VIEWS.map((view, index) => {
      const radio = document.createElement("input");
      Object.assign(radio, { type: "radio", name: "view", value: view, disabled: true });
      radio.setAttribute("aria-keyshortcuts", String(index + 1));
      radio.addEventListener("change", () => this.choose(view));
      return radio;
    });
    element("views", HTMLDivElement).append(...this.radios.map((radio) => {
      const label = document.createElement("label");
      const name = document.createElement("span");
      name.textContent = titleOf(radio.value);
      label.append(radio, name);
      return label;
    }));
    element("legend-bar", HTMLDivElement).style.backgroundImage = `linear-gradient(to right, ${
      catalog.colors.map((color) => `rgb(${color.map((part) => Math.round(255 * part)).join(" ")})`).join(", ")
    })`;
    button("reset-camera").addEventListener("click", () => void player.resetCamera());
  }

  enable(on: boolean): void {
    for (const radio of this.radios) radio.disabled = !on || this.refusal(radio.value as View) !== null;
    button("reset-camera").disabled = !on;
  }

  /** Views that the scene has nothing to show in cannot be chosen; it says below them why. Before `enable`. */
  opened({ refusedViews }: WorldInfo): void {
    this.refused = refusedViews;
    for (const radio of this.radios) {
      if (this.refusal(radio.value as View) === null) radio.removeAttribute("aria-describedby");
      else radio.setAttribute("aria-describedby", this.remark.id);
    }
    if (this.refusal(this.beforeWireframe) !== null) this.beforeWireframe = VIEWS[0];
    this.remark.textContent = Object.values(refusedViews).join(" ");
    this.remark.hidden = this.remark.textContent === "";
  }

  private refusal(view: View): string | null {
    return this.refused[view] ?? null;
  }

  /** By pointer or by key. */
  choose(view: View): void {
    const refusal = this.refusal(view);
    if (refusal === null) void this.player.setView(view);
    else this.say(refusal);
  }

  viewed(view: View): void {
    if (view !== "wireframe") this.beforeWireframe = view;
    for (const radio of this.radios) radio.checked = radio.value === view;
    element("scene-title", HTMLParagraphElement).dataset["view"] = view; // each has its background
    const [legend, range] = [LEGENDS[view], this.catalog.ranges[view]];
    element("legend", HTMLElement).hidden = !legend || !range;
    if (!legend || !range) return;
    element("legend-title", HTMLElement).textContent = legend.title;
    for (const [id, value] of [["legend-low", range[0]], ["legend-high", range[1]]] as const)
      element(id, HTMLSpanElement).textContent = `${value} ${legend.unit}`.trim();
  }

  toggleWireframe(): void {
    void this.player.setView(this.player.shownView === "wireframe" ? this.beforeWireframe : "wireframe");
  }
}
