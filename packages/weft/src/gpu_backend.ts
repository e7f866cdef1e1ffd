// The JavaScript side of the browser back end (src/gpu/web/imports.hpp has the C++ side): the device, its errors and
// its loss, what is made on it, and the one call that submits a frame.
import { describe, isNamed, nameOf, noneNamed } from "./adapter_info.js";
import { FrameEncoder } from "./frame_encoder.js";
import { GpuObjects } from "./gpu_objects.js";
import { BUFFER_USAGE, DEVICE_LIMITS, ERROR_KINDS, flags, OBJECT_KINDS, TEXTURE_FORMATS, TEXTURE_USAGE, type ErrorKind,
  type GpuObject, type Memory } from "./gpu_tables.js";

const MAP_READY = 2;
const MAP_FAILED = 3;

const COMPUTE = 4; // GPUShaderStage
const VERTEX_AND_FRAGMENT = 3;
const MAP_READ = 1; // GPUMapMode

export class GpuBackend {
  /** The UTF-8 text that the C++ side fetches next. */
  text: Uint8Array = new Uint8Array();
  readonly objects = new GpuObjects();
  device: GPUDevice | null = null;
  /** Called when the device is lost, unless it was closed. */
  onLost: ((message: string) => void) | null = null;

  private memory: Memory | null = null;
  private errorFlag = 0; // where in memory
  private error: { kind: ErrorKind; message: string } | null = null;
  private lost: string | null = null;
  private errors: Promise<void> = Promise.resolve(); // those of scopes, in their order
  private maps = new Set<Promise<void>>();
  private generation = 0; // of the device: callbacks of an older one are void
  private canvas: GPUCanvasContext | null = null;
  private canvasHandle = 0;
  private readonly canvasView: GPUTextureViewDescriptor = {};
  private readonly encoder = new FrameEncoder(this.objects, () => this.heap(), {
    handle: () => this.canvasHandle,
    view: () => this.canvas!.getCurrentTexture().createView(this.canvasView),
  });
  private readonly submitted: GPUCommandBuffer[] = [];

  /** `given`: a device of the page's own, which goes on using it. */
  constructor(private readonly gpu: GPU | undefined, private readonly given: GPUDevice | undefined = undefined) {}

  attach(memory: Memory): void {
    this.memory = memory;
  }

  /** Draws on this canvas from now on: a handle whose texture is new in every frame, and its format's index. */
  attachCanvas(context: GPUCanvasContext): { handle: number; format: number } {
    const device = this.need();
    this.canvas = context;
    const plain = this.gpu!.getPreferredCanvasFormat();
    const view = `${plain}-srgb` as GPUTextureFormat; // light is computed linear and stored as sRGB
    this.canvasView.format = view;
    context.configure({ device, format: plain, viewFormats: [view], alphaMode: "opaque" });
    if (this.canvasHandle === 0) this.canvasHandle = this.objects.keep({ label: "canvas" } as GPUTextureView);
    return { handle: this.canvasHandle, format: TEXTURE_FORMATS.indexOf(view) };
  }

  // Adapter, device and errors

  async open(adapter: number, size: number, timestamps: number, error: number): Promise<number> {
    this.errorFlag = error; // before there is a device that can be lost
    try {
      return await this.tryOpen(this.decode(adapter, size), timestamps !== 0);
    } catch (reason) { // the caller sleeps: a rejection would never wake it
      return this.refuse("failure", `The browser's WebGPU fails: ${String(reason)}.`);
    }
  }

