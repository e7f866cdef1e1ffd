// The JavaScript side of the browser back end (src/gpu/web/imports.hpp has the C++ side): keeps WebGPU's objects under small
// numbers, and encodes a frame's flat command lists, read where they lie in the module's memory, in one call.

/** What the back end needs of the WebAssembly module; views change when its memory grows, so they are read anew. */
export interface Memory {
  readonly HEAPU8: Uint8Array;
  readonly HEAP32: Int32Array;
  readonly HEAPU32: Uint32Array;
  readonly HEAPF32: Float32Array;
  readonly HEAPF64: Float64Array;
}

/** The kinds of base/result.hpp, in their order. */
export const ERROR_KINDS = ["failure", "usage", "input", "shape", "shader", "no-adapter", "limit", "out-of-memory",
  "device-lost", "diverged", "interrupted"] as const;
export type ErrorKind = (typeof ERROR_KINDS)[number];

// Mirrors of gpu/types.hpp and gpu/command_list.hpp; tests/web/layouts_backend.test.ts compares them.
export const OBJECT_KINDS = ["none", "buffer", "texture", "texture-view", "sampler", "shader-module",
  "bind-group-layout", "pipeline-layout", "bind-group", "compute-pipeline", "render-pipeline", "query-set"] as const;
export const TEXTURE_FORMATS: readonly (GPUTextureFormat | undefined)[] =
  [undefined, "rgba8unorm-srgb", "bgra8unorm-srgb", "rgba8unorm", "depth32float"];
export const COMMAND_KINDS = ["begin-compute", "end-compute", "dispatch", "copy-buffer", "clear-buffer",
  "resolve-queries", "begin-render", "end-render", "draw", "copy-texture"] as const;

const enum Kind { BeginCompute, EndCompute, Dispatch, CopyBuffer, ClearBuffer, ResolveQueries, BeginRender,
  EndRender, Draw, CopyTexture }
const COMMAND_WORDS = 16; // kind 0, ids 1 to 3, args 4 to 8, sizes (two words each) 10 to 15
const TARGET_WORDS = 14; // color, resolve, depth; clear colour (f64) from 4; store_depth 12
const NO_TIMESTAMP = 0xffffffff;
const MAP_READY = 2;
const MAP_FAILED = 3;

type GpuObject = GPUBuffer | GPUTexture | GPUTextureView | GPUSampler | GPUShaderModule | GPUBindGroupLayout |
  GPUPipelineLayout | GPUBindGroup | GPUComputePipeline | GPURenderPipeline | GPUQuerySet;

const USAGE = { // BufferUsage of gpu/types.hpp, bit by bit, as WebGPU's flags
  buffer: [0x80, 0x40, 0x04, 0x08, 0x10, 0x100, 0x01, 0x200], // STORAGE … QUERY_RESOLVE
  texture: [0x10, 0x04, 0x01], // RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC
};
const COMPUTE = 4; // GPUShaderStage
const VERTEX_AND_FRAGMENT = 3;
const MAP_READ = 1; // GPUMapMode

function flags(bits: number, table: readonly number[]): number {
  return table.reduce((sum, flag, bit) => (bits & (1 << bit) ? sum | flag : sum), 0);
}

export class GpuBackend {
  /** The UTF-8 text that the C++ side fetches next. */
  text: Uint8Array = new Uint8Array();
  /** GPU objects that are alive, for tests of leaks. */
  alive = 0;
  device: GPUDevice | null = null;
  /** Called when the device is lost, unless it was closed. */
  onLost: ((message: string) => void) | null = null;

  private objects: (GpuObject | null)[] = [null];
  private free: number[] = [];
  private memory: Memory | null = null;
  private errorFlag = 0; // where in memory
  private error: { kind: ErrorKind; message: string } | null = null;
  private lost: string | null = null;
  private scopesOpen = false;
  private maps = new Set<Promise<void>>();
  private generation = 0; // of the device: callbacks of an older one are void
  private canvas: GPUCanvasContext | null = null;
  private canvasFormat: GPUTextureFormat = "rgba8unorm";
  private canvasHandle = 0;
  // Filled in and used again for every pass: a frame makes no objects of its own.
  private readonly computePass: GPUComputePassDescriptor = {};
  private readonly color: GPURenderPassColorAttachment = {
    view: null as unknown as GPUTextureView, loadOp: "clear", storeOp: "store", clearValue: [0, 0, 0, 1] };
  private readonly depth: GPURenderPassDepthStencilAttachment = {
    view: null as unknown as GPUTextureView, depthLoadOp: "clear", depthStoreOp: "store", depthClearValue: 1 };
  private readonly colors: GPURenderPassColorAttachment[] = [];
  private readonly renderPass: GPURenderPassDescriptor = { colorAttachments: this.colors };
  private readonly canvasView: GPUTextureViewDescriptor = {};
  private readonly submitted: GPUCommandBuffer[] = [];

