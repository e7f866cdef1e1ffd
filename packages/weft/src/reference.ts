// A scene on the CPU, in double: slow, but with the same bits in every browser, and without WebGPU.
import { Core } from "./core.js";
import { WeftError } from "./error.js";
import { ModuleFile } from "./module_file.js";
import createReferenceModule from "./reference_module.js";
import { changeLines, sceneText, type Scene } from "./scene.js";
import type { SceneOptions, WorldInfo } from "./world_types.js";

const REFERENCE = new ModuleFile(new URL("reference_module.wasm", import.meta.url), createReferenceModule);

export interface ReferenceOptions extends SceneOptions {
  scene: Scene;
}

/** What was loaded. */
export type ReferenceInfo = Omit<WorldInfo, "adapter" | "gpuBytes" | "timestamps" | "view" | "refusedViews">;

/** Builds the scene at rest. Needs no WebGPU, and loads a module of its own. */
export async function createReference({ scene, meshes = {}, set = {} }: ReferenceOptions): Promise<Reference> {
  const core = await Core.create(undefined, undefined, REFERENCE);
  await core.addMeshes(meshes);
  core.check("reference_load", sceneText(scene), changeLines(set));
  return new Reference(core);
}

/** A scene that advances when it is told to, within the call. Lengths are metres, times seconds. */
export class Reference {
  readonly info: ReferenceInfo;
  /** Three nodes a triangle, counter-clockwise seen from the cloth's front. */
  readonly triangles: Uint32Array;
  private disposed = false;

  /** @internal */
  constructor(private readonly core: Core) {
    core.call("reference_describe");
    this.info = JSON.parse(core.text()) as ReferenceInfo;
    const at = core.call("reference_triangles") >>> 2;
    this.triangles = core.module.HEAPU32.slice(at, at + 3 * this.info.triangles);
  }

  /** Simulates this many frames. */
  advance(frames = 1): void {
    for (let i = 0; i < frames; i++) this.live().check("reference_advance");
  }

  /** Back to the rest state at time 0. */
  reset(): void {
    this.live().call("reference_reset");
  }

  /** x, y, z of every node in model order [m]. */
  positions(): Float32Array {
    const at = this.live().call("reference_positions") >>> 2;
    return this.core.module.HEAPF32.slice(at, at + 3 * this.info.nodes);
  }

  /** XXH3-64 of the bits of the state: equal on every machine. */
  hash(): string {
    this.live().call("reference_hash");
    return this.core.text();
  }

  /** Simulated time [s]. */
  get seconds(): number {
    return this.live().call("reference_seconds");
  }

  /** Kinetic, elastic and in gravity, which is 0 at a height of 0 [J]. */
  get energy(): number {
    return this.live().call("reference_energy");
  }

  dispose(): void {
    if (this.disposed) return;
    this.core.call("reference_close");
    this.disposed = true;
  }

  private live(): Core {
    if (this.disposed) throw new WeftError("failure", "The reference is disposed of.");
    return this.core;
  }
}
