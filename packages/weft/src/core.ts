// The WebAssembly module as typed calls (packages/weft/core/bindings.cpp is the other side). Knows nothing of scenes:
// world.ts does.
import createCore from "./core_module.js";
import { WeftError } from "./error.js";
import { ERROR_KINDS, GpuBackend, type Memory } from "./gpu_backend.js";

/** The module as Emscripten makes it. */
export interface CoreModule extends Memory {
  ccall(name: string, returns: "number", types: string[], args: number[], options: { async: true }): Promise<number>;
  _malloc(bytes: number): number;
  _free(at: number): void;
  [call: `_weft_${string}`]: (...args: number[]) => number;
}

const WASM = new URL("core_module.wasm", import.meta.url);

/** The module's bytes: from the network, or in Node from the file. */
async function load(): Promise<BufferSource | Response> {
  if (WASM.protocol !== "file:") return fetch(WASM);
  const name = "node:fs/promises"; // a variable, so that bundlers for the browser leave it alone
  const { readFile } = (await import(/* @vite-ignore */ name)) as { readFile(file: URL): Promise<Uint8Array<ArrayBuffer>> };
  return readFile(WASM);
}

let compiled: Promise<WebAssembly.Module> | null = null;

async function compile(): Promise<WebAssembly.Module> {
  const source = await load();
  if (!(source instanceof Response)) return WebAssembly.compile(source);
  if (!source.ok) throw new WeftError("input", `The file ${WASM.pathname} cannot be fetched: HTTP ${source.status}.`);
  return WebAssembly.compile(await source.arrayBuffer());
}

export class Core {
  private sleeping: Promise<unknown> = Promise.resolve();
  private asleep = 0;
  private inFlight = false;
  /** Called after each call that slept, before the next one starts. */
  onAwake: (() => void) | null = null;

  private constructor(readonly module: CoreModule, readonly backend: GpuBackend) {}

  static async create(gpu: GPU | undefined): Promise<Core> {
    compiled ??= compile();
    const wasm = await compiled.catch((reason: unknown) => {
      compiled = null; // the next try fetches again
      throw reason;
    });
    const backend = new GpuBackend(gpu);
    const module = await createCore({
      gpu: backend,
      instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
        void WebAssembly.instantiate(wasm, imports).then(done);
        return {};
      },
    });
    backend.attach(module);
    return new Core(module, backend);
  }

  /** Whether a call sleeps; until it returns, no other may be made. */
  get busy(): boolean { return this.inFlight; }

  /** A call of a frame: without arguments, and without making anything for the garbage collector. Not while busy. */
  now(name: `_weft_${string}`): number { return this.module[name]!(); }

  /** A call that returns at once. Not while busy. */
  call(name: string, ...args: (number | string)[]): number {
    if (this.busy) throw new WeftError("failure", `The world is busy; ${name} must wait.`);
    const { numbers, free } = this.lower(args);
    try {
      return this.module[`_weft_${name}`]!(...numbers);
    } catch (reason) {
      throw ended(reason);
    } finally {
      free();
    }
  }

  /** A call that may fail. */
  check(name: string, ...args: (number | string)[]): void { this.throwIf(this.call(name, ...args)); }
  checkNow(name: `_weft_${string}`): void { this.throwIf(this.now(name)); }

  /** A call that sleeps; waits for those before it. */
  async sleep(name: string, ...args: (number | string)[]): Promise<void> {
    this.asleep += 1;
    const run = async () => {
      const { numbers, free } = this.lower(args);
      const types = numbers.map(() => "number");
      this.inFlight = true;
      try {
        this.throwIf(await this.module.ccall(`weft_${name}`, "number", types, numbers, { async: true }));
      } catch (reason) {
        throw ended(reason);
      } finally {
        this.inFlight = false;
        free();
        this.onAwake?.();
      }
    };
    const done = this.sleeping.then(run);
    this.sleeping = done.catch(() => undefined);
    try {
      await done;
    } finally {
      this.asleep -= 1;
    }
  }

  /** Once no call sleeps. */
  async idle(): Promise<void> {
    while (this.asleep > 0) await this.sleeping;
  }

  /** The sentence or text of the last call. */
  text(): string {
    const at = this.module._weft_message!() >>> 0;
    return new TextDecoder().decode(this.module.HEAPU8.slice(at, at + this.module._weft_message_size!()));
  }

  /** Hands bytes over for one call of `use`. */
  withBytes<T>(bytes: Uint8Array, use: (at: number, size: number) => T): T {
    const at = this.module._malloc(Math.max(bytes.length, 1));
    if (at === 0) throw new WeftError("out-of-memory", `The module has no room for ${bytes.length} bytes.`);
    this.module.HEAPU8.set(bytes, at >>> 0);
    try {
      return use(at, bytes.length);
    } finally {
      this.module._free(at);
    }
  }

  private throwIf(result: number): void {
    if (result !== 0) throw new WeftError(ERROR_KINDS[result - 1] ?? "failure", this.text());
  }

  /** Texts become an address and a size. */
  private lower(args: (number | string)[]): { numbers: number[]; free: () => void } {
    const texts: number[] = [];
    const numbers = args.flatMap((arg) => {
      if (typeof arg === "number") return [arg];
      const bytes = new TextEncoder().encode(arg);
      const at = this.module._malloc(Math.max(bytes.length, 1));
      this.module.HEAPU8.set(bytes, at >>> 0);
      texts.push(at);
      return [at, bytes.length];
    });
    return { numbers, free: () => texts.forEach((at) => this.module._free(at)) };
  }
}

/** A trap in the module, most likely for want of memory, ends it: this world is of no more use. */
function ended(reason: unknown): unknown {
  if (!(reason instanceof WebAssembly.RuntimeError)) return reason;
  return new WeftError("failure", `The module has stopped (${reason.message}); make a new world.`);
}
