// Every shader must compile in Tint without a message, as it does in naga: the browser is the second home.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { create, globals } from "webgpu";

Object.assign(globalThis, globals);
const root = join(import.meta.dirname, "../../shaders");

/** The text of a shader with its includes put in, each once (src/gpu/shader_source.cpp). */
function load(path, seen = new Set()) {
  if (seen.has(path)) return "";
  seen.add(path);
  return readFileSync(join(root, path), "utf8")
    .split("\n")
    .map((line) => {
      const include = /^#include "(.+?)"/.exec(line);
      return include ? load(include[1], seen) : line;
    })
    .join("\n");
}

const gpu = create([]); // kept: Dawn ends the process where it is collected
const adapter = await gpu.requestAdapter();
if (!adapter) {
  console.error("Dawn finds no adapter.");
  process.exit(1);
}
const device = await adapter.requestDevice();
let compiled = 0;
let failed = 0;
for (const path of readdirSync(root, { recursive: true }).filter((name) => name.endsWith(".wgsl")).sort()) {
  const code = load(path);
  if (!/@(compute|vertex|fragment)\b/.test(code)) continue; // included by others
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ label: path, code });
  const { messages } = await module.getCompilationInfo();
  const error = await device.popErrorScope();
  for (const message of messages) console.error(`${path}: ${message.type} at line ${message.lineNum}: ${message.message}`);
  if (error) console.error(`${path}: ${error.message}`);
  compiled += 1;
  if (error || messages.length > 0) failed += 1;
}
console.log(`${compiled} shaders, ${failed} with messages`);
process.exit(failed === 0 && compiled > 0 ? 0 : 1);
