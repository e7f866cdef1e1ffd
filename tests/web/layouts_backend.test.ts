// gpu_backend.ts reads numbers and structs that C++ wrote: it takes them for what C++ meant.
import { globals } from "webgpu";
import { beforeEach, describe, expect, it } from "vitest";
import { GpuBackend } from "../../packages/weft/src/gpu_backend.js";
import { COMMAND_KINDS, ERROR_KINDS, OBJECT_KINDS, TEXTURE_FORMATS } from "../../packages/weft/src/gpu_tables.js";
import { layouts, type Values } from "./layouts.js";

const { GPUBufferUsage, GPUTextureUsage } = globals as unknown as {
  GPUBufferUsage: Record<string, number>;
  GPUTextureUsage: Record<string, number>;
};
const cpp = layouts();

/** The enumerators by rising value, none left out. */
function inOrder(values: Values): string[] {
  const names = Object.keys(values).sort((a, b) => values[a]! - values[b]!);
  expect(names.map((name) => values[name])).toEqual(names.map((_, i) => i));
  return names;
}
const kebab = (name: string) => name.replace(/\B[A-Z]/g, "-$&").toLowerCase(); // DeviceLost: device-lost

describe("a table has an enumeration's names in its order", () => {
  it("ErrorKind", () => {
    expect(ERROR_KINDS).toEqual(inOrder(cpp.enums.ErrorKind).map(kebab));
  });
  it("ObjectKind", () => {
    expect(OBJECT_KINDS).toEqual(inOrder(cpp.enums.ObjectKind).map(kebab));
  });
  it("CommandKind", () => {
    expect(COMMAND_KINDS).toEqual(inOrder(cpp.enums.CommandKind).map(kebab));
  });
  it("TextureFormat", () => {
    const names = inOrder(cpp.enums.TextureFormat).map((name) => name.replace(/Srgb$/, "-srgb").toLowerCase());
    expect(TEXTURE_FORMATS.map((format) => format ?? "none")).toEqual(names);
  });
});

type Call = [name: string, ...args: unknown[]];

/** A copy in which an object of the GPU is its number. */
function unwrap(value: unknown): unknown {
  if (typeof value !== "object" || value === null) return value;
  if ("made" in value) return `object ${String(value.made)}`;
  if (Array.isArray(value)) return value.map(unwrap);
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unwrap(inner)]));
}

/** An encoder that writes down its calls; dynamic offsets as the numbers they stand for. */
function recorder(calls: Call[]): object {
  return new Proxy({}, {
    get: (_, name) => (...args: unknown[]) => {
      if (args[2] instanceof Uint32Array) { // setBindGroup(index, group, words, first, count)
        const [first, count] = args.splice(3) as [number, number];
        args[2] = [...args[2].subarray(first, first + count)];
      }
      calls.push([String(name), ...args.map(unwrap)]); // now: descriptors are used again
      return recorder(calls);
    },
  });
}

// The heap: a text of no characters, two arrays for what a call reads, and a list of commands.
const NO_TEXT = 0;
const ENTRIES = 64;
const LIST = 128;
const STATE = 192;
const TARGETS = 256;
const COMMANDS = 1024;

let view: DataView;
let calls: Call[];
let backend: GpuBackend;
let mapping: Promise<void>;

beforeEach(() => {
  const heap = new ArrayBuffer(1 << 14);
  view = new DataView(heap);
  calls = [];
  mapping = Promise.resolve();
  let made = 0;
  const make = (name: string) => (descriptor: object) => {
    calls.push([name, descriptor]);
    return { made: ++made };
  };
  backend = new GpuBackend(undefined);
  backend.attach({ HEAPU8: new Uint8Array(heap), HEAP32: new Int32Array(heap), HEAPU32: new Uint32Array(heap),
    HEAPF32: new Float32Array(heap), HEAPF64: new Float64Array(heap) });
  backend.device = {
    pushErrorScope: () => undefined,
    popErrorScope: () => Promise.resolve(null),
    createBuffer: (descriptor: object) => ({ ...make("createBuffer")(descriptor), mapAsync: () => mapping }),
    createTexture: make("createTexture"),
    createBindGroupLayout: make("createBindGroupLayout"),
    createCommandEncoder: () => recorder(calls),
    queue: { submit: () => undefined },
  } as unknown as GPUDevice;
});

