// The panel's buttons, lists and sliders, and the keys that do the same.
import { VIEWS, type View } from "weft";
import { button, element, input, select } from "./elements.js";
import { Latest } from "./latest.js";
import type { Player } from "./player.js";
import { gridOf, RESOLUTIONS, SCENES, type Choice, type LoadedScene } from "./scenes.js";

const VIEW_NAMES: Record<View, string> = {
  textured: "Textured", wireframe: "Wireframe", normals: "Normals", stretch: "Stretch" };
const MOST_WIND = 2; // times the scene's own

export class Controls {
  private readonly scene = select("scene");
  private readonly resolution = select("resolution");
  private readonly wind = input("wind");
  private readonly transport = ["play", "step", "reset", "reset-camera"].map(button);
  private viewBeforeWireframe: View = "textured";
  private shown: LoadedScene | null = null;
  private readonly blow = new Latest<readonly [number, number, number]>((velocity) => this.player.setWind(velocity));

  constructor(private readonly player: Player, open: (choice: Choice) => void) {
    this.scene.replaceChildren(...SCENES.map(({ name, title }) => new Option(title, name)));
    this.scene.addEventListener("change", () => open({ name: this.scene.value, nodes: null }));
    this.resolution.addEventListener("change", () =>
      open({ name: this.scene.value, nodes: Number(this.resolution.value) || null }));
    button("play").addEventListener("click", () => player.play(!player.playing));
    button("step").addEventListener("click", () => void player.step());
    button("reset").addEventListener("click", () => void player.reset());
    button("reset-camera").addEventListener("click", () => void player.resetCamera());
    this.wind.addEventListener("input", () => this.setWind());
    this.addViews();
    this.addSheet();
    document.addEventListener("keydown", (event) => this.onKey(event));
  }

  // What the player says

  opening(): void {
    for (const each of this.transport) each.disabled = true;
    this.enableViews(false);
    this.scene.disabled = this.resolution.disabled = false; // another choice may replace one that takes long
  }

  opened(scene: LoadedScene): void {
    this.shown = scene;
    for (const each of this.transport) each.disabled = false;
    this.enableViews(true);
    this.scene.disabled = false;
    this.scene.value = scene.choice.name;
    this.fillResolutions(scene);
    const wind = scene.wind && Math.hypot(...scene.wind);
    element("wind-field", HTMLDivElement).hidden = !wind;
    if (!wind) return;
    this.wind.max = String(MOST_WIND * wind);
    this.wind.value = String(wind);
    this.showWind();
  }

  empty(): void {
    this.opening();
    this.shown = null;
    // Any choice must count as a change, so none is shown as made.
    this.scene.selectedIndex = -1;
    this.resolution.replaceChildren();
    this.resolution.disabled = true;
  }

  playing(on: boolean): void {
    element("play-label", HTMLSpanElement).textContent = on ? "Pause" : "Play";
    button("play").dataset["playing"] = String(on);
  }

  viewed(view: View): void {
    if (view !== "wireframe") this.viewBeforeWireframe = view;
    for (const radio of this.views()) radio.checked = radio.value === view;
  }

  // Building

  private fillResolutions({ ownGrid, choice }: LoadedScene): void {
    this.resolution.disabled = ownGrid === null;
    if (!ownGrid) return this.resolution.replaceChildren(new Option("as its mesh has", ""));
    const own = Math.max(...ownGrid);
    const chosen = choice.nodes ?? own;
    const counts = [...new Set([...RESOLUTIONS, own, chosen])].sort((a, b) => a - b);
    this.resolution.replaceChildren(...counts.map((count) => {
      const grid = gridOf(ownGrid, count).join(" × ");
      return new Option(count === own ? `${grid} (the scene's)` : grid, String(count), false, count === chosen);
    }));
  }

  private addViews(): void {
    element("views", HTMLDivElement).append(...VIEWS.map((view, index) => {
      const label = document.createElement("label");
      const radio = document.createElement("input");
      Object.assign(radio, { type: "radio", name: "view", value: view, checked: index === 0, disabled: true });
      radio.setAttribute("aria-keyshortcuts", String(index + 1));
      radio.addEventListener("change", () => void this.player.setView(view));
      const name = document.createElement("span");
      name.textContent = VIEW_NAMES[view];
      label.append(radio, name);
      return label;
    }));
  }

  private views(): HTMLInputElement[] {
    return [...element("views", HTMLDivElement).querySelectorAll("input")];
  }

  private enableViews(on: boolean): void { for (const radio of this.views()) radio.disabled = !on; }

  /** On a phone the panel is a sheet, with all but the first row folded away. */
  private addSheet(): void {
    const more = button("more");
    more.addEventListener("click", () => {
      const unfolded = element("controls", HTMLElement).classList.toggle("unfolded");
      more.setAttribute("aria-expanded", String(unfolded));
      element("more-label", HTMLSpanElement).textContent = unfolded ? "Less" : "More";
    });
  }

  // Wind

  private setWind(): void {
    const own = this.shown?.wind;
    if (!own) return;
    const factor = Number(this.wind.value) / Math.hypot(...own);
    this.blow.set([own[0] * factor, own[1] * factor, own[2] * factor]);
    this.showWind();
  }

  private showWind(): void {
    const text = `${Number(this.wind.value).toFixed(1)} m/s`;
    element("wind-value", HTMLOutputElement).textContent = text;
    this.wind.setAttribute("aria-valuetext", text);
  }

  // Keys

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat || !input("shortcuts").checked) return;
    const target = event.target instanceof Element ? event.target : document.body;
    if (target.closest("select")) return; // letters and digits choose there
    if (event.key === " " && target.closest("button, input, summary, a")) return; // it presses what has the focus
    const action = this.actionOf(event.key.toLowerCase());
    if (!action || !this.player.live) return;
    event.preventDefault();
    action();
  }

  private actionOf(key: string): (() => void) | null {
    const view = VIEWS[Number(key) - 1];
    if (view) return () => void this.player.setView(view);
    switch (key) {
      case " ": return () => this.player.play(!this.player.playing);
      case ".": return () => void this.player.step();
      case "r": return () => void this.player.reset();
      case "f": return () => void this.player.resetCamera();
      case "x": return () => void this.player.setView(
        this.player.shownView === "wireframe" ? this.viewBeforeWireframe : "wireframe");
      default: return null;
    }
  }
}
