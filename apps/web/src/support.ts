// Why there may be no WebGPU, and what to do about it.

export interface Missing {
  cause: string;
  advice: string;
}

const BROWSERS = "Use a current Chrome or Edge, Firefox 141 or later on Windows, or Safari 26 or later.";
const LINUX = "In Chrome on Linux, open chrome://flags/#enable-unsafe-webgpu, enable it and restart the browser.";
const HARDWARE =
  "Turn on “Use graphics acceleration when available” in the browser's settings under System, restart the " +
  "browser, and bring the graphics driver up to date.";

const onLinux = (): boolean => /Linux/.test(navigator.userAgent) && !/Android/.test(navigator.userAgent);

/** What is missing; null where WebGPU has an adapter. */
export async function missingSupport(): Promise<Missing | null> {
  if (!window.isSecureContext)
    return { cause: "Browsers offer WebGPU only to secure pages, and this one came over plain HTTP.",
      advice: "Open it with https, or from localhost." };
  const gpu = (navigator as { gpu?: GPU }).gpu;
  if (!gpu)
    return { cause: "This browser has no WebGPU, which weft computes and draws the cloth with.",
      advice: onLinux() ? `${BROWSERS} ${LINUX}` : BROWSERS };
  const adapter = await gpu.requestAdapter({ powerPreference: "high-performance" }).catch(() => null);
  if (!adapter)
    return { cause: "This browser has WebGPU, but it finds no graphics adapter that WebGPU can use.",
      advice: onLinux() ? `${HARDWARE} ${LINUX}` : HARDWARE };
  return null;
}

/** Asked after a world could not be opened: whether it was for want of a device. */
export async function missingDevice(): Promise<Missing | null> {
  const missing = await missingSupport();
  if (missing) return missing;
  try {
    const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
    (await adapter?.requestDevice())?.destroy();
    return null;
  } catch {
    return { cause: "The graphics adapter is there, but it gives this page no WebGPU device.",
      advice: `Close other pages that use the graphics adapter and reload this one. ${HARDWARE}` };
  }
}
