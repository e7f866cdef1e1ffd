// Shared tables of the module's memory and the browser's GPU: numbers of C++, and their objects here.
// Mirrors of src/gpu/types.hpp and command_list.hpp; tests/web/layouts_backend.test.ts compares them.

/** What the back end needs of the WebAssembly module; views change when its memory grows, so they are read again. */
export interface Memory {
  readonly HEAPU8: Uint8Array;
  readonly HEAP32: Int32Array;
  readonly HEAPU32: Uint32Array;
  readonly HEAPF32: Float32Array;
  readonly HEAPF64: Float64Array;
}

/** The kinds of include/weft/result.hpp, in their order. */
export const ERROR_KINDS = ["failure", "usage", "input", "shape", "shader", "no-adapter", "limit", "out-of-memory",
  "device-lost", "diverged", "interrupted"] as const;
export type ErrorKind = (typeof ERROR_KINDS)[number];

export const OBJECT_KINDS = ["none", "buffer", "texture", "texture-view", "sampler", "shader-module",
  "bind-group-layout", "pipeline-layout", "bind-group", "compute-pipeline", "render-pipeline", "query-set"] as const;
export const TEXTURE_FORMATS: readonly (GPUTextureFormat | undefined)[] = [undefined, "rgba8unorm-srgb",
  "bgra8unorm-srgb", "rgba8unorm", "bgra8unorm", "depth32float"];
export const COMMAND_KINDS = ["begin-compute", "end-compute", "dispatch", "copy-buffer", "clear-buffer",
  "resolve-queries", "begin-render", "end-render", "draw", "copy-texture"] as const;

export type GpuObject = GPUBuffer | GPUTexture | GPUTextureView | GPUSampler | GPUShaderModule | GPUBindGroupLayout
  | GPUPipelineLayout | GPUBindGroup | GPUComputePipeline | GPURenderPipeline | GPUQuerySet;

/** What BufferUsage and TextureUsage mean, bit by bit, as WebGPU's flags. */
export const BUFFER_USAGE = [0x80, 0x40, 0x04, 0x08, 0x10, 0x100, 0x01, 0x200, 0x20] as const; // STORAGE … VERTEX
export const TEXTURE_USAGE = [0x10, 0x04, 0x01] as const; // RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC

/**
 * What weft's shaders need of a device, each WebGPU's default or less, so that a device of `requestDevice()` is enough;
 * no feature is needed. How large `maxBufferSize` and `maxStorageBufferBindingSize` must be depends on the scene.
 */
export const DEVICE_LIMITS = {
  maxStorageBuffersPerShaderStage: 8,
  maxComputeInvocationsPerWorkgroup: 256,
  maxComputeWorkgroupSizeX: 256,
  maxComputeWorkgroupsPerDimension: 65535,
  maxComputeWorkgroupStorageSize: 16384,
  maxUniformBufferBindingSize: 65536,
  maxBindingsPerBindGroup: 16,
} as const;

export function flags(bits: number, table: readonly number[]): number {
  return table.reduce((sum, flag, bit) => (bits & (1 << bit) ? sum | flag : sum), 0);
}
