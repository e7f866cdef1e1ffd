// The C++ compiler's layouts of everything shared with WGSL and TypeScript, printed by tests/layouts.
import { execFileSync } from "node:child_process";
import { join } from "node:path";

export interface Member {
  name: string;
  offset: number;
  size: number;
  scalar: string;
}
export interface Struct {
  name: string;
  file: string;
  size: number;
  rounded_to: number;
  members: Member[];
}
export interface Constant {
  name: string;
  file: string;
  value: number;
}
export type Values = Record<string, number>;
export interface Layouts {
  structs: Struct[];
  constants: Constant[];
  enums: Record<
    "ErrorKind" | "ObjectKind" | "TextureFormat" | "CommandKind" | "BindingKind" | "MapState" | "BufferUsage"
      | "TextureUsage",
    Values
  >;
  command: Record<"size" | "ids" | "args" | "sizes", number>; // bytes, in a browser's build
  render_target: Record<"size" | "color" | "resolve" | "depth" | "clear_color" | "store_depth", number>;
}

export function layouts(): Layouts {
  return JSON.parse(execFileSync(join(import.meta.dirname, "../../build/layouts"), { encoding: "utf8" })) as Layouts;
}
