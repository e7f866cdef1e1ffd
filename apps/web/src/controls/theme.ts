// Dark or light: as the system says, until it is chosen here. The choice is kept for the next visit.
import { button, element } from "../elements.js";

const KEPT = "weft-theme";
type Look = "dark" | "light";

const system = matchMedia("(prefers-color-scheme: light)");

/** Storage may be forbidden; then a choice lasts as long as the page. */
function kept(): Look | null {
  try {
    const value = localStorage.getItem(KEPT);
    return value === "dark" || value === "light" ? value : null;
  } catch {
    return null;
  }
}

export class Theme {
  private chosen = kept();
  /** Called when colours have changed. */
  onChange: (() => void) | null = null;

  constructor() {
    button("theme").addEventListener("click", () => this.toggle());
    system.addEventListener("change", () => this.show());
    this.show();
  }

  private get now(): Look {
    return this.chosen ?? (system.matches ? "light" : "dark");
  }

  toggle(): void {
    this.chosen = this.now === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(KEPT, this.chosen);
    } catch {
      // It lasts as long as the page.
    }
    this.show();
  }

  private show(): void {
    if (this.chosen) document.documentElement.dataset["theme"] = this.chosen;
    element("theme-label", HTMLSpanElement).textContent = this.now === "dark" ? "Light theme" : "Dark theme";
    this.onChange?.();
  }
}
