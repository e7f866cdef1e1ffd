import { element } from "./elements.js";
import type { Missing } from "./support.js";

/** Puts one sentence about what is missing, and one about what to do, in place of the canvas. */
export function showFallback(missing: Missing): void {
  document.body.classList.add("without-gpu");
  element("canvas", HTMLCanvasElement).hidden = true;
  element("fallback", HTMLElement).hidden = false;
  element("fallback-cause", HTMLParagraphElement).textContent = missing.cause;
  element("fallback-advice", HTMLParagraphElement).textContent = missing.advice;
  showReference(element("reference", HTMLDivElement));
}

/** The place of the reference on the CPU: the same cloth, small and slow, labelled as such. Empty until the core has it. */
function showReference(place: HTMLDivElement): void { place.hidden = true; }
