// A call in the next frame of the display, or soon where there is none, as in Node.

export function schedule(callback: (now: number) => void): number {
  if (typeof requestAnimationFrame === "function") return requestAnimationFrame(callback);
  return setTimeout(() => callback(performance.now()), 1) as unknown as number;
}

export function unschedule(timer: number): void {
  if (typeof cancelAnimationFrame === "function") cancelAnimationFrame(timer);
  else clearTimeout(timer);
}
