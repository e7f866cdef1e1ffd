// The shaders as the engine loads them.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

export const SHADERS = join(import.meta.dirname, "../../shaders");

/** Every shader's path in shaders/. */
export function shaderPaths(): string[] {
  return readdirSync(SHADERS, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".wgsl")).sort();
}

/** The text of a shader as it stands. */
export function readShader(path: string): string { return readFileSync(join(SHADERS, path), "utf8"); }

/** The text of a shader with its includes put in, each once (src/gpu/shader_source.cpp). */
export function loadShader(path: string, seen = new Set<string>()): string {
  if (seen.has(path)) return "";
  seen.add(path);
  return readShader(path)
    .split("\n")
    .map((line) => {
      const included = /^#include "(.+?)"/.exec(line)?.[1];
      return included ? loadShader(included, seen) : line;
    })
    .join("\n");
}