  constructor(private readonly gpu: GPU | undefined) {}

  attach(memory: Memory): void { this.memory = memory; }

  /** Draws on this canvas from now on: a handle whose texture is new in every frame, and its format's index. */
  attachCanvas(context: GPUCanvasContext): { handle: number; format: number } {
    const device = this.need();
    this.canvas = context;
    this.canvasFormat = this.gpu!.getPreferredCanvasFormat();
    const view = `${this.canvasFormat}-srgb` as GPUTextureFormat; // light is computed linear and stored as sRGB
    this.canvasView.format = view;
    context.configure({ device, format: this.canvasFormat, viewFormats: [view], alphaMode: "opaque" });
    if (this.canvasHandle === 0) this.canvasHandle = this.keep({ label: "canvas" } as GPUTextureView);
    return { handle: this.canvasHandle, format: TEXTURE_FORMATS.indexOf(view) };
  }

  // Adapter, device and errors

  async open(adapter: number, size: number, timestamps: number, error: number): Promise<number> {
    this.errorFlag = error; // before there is a device that can be lost
    try {
      return await this.tryOpen(this.decode(adapter, size), timestamps !== 0);
    } catch (reason) { // the caller sleeps: a rejection would never wake it
      this.setText(`The browser's WebGPU fails: ${String(reason)}.`);
      return 1 + ERROR_KINDS.indexOf("failure");
    }
  }

  private async tryOpen(wanted: string, timestamps: boolean): Promise<number> {
    const fail = (kind: ErrorKind, message: string) => {
      this.setText(message);
      return 1 + ERROR_KINDS.indexOf(kind);
    };
    if (!this.gpu) return fail("no-adapter", "This browser has no WebGPU (navigator.gpu is missing).");
    const adapter = await this.gpu.requestAdapter({ powerPreference: "high-performance" }).catch(() => null);
    if (!adapter) return fail("no-adapter", "No WebGPU adapter was found: the browser gives none for this machine.");
    const info = (adapter.info as GPUAdapterInfo | undefined) ?? // missing in older browsers
      { description: "", device: "", vendor: "", architecture: "" };
    const name = info.description || info.device || `${info.vendor} ${info.architecture}`.trim() || "unnamed adapter";
    if (!name.toLowerCase().includes(wanted.toLowerCase()))
      return fail("no-adapter", `No adapter's name contains "${wanted}"; there is: ${name}.`);
    const requiredLimits: Record<string, number> = {};
    for (const key in adapter.limits) { // weft asks for all that the adapter has
      const value = adapter.limits[key as keyof GPUSupportedLimits];
      if (typeof value === "number") requiredLimits[key] = value;
    }
    const requiredFeatures: GPUFeatureName[] =
      timestamps && adapter.features.has("timestamp-query") ? ["timestamp-query"] : [];
    try {
      this.device = await adapter.requestDevice({ label: "weft", requiredLimits, requiredFeatures });
    } catch (reason) {
      return fail("failure", `Adapter ${name} gives no device: ${String(reason)}.`);
    }
    this.watch(this.device);
    this.setText([name, info.vendor, info.description, "WebGPU",
      (info as { isFallbackAdapter?: boolean }).isFallbackAdapter ? "CPU" : "unknown"].join("\n"));
    return 0;
  }

  private watch(device: GPUDevice): void {
    const generation = ++this.generation;
    this.error = null;
    this.lost = null;
    device.addEventListener("uncapturederror", (event) => {
      if (generation === this.generation) this.report((event as GPUUncapturedErrorEvent).error);
    });
    void device.lost.then((info) => {
      if (generation !== this.generation) return;
      this.lost = info.message || "no reason given";
      this.raise();
      this.onLost?.(this.lost);
    });
  }

