// WebGPU in Node: Dawn, of the package webgpu.
import { create, globals } from "webgpu";
import { SLOW_ON_SWIFTSHADER } from "./adapter.ts";

Object.assign(globalThis, globals);
/** Kept for as long as the process lives: Dawn ends the process where it is collected. */
export const gpu: GPU = create([`disable-dawn-features=${SLOW_ON_SWIFTSHADER}`]);
