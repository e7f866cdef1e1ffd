// One method: its world, drawn on a canvas of its own, and what a frame of it takes.
import { createWorld, type Snapshot, type World } from "weft-cloth";
import { fitCamera } from "../src/fit_camera.js";
import { sentence } from "../src/sentence.js";
import { Times } from "../src/times.js";
import type { SceneByMethod } from "./scenes.js";
import { MOST_SWEEPS } from "./state.js";

/** Frames over which the median of their times is taken. */
export const KEPT = 30;

/** How far the visitor has turned the cameras about their targets [rad]. */
export interface Turned {
  dx: number;
  dy: number;
}

/** What a lane is to hold. */
export interface Opening {
  readonly kind: string;
  readonly substeps: number | "auto";
  /** Over the cloth, in a substep. */
  readonly sweeps: number;
  /** Throws where the scene has no room. */
  scene(): SceneByMethod;
}

/** Throws where a frame would keep a GPU busy for too long. */
function checkWork({ kind, sweeps }: Opening, substeps: number): void {
  if (substeps * sweeps <= MOST_SWEEPS) return;
  const [each, limit] = sweeps === 1 ? ["", MOST_SWEEPS] : [` of ${sweeps} sweeps`, `${MOST_SWEEPS} sweeps`];
  throw new Error(`${kind} needs ${substeps} substeps${each} a frame, more than the page's limit of ${limit}.`);
}

export class Lane {
  private world: World | null = null;
  private held = ""; // what the world was made for
  private fault_: string | null = null;
  private readonly times = new Times(KEPT);
  private start_: Snapshot | null = null;
  private size: readonly [width: number, height: number] | null = null; // of the picture, as it was told last

  /** `turned`: how all cameras are turned. `failed`: something went wrong that no call tells of. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly turned: Turned,
    private readonly failed: () => void) {}

  /** The world; null where the method has been refused or has failed. */
  get live(): World | null {
    return this.start_ ? this.world : null;
  }
  /** Why there is no world, in a sentence. */
  get fault(): string | null {
    return this.fault_;
  }
  /** The state at time 0. */
  get start(): Snapshot | null {
    return this.start_;
  }

  /** Of a frame, the median of the last ones [ms]. */
  get milliseconds(): number | null {
    return this.times.median;
  }

  /** The scene at rest. Does not reject: a refusal is `fault`. */
  async open(opening: Opening): Promise<void> {
    this.fault_ = null;
    this.start_ = null;
    this.times.clear();
    await this.guarded(async () => {
      if (opening.substeps !== "auto") checkWork(opening, opening.substeps); // before anything is compiled
      const options = opening.scene();
      const wanted = JSON.stringify([options.scene, options.set]);
      if (this.world && this.held === wanted) await this.world.reset();
      else await this.make(options, opening);
      this.held = wanted;
      const world = this.world!;
      this.start_ = await world.snapshot();
      await this.frame(world, this.start_);
    });
  }

  private async make(options: SceneByMethod, opening: Opening): Promise<void> {
    this.held = "";
    if (this.world) await this.world.load(options.scene, options);
    else {
      const world = await createWorld({ ...options, canvas: this.canvas });
      world.on("error", (reason) => {
        if (this.world !== world) return;
        this.fail(reason);
        this.failed();
      });
      this.world = world;
    }
    checkWork(opening, this.world.info.substeps);
  }

  /** The scene's camera, so far back that the cloth at rest is in the picture, turned as all of them are. */
  private async frame(world: World, start: Snapshot): Promise<void> {
    const [width, height] = this.size ?? [this.canvas.width, this.canvas.height];
    world.resetCamera();
    await world.resize(width, height); // after the camera, in its turn
    await fitCamera(world, width / height, start.positions);
    world.orbit(this.turned.dx, this.turned.dy);
  }

  /** Simulates a frame, waits until all of it is done, and draws nothing: the time is the method's alone. */
  async step(): Promise<void> {
    await this.guarded(async () => {
      const { live } = this;
      if (live) await this.times.measure(() => live.step(1, { draw: null }));
    });
  }

  async read(): Promise<Snapshot | null> {
    let state: Snapshot | null = null;
    await this.guarded(async () => {
      state = await this.live?.snapshot() ?? null;
    });
    return state;
  }

  /** When what was drawn is done. */
  async drained(): Promise<void> {
    await this.live?.device?.queue.onSubmittedWorkDone();
  }

  /** Sets the canvas's size in device pixels. */
  async resize(width: number, height: number): Promise<void> {
    this.size = [width, height]; // a lane that is being opened ends with it
    const { live, start } = this;
    if (live && start) await this.guarded(() => this.frame(live, start));
    else if (!this.world) [this.canvas.width, this.canvas.height] = [width, height]; // where a world that opens looks
  }

  dispose(): void {
    const { world } = this;
    this.world = null;
    this.start_ = null;
    world?.dispose();
  }

  private async guarded(action: () => Promise<void>): Promise<void> {
    try {
      await action();
    } catch (reason) {
      this.fail(reason);
    }
  }

  /** The next opening makes a new world, on a device of its own. */
  private fail(reason: unknown): void {
    this.dispose();
    this.fault_ ??= sentence(reason); // what comes after the first only follows from it
  }
}
