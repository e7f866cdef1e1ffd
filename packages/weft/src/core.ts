// A WebAssembly module as typed calls (packages/weft/core is the other side). What scenes are, world.ts and
// reference.ts know.
import createCore from "./core_module.js";
import { WeftError } from "./error.js";
import { GpuBackend } from "./gpu_backend.js";
import { ERROR_KINDS, type Memory } from "./gpu_tables.js";
import { ModuleFile } from "./module_file.js";
import { unpacked, type Bytes } from "./scene.js";

/** The module as Emscripten makes it. */
export interface CoreModule extends Memory {
  ccall(name: string, returns: "number", types: string[], args: number[], options: { async: true }): Promise<number>;
  _malloc(bytes: number): number;
  _free(at: number): void;
  [call: `_weft_${string}`]: (...args: number[]) => number;
}

/** What drives a GPU, reads files and has the catalogue. */
const CORE = new ModuleFile(new URL("core_module.wasm", import.meta.url), createCore);

export class Core {
  private last: Promise<unknown> = Promise.resolve(); // of the turns
  private inFlight = false;
  private dead: WeftError | null = null;
  /** Called after each call that slept, before anything else. */
  onAwake: (() => void) | null = null;

  private constructor(readonly module: CoreModule, readonly backend: GpuBackend) {}

  /** Starts a module of this package. */
  static async create(gpu?: GPU, device?: GPUDevice, file = CORE): Promise<Core> {
    const backend = new GpuBackend(gpu, device);
    const module = await file.start({ gpu: backend });
    backend.attach(module);
    return new Core(module, backend);
  }

  /** Whether a call sleeps; until it returns, no other may be made. */
  get busy(): boolean {
    return this.inFlight;
  }
  /** Whether a trap has ended the module: every call throws. */
  get stopped(): boolean {
    return this.dead !== null;
  }

  /** Carries something out after all that was asked before and before all that will be asked. */
  turn<T>(action: () => T | Promise<T>): Promise<T> {
    const done = this.last.then(action);
    this.last = done.catch(() => undefined);
    return done;
  }

  /** A call that sleeps, in its turn; `after` reads what it left, before the next turn. */
  sleep<T = void>(name: string, args: readonly (number | string)[] = [], after?: () => T): Promise<T> {
    return this.turn(() => this.sleepNow(name, args, after));
  }

  /** The same within a turn. */
  async sleepNow<T = void>(name: string, args: readonly (number | string)[], after?: () => T): Promise<T> {
    if (this.dead) throw this.dead;
    const { numbers, free } = this.lower(args);
    const types = numbers.map(() => "number");
    this.inFlight = true;
    let result: number;
    try {
      result = await this.module.ccall(`weft_${name}`, "number", types, numbers, { async: true });
    } catch (reason) {
      throw this.ended(reason);
    } finally {
      this.inFlight = false;
      if (!this.dead) free();
    }
    this.onAwake?.();
    this.throwIf(result);
    return after?.() as T;
  }

  /** A call that sleeps and reads bytes, of which the module has a copy for as long. Within a turn. */
  async sleepWithBytesNow<T>(name: string, bytes: Uint8Array, after: () => T): Promise<T> {
    const at = this.copied(bytes);
    try {
      return await this.sleepNow(name, [at, bytes.length], after);
    } finally {
      if (!this.dead) this.module._free(at);
    }
  }

  /** Until one of the frames under way has reported; the others go on meanwhile. In its turn. */
  takeReport(): Promise<void> {
    return this.turn(async () => {
      await this.backend.anyMapped();
      this.checkNow("_weft_poll");
    });
  }

  /** A call of a frame: without arguments, and without making anything for the garbage collector. Not while busy. */
  now(name: `_weft_${string}`): number {
    if (this.dead) throw this.dead;
    try {
      return this.module[name]!();
    } catch (reason) {
      throw this.ended(reason);
    }
  }

  /** A call that returns at once. Not while busy. */
  call(name: string, ...args: (number | string)[]): number {
    if (this.dead) throw this.dead;
    if (this.busy) throw new WeftError("failure", `The world is busy; ${name} must wait.`);
    const { numbers, free } = this.lower(args);
    try {
      return this.module[`_weft_${name}`]!(...numbers);
    } catch (reason) {
      throw this.ended(reason);
    } finally {
      if (!this.dead) free();
    }
  }

  /** A call that may fail. */
  check(name: string, ...args: (number | string)[]): void {
    this.throwIf(this.call(name, ...args));
  }
  checkNow(name: `_weft_${string}`): void {
    this.throwIf(this.now(name));
  }

  /** The sentence or text of the last call. */
  text(): string {
    const at = this.module._weft_message!() >>> 0;
    return new TextDecoder().decode(this.module.HEAPU8.slice(at, at + this.module._weft_message_size!()));
  }

  /** Hands over mesh files by the name that scenes give them, packed or not. In a turn. */
  async addMeshes(meshes: Readonly<Record<string, Bytes>>): Promise<void> {
    for (const [name, packed] of Object.entries(meshes))
      this.withBytes(await unpacked(packed), (at, size) => this.check("add_mesh", name, at, size));
  }

  /** Calls `use` with the address of a copy of the bytes in the module's memory, which is there for this call only. */
  withBytes(bytes: Uint8Array, use: (at: number, size: number) => void): void {
    const at = this.copied(bytes);
    try {
      use(at, bytes.length);
    } finally {
      if (!this.dead) this.module._free(at);
    }
  }

  /** The address of a copy, to be freed. */
  private copied(bytes: Uint8Array): number {
    const at = this.module._malloc(Math.max(bytes.length, 1));
    if (at === 0) throw new WeftError("out-of-memory", `The module has no room for ${bytes.length} bytes.`);
    this.module.HEAPU8.set(bytes, at >>> 0);
    return at;
  }

  private throwIf(result: number): void {
    if (result !== 0) throw new WeftError(ERROR_KINDS[result - 1] ?? "failure", this.text());
  }

  /** Texts become an address and a size. */
  private lower(args: readonly (number | string)[]): { numbers: number[]; free: () => void } {
    const texts: number[] = [];
    const free = () => texts.forEach((at) => this.module._free(at));
    const numbers = args.flatMap((arg) => {
      if (typeof arg === "number") return [arg];
      const bytes = new TextEncoder().encode(arg);
      const at = this.module._malloc(Math.max(bytes.length, 1));
      if (at === 0) {
        free();
        throw new WeftError("out-of-memory", `The module has no room for ${bytes.length} bytes.`);
      }
      this.module.HEAPU8.set(bytes, at >>> 0);
      texts.push(at);
      return [at, bytes.length];
    });
    return { numbers, free };
  }

  /** A trap in the module, most likely for want of memory, ends it: nothing of it can be used any more. */
  private ended(reason: unknown): unknown {
    if (!(reason instanceof WebAssembly.RuntimeError)) return reason;
    this.dead = new WeftError("failure", `The module has stopped (${reason.message}); make a new world.`);
    return this.dead;
  }
}
