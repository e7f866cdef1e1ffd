// The scenes as pictures: what the page opens with, unless its address names one.
import { button, element } from "../elements.js";
import { SCENES } from "../scenes.js";

const PICTURES = import.meta.glob<string>("../gallery/*.webp", { query: "?url", import: "default", eager: true });

/** The address of a scene's picture; undefined where there is none. */
const pictureOf = (name: string): string | undefined => PICTURES[`../gallery/${name}.webp`];

export class Gallery {
  private readonly place = element("gallery", HTMLElement);
  private readonly canvas = element("canvas", HTMLCanvasElement);
  private readonly sides = element("sides", HTMLDivElement);
  private readonly cards: ReadonlyMap<string, HTMLButtonElement>;
  /** It covers the picture now, or does so no more. */
  onChange: (() => void) | null = null;

  constructor(choose: (scene: string) => void) {
    this.cards = new Map(SCENES.map(({ name, title }) => {
      const card = document.createElement("button");
      Object.assign(card, { type: "button", className: "card" });
      card.append(this.picture(name), Object.assign(document.createElement("span"), { textContent: title }));
      card.addEventListener("click", () => {
        this.close();
        choose(name);
      });
      return [name, card];
    }));
    element("gallery-list", HTMLUListElement).append(...[...this.cards.values()].map((card) => {
      const item = document.createElement("li");
      item.append(card);
      return item;
    }));
    button("gallery-open").addEventListener("click", () => this.toggle());
    button("gallery-close").addEventListener("click", () => this.close());
    this.place.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.close();
    });
  }

  private picture(name: string): HTMLImageElement {
    const image = new Image();
    Object.assign(image, { loading: "lazy", decoding: "async", alt: "", width: 384, height: 216 });
    const address = pictureOf(name);
    if (address !== undefined) image.src = address;
    return image;
  }

  get shown(): boolean {
    return !this.place.hidden;
  }

  /** The card of the scene that is shown. */
  mark(scene: string | null): void {
    for (const [name, card] of this.cards) {
      if (name === scene) card.setAttribute("aria-current", "true");
      else card.removeAttribute("aria-current");
    }
  }

  /** As the page's first sight: the focus stays where it is. */
  greet(): void {
    this.show(true);
  }

  toggle(): void {
    if (this.shown) return this.close();
    this.show(true);
    (this.place.querySelector<HTMLButtonElement>("[aria-current]") ?? button("gallery-close")).focus();
  }

  close(): void {
    if (!this.shown) return;
    const inside = this.place.contains(document.activeElement);
    this.show(false);
    if (inside) this.canvas.focus();
  }

  private show(on: boolean): void {
    this.place.hidden = !on;
    this.canvas.inert = this.sides.inert = on; // they are covered
    button("gallery-open").setAttribute("aria-expanded", String(on));
    this.onChange?.();
  }
}