  close(): void {
    this.generation += 1;
    // Another world may have taken the canvas over meanwhile.
    if (this.canvas?.getConfiguration?.()?.device === this.device) this.canvas?.unconfigure();
    this.canvas = null;
    this.device?.destroy();
    this.device = null;
    this.objects = [null];
    this.free = [];
    this.alive = 0;
    this.maps.clear();
    this.scopesOpen = false;
    this.canvasHandle = 0;
    this.errorFlag = 0;
  }

  lose(): void {
    this.lost = "it was given up";
    this.raise();
    this.device?.destroy();
  }

  limits(target: number): number {
    const device = this.need();
    const { limits } = device;
    this.heap().HEAPF64.set([limits.maxBufferSize, limits.maxStorageBufferBindingSize,
      limits.maxStorageBuffersPerShaderStage, limits.maxComputeInvocationsPerWorkgroup,
      limits.maxComputeWorkgroupsPerDimension, limits.maxTextureDimension2D,
      limits.minUniformBufferOffsetAlignment], target >>> 3);
    return device.features.has("timestamp-query") ? 1 : 0;
  }

  takeError(): number {
    if (this.lost !== null) {
      this.setText(`The GPU device is lost: ${this.lost}.`);
      return ERROR_KINDS.indexOf("device-lost");
    }
    const error = this.error ?? { kind: "failure" as const, message: "The GPU failed without a message." };
    this.error = null;
    if (this.errorFlag !== 0) this.heap().HEAPU32[this.errorFlag >>> 2] = 0;
    this.setText(error.message);
    return ERROR_KINDS.indexOf(error.kind);
  }

  private report(error: GPUError): void {
    if (this.error) return; // the first error is the cause
    const memory = error.constructor.name === "GPUOutOfMemoryError";
    const invalid = error.constructor.name === "GPUValidationError";
    this.error = {
      kind: memory ? "out-of-memory" : invalid ? "shader" : "failure",
      message: memory ? `The GPU has no memory left (${error.message}).` : error.message,
    };
    this.raise();
  }

  private raise(): void {
    if (this.errorFlag !== 0) this.heap().HEAPU32[this.errorFlag >>> 2] = 1;
  }

  async wait(): Promise<void> {
    try {
      await this.settle();
    } catch (reason) { // the caller sleeps: a rejection would never wake it
      this.error ??= { kind: "failure", message: `The browser's WebGPU fails: ${String(reason)}.` };
      this.raise();
    }
  }

  private async settle(): Promise<void> {
    const device = this.device;
    if (!device || this.lost !== null) return;
    if (this.scopesOpen) {
      this.scopesOpen = false;
      const scopes = [device.popErrorScope(), device.popErrorScope(), device.popErrorScope()] as const;
      const [validation, memory, internal] = await Promise.all(scopes.map((scope) => scope.catch(() => null)));
      // What could not be made for want of memory is invalid wherever it is used: that is no error of its own.
      for (const error of [memory, internal, validation]) if (error) this.report(error);
    }
    await device.queue.onSubmittedWorkDone().catch(() => undefined);
    while (this.maps.size > 0) await Promise.allSettled([...this.maps]);
  }

  // Objects

  /** The device to make something on; what is wrong with what is made is caught until the next wait. */
  private make(): GPUDevice {
    const device = this.need();
    if (!this.scopesOpen) {
      for (const filter of ["internal", "out-of-memory", "validation"] as const) device.pushErrorScope(filter);
      this.scopesOpen = true;
    }
    return device;
  }

  private keep(object: GpuObject): number {
    this.alive += 1;
    const id = this.free.pop() ?? this.objects.length;
    this.objects[id] = object;
    return id;
  }

  private get<T extends GpuObject>(id: number): T { return this.objects[id] as T; }

  release(kind: number, id: number): void {
    const object = this.objects[id];
    if (!object) return;
    const name = OBJECT_KINDS[kind];
    if (name === "buffer" || name === "texture" || name === "query-set") (object as GPUBuffer).destroy();
    this.objects[id] = null;
    this.free.push(id);
    this.alive -= 1;
  }

  buffer(size: number, usage: number, label: number): number {
    return this.keep(this.make().createBuffer({ label: this.string(label), size, usage: flags(usage, USAGE.buffer) }));
  }

  write(buffer: number, offset: number, bytes: number, size: number): void {
    this.need().queue.writeBuffer(this.get<GPUBuffer>(buffer), offset, this.heap().HEAPU8 as Uint8Array<ArrayBuffer>,
      bytes >>> 0, size);
  }

