// A WebAssembly module of this package as a file beside the scripts, of which any number are started.
import type { CoreModule } from "./core.js";
import { WeftError } from "./error.js";

/** Emscripten's loader of one of them. */
export type Loader = (options: Record<string, unknown>) => Promise<CoreModule>;

export class ModuleFile {
  private compiled: Promise<WebAssembly.Module> | null = null;

  constructor(private readonly address: URL, private readonly loader: Loader) {}

  /** `options` are what the module's imports find in `Module`. */
  async start(options: Record<string, unknown>): Promise<CoreModule> {
    this.compiled ??= this.compile();
    const wasm = await this.compiled.catch((reason: unknown) => {
      this.compiled = null; // the next try fetches again
      throw reason instanceof WeftError ?
        reason :
        new WeftError("failure", `The core cannot be loaded: ${String(reason)}.`);
    });
    return new Promise<CoreModule>((resolve, reject) => {
      this.loader({
        ...options,
        instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
          WebAssembly.instantiate(wasm, imports).then(done, (reason: unknown) =>
            // most likely there is no room for it
            reject(new WeftError("out-of-memory", `The core cannot be started: ${String(reason)}.`)));
          return {};
        },
      }).then(resolve, reject);
    });
  }

  private async compile(): Promise<WebAssembly.Module> {
    const source = await this.load();
    if (!(source instanceof Response)) return WebAssembly.compile(source);
    if (!source.ok) {
      throw new WeftError("input", `The file ${this.address.pathname} cannot be fetched: HTTP ${source.status}.`);
    }
    return WebAssembly.compile(await source.arrayBuffer());
  }

  /** The bytes: from the network, or in Node from the file. */
  private async load(): Promise<BufferSource | Response> {
    if (this.address.protocol !== "file:") return fetch(this.address);
    const name = "node:fs/promises"; // a variable, so that bundlers for the browser leave it alone
    const { readFile } = (await import(/* @vite-ignore */ /* webpackIgnore: true */ name)) as {
      readFile(file: URL): Promise<Uint8Array<ArrayBuffer>>;
    };
    return readFile(this.address);
  }
}
