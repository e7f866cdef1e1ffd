// The shaders as the engine loads them.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

export const SHADERS = join(import.meta.dirname, "../../src");

/** Every shader's path in src/. */
export function shaderPaths(): string[] {
  return readdirSync(SHADERS, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".wgsl")).sort();
}

/** The text of a shader as it stands. */
export function readShader(path: string): string {
  return readFileSync(join(SHADERS, path), "utf8");
}

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

/** The text with blanks for its comments, so that lines keep their numbers; WGSL's block comments nest. */
export function withoutComments(text: string): string {
  let depth = 0; // of block comments
  let line = false; // in a comment that ends with its line
  return text.replace(/\/\*|\*\/|\/\/|\n|[^]/g, (token) => {
    if (token === "\n") {
      line = false;
      return token;
    }
    if (!line && token === "/*") depth += 1;
    else if (!line && depth > 0 && token === "*/") depth -= 1;
    else if (depth === 0 && token === "//") line = true;
    else if (depth === 0 && !line) return token;
    return " ".repeat(token.length);
  });
}
