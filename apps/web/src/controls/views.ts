// What is drawn, and what its colours mean.
import { VIEWS, type Catalog, type View } from "weft-cloth";
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

  constructor(private readonly player: Player, private readonly catalog: Catalog) {
    this.radios = VIEWS.map((view, index) => {
      const radio = document.createElement("input");
      Object.assign(radio, { type: "radio", name: "view", value: view, disabled: true });
      radio.setAttribute("aria-keyshortcuts", String(index + 1));
      radio.addEventListener("change", () => void player.setView(view));
      return radio;
    });
    element("views", HTMLDivElement).append(...this.radios.map((radio) => {
      const label = document.createElement("label");
      const name = document.createElement("span");
      name.textContent = titleOf(radio.value);
      label.append(radio, name);
      return label;
    }));
    element("legend-bar", HTMLDivElement).style.backgroundImage = `linear-gradient(to right, ${catalog.colors.map((color) =>
      `rgb(${color.map((part) => Math.round(255 * part)).join(" ")})`).join(", ")})`;
    button("reset-camera").addEventListener("click", () => void player.resetCamera());
  }

  enable(on: boolean): void { for (const each of [...this.radios, button("reset-camera")]) each.disabled = !on; }

  viewed(view: View): void {
    if (view !== "wireframe") this.beforeWireframe = view;
    for (const radio of this.radios) radio.checked = radio.value === view;
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
