import { button, element } from "./elements.js";
import type { Missing } from "./support.js";

/** Says what is missing and what to do in place of the canvas; below, the cloth as the CPU computes it. */
export function showFallback(missing: Missing): void {
  document.body.classList.add("without-gpu");
  element("canvas", HTMLCanvasElement).hidden = true;
  element("fallback", HTMLElement).hidden = false;
  element("fallback-cause", HTMLParagraphElement).textContent = missing.cause;
  element("fallback-advice", HTMLParagraphElement).textContent = missing.advice;
  void showReference();
}

/** The cloth that needs no WebGPU: coarse, by the reference on the CPU, and labelled as such. */
async function showReference(): Promise<void> {
  const place = element("reference", HTMLElement);
  const note = element("reference-note", HTMLParagraphElement);
  const play = button("reference-play");
  place.hidden = false; // its canvas needs a size
  try {
    const { ReferencePlayer } = await import("./reference_player.js"); // few pages need it
    const player = await ReferencePlayer.create(element("reference-canvas", HTMLCanvasElement), {
      playing(on) {
        play.dataset["playing"] = String(on);
        element("reference-play-label", HTMLSpanElement).textContent = on ? "Pause" : "Play";
      },
      failed: (sentence) => {
        note.textContent = sentence;
      },
    });
    element("reference-label", HTMLElement).textContent = `CPU reference, ${
      player.grid.join("\u00a0×\u00a0")
    } nodes, double precision`;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    note.textContent = "Without WebGPU this is what the page can show. Drag to turn it." +
      (still ? " Your system asks for less motion, so it waits until you press Play." : "");
    play.disabled = false;
    play.addEventListener("click", () => player.play(!player.playing));
    player.draw();
    player.play(!still);
  } catch (reason) {
    place.classList.add("failed");
    note.textContent = `The reference on the CPU does not run here either: ${
      reason instanceof Error ? reason.message : String(reason)
    }`;
  }
}