  shaderModule(source: number, label: number): number {
    return this.keep(this.make().createShaderModule({ label: this.string(label), code: this.string(source) }));
  }

  bindGroupLayout(at: number, count: number, render: number, label: number): number {
    const words = this.heap().HEAPU32;
    const visibility = render ? VERTEX_AND_FRAGMENT : COMPUTE;
    const entries: GPUBindGroupLayoutEntry[] = [];
    for (let i = 0; i < count; i++) {
      const entry = { binding: words[(at >>> 2) + 2 * i]!, visibility };
      entries.push({ ...entry, ...this.binding(words[(at >>> 2) + 2 * i + 1]!) });
    }
    return this.keep(this.make().createBindGroupLayout({ label: this.string(label), entries }));
  }

  /** In the order of BindingKind (gpu/types.hpp). */
  private binding(kind: number): Omit<GPUBindGroupLayoutEntry, "binding" | "visibility"> {
    return [
      { buffer: { type: "uniform" as const } },
      { buffer: { type: "uniform" as const, hasDynamicOffset: true } },
      { buffer: { type: "read-only-storage" as const } },
      { buffer: { type: "storage" as const } },
      { texture: { sampleType: "float" as const } },
      { texture: { sampleType: "depth" as const } },
      { sampler: { type: "filtering" as const } },
      { sampler: { type: "comparison" as const } },
    ][kind]!;
  }

  pipelineLayout(layout: number, label: number): number {
    const bindGroupLayouts = [this.get<GPUBindGroupLayout>(layout)];
    return this.keep(this.make().createPipelineLayout({ label: this.string(label), bindGroupLayouts }));
  }

  bindGroup(layout: number, at: number, count: number, label: number): number {
    const { HEAPU32, HEAPF64 } = this.heap();
    const entries: GPUBindGroupEntry[] = [];
    for (let i = 0; i < count; i++) {
      const word = (at >>> 2) + 8 * i;
      const object = this.objects[HEAPU32[word + 2]!]!;
      const resource = OBJECT_KINDS[HEAPU32[word + 1]!] === "buffer"
        ? { buffer: object as GPUBuffer, offset: HEAPF64[(word >>> 1) + 2]!, size: HEAPF64[(word >>> 1) + 3]! }
        : (object as GPUTextureView | GPUSampler);
      entries.push({ binding: HEAPU32[word]!, resource });
    }
    return this.keep(this.make().createBindGroup({ label: this.string(label), layout: this.get(layout), entries }));
  }

  private constants(at: number, count: number): Record<string, number> {
    const constants: Record<string, number> = {};
    for (let i = 0; i < count; i++)
      constants[this.string(at + 16 * i)] = this.heap().HEAPF64[(at >>> 3) + 2 * i + 1]!;
    return constants;
  }

  computePipeline(layout: number, module: number, entry: number, constants: number, count: number,
    label: number): number {
    return this.keep(this.make().createComputePipeline({
      label: this.string(label), layout: this.get<GPUPipelineLayout>(layout),
      compute: { module: this.get(module), entryPoint: this.string(entry), constants: this.constants(constants, count) },
    }));
  }

  renderPipeline(layout: number, module: number, at: number, constantsAt: number, count: number,
    label: number): number {
    const { HEAPU32, HEAP32, HEAPF32 } = this.heap();
    const word = at >>> 2;
    const constants = this.constants(constantsAt, count);
    const color = TEXTURE_FORMATS[HEAPU32[word + 2]!];
    const depth = TEXTURE_FORMATS[HEAPU32[word + 3]!];
    const over: GPUBlendState = {
      color: { srcFactor: "src-alpha", dstFactor: "one-minus-src-alpha" },
      alpha: { srcFactor: "one", dstFactor: "one-minus-src-alpha" },
    };
    const fragmentEntry = this.string(at + 48);
    return this.keep(this.make().createRenderPipeline({
      label: this.string(label), layout: this.get<GPUPipelineLayout>(layout),
      vertex: { module: this.get(module), entryPoint: this.string(at + 40), constants },
      primitive: { topology: HEAPU32[word] ? "line-list" : "triangle-list", cullMode: HEAPU32[word + 1] ? "back" : "none" },
      multisample: { count: HEAPU32[word + 4]! },
      ...(depth && { depthStencil: {
        format: depth, depthWriteEnabled: HEAPU32[word + 5] !== 0, depthCompare: HEAPU32[word + 6] ? "less-equal" : "less",
        depthBias: HEAP32[word + 8]!, depthBiasSlopeScale: HEAPF32[word + 9]!,
      } }),
      ...(fragmentEntry && { fragment: {
        module: this.get(module), entryPoint: fragmentEntry, constants,
        targets: color ? [{ format: color, ...(HEAPU32[word + 7] && { blend: over }) }] : [],
      } }),
    } as GPURenderPipelineDescriptor));
  }

