import { Core } from "./core.js";
import { WeftError } from "./error.js";
import { numbersOf, type Placement } from "./placement.js";
import { changeLines, sceneText, type Scene } from "./scene.js";
import { schedule, unschedule } from "./ticks.js";
import { noTotals, TOTALS } from "./totals.js";
import { VIEWS, type Camera, type Events, type Measures, type MemoryUse, type OpenedState, type PassTime, type Pick,
  type Point, type Probe, type SceneOptions, type Snapshot, type Statistics, type Step, type StepOptions, type View,
  type WorldBuffers, type WorldInfo, type WorldOptions } from "./world_types.js";

/** Opens a device, builds the scene and, with a canvas, draws it at rest. Does not run yet. */
export async function createWorld(options: WorldOptions): Promise<World> {
  const gpu = options.gpu ?? (globalThis.navigator as Navigator | undefined)?.gpu;
  const world = new World(await Core.create(gpu, options.device), options);
  try {
    await world.open();
    await world.load(options.scene, options);
  } catch (reason) {
    world.dispose();
    throw reason;
  }
  return world;
}

/**
 * A running scene. Lengths are metres, times seconds. Places on the canvas are in clip coordinates: x from -1 at the
 * left to 1, y from -1 at the bottom to 1. Calls that return a promise are carried out one after the other.
 */
export class World {
  private readonly canvas: WorldOptions["canvas"];
  private readonly adapter: string;
  private readonly sharesDevice: boolean;
  private readonly listeners: { [name in keyof Events]: Set<(event: Events[name]) => void> } = {
    frame: new Set(),
    step: new Set(),
    mesh: new Set(),
    news: new Set(),
    error: new Set(),
  };
  private current: WorldInfo | null = null;
  private scene: { scene: Scene; set: Readonly<Record<string, unknown>> } = { scene: "", set: {} };
  private readonly totals: Statistics = { ...noTotals(), seconds: 0, droppedSeconds: 0 };
  private shownView: View;
  private playing = false;
  private lastTick = 0;
  private due = 0; // simulated time that has come due since the last frame [s]
  private stale = true; // whether the canvas shows something else than it would now
  private timer = 0;
  private disposed = false;
  private changing = false; // whether a frame waits for the mesh
  private hostTime = 0; // [ms]
  private lossTold = false;

  /** @internal */
  constructor(private readonly core: Core, options: WorldOptions) {
    this.canvas = options.canvas;
    this.adapter = options.adapter ?? "";
    this.sharesDevice = options.device !== undefined;
    this.shownView = known(options.view ?? "textured");
    core.onAwake = () => this.readTotals(); // of what the call has changed or taken in
    core.backend.onLost = (message) => this.fail(new WeftError("device-lost", `The GPU device is lost: ${message}.`));
  }

  /** @internal */
  async open(): Promise<void> {
    await this.core.sleep("open", [this.adapter]);
    this.lossTold = false;
    if (!this.canvas) return;
    const context = (this.canvas as HTMLCanvasElement).getContext("webgpu");
    if (!context) throw new WeftError("failure", "The canvas gives no WebGPU context: it has another one already.");
    const { handle, format } = this.core.backend.attachCanvas(context);
    await this.core.sleep("canvas", [handle, format, this.canvas.width, this.canvas.height]);
    await this.core.sleep("view", [VIEWS.indexOf(this.shownView)]);
  }

  get info(): WorldInfo {
    if (!this.current) throw new WeftError("failure", "No scene is loaded.");
    return this.current;
  }
  get statistics(): Readonly<Statistics> {
    return this.totals;
  }
  /** What the last frame of run cost this thread, JavaScript and WebAssembly, drawing included [ms]. */
  get hostMilliseconds(): number {
    return this.hostTime;
  }
  get running(): boolean {
    return this.playing;
  }
  /** Whether a call is under way; what returns at once then throws. */
  get busy(): boolean {
    return this.core.busy;
  }
  /** Whether the module has ended, most likely for want of memory: every call fails, and only a new world helps. */
  get stopped(): boolean {
    return this.core.stopped;
  }
  get view(): View {
    return this.shownView;
  }

