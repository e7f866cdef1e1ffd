import { button, element } from "./elements.js";

/** Sentences to the user: over the cloth where they matter, and aloud where a screen reader is in use. */
export class Notice {
  private readonly box = element("notice", HTMLDivElement);
  private readonly line = element("notice-text", HTMLDivElement);
  private readonly announcer = element("announcer", HTMLParagraphElement);
  private readonly veil = element("veil", HTMLDivElement);

  constructor() {
    button("notice-close").addEventListener("click", () => {
      this.box.hidden = true;
      element("canvas", HTMLCanvasElement).focus();
    });
  }

  /** Something went wrong, or was put right; stays until it is closed or something else is said. */
  say(sentence: string, tone: "error" | "plain" = "error"): void {
    this.box.dataset["tone"] = tone;
    this.box.hidden = false;
    this.line.textContent = sentence;
  }

  /** What is said over the cloth; null: nothing. */
  get text(): string | null { return this.box.hidden ? null : this.line.textContent; }

  clear(): void { this.box.hidden = true; }

  /** A change of state that can be seen on the controls; for those who do not see them. */
  announce(sentence: string): void { this.announcer.textContent = sentence; }

  /** That something is under way, in front of the cloth; null: no longer. */
  wait(sentence: string | null): void {
    this.veil.hidden = sentence === null;
    element("veil-text", HTMLSpanElement).textContent = sentence ?? "";
    if (sentence !== null) this.announce(sentence);
  }
}
