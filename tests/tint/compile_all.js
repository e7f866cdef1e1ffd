// Every shader must compile in Tint without a message, as it does in naga: the browser is the second home.
import { create, globals } from "webgpu";
import { loadShader, readShader, shaderPaths } from "../web/shaders.ts"; // Node strips the types

Object.assign(globalThis, globals);

const gpu = create([]); // kept: Dawn ends the process where it is collected
const adapter = await gpu.requestAdapter();
if (!adapter) {
  console.error("Dawn finds no adapter.");
  process.exit(1);
}
const device = await adapter.requestDevice();
const all = shaderPaths().map(readShader).join("\n");
let compiled = 0;
let failed = 0;
for (const path of shaderPaths()) {
  if (all.includes(`#include "${path}"`)) continue; // a part of others, compiled with them
  const code = loadShader(path);
  if (!/@(compute|vertex|fragment)\b/.test(code)) continue;
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ label: path, code });
  const { messages } = await module.getCompilationInfo();
  const error = await device.popErrorScope();
  for (const message of messages)
    console.error(`${path}: ${message.type} at line ${message.lineNum}: ${message.message}`);
  if (error) console.error(`${path}: ${error.message}`);
  compiled += 1;
  if (error || messages.length > 0) failed += 1;
}
console.log(`${compiled} shaders, ${failed} with messages`);
process.exit(failed === 0 && compiled > 0 ? 0 : 1);