  on<Name extends keyof Events>(name: Name, listener: (event: Events[Name]) => void): () => void {
    this.listeners[name].add(listener);
    return () => void this.listeners[name].delete(listener);
  }

  /** Replaces the scene on the same device. Where it cannot be built, no scene is loaded any more. */
  async load(scene: Scene, { meshes = {}, set = {} }: SceneOptions = {}): Promise<void> {
    this.playing = false;
    await this.core.turn(async () => {
      this.current = null;
      this.scene = { scene, set };
      await this.core.addMeshes(meshes);
      await this.core.sleepNow("load", [sceneText(scene), changeLines(set)]);
      this.current = this.describe();
      this.shownView = this.current.view;
      this.totals.droppedSeconds = 0;
    });
    this.changed();
  }

  private describe(): WorldInfo {
    this.core.call("describe");
    return JSON.parse(this.core.text()) as WorldInfo;
  }

  /**
   * After a loss: a new device, and the scene that was loaded last from its rest state. On a device of the page's own
   * only a new world can.
   */
  async recover(): Promise<void> {
    if (this.sharesDevice)
      throw new WeftError("device-lost", "The lost device is the page's own; make a new world on a new one.");
    this.playing = false;
    this.current = null;
    await this.open();
    await this.load(this.scene.scene, { set: this.scene.set });
  }

  // Time

  /** Plays in real time, as far as the machine can. */
  run(): void {
    this.loaded();
    if (this.playing) return;
    this.playing = true;
    this.lastTick = performance.now();
    this.due = 0;
    this.schedule();
  }

