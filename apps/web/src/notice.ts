import { button, element } from "./elements.js";

/** A plain one goes by itself. An error or a warning stays until it is closed or the page goes on to another scene. */
export type Tone = "error" | "warning" | "plain";

/** Something that the visitor can do about it. */
export interface Offer {
  readonly label: string;
  act(): void;
}

interface Said {
  readonly sentence: string;
  readonly tone: Tone;
  readonly offer: Offer | null;
}

const PLAIN_STAYS = 5000; // [ms]

/** Sentences to the user: over the cloth where they matter, and aloud where a screen reader is in use. */
export class Notice {
  private readonly box = element("notice", HTMLDivElement);
  private readonly line = element("notice-text", HTMLDivElement);
  private readonly offer = button("notice-offer");
  private readonly announcer = element("announcer", HTMLParagraphElement);
  private readonly veil = element("veil", HTMLDivElement);
  private standing: Said | null = null; // the error or warning that nobody has closed
  private shown: Said | null = null;
  private end: ReturnType<typeof setTimeout> | undefined; // of a plain one

  constructor() {
    const canvas = element("canvas", HTMLCanvasElement);
    button("notice-close").addEventListener("click", () => {
      if (this.shown === this.standing) this.standing = null;
      this.show(this.standing);
      if (!this.shown) canvas.focus();
    });
    this.offer.addEventListener("click", () => {
      canvas.focus();
      this.shown?.offer?.act();
    });
  }

  /** A warning does not take the place of an error. */
  say(sentence: string, tone: Tone = "error", offer: Offer | null = null): void {
    const said = { sentence, tone, offer };
    if (tone === "warning" && this.standing?.tone === "error") return;
    if (tone !== "plain") this.standing = said;
    this.show(said);
  }

  /** The notice over the cloth; null: none. */
  get text(): string | null {
    return this.shown?.sentence ?? null;
  }

  clear(): void {
    this.standing = null;
    this.show(null);
  }

  /** What made the cloth stop has been read, or is no longer so. */
  clearError(): void {
    if (this.standing?.tone === "error") this.standing = null;
    this.show(this.standing);
  }

  private show(said: Said | null): void {
    clearTimeout(this.end);
    this.shown = said;
    this.box.hidden = said === null;
    if (!said) return;
    this.box.dataset["tone"] = said.tone;
    this.line.textContent = said.sentence;
    this.offer.hidden = said.offer === null;
    this.offer.textContent = said.offer?.label ?? "";
    if (said.tone === "plain") this.endLater();
  }

  /** Not under a pointer or with the focus in it: it is being read. */
  private endLater(): void {
    this.end = setTimeout(() => {
      if (this.box.matches(":hover, :focus-within")) this.endLater();
      else this.show(this.standing);
    }, PLAIN_STAYS);
  }

  /** A change of state that can be seen on the controls; for those who do not see them. */
  announce(sentence: string): void {
    this.announcer.textContent = sentence;
  }

  /** That something is under way, in front of the cloth; null: no longer. */
  wait(sentence: string | null): void {
    this.veil.hidden = sentence === null;
    element("veil-text", HTMLSpanElement).textContent = sentence ?? "";
    if (sentence !== null) this.announce(sentence);
  }
}
