// The reference on the CPU, played in real time and drawn on a 2D canvas: what a page without WebGPU can show.
import { catalog, createReference, VIEWS, type Reference } from "weft-cloth";
import { followSize, setFirstSize } from "./canvas_size.js";
import { ClothSketch, type Look } from "./cloth_sketch.js";
import { fetchScene, type Grid } from "./scenes.js";
import { plain } from "./state/page_state.js";
import { Ticks } from "./ticks.js";
import { turnBy } from "./turning.js";

/** Always in motion. 24 × 18 nodes take a fifth of a frame with drawing (docs/reference.md), for slower machines. */
const SHOWN = { ...plain("breeze", VIEWS[0]), nodes: 24 };

export interface ReferencePlayerEvents {
  playing(on: boolean): void;
  failed(sentence: string): void;
}

export class ReferencePlayer {
  private wanted = false; // by who looks at it
  private readonly ticks = new Ticks((elapsed) => this.tick(elapsed));
  private due = 0; // simulated time that has come due since the last frame [s]

  private constructor(private readonly reference: Reference, private readonly sketch: ClothSketch,
    private readonly canvas: HTMLCanvasElement, readonly grid: Grid, private readonly events: ReferencePlayerEvents) {
    setFirstSize(canvas);
    followSize(canvas, async (width, height) => {
      [canvas.width, canvas.height] = [width, height];
      this.draw(); // at once: a canvas that changes its size is empty
    });
    this.listen();
  }

  /** Builds the scene and draws it at rest. */
  static async create(canvas: HTMLCanvasElement, events: ReferencePlayerEvents): Promise<ReferencePlayer> {
    const { json, set } = await fetchScene(SHOWN, await catalog());
    const { camera } = JSON.parse(json) as {
      camera: { eye: Look["eye"]; target: Look["target"]; fov_degrees: number };
    };
    const reference = await createReference({ scene: json, set });
    const context = canvas.getContext("2d");
    if (!context) throw new Error("The canvas gives no context to draw in.");
    const grid = set["cloths.0.grid"] as Grid;
    const sketch = new ClothSketch(canvas, context, reference.triangles, grid, { eye: camera.eye, target: camera.target,
      fov: camera.fov_degrees });
    return new ReferencePlayer(reference, sketch, canvas, grid, events);
  }

  get playing(): boolean {
    return this.wanted;
  }

  play(on: boolean): void {
    this.wanted = on;
    this.schedule();
    this.events.playing(on);
  }

  draw(): void {
    this.sketch.draw(this.reference.positions());
  }

  // Time

  private schedule(): void {
    if (!this.ticks.running) this.due = 0;
    this.ticks.run(this.wanted && !document.hidden);
  }

  private tick(elapsed: number): void {
    const { frameSeconds } = this.reference.info;
    // As World does: what is late by more than a frame is dropped, and half a millisecond of slack keeps one a tick.
    this.due = Math.min(this.due + elapsed / 1000, 2 * frameSeconds);
    if (this.due + 5e-4 < frameSeconds) return;
    this.due -= frameSeconds;
    try {
      this.reference.advance();
      this.draw();
    } catch (reason) {
      this.play(false);
      this.events.failed(reason instanceof Error ? reason.message : String(reason));
    }
  }

  // Hands

  private listen(): void {
    document.addEventListener("visibilitychange", () => this.schedule());
    turnBy(this.canvas, (dx, dy) => this.orbit(dx, dy));
  }

  private orbit(dx: number, dy: number): void {
    this.sketch.orbit(dx, dy);
    if (!this.ticks.running) this.draw();
  }
}
