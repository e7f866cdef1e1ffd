// Goes through sizes and paths, and keeps what was found.
import { CATALOG, type PathName } from "./catalog.js";
import { Gate, Stopped } from "./gate.js";
import { measure, type Timing } from "./measure.js";
import type { Options } from "./options.js";
import { HEIGHT, Unavailable, WIDTH, type Path } from "./paths/path.js";
import { sheetOf } from "./sheet.js";

export interface Cell {
  readonly path: PathName;
  readonly side: number;
  step: Timing | null;
  frame: Timing | null;
  /** Why something is missing. */
  note: string | null;
}

export const framesASecond = ({ frame }: Cell): number | null => (frame ? 1000 / frame.median : null);

const SLOWEST = 1; // frames a second; a path that is slower is not asked for larger sheets

export interface Listener {
  /** Something is measured now, drawn on this canvas. */
  began(cell: Cell, canvas: HTMLCanvasElement): void;
  changed(cell: Cell): void;
}

export class Runner {
  readonly cells: Cell[] = [];
  readonly gate = new Gate();
  /** Why larger sheets of a path are left out. */
  private readonly ended = new Map<PathName, string>();

  constructor(private readonly options: Options, private readonly scene: string, private readonly listener: Listener) {}

  /** True when it came to its end, false when it was stopped. */
  async run(): Promise<boolean> {
    const { sides, paths } = this.options;
    for (const side of sides)
      for (const path of paths) {
        const cell: Cell = { path, side, step: null, frame: null, note: this.ended.get(path) ?? null };
        this.cells.push(cell);
        try {
          if (cell.note === null) await this.fill(cell);
        } catch (reason) {
          if (reason instanceof Stopped) {
            cell.note = "Stopped.";
            this.listener.changed(cell);
            return false;
          }
          cell.note = reason instanceof Error ? reason.message : String(reason);
          this.ended.set(path, reason instanceof Unavailable ? cell.note : `Not run: ${side ** 2} nodes failed.`);
        }
        this.listener.changed(cell);
      }
    return true;
  }

  private async fill(cell: Cell): Promise<void> {
    const { gate, options: { budget } } = this;
    const canvas = freshCanvas();
    this.listener.began(cell, canvas);
    await gate.pass();
    const path = await openPath(cell.path, this.scene, [cell.side, cell.side], canvas);
    try {
      cell.frame = await measure((steps) => path.animate(steps), budget, gate); // first, to show a picture
      this.listener.changed(cell);
      cell.step = await measure((steps) => path.simulate(steps), budget, gate, path.leastSteps);
      if (!(await path.positions()).every(Number.isFinite)) cell.note = "In the end the state was not finite.";
    } finally {
      path.dispose();
    }
    const rate = framesASecond(cell);
    if (rate !== null && rate < SLOWEST)
      this.ended.set(cell.path, `Not run: ${rate.toFixed(2)} fps at ${cell.side ** 2} nodes.`);
  }
}

export function freshCanvas(): HTMLCanvasElement {
  return Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
}

export async function openPath(name: PathName, scene: string, [nx, ny]: readonly [number, number],
  canvas: HTMLCanvasElement): Promise<Path> {
  const open = await CATALOG.find((entry) => entry.name === name)!.load();
  return open(sheetOf(scene, nx, ny), canvas);
}
