// Structs of C++ and WGSL agree: by the compiler's own offsets on one side, by reflection on the other.
import { describe, expect, it } from "vitest";
import { Const, Override, WgslParser, WgslReflect, type ArrayInfo, type LiteralExpr, type StructInfo,
  type TypeInfo } from "wgsl_reflect/wgsl_reflect.module.js";
import { layouts, type Constant, type Struct } from "./layouts.js";
import { loadShader, shaderPaths } from "./shaders.js";

const cpp = layouts();

/** f32 of vec4f, mat4x4f and array<vec4f, 9>. */
function scalar(type: TypeInfo): string {
  if (type.isArray) return scalar((type as ArrayInfo).format);
  const short = /^(?:vec\d|mat\dx\d)([fiu])$/.exec(type.name)?.[1];
  return short ? `${short}32` : type.name;
}

/** Where a WGSL struct and its mirror differ, as sentences. */
function differences(wgsl: StructInfo | null, mirror: Struct): string[] {
  if (!wgsl) return [`${mirror.file} has no struct ${mirror.name}.`];
  const members = wgsl.members.map(({ name, offset, size, type }) =>
    `${name}: ${scalar(type)} at ${offset}, ${size} bytes`
  );
  const mirrored = mirror.members.map(({ name, offset, size, scalar: kind }) =>
    `${name}: ${kind} at ${offset}, ${size} bytes`
  );
  const found = Array.from({ length: Math.max(members.length, mirrored.length) }, (_, i) => [members[i], mirrored[i]])
    .filter(([here, there]) => here !== there)
    .map(([here, there]) => `${mirror.name} has (${here}) in WGSL and (${there}) in C++.`);
  const rounded = Math.ceil(wgsl.size / mirror.rounded_to) * mirror.rounded_to;
  if (rounded !== mirror.size) found.push(`${mirror.name} has ${rounded} bytes by WGSL and ${mirror.size} in C++.`);
  return found;
}

const reflected = new Map(shaderPaths().map((path) => [path, new WgslReflect(loadShader(path))]));

/** A struct type and those of its members, with the stride where it is the element of an array. */
function structs(type: TypeInfo, stride: number | null = null): { name: string; stride: number | null }[] {
  if (type.isArray) {
    const { size, align } = (type as ArrayInfo).format as StructInfo;
    return structs((type as ArrayInfo).format, Math.ceil(size / align) * align); // wgsl_reflect's stride ignores @size
  }
  if (!type.isStruct) return [];
  const parts = (type as StructInfo).members.flatMap((member) => structs(member.type));
  return [{ name: type.name, stride }, ...parts.filter((part) => part.stride === null)];
}

/** The struct types of a shader's bindings. */
function bound(shader: WgslReflect): { name: string; stride: number | null }[] {
  return [...shader.uniforms, ...shader.storage].flatMap(({ type }) => structs(type));
}

function valueInWgsl({ file, name }: Constant): number | undefined {
  const declared = new WgslParser().parse(loadShader(file))
    .find((node) => (node instanceof Const || node instanceof Override) && node.name === name) as Const | undefined;
  return (declared?.value as LiteralExpr | undefined)?.scalarValue;
}

describe("a struct has the same members, offsets and size in C++ as in WGSL", () => {
  it.each(cpp.structs)("$name", (mirror) => {
    expect(differences(reflected.get(mirror.file)?.getStructInfo(mirror.name) ?? null, mirror)).toEqual([]);
  });
});

it("every struct of a binding has a mirror, its array the mirror's stride, and no mirror is without a binding", () => {
  const mirrors = new Map(cpp.structs.map((mirror) => [mirror.name, mirror]));
  const used = new Set<string>();
  for (const [path, shader] of reflected)
    for (const { name, stride } of bound(shader)) {
      used.add(name);
      expect(mirrors.has(name), `${path} binds ${name}, which tests/layouts/structs.cpp does not list.`).toBe(true);
      if (stride !== null) expect(mirrors.get(name)!.size, `the stride of ${name} in ${path}`).toBe(stride);
    }
  expect([...mirrors.keys()].filter((name) => !used.has(name))).toEqual([]);
});

it.each(cpp.constants)("$name of $file is the same number in C++", (constant) => {
  expect(valueInWgsl(constant)).toBe(constant.value);
});

it("every statistic of WGSL is compared", () => {
  const declared = [...loadShader("state/statistics.wgsl").matchAll(/^const (kStat\w+)/gm)].map(([, name]) => name);
  expect(cpp.constants.map(({ name }) => name).filter((name) => name.startsWith("kStat"))).toEqual(declared);
});

describe("the comparison bites", () => {
  const mirror: Struct = { name: "S", file: "s.wgsl", size: 32, rounded_to: 1, members: [
    { name: "a", offset: 0, size: 16, scalar: "f32" },
    { name: "b", offset: 16, size: 4, scalar: "u32" },
  ] };
  const compare = (text: string) => differences(new WgslReflect(text).getStructInfo("S"), mirror);

  it.each([
    ["the same", "struct S { a : vec4f, b : u32 }", []],
    ["another order", "struct S { b : u32, a : vec4f }", [
      "S has (b: u32 at 0, 4 bytes) in WGSL and (a: f32 at 0, 16 bytes) in C++.",
      "S has (a: f32 at 16, 16 bytes) in WGSL and (b: u32 at 16, 4 bytes) in C++.",
    ]],
    ["another offset", "struct S { a : vec4f, @align(8) @size(8) c : u32, b : u32 }", [
      "S has (c: u32 at 16, 8 bytes) in WGSL and (b: u32 at 16, 4 bytes) in C++.",
      "S has (b: u32 at 24, 4 bytes) in WGSL and (undefined) in C++.",
    ]],
    ["another type", "struct S { a : vec4f, b : f32 }", [
      "S has (b: f32 at 16, 4 bytes) in WGSL and (b: u32 at 16, 4 bytes) in C++.",
    ]],
    ["no such struct", "struct T { a : vec4f }", ["s.wgsl has no struct S."]],
  ])("%s", (_, text, sentences) => {
    expect(compare(text)).toEqual(sentences);
  });
});
