import { Latest } from "./latest.js";

const MOST_PIXELS = 4096; // along a side; beyond, a picture costs more than the eye gains

/** Device pixels, capped with the aspect kept. */
function capped(width: number, height: number): [width: number, height: number] {
  const scale = Math.min(1, MOST_PIXELS / Math.max(width, height));
  return [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
}

/** The canvas's size now, before an observer has said it. */
export function setFirstSize(canvas: HTMLCanvasElement): void {
  const { width, height } = canvas.getBoundingClientRect();
  [canvas.width, canvas.height] = capped(width * devicePixelRatio, height * devicePixelRatio);
}

/** Tells `resize` the canvas's size in device pixels whenever it changes. */
export function followSize(canvas: HTMLCanvasElement, resize: (width: number, height: number) => Promise<void>): void {
  const latest = new Latest<[number, number]>(([width, height]) => resize(width, height));
  const observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const exact = entry.devicePixelContentBoxSize?.[0];
    const { inlineSize, blockSize } = entry.contentBoxSize[0]!;
    const [width, height] = exact ?
      capped(exact.inlineSize, exact.blockSize) :
      capped(inlineSize * devicePixelRatio, blockSize * devicePixelRatio);
    if (inlineSize > 0 && blockSize > 0) latest.set([width, height]);
  });
  try {
    observer.observe(canvas, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(canvas); // Safari has no such box
  }
}