  texture(width: number, height: number, sampleCount: number, format: number, usage: number, label: number): number {
    return this.keep(this.make().createTexture({
      label: this.string(label), size: [width, height], sampleCount, format: TEXTURE_FORMATS[format]!,
      usage: flags(usage, USAGE.texture),
    }));
  }

  textureView(texture: number, label: number): number {
    this.make();
    return this.keep(this.get<GPUTexture>(texture).createView({ label: this.string(label) }));
  }

  sampler(linear: number, repeat: number, comparison: number, label: number): number {
    const filter = linear ? "linear" : "nearest";
    const address = repeat ? "repeat" : "clamp-to-edge";
    return this.keep(this.make().createSampler({
      label: this.string(label), magFilter: filter, minFilter: filter, addressModeU: address, addressModeV: address,
      ...(comparison && { compare: "less-equal" as const }),
    }));
  }

  queries(count: number, label: number): number {
    return this.keep(this.make().createQuerySet({ label: this.string(label), type: "timestamp", count }));
  }

  // Frames

  submit(lists: number, count: number): void {
    const device = this.need();
    const encoder = device.createCommandEncoder();
    for (let i = 0; i < count; i++) {
      const word = (lists >>> 2) + 3 * i;
      const words = this.heap().HEAPU32;
      this.encode(encoder, words[word]! >>> 2, words[word + 1]!, words[word + 2]! >>> 2);
    }
    this.submitted[0] = encoder.finish();
    device.queue.submit(this.submitted);
  }