describe("a bit of C++ is WebGPU's flag of that meaning", () => {
  it.each(
    Object.entries({ kStorage: "STORAGE", kUniform: "UNIFORM", kCopySource: "COPY_SRC", kCopyTarget: "COPY_DST",
      kIndex: "INDEX", kIndirect: "INDIRECT", kMapRead: "MAP_READ", kQueryResolve: "QUERY_RESOLVE",
      kVertex: "VERTEX" }),
  )("BufferUsage %s", (name, flag) => {
    backend.buffer(16, cpp.enums.BufferUsage[name]!, NO_TEXT);
    expect(calls).toEqual([["createBuffer", { label: "", size: 16, usage: GPUBufferUsage[flag] }]]);
  });

  it.each(
    Object.entries({ kRenderTarget: "RENDER_ATTACHMENT", kSampled: "TEXTURE_BINDING", kTextureCopySource: "COPY_SRC" }),
  )("TextureUsage %s", (name, flag) => {
    backend.texture(2, 3, 1, cpp.enums.TextureFormat["Depth32Float"]!, cpp.enums.TextureUsage[name]!, NO_TEXT);
    expect(calls).toMatchObject([["createTexture", { size: [2, 3], format: "depth32float",
      usage: GPUTextureUsage[flag] }]]);
  });

  it("knows every bit", () => {
    const { BufferUsage, TextureUsage } = cpp.enums;
    backend.buffer(16, Object.values(BufferUsage).reduce((a, b) => a | b), NO_TEXT);
    backend.texture(1, 1, 1, 1, Object.values(TextureUsage).reduce((a, b) => a | b), NO_TEXT);
    const usages = calls.map(([, descriptor]) =>
      (descriptor as { usage: number }).usage.toString(2).replaceAll("0", "").length
    );
    expect(usages).toEqual([Object.keys(BufferUsage).length, Object.keys(TextureUsage).length]);
  });
});

describe("a binding of C++ is WebGPU's", () => {
  const bindings: Record<string, object> = {
    Uniform: { buffer: { type: "uniform" } },
    StepUniform: { buffer: { type: "uniform", hasDynamicOffset: true } },
    StorageRead: { buffer: { type: "read-only-storage" } },
    StorageReadWrite: { buffer: { type: "storage" } },
    Texture: { texture: { sampleType: "float" } },
    DepthTexture: { texture: { sampleType: "depth" } },
    Sampler: { sampler: { type: "filtering" } },
    ComparisonSampler: { sampler: { type: "comparison" } },
  };
  it.each(inOrder(cpp.enums.BindingKind))("%s", (name) => {
    view.setUint32(ENTRIES, 5, true);
    view.setUint32(ENTRIES + 4, cpp.enums.BindingKind[name]!, true);
    backend.bindGroupLayout(ENTRIES, 1, 0, NO_TEXT);
    const visibility = 4; // COMPUTE
    expect(calls).toEqual([["createBindGroupLayout", { label: "",
      entries: [{ binding: 5, visibility, ...bindings[name] }] }]]);
  });
});

describe("a mapping reports with C++'s values", () => {
  it.each([
    ["Ready", () => Promise.resolve()],
    ["Failed", () => Promise.reject(new Error("lost"))],
  ])("%s", async (name, settle) => {
    const buffer = backend.buffer(16, cpp.enums.BufferUsage["kMapRead"]!, NO_TEXT);
    view.setUint32(STATE, cpp.enums.MapState["Pending"]!, true);
    mapping = settle();
    backend.map(buffer, 16, STATE);
    await new Promise(setImmediate);
    expect(view.getUint32(STATE, true)).toBe(cpp.enums.MapState[name]);
  });
});

interface Written {
  kind: string;
  ids?: number[];
  args?: number[];
  sizes?: number[];
}

