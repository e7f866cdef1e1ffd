import type { GpuObjects } from "./gpu_objects.js";
import type { Memory } from "./gpu_tables.js";

// Where a Command and a RenderTarget have what (src/gpu/web/layout.hpp); tests/web/layouts_backend.test.ts compares
// them.
const enum Kind {
  BeginCompute,
  EndCompute,
  Dispatch,
  CopyBuffer,
  ClearBuffer,
  ResolveQueries,
  BeginRender,
  EndRender,
  Draw,
  CopyTexture,
}
const COMMAND_WORDS = 16; // kind 0, ids 1 to 3, args 4 to 8, sizes (two words each) 10 to 15
const TARGET_WORDS = 14; // color, resolve, depth; clear colour (f64) from 4; store_depth 12
const NO_TIMESTAMP = 0xffffffff;

/** The canvas as the module knows it: a handle whose texture is another one in every frame. */
export interface CanvasTarget {
  handle(): number;
  view(): GPUTextureView;
}

/** Turns flat command lists, read where they lie in the module's memory, into WebGPU's commands. */
export class FrameEncoder {
  // Filled in and used again for every pass: a frame makes no objects of its own.
  private readonly computePass: GPUComputePassDescriptor = {};
  private readonly color: GPURenderPassColorAttachment = {
    view: null as unknown as GPUTextureView,
    loadOp: "clear",
    storeOp: "store",
    clearValue: [0, 0, 0, 1],
  };
  private readonly depth: GPURenderPassDepthStencilAttachment = {
    view: null as unknown as GPUTextureView,
    depthLoadOp: "clear",
    depthStoreOp: "store",
    depthClearValue: 1,
  };
  private readonly colors: GPURenderPassColorAttachment[] = [];
  private readonly renderPass: GPURenderPassDescriptor = { colorAttachments: this.colors };

  constructor(private readonly objects: GpuObjects, private readonly memory: () => Memory,
    private readonly canvas: CanvasTarget) {}

  /** Encodes the `count` commands from word `first` on; their render targets begin at word `targets`. */
  encode(encoder: GPUCommandEncoder, first: number, count: number, targets: number): void {
    const words = this.memory().HEAPU32 as Uint32Array<ArrayBuffer>;
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
            compute!.setPipeline(this.objects.get<GPUComputePipeline>(pipeline));
          }
          const readsStep = words[at + 8] !== 0;
          if (readsStep) compute!.setBindGroup(0, this.objects.get<GPUBindGroup>(words[at + 2]!), words, at + 7, 1);
          else if (group !== words[at + 2]) compute!.setBindGroup(0, this.objects.get<GPUBindGroup>(words[at + 2]!));
          group = words[at + 2]!;
          compute!.dispatchWorkgroups(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          break;
        }
        case Kind.EndCompute:
          compute!.end();
          break;
        case Kind.CopyBuffer:
          encoder.copyBufferToBuffer(this.objects.get<GPUBuffer>(words[at + 1]!), size(words, at + 10),
            this.objects.get<GPUBuffer>(words[at + 2]!), size(words, at + 12), size(words, at + 14));
          break;
        case Kind.ClearBuffer:
          encoder.clearBuffer(this.objects.get<GPUBuffer>(words[at + 1]!), size(words, at + 10), size(words, at + 12));
          break;
        case Kind.ResolveQueries:
          encoder.resolveQuerySet(this.objects.get<GPUQuerySet>(words[at + 1]!), 0, words[at + 4]!,
            this.objects.get<GPUBuffer>(words[at + 2]!), 0);
          break;
        case Kind.BeginRender:
          render = encoder.beginRenderPass(this.describeRender(words, targets + TARGET_WORDS * words[at + 4]!));
          break;
        case Kind.Draw:
          render!.setPipeline(this.objects.get<GPURenderPipeline>(words[at + 1]!));
          render!.setBindGroup(0, this.objects.get<GPUBindGroup>(words[at + 2]!));
          if (words[at + 3] === 0) {
            render!.draw(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          } else {
            render!.setIndexBuffer(this.objects.get<GPUBuffer>(words[at + 3]!), "uint32");
            render!.drawIndexed(words[at + 4]!, words[at + 5]!, words[at + 6]!);
          }
          break;
        case Kind.EndRender:
          render!.end();
          break;
        case Kind.CopyTexture:
          encoder.copyTextureToBuffer({ texture: this.objects.get<GPUTexture>(words[at + 1]!) }, {
            buffer: this.objects.get<GPUBuffer>(words[at + 2]!),
            bytesPerRow: words[at + 6]!,
            rowsPerImage: words[at + 5]!,
          }, [words[at + 4]!, words[at + 5]!]);
          break;
      }
    }
  }

  private describeCompute(words: Uint32Array, at: number): GPUComputePassDescriptor {
    if (words[at + 1] === 0) return this.computePass;
    const time = (word: number) => (words[word] === NO_TIMESTAMP ? undefined : words[word]);
    return {
      timestampWrites: { querySet: this.objects.get<GPUQuerySet>(words[at + 1]!),
        beginningOfPassWriteIndex: time(at + 5), endOfPassWriteIndex: time(at + 6) },
    } as GPUComputePassDescriptor;
  }

  private describeRender(words: Uint32Array, at: number): GPURenderPassDescriptor {
    const [color, resolve, depth] = [words[at]!, words[at + 1]!, words[at + 2]!];
    this.colors.length = 0;
    if (color !== 0) {
      this.color.view = this.view(color);
      this.color.storeOp = resolve !== 0 ? "discard" : "store";
      if (resolve !== 0) this.color.resolveTarget = this.view(resolve);
      else delete this.color.resolveTarget;
      const clear = this.memory().HEAPF64;
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
    return id === this.canvas.handle() ? this.canvas.view() : this.objects.get<GPUTextureView>(id);
  }
}

/** A u64 of the module's memory; all of weft's are below 2^53. */
function size(words: Uint32Array, at: number): number {
  return words[at]! + words[at + 1]! * 0x100000000;
}