  private async tryOpen(wanted: string, timestamps: boolean): Promise<number> {
    if (this.given) return this.take(this.given, wanted);
    if (!this.gpu) return this.refuse("no-adapter", "This browser has no WebGPU (navigator.gpu is missing).");
    const adapter = await this.gpu.requestAdapter({ powerPreference: "high-performance" }).catch(() => null);
    if (!adapter)
      return this.refuse("no-adapter", "No WebGPU adapter was found: the browser gives none for this machine.");
    const info = adapter.info as GPUAdapterInfo | undefined;
    if (!isNamed(info, wanted)) return this.refuse("no-adapter", noneNamed(wanted, info));
    const requiredLimits: Record<string, number> = {};
    for (const key in adapter.limits) { // weft asks for all that the adapter has
      const value = adapter.limits[key as keyof GPUSupportedLimits];
      if (typeof value === "number") requiredLimits[key] = value;
    }
    const requiredFeatures: GPUFeatureName[] = timestamps && adapter.features.has("timestamp-query") ?
      ["timestamp-query"] :
      [];
    try {
      this.device = await adapter.requestDevice({ label: "weft", requiredLimits, requiredFeatures });
    } catch (reason) {
      return this.refuse("failure", `Adapter ${nameOf(info)} gives no device: ${String(reason)}.`);
    }
    this.watch(this.device);
    this.setText(describe(info));
    return 0;
  }

  private take(device: GPUDevice, wanted: string): number {
    for (const [limit, needed] of Object.entries(DEVICE_LIMITS)) {
      const has = device.limits[limit as keyof typeof DEVICE_LIMITS];
      if (!(has >= needed))
        return this.refuse("limit", `The device's ${limit} is ${has}, and weft's shaders need ${needed}.`);
    }
    const info = device.adapterInfo as GPUAdapterInfo | undefined;
    if (!isNamed(info, wanted)) return this.refuse("no-adapter", noneNamed(wanted, info));
    this.device = device;
    this.watch(device);
    this.setText(describe(info));
    return 0;
  }

  private refuse(kind: ErrorKind, message: string): number {
    this.setText(message);
    return 1 + ERROR_KINDS.indexOf(kind);
  }