/** Writes commands as C++ lays them out, submits them, and gives the calls that they became. */
function submit(commands: Written[], targets: (at: number) => void = () => undefined): Call[] {
  commands.forEach(({ kind, ids = [], args = [], sizes = [] }, i) => {
    const at = COMMANDS + i * cpp.command.size;
    for (let word = 0; word < cpp.command.size; word += 4) view.setUint32(at + word, 0xcdcdcdcd, true); // padding
    view.setUint8(at, cpp.enums.CommandKind[kind]!);
    [0, 1, 2].forEach((k) => {
      view.setUint32(at + cpp.command.ids + 4 * k, ids[k] ?? 0, true);
    });
    [0, 1, 2, 3, 4].forEach((k) => {
      view.setUint32(at + cpp.command.args + 4 * k, args[k] ?? 0, true);
    });
    [0, 1, 2].forEach((k) => {
      view.setBigUint64(at + cpp.command.sizes + 8 * k, BigInt(sizes[k] ?? 0), true);
    });
  });
  targets(TARGETS);
  [COMMANDS, commands.length, TARGETS].forEach((word, i) => {
    view.setUint32(LIST + 4 * i, word, true);
  });
  const ids = Array.from({ length: 5 }, () => backend.buffer(16, 1, NO_TEXT));
  expect(ids).toEqual([1, 2, 3, 4, 5]); // whatever they are: each is passed on as it stands
  calls.length = 0;
  backend.device!.createBuffer = () => {
    throw new Error("A submit makes nothing.");
  };
  backend.submit(LIST, 1);
  return calls;
}
describe("a command of C++ becomes WebGPU's call, with each number in its place", () => {
  it("compute", () => {
    expect(submit([
      { kind: "BeginCompute", ids: [1], args: [9, 3, 0xffffffff] },
      { kind: "Dispatch", ids: [2, 3], args: [7, 8, 9, 512, 1] },
      { kind: "EndCompute" },
      { kind: "BeginCompute" },
      { kind: "Dispatch", ids: [2, 4], args: [1, 2, 3, 512, 0] },
      { kind: "EndCompute" },
    ])).toEqual([
      ["beginComputePass", { timestampWrites: {
        querySet: "object 1",
        beginningOfPassWriteIndex: 3,
        endOfPassWriteIndex: undefined,
      } }],
      ["setPipeline", "object 2"],
      ["setBindGroup", 0, "object 3", [512]],
      ["dispatchWorkgroups", 7, 8, 9],
      ["end"],
      ["beginComputePass", {}],
      ["setPipeline", "object 2"],
      ["setBindGroup", 0, "object 4"],
      ["dispatchWorkgroups", 1, 2, 3],
      ["end"],
      ["finish"],
    ]);
  });

  it("copies", () => {
    const far = 2 ** 33 + 8; // more than 32 bits
    expect(submit([
      { kind: "CopyBuffer", ids: [1, 2], sizes: [far, 16, 32] },
      { kind: "ClearBuffer", ids: [3], sizes: [8, far] },
      { kind: "ResolveQueries", ids: [4, 5], args: [6] },
      { kind: "CopyTexture", ids: [1, 2], args: [64, 48, 256] },
    ])).toEqual([
      ["copyBufferToBuffer", "object 1", far, "object 2", 16, 32],
      ["clearBuffer", "object 3", 8, far],
      ["resolveQuerySet", "object 4", 0, 6, "object 5", 0],
      ["copyTextureToBuffer", { texture: "object 1" }, { buffer: "object 2", bytesPerRow: 256, rowsPerImage: 48 }, [64,
        48]],
      ["finish"],
    ]);
  });

  it("drawing, on the second of two targets", () => {
    expect(submit([
      { kind: "BeginRender", args: [1, 9] },
      { kind: "Draw", ids: [1, 2, 0], args: [3, 4, 5] },
      { kind: "Draw", ids: [1, 2, 3], args: [6, 7, 8] },
      { kind: "EndRender" },
    ], (at) => {
      const { size, color, resolve, depth, clear_color, store_depth } = cpp.render_target;
      view.setUint32(at + size + color, 3, true);
      view.setUint32(at + size + resolve, 4, true);
      view.setUint32(at + size + depth, 5, true);
      [0.25, 0.5, 0.75, 1].forEach((value, i) => {
        view.setFloat64(at + size + clear_color + 8 * i, value, true);
      });
      view.setUint32(at + size + store_depth, 0xcdcdcd01, true); // a bool and its padding
    })).toEqual([
      ["beginRenderPass", {
        colorAttachments: [{ view: "object 3", resolveTarget: "object 4", loadOp: "clear", storeOp: "discard",
          clearValue: [0.25, 0.5, 0.75, 1] }],
        depthStencilAttachment: { view: "object 5", depthLoadOp: "clear", depthStoreOp: "store", depthClearValue: 1 },
      }],
      ["setPipeline", "object 1"],
      ["setBindGroup", 0, "object 2"],
      ["draw", 3, 4, 5],
      ["setPipeline", "object 1"],
      ["setBindGroup", 0, "object 2"],
      ["setIndexBuffer", "object 3", "uint32"],
      ["drawIndexed", 6, 7, 8],
      ["end"],
      ["finish"],
    ]);
  });
});
