import { describe, expect, it } from "vitest";
import { readShader, shaderPaths } from "./shaders.js";
import { lint, unusedExceptions } from "./wgsl_lint.js";

const kernels = shaderPaths().filter((path) => !/^render\/|\/test\//.test(path)); // pictures have no bits to keep

it("finds the kernels of every method", () => {
  expect(kernels).toEqual(
    expect.arrayContaining(["contact/pushes/bvh.wgsl", "state/surface.wgsl", "method/mass_spring/advance_grid.wgsl",
      "state/integrate.wgsl"]),
  );
});

it.each(kernels)("%s leaves no bit to the driver", (path) => {
  expect(lint(path, readShader(path))).toEqual([]);
});

it("no exception outlives its reason", () => {
  expect(unusedExceptions(readShader)).toEqual([]);
});

/** The rules that a line breaks. */
const broken = (line: string, path = "a/b.wgsl") =>
  lint(path, `// A file.\n${line}\n`).map((sentence) => /^.+?:2: ([\w-]+): /.exec(sentence)?.[1]);

describe("each rule bites", () => {
  const names = `sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 log log2 pow normalize mix
    smoothstep inverseSqrt degrees radians reflect refract faceForward`.split(/\s+/);
  it.each(names)("inexact: %s", (name) => {
    expect(broken(`let y = 2.0 * ${name} (x);`)).toEqual(["inexact"]);
  });

  it.each([
    ["fma", "let y = fma(a, b, c);"],
    ["nan-test", "if (x != x) { return; }"],
    ["nan-test", "let finite = v[i].x == v[i].x;"],
    ["nan-test", "return !(sum.y==sum.y) || late;"],
    ["f16", "enable f16;"],
    ["f16", "let y = vec3h(0);"],
    ["f16", "let y = 1.5h;"],
    ["float-atomic", "let r = atomicCompareExchangeWeak(&sums[i], old, bitcast<u32>(bitcast<f32>(old) + x));"],
  ])("%s: %s", (name, line) => {
    expect(broken(line)).toContain(name);
  });

  it("comment", () => {
    expect(lint("a.wgsl", "struct S { x : f32 }\n")).toEqual([
      "a.wgsl:1: comment: the first line does not say what the file is.",
    ]);
    expect(lint("a.wgsl", "//\nstruct S { x : f32 }\n")).toHaveLength(1);
  });

  it("an exception is for its file and its rule alone", () => {
    expect(broken("let y = fma(a, b, c);", "contact/pushes/triangle_pair.wgsl")).toEqual([]);
    expect(broken("let y = fma(a, sin(b), c);", "contact/pushes/triangle_pair.wgsl")).toEqual(["inexact"]);
  });
});

it.each([
  "// normalize(x) is not used, and x != x is no test.",
  "/* outer /* exp(x) */ sin(x) */ let y = 1.0;",
  "let y = dot(a, b) + length(c) + sqrt(d) + fract(e) + distance(f, g);",
  "let remix = mixed(a) + basin(b) + s.exp;",
  "if (a != b || a.x == b.x || a == a_old || a.x == x || x == x.y) { return; }",
  "if (x == x + 1u || 2u * x == x || p - x != x || a[x] == x || y.x != x) { return; }",
  "let mask = 0x7f800000u & bits;",
])("lets pass: %s", (line) => {
  expect(broken(line)).toEqual([]);
});