  private encode(encoder: GPUCommandEncoder, first: number, count: number, targets: number): void {
    const words = this.heap().HEAPU32 as Uint32Array<ArrayBuffer>;
    let compute: GPUComputePassEncoder | null = null;
    let render: GPURenderPassEncoder | null = null;
    let pipeline = 0; // what is set, so that repeats are left out
    let group = 0;
    for (let at = first; at < first + COMMAND_WORDS * count; at += COMMAND_WORDS) {
      switch ((words[at]! & 0xff) as Kind) {
        case Kind.BeginCompute:
          compute = encoder.beginComputePass(this.describeCompute(words, at));
          pipeline = group = 0;
          break;
        case Kind.Dispatch: {
          if (pipeline !== words[at + 1]) {
            pipeline = words[at + 1]!;
            compute!.setPipeline(this.get<GPUComputePipeline>(pipeline));
          }
          const readsStep = words[at + 8] !== 0;
          if (readsStep) compute!.setBindGroup(0, this.get<GPUBindGroup>(words[at + 2]!), words, at + 7, 1);
          else if (group !== words[at + 2]) compute!.setBindGroup(0, this.get<GPUBindGroup>(words[at + 2]!));
          group = words[at + 2]!;
          compute!.dispatchWorkgroups(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          break;
        }
        case Kind.EndCompute:
          compute!.end();
          break;
        case Kind.CopyBuffer:
          encoder.copyBufferToBuffer(this.get<GPUBuffer>(words[at + 1]!), size(words, at + 10),
            this.get<GPUBuffer>(words[at + 2]!), size(words, at + 12), size(words, at + 14));
          break;
        case Kind.ClearBuffer:
          encoder.clearBuffer(this.get<GPUBuffer>(words[at + 1]!), size(words, at + 10), size(words, at + 12));
          break;
        case Kind.ResolveQueries:
          encoder.resolveQuerySet(this.get<GPUQuerySet>(words[at + 1]!), 0, words[at + 4]!,
            this.get<GPUBuffer>(words[at + 2]!), 0);
          break;
        case Kind.BeginRender:
          render = encoder.beginRenderPass(this.describeRender(words, targets + TARGET_WORDS * words[at + 4]!));
          break;
        case Kind.Draw:
          render!.setPipeline(this.get<GPURenderPipeline>(words[at + 1]!));
          render!.setBindGroup(0, this.get<GPUBindGroup>(words[at + 2]!));
          if (words[at + 3] === 0) {
            render!.draw(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          } else {
            render!.setIndexBuffer(this.get<GPUBuffer>(words[at + 3]!), "uint32");
            render!.drawIndexed(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          }
          break;
        case Kind.EndRender:
          render!.end();
          break;
        case Kind.CopyTexture:
          encoder.copyTextureToBuffer({ texture: this.get<GPUTexture>(words[at + 1]!) },
            { buffer: this.get<GPUBuffer>(words[at + 2]!), bytesPerRow: words[at + 6]!, rowsPerImage: words[at + 5]! },
            [words[at + 4]!, words[at + 5]!]);
          break;
      }
    }
  }

  private describeCompute(words: Uint32Array, at: number): GPUComputePassDescriptor {
    if (words[at + 1] === 0) return this.computePass;
    const time = (word: number) => (words[word] === NO_TIMESTAMP ? undefined : words[word]);
    return { timestampWrites: { querySet: this.get<GPUQuerySet>(words[at + 1]!),
      beginningOfPassWriteIndex: time(at + 5), endOfPassWriteIndex: time(at + 6) } } as GPUComputePassDescriptor;
  }

  private describeRender(words: Uint32Array, at: number): GPURenderPassDescriptor {
    const [color, resolve, depth] = [words[at]!, words[at + 1]!, words[at + 2]!];
    this.colors.length = 0;
    if (color !== 0) {
      this.color.view = this.view(color);
      this.color.storeOp = resolve !== 0 ? "discard" : "store";
      if (resolve !== 0) this.color.resolveTarget = this.view(resolve);
      else delete this.color.resolveTarget;
      const clear = this.heap().HEAPF64;
      const rgba = this.color.clearValue as number[];
      for (let i = 0; i < 4; i++) rgba[i] = clear[(at >>> 1) + 2 + i]!;
      this.colors.push(this.color);
    }
    if (depth !== 0) {
      this.depth.view = this.view(depth);
      this.depth.depthStoreOp = words[at + 12]! & 0xff ? "store" : "discard";
      this.renderPass.depthStencilAttachment = this.depth;
    } else {
      delete this.renderPass.depthStencilAttachment;
    }
    return this.renderPass;
  }

  private view(id: number): GPUTextureView {
    if (id !== this.canvasHandle) return this.get<GPUTextureView>(id);
    return this.canvas!.getCurrentTexture().createView(this.canvasView);
  }

  // Bytes that come back

  map(buffer: number, bytes: number, state: number): void {
    const generation = this.generation;
    const settle = (value: number) => {
      if (generation === this.generation) this.heap().HEAPU32[state >>> 2] = value;
    };
    if (this.lost !== null) return settle(MAP_FAILED);
    const mapped: Promise<void> = this.get<GPUBuffer>(buffer).mapAsync(MAP_READ, 0, bytes)
      .then(() => settle(MAP_READY), () => settle(MAP_FAILED))
      .then(() => void this.maps.delete(mapped));
    this.maps.add(mapped);
  }

  takeMapped(buffer: number, target: number, size: number): void {
    const object = this.get<GPUBuffer>(buffer);
    try {
      this.heap().HEAPU8.set(new Uint8Array(object.getMappedRange(0, size)), target >>> 0);
      object.unmap();
    } catch { // a lost device takes its mappings with it before it says so
      this.heap().HEAPU8.fill(0, target >>> 0, (target >>> 0) + size);
      this.lost ??= "its mapped buffers are gone";
      this.raise();
    }
  }

  // Memory

  private heap(): Memory {
    if (!this.memory) throw new Error("The back end has no module.");
    return this.memory;
  }

  private need(): GPUDevice {
    if (!this.device) throw new Error("The back end has no device.");
    return this.device;
  }

  private decode(at: number, size: number): string {
    return new TextDecoder().decode(this.heap().HEAPU8.slice(at >>> 0, (at >>> 0) + size));
  }

  /** The text that a `Text` struct of imports.hpp points to. */
  private string(at: number): string {
    const words = this.heap().HEAPU32;
    return this.decode(words[at >>> 2]!, words[(at >>> 2) + 1]!);
  }

  private setText(text: string): void { this.text = new TextEncoder().encode(text); }
}

/** A u64 of the module's memory; all of weft's are below 2^53. */
function size(words: Uint32Array, at: number): number { return words[at]! + words[at + 1]! * 0x100000000; }