  /** Stops, and takes in what the frames under way report. */
  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    if (this.current) this.later("finish");
  }

  /** Simulates this many frames and waits for them. Draws each of them, or else the last, or none. */
  async step(frames = 1, { draw = false }: StepOptions = {}): Promise<Statistics> {
    for (let i = 0; i < frames;) {
      const went = await this.core.turn(async () => {
        this.loaded();
        if (this.core.now("_weft_has_room") === 0) return false;
        if (this.info.changesMesh) await this.changeMesh();
        this.core.checkNow(draw ? "_weft_advance_and_draw" : "_weft_advance");
        return true;
      });
      if (went) i += 1;
      else {
        await this.core.takeReport();
        this.readTotals();
      }
    }
    const totals = await this.core.sleep("finish", [], () => ({ ...this.totals }));
    if (draw === false) this.changed();
    return totals;
  }

  /** Back to the rest state at time 0; grabbed nodes are let go. */
  async reset(): Promise<void> {
    this.loaded();
    await this.core.sleep("reset");
    if (this.info.changesMesh) this.tellMesh();
    this.totals.droppedSeconds = 0;
    this.changed();
  }

  // Change

  /**
   * Changes a key of the scene while it moves: `gravity`, `external_force`, `drag`, `wind.velocity`, `wind.gusts`,
   * `wind.wavelength`, those of `air` where the scene has it, and what it looks like: `color` and `look` of cloths,
   * `material` of colliders and `render.light`. null takes the key out of the scene. Any other is refused: load the
   * scene again with `set`.
   */
  async setParameter(key: string, value: unknown): Promise<void> {
    this.loaded();
    await this.core.sleep("set", [key, JSON.stringify(value)]);
    this.changed();
  }

  /**
   * Takes hold of a node: from now on it is drawn to `target`, by a force as it were, with a bounded speed. At once
   * `catalog().mostGrabs` nodes can be. Errors: "input", a node that is pinned, moved or grabbed; "limit", one too
   * many.
   */
  async grab(node: number, target: Point): Promise<void> {
    this.loaded();
    await this.core.sleep("grab", [index(node), ...target]);
  }
  /** Moves the target of a grabbed node. */
  async drag(node: number, target: Point): Promise<void> {
    this.loaded();
    await this.core.sleep("drag", [index(node), ...target]);
  }
  async release(node: number): Promise<void> {
    this.loaded();
    await this.core.sleep("release", [index(node)]);
  }

  /**
   * Moves a collider that the scene gives a motion of kind "given", with all that is attached to it: through the next
   * frame, at constant velocity and spin, which cloth in contact feels, and there it stays. Called again before that
   * frame, it counts instead. `placement` may be the 16 numbers of a matrix, column by column, as three.js's
   * `matrixWorld.elements`. Errors "input", and it does not move: another collider, by its place in the scene's list; a
   * number that is not finite, a rotation that is none, a matrix that scales; faster than the motion's `speed`.
   */
  async setCollider(collider: number, placement: Placement | ArrayLike<number>): Promise<void> {
    this.loaded();
    const numbers = Float64Array.of(index(collider, "Collider"), ...numbersOf(placement));
    await this.core.turn(() => {
      this.loaded();
      return this.core.sleepWithBytesNow("set_collider", new Uint8Array(numbers.buffer), () => undefined);
    });
  }

  // Look

  /** The node of the cloth under a place on the canvas. */
  async pick(x: number, y: number): Promise<Pick | null> {
    this.loaded();
    const [node, ...point] = await this.core.sleep("pick", [x, y], () => this.numbers("picked", 4)) as [number, number,
      number, number];
    return node < 0 ? null : { node, point };
  }

  /** The nodes under a rectangle of the canvas between two corners, seen or hidden by others, in rising order. */
  async pickWithin(ax: number, ay: number, bx: number, by: number): Promise<Uint32Array> {
    this.loaded();
    return this.core.sleep("pick_within", [ax, ay, bx, by], () => {
      const at = this.core.call("picked_within") >>> 2;
      return this.core.module.HEAPU32.slice(at, at + this.core.call("picked_count"));
    });
  }

  /** The point under a place on the canvas that is as far from the camera's plane as `reference`. */
  pointAt(x: number, y: number, reference: Point): Point {
    return this.numbers("point_at", 3, x, y, ...reference) as [number, number, number];
  }

  /** Where a point is seen on the canvas. */
  project(point: Point): [x: number, y: number] {
    return this.numbers("project", 2, ...point) as [number, number];
  }

  get camera(): Camera {
    const n = this.numbers("camera", 7) as [number, number, number, number, number, number, number];
    return { eye: [n[0], n[1], n[2]], target: [n[3], n[4], n[5]], fov: n[6] };
  }
  set camera({ eye, target, fov }: Camera) {
    this.look("set_camera", ...eye, ...target, fov);
  }
  /** Turns the eye about the target, to the right and upwards [rad]: for a scene that follows a pointer, negate. */
  orbit(dx: number, dy: number): void {
    this.look("orbit", dx, dy);
  }
  /** Moves the picture to the right and upwards, in picture heights. */
  pan(dx: number, dy: number): void {
    this.look("pan", dx, dy);
  }
  /** What is looked at becomes `factor` times as large. */
  zoom(factor: number): void {
    if (!(factor > 0)) throw new WeftError("input", `A picture cannot become ${factor} times as large.`);
    this.look("zoom", factor);
  }
  /** The camera of the scene again, or one that has all in view. */
  resetCamera(): void {
    this.look("reset_camera");
  }

  async setView(view: View): Promise<void> {
    await this.core.sleep("view", [VIEWS.indexOf(known(view))]);
    this.shownView = view;
    this.changed();
  }

  /** Sets the canvas's size in device pixels. */
  async resize(width: number, height: number): Promise<void> {
    const canvas = this.canvas;
    if (!canvas) return;
    await this.core.sleep("resize", [width, height], () => {
      canvas.width = width;
      canvas.height = height;
    });
    this.changed();
  }

  /** Draws in the next tick, whether anything has changed or not. */
  redraw(): void {
    this.loaded();
    this.changed();
  }

  // Read

  /**
   * Where the state lies on the GPU, for commands of the page's own on this world's device: submitted now, they see the
   * state at the end of the last frame, and nothing is waited for or copied. To be asked for anew after each frame, as
   * positions and velocities have two buffers each that take turns; valid until the next frame, `load` or `dispose`.
   * They stay the world's: others may read them, and not write or destroy.
   */
  buffers(): WorldBuffers {
    const { nodes, triangles } = this.info;
    const at = this.core.call("buffers") >>> 3;
    const handles = this.core.module.HEAPF64;
    const of = <Format extends string>(place: number, stride: number, count: number, format: Format) => ({
      buffer: this.core.backend.objects.get<GPUBuffer>(handles[at + place]!),
      offset: 0,
      stride,
      count,
      format,
    });
    return {
      position: of(0, 16, nodes, "float32x3"),
      velocity: of(1, 16, nodes, "float32x3"),
      normal: of(2, 16, nodes, "float32x3"),
      stretch: of(3, 4, nodes, "float32"),
      triangles: of(4, 12, triangles, "uint32x3"),
    };
  }

  async snapshot(): Promise<Snapshot> {
    this.loaded();
    return this.core.sleep("snapshot", [], () => {
      const hash = this.core.text();
      const { nodes } = this.info;
      const fourEach = (name: string) => {
        const at = this.core.call(name) >>> 2;
        return this.core.module.HEAPF32.subarray(at, at + 4 * nodes);
      };
      const packed = (all: Float32Array) => {
        const out = new Float32Array(3 * nodes);
        for (let node = 0; node < nodes; node++) out.set(all.subarray(4 * node, 4 * node + 3), 3 * node);
        return out;
      };
      const places = fourEach("positions");
      const inverseMasses = Float32Array.from({ length: nodes }, (_, node) => places[4 * node + 3]!);
      return { positions: packed(places), velocities: packed(fourEach("velocities")), inverseMasses, hash };
    });
  }

  /** x, y, z of every node of the cloth at rest, in model order [m]: what `probe` calls `rest`. */
  async restPositions(): Promise<Float32Array> {
    this.loaded();
    return this.core.turn(() => {
      this.loaded();
      const at = this.core.call("rest_positions") >>> 3;
      return Float32Array.from(this.core.module.HEAPF64.subarray(at, at + 3 * this.info.nodes));
    });
  }

  /** x, y, z of every node in model order [m]. */
  async positions(): Promise<Float32Array> {
    return (await this.snapshot()).positions;
  }

  /**
   * Energies, stretch and residual at the end of the last frame, as a row of frames.csv has them. The state is read
   * back and summed up by this thread in double, which takes some 400 bytes of the module a node.
   */
  async measure(): Promise<Measures> {
    this.loaded();
    return this.core.sleep("measure", [], () => JSON.parse(this.core.text()) as Measures);
  }

  /**
   * What a node does at the end of the last frame. The state is read back and forces are summed up, as for `measure`.
   * Errors: "input", where there is no such node.
   */
  async probe(node: number): Promise<Probe> {
    this.loaded();
    return this.core.sleep("probe", [index(node)], () => JSON.parse(this.core.text()) as Probe);
  }

  /**
   * What each kernel takes on the GPU, over a few frames of two steps whose passes are apart: shares, not totals. The
   * state stays as it is. Empty where `info.timestamps` is false; fails before the first frame.
   */
  async passTimes(): Promise<PassTime[]> {
    this.loaded();
    return this.core.sleep("time_passes", [], () => JSON.parse(this.core.text()) as PassTime[]);
  }

  /**
   * The cloths' shape as a file with normals and texture coordinates; with the scene's `render.subdivide`, the finer
   * one that is drawn.
   */
  async exportMesh(format: "obj" | "ply" | "glb"): Promise<Uint8Array<ArrayBuffer>> {
    this.loaded();
    return this.core.sleep("export", [format], () => {
      const at = this.core.call("exported") >>> 0;
      return this.core.module.HEAPU8.slice(at, at + this.core.call("exported_size")) as Uint8Array<ArrayBuffer>;
    });
  }

  // Keep

  /**
   * The whole state once all frames have reported, to go on from in a world of the same scene, here or elsewhere: 32 to
   * some 200 bytes a node. `weft run --resume` takes the same file. Errors: "diverged", "device-lost", "out-of-memory".
   */
  async saveState(): Promise<Uint8Array<ArrayBuffer>> {
    this.loaded();
    return this.core.sleep("save_state", [], () => {
      const at = this.core.call("saved") >>> 0;
      const bytes = this.core.module.HEAPU8.slice(at, at + this.core.call("saved_size")) as Uint8Array<ArrayBuffer>;
      this.core.call("drop_saved");
      return bytes;
    });
  }

  /**
   * Goes on from what `saveState`, or `weft run --checkpoint-every`, has given: with its positions, velocities, forces
   * of contact, time, totals and grabbed nodes. The scene must be the one it is of, with the same meshes and changes;
   * title, camera, `render` and `time.frames` may differ. A world that plays plays on. Errors, with the world as it
   * was: "input", where the bytes are cut off, spoiled, no saved state or of another scene.
   */
  async openState(bytes: ArrayBuffer | Uint8Array): Promise<OpenedState> {
    this.loaded();
    const given = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes);
    const opened = await this.core.turn(() => {
      this.loaded();
      const most = this.core.call("most_saved_bytes");
      if (given.length > most)
        throw new WeftError("input",
          `There are ${given.length} bytes, more than a saved state of this scene has: at most ${most}.`);
      return this.core.sleepWithBytesNow("open_state", given, () => JSON.parse(this.core.text()) as OpenedState);
    });
    this.totals.droppedSeconds = 0;
    this.changed();
    return opened;
  }

  memory(): MemoryUse {
    return {
      wasmHeap: this.core.call("heap_bytes"), // what the module's allocator has given out
      wasmSize: this.core.module.HEAPU8.length,
      gpuBytes: this.current ? this.core.call("gpu_bytes") : 0,
      gpuObjects: this.core.backend.objects.alive,
    };
  }

  /** The device underneath: what `buffers` gives is on it. */
  get device(): GPUDevice | null {
    return this.core.backend.device;
  }

  dispose(): void {
    if (this.disposed) return;
    this.disposed = true;
    this.playing = false;
    this.current = null;
    if (this.timer !== 0) unschedule(this.timer);
    this.core.turn(() => this.core.call("close")).catch(() => this.core.backend.close()); // a stopped module cannot
  }

  // The frame

  /** Sews and tears what is due before the next frame; within a turn. */
  private async changeMesh(): Promise<void> {
    await this.core.sleepNow("change_mesh", []);
    const { changed, news } = JSON.parse(this.core.text()) as { changed: boolean; news: string[] };
    if (changed) this.tellMesh();
    for (const sentence of news) for (const listener of this.listeners.news) listener(sentence);
  }

  private tellMesh(): void {
    this.current = this.describe();
    for (const listener of this.listeners.mesh) listener(this.current);
  }

  private schedule(): void {
    if (this.timer === 0 && !this.disposed) this.timer = schedule((now) => this.tick(now));
  }

  private changed(): void {
    this.stale = true;
    this.schedule();
  }

  private tick(now: number): void {
    this.timer = 0;
    if (this.disposed) return;
    try {
      if (!this.core.busy && this.current) this.frame(now);
    } catch (reason) {
      return this.fail(reason);
    }
    if (this.playing || this.stale) this.schedule();
  }

  private frame(now: number): void {
    const start = performance.now();
    this.core.checkNow("_weft_poll");
    let advanced = false;
    if (this.playing) {
      const frameSeconds = this.info.frameSeconds;
      // Time that is late by more than a frame is dropped: slower than real time, never a burst.
      const due = this.due + (now - this.lastTick) / 1000;
      this.due = Math.min(due, 2 * frameSeconds);
      this.totals.droppedSeconds += due - this.due;
      this.lastTick = now;
      // A display of 60 Hz ticks a little early or late; half a millisecond of slack keeps one frame a tick.
      if (this.due + 5e-4 >= frameSeconds && !this.changing && this.core.now("_weft_has_room") !== 0) {
        this.due -= frameSeconds;
        if (this.info.changesMesh) return this.changeAndAdvance();
        this.core.checkNow(this.canvas ? "_weft_advance_and_draw" : "_weft_advance");
        advanced = true;
      }
    }
    if (this.canvas && this.stale && !advanced) this.core.checkNow("_weft_draw");
    if (!advanced && !this.stale) return;
    this.tellFrame();
    if (advanced) this.hostTime = performance.now() - start;
  }

  /** A frame of a scene whose mesh may change, which waits for those before. */
  private changeAndAdvance(): void {
    const start = performance.now();
    this.changing = true;
    this.core.turn(async () => {
      if (!this.current || !this.playing) return;
      await this.changeMesh();
      this.core.checkNow(this.canvas ? "_weft_advance_and_draw" : "_weft_advance");
      this.tellFrame();
      this.hostTime = performance.now() - start;
    }).catch((reason: unknown) => this.fail(reason)).finally(() => {
      this.changing = false;
    });
  }

  private tellFrame(): void {
    this.stale = false;
    this.readTotals();
    for (const listener of this.listeners.frame) listener(this.totals);
  }

  private readTotals(): void {
    const at = this.core.now("_weft_totals") >>> 3;
    if (at === 0) return; // there is no world
    const values = this.core.module.HEAPF64;
    for (let i = 0; i < TOTALS.length; i++) this.totals[TOTALS[i]!] = values[at + i]!;
    this.totals.seconds = this.totals.frames * (this.current?.frameSeconds ?? 0);
    this.tellSteps();
  }

  /** Tells of the frames that have reported since. */
  private tellSteps(): void {
    const length = 2 + TOTALS.length, count = this.core.now("_weft_reported_count") / length;
    if (count === 0) return;
    const at = this.core.now("_weft_reported") >>> 3;
    const steps: Step[] = [];
    for (let one = 0; one < count && this.listeners.step.size > 0; one++) {
      const [frame, seconds, ...values] = this.core.module.HEAPF64.subarray(at + one * length, at + (one + 1) * length);
      const totals = noTotals();
      TOTALS.forEach((name, i) => {
        totals[name] = values[i]!;
      });
      steps.push({ frame: frame!, seconds: seconds!, totals });
    }
    this.core.now("_weft_drop_reported");
    for (const step of steps) for (const listener of this.listeners.step) listener(step);
  }

  private numbers(name: string, count: number, ...args: number[]): number[] {
    this.loaded();
    const at = this.core.call(name, ...args) >>> 3;
    if (at === 0) throw new WeftError("failure", "A world without a canvas has no camera.");
    return Array.from(this.core.module.HEAPF64.subarray(at, at + count));
  }

  private look(name: string, ...args: number[]): void {
    this.loaded();
    const odd = args.find((arg) => !Number.isFinite(arg));
    if (odd !== undefined) throw new WeftError("input", `The camera cannot be moved by ${odd}.`);
    this.later(name, ...args);
  }

  /** A call whose failure goes to the listeners. */
  private later(name: string, ...args: number[]): void {
    this.core.sleep(name, args).then(() => this.changed(), (reason: unknown) => this.fail(reason));
  }

  private loaded(): void {
    void this.info;
  }

  private fail(reason: unknown): void {
    this.playing = false;
    const error = reason instanceof WeftError ? reason : new WeftError("failure", String(reason));
    if (error.kind === "device-lost") {
      if (this.lossTold || this.disposed) return;
      this.lossTold = true;
    }
    for (const listener of this.listeners.error) listener(error);
  }
}

function known(view: View): View {
  if (VIEWS.includes(view)) return view;
  throw new WeftError("input", `There is no view ${JSON.stringify(view)}; there are ${VIEWS.join(", ")}.`);
}

function index(number: number, what = "Node"): number {
  if (Number.isInteger(number) && number >= 0) return number;
  throw new WeftError("input", `${what} ${number} is no index.`);
}
