import { button, element } from "./elements.js";

/** Sentences to the user: over the cloth where they matter, and aloud where a screen reader is in use. */
export class Notice {
  private readonly box = element("notice", HTMLDivElement);
  private readonly text = element("notice-text", HTMLDivElement);
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
    this.text.textContent = sentence;
  }

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