  private watch(device: GPUDevice): void {
    const generation = ++this.generation;
    this.error = null;
    this.lost = null;
    // Those of a given device may be of the page's own calls: what weft does on it is in scopes.
    if (!this.given)
      device.addEventListener("uncapturederror", (event) => {
        this.reportInTurn(Promise.resolve([(event as GPUUncapturedErrorEvent).error]), generation);
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
    this.objects.clear(); // a given device goes on without them
    if (!this.given) this.device?.destroy();
    this.device = null;
    this.maps.clear();
    this.canvasHandle = 0;
    this.errorFlag = 0;
  }

  lose(): void {
    this.lost = "it was given up";
    this.raise();
    if (!this.given) this.device?.destroy();
  }

  limits(target: number): number {
    const device = this.need();
    const { limits } = device;
    this.heap().HEAPF64.set([limits.maxBufferSize, limits.maxStorageBufferBindingSize,
      limits.maxStorageBuffersPerShaderStage,
      Math.min(limits.maxComputeInvocationsPerWorkgroup, limits.maxComputeWorkgroupSizeX),
      limits.maxComputeWorkgroupStorageSize, limits.maxComputeWorkgroupsPerDimension, limits.maxTextureDimension2D,
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
    await this.errors;
    await device.queue.onSubmittedWorkDone().catch(() => undefined);
    while (this.maps.size > 0) await Promise.allSettled([...this.maps]);
    await this.errors; // of the frames, where the device is given
  }

  /** Until one of the mappings under way has settled; at once where there is none. */
  async anyMapped(): Promise<void> {
    if (this.maps.size > 0) await Promise.race(this.maps);
  }

  // Objects

  /** What `act` makes on the device; what is wrong with it arrives before a wait is over. */
  private caught<T>(act: (device: GPUDevice) => T): T {
    const device = this.need();
    for (const filter of ["internal", "out-of-memory", "validation"] as const) device.pushErrorScope(filter);
    try {
      return act(device);
    } finally {
      const [validation, memory, internal] = [device.popErrorScope(), device.popErrorScope(), device.popErrorScope()];
      const scopes = [memory, internal, validation].map((scope) => scope.catch(() => null)); // a lost device's fail
      this.reportInTurn(Promise.all(scopes), this.generation);
    }
  }

  /**
   * An object that could not be made for lack of memory is invalid wherever it is used, and that is no further error:
   * so errors are reported in the order of the calls, whichever way they come.
   */
  private reportInTurn(found: Promise<readonly (GPUError | null)[]>, generation: number): void {
    this.errors = this.errors.then(() => found).then((all) => {
      for (const error of all) if (error && generation === this.generation) this.report(error);
    });
  }

  private make<T extends GpuObject>(create: (device: GPUDevice) => T): number {
    return this.objects.keep(this.caught(create));
  }

  release(kind: number, id: number): void {
    this.objects.release(kind, id);
  }

  buffer(size: number, usage: number, label: number): number {
    return this.make((device) =>
      device.createBuffer({ label: this.string(label), size, usage: flags(usage, BUFFER_USAGE) })
    );
  }

  write(buffer: number, offset: number, bytes: number, size: number): void {
    const act = (device: GPUDevice) =>
      device.queue.writeBuffer(this.objects.get<GPUBuffer>(buffer), offset,
        this.heap().HEAPU8 as Uint8Array<ArrayBuffer>, bytes >>> 0, size);
    if (this.given) this.caught(act);
    else act(this.need());
  }

  shaderModule(source: number, label: number): number {
    return this.make((device) => device.createShaderModule({ label: this.string(label), code: this.string(source) }));
  }

  bindGroupLayout(at: number, count: number, render: number, label: number): number {
    const words = this.heap().HEAPU32;
    const visibility = render ? VERTEX_AND_FRAGMENT : COMPUTE;
    const entries: GPUBindGroupLayoutEntry[] = [];
    for (let i = 0; i < count; i++) {
      const entry = { binding: words[(at >>> 2) + 2 * i]!, visibility };
      entries.push({ ...entry, ...this.binding(words[(at >>> 2) + 2 * i + 1]!) });
    }
    return this.make((device) => device.createBindGroupLayout({ label: this.string(label), entries }));
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
    const bindGroupLayouts = [this.objects.get<GPUBindGroupLayout>(layout)];
    return this.make((device) => device.createPipelineLayout({ label: this.string(label), bindGroupLayouts }));
  }

  bindGroup(layout: number, at: number, count: number, label: number): number {
    const { HEAPU32, HEAPF64 } = this.heap();
    const entries: GPUBindGroupEntry[] = [];
    for (let i = 0; i < count; i++) {
      const word = (at >>> 2) + 8 * i;
      const object = this.objects.get<GPUBuffer | GPUTextureView | GPUSampler>(HEAPU32[word + 2]!);
      const resource = OBJECT_KINDS[HEAPU32[word + 1]!] === "buffer" ?
        { buffer: object as GPUBuffer, offset: HEAPF64[(word >>> 1) + 2]!, size: HEAPF64[(word >>> 1) + 3]! } :
        (object as GPUTextureView | GPUSampler);
      entries.push({ binding: HEAPU32[word]!, resource });
    }
    return this.make((device) =>
      device.createBindGroup({ label: this.string(label), layout: this.objects.get(layout), entries })
    );
  }

  private constants(at: number, count: number): Record<string, number> {
    const constants: Record<string, number> = {};
    for (let i = 0; i < count; i++)
      constants[this.string(at + 16 * i)] = this.heap().HEAPF64[(at >>> 3) + 2 * i + 1]!;
    return constants;
  }

  computePipeline(layout: number, module: number, entry: number, constants: number, count: number,
    label: number): number {
    return this.make((device) =>
      device.createComputePipeline({
        label: this.string(label),
        layout: this.objects.get<GPUPipelineLayout>(layout),
        compute: { module: this.objects.get(module), entryPoint: this.string(entry),
          constants: this.constants(constants, count) },
      })
    );
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
    const descriptor = {
      label: this.string(label),
      layout: this.objects.get<GPUPipelineLayout>(layout),
      vertex: { module: this.objects.get(module), entryPoint: this.string(at + 40), constants },
      primitive: { topology: HEAPU32[word] ? "line-list" : "triangle-list",
        cullMode: HEAPU32[word + 1] ? "back" : "none" },
      multisample: { count: HEAPU32[word + 4]! },
      ...(depth && { depthStencil: {
        format: depth,
        depthWriteEnabled: HEAPU32[word + 5] !== 0,
        depthCompare: HEAPU32[word + 6] ? "less-equal" : "less",
        depthBias: HEAP32[word + 8]!,
        depthBiasSlopeScale: HEAPF32[word + 9]!,
      } }),
      ...(fragmentEntry && { fragment: {
        module: this.objects.get(module),
        entryPoint: fragmentEntry,
        constants,
        targets: color ? [{ format: color, ...(HEAPU32[word + 7] && { blend: over }) }] : [],
      } }),
    } as GPURenderPipelineDescriptor;
    return this.make((device) => device.createRenderPipeline(descriptor));
  }

  texture(width: number, height: number, sampleCount: number, format: number, usage: number, label: number): number {
    return this.make((device) =>
      device.createTexture({
        label: this.string(label),
        size: [width, height],
        sampleCount,
        format: TEXTURE_FORMATS[format]!,
        usage: flags(usage, TEXTURE_USAGE),
      })
    );
  }

  textureView(texture: number, label: number): number {
    return this.make(() => this.objects.get<GPUTexture>(texture).createView({ label: this.string(label) }));
  }

  sampler(linear: number, repeat: number, comparison: number, label: number): number {
    const filter = linear ? "linear" : "nearest";
    const address = repeat ? "repeat" : "clamp-to-edge";
    return this.make((device) =>
      device.createSampler({
        label: this.string(label),
        magFilter: filter,
        minFilter: filter,
        addressModeU: address,
        addressModeV: address,
        ...(comparison && { compare: "less-equal" as const }),
      })
    );
  }

  queries(count: number, label: number): number {
    return this.make((device) => device.createQuerySet({ label: this.string(label), type: "timestamp", count }));
  }

  // Frames

  submit(lists: number, count: number): void {
    if (this.given) this.caught((device) => this.submitOn(device, lists, count));
    else this.submitOn(this.need(), lists, count); // whose errors arrive uncaptured, and cost a frame nothing
  }

  private submitOn(device: GPUDevice, lists: number, count: number): void {
    const encoder = device.createCommandEncoder();
    for (let i = 0; i < count; i++) {
      const word = (lists >>> 2) + 3 * i;
      const words = this.heap().HEAPU32;
      this.encoder.encode(encoder, words[word]! >>> 2, words[word + 1]!, words[word + 2]! >>> 2);
    }
    this.submitted[0] = encoder.finish();
    device.queue.submit(this.submitted);
  }

  // Bytes that come back

  map(buffer: number, bytes: number, state: number): void {
    const generation = this.generation;
    const settle = (value: number) => {
      if (generation === this.generation) this.heap().HEAPU32[state >>> 2] = value;
    };
    if (this.lost !== null) return settle(MAP_FAILED);
    const act = () => this.objects.get<GPUBuffer>(buffer).mapAsync(MAP_READ, 0, bytes);
    const mapped: Promise<void> = (this.given ? this.caught(act) : act())
      .then(() => settle(MAP_READY), () => settle(MAP_FAILED))
      .then(() => void this.maps.delete(mapped));
    this.maps.add(mapped);
  }

  takeMapped(buffer: number, target: number, size: number): void {
    const object = this.objects.get<GPUBuffer>(buffer);
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

  private setText(text: string): void {
    this.text = new TextEncoder().encode(text);
  }
}
