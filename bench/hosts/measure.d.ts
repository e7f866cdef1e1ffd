interface Summary {
  median: number;
  min: number;
  p95: number;
}
interface Where {
  scene: string;
  canvas: HTMLCanvasElement | null;
  gpu?: GPU;
}
export const STEPS_A_FRAME: number;
export function changes(n: number): Record<string, unknown>;
export function measureSteps(weft: typeof import("weft-cloth"), where: Where, n: number,
  frames: number): Promise<{ adapter: string; ms_per_step: Summary; state_hash: string }>;
export function measureHost(weft: typeof import("weft-cloth"), where: Where, frames: number): Promise<Summary>;
