// Makes packages/weft/src/scene_types.ts from the JSON Schema of scenes: node scripts/make_scene_types.ts, once
// ./dev build has made build/weft. The types say which keys there are, what they hold and which must be there; ranges,
// and which keys go together, the core checks.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { formatted } from "./web_formatter.ts";

const ROOT = join(import.meta.dirname, "..");
const PATH = "packages/weft/src/scene_types.ts";
const LONGEST_TUPLE = 4;
const LONGEST_LINE = 100; // of a comment, before it is indented

interface Schema {
  readonly $ref?: string;
  readonly const?: unknown;
  readonly enum?: readonly unknown[];
  readonly type?: string;
  readonly anyOf?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly prefixItems?: readonly Schema[];
  readonly items?: Schema;
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly required?: readonly string[];
  readonly description?: string;
  readonly default?: unknown;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

/** "collider_motion" is SceneColliderMotion. */
const nameOf = (word: string) =>
  `Scene${word.split("_").map((part) => part[0]!.toUpperCase() + part.slice(1)).join("")}`;

function listType({ prefixItems, items = {}, minItems, maxItems }: Schema): string {
  if (prefixItems) return `readonly [${prefixItems.map(typeOf).join(", ")}]`;
  const item = typeOf(items);
  if (minItems !== maxItems || maxItems! > LONGEST_TUPLE) return `readonly (${item})[]`;
  return `readonly [${Array.from({ length: maxItems! }, () => item).join(", ")}]`;
}

/** The words in lines of so many characters at most. */
function wrapped(text: string): string[] {
  const lines = [""];
  for (const word of text.split(" ")) {
    const last = lines.at(-1)!;
    if (last.length + word.length < LONGEST_LINE) lines[lines.length - 1] = last === "" ? word : `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

function comment({ description = "", default: standard }: Schema): string {
  const text = standard === undefined ? description : `${description} Default: ${JSON.stringify(standard)}`;
  return text === "" ? "" : `/** ${wrapped(text).join("\n * ")} */\n`;
}

function body({ properties = {}, required = [] }: Schema): string {
  const members = Object.entries(properties).map(([key, schema]) =>
    `${comment(schema)}readonly ${key}${required.includes(key) ? "" : "?"}: ${typeOf(schema)}${
      required.includes(key) ? "" : " | undefined"
    };\n`
  );
  return `{\n${members.join("")}}`;
}

function typeOf(schema: Schema): string {
  if (schema.$ref !== undefined) return nameOf(schema.$ref.replace("#/$defs/", ""));
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((word) => JSON.stringify(word)).join(" | ");
  const some = schema.anyOf ?? schema.oneOf;
  if (some) return some.map(typeOf).join(" | ");
  if (schema.type === "array") return listType(schema);
  if (schema.type === "object") return body(schema);
  return schema.type === "integer" ? "number" : schema.type!;
}

/** The file of the types of a schema. */
export function sceneTypes(schema: Schema): string {
  const types = Object.entries(schema.$defs!).map(([word, one]) => `export type ${nameOf(word)} = ${typeOf(one)};\n`);
  return formatted(
    PATH,
    "// Made by scripts/make_scene_types.ts from the JSON Schema of scenes: `weft schema`.\n\n" +
      `/** A scene: docs/scene.md. */\nexport interface SceneObject ${body(schema)}\n\n${types.join("\n")}`,
  );
}

export function schemaOfProgram(): Schema {
  return JSON.parse(execFileSync(join(ROOT, "build/weft"), ["schema"], { encoding: "utf8" })) as Schema;
}

if (import.meta.main) writeFileSync(join(ROOT, PATH), sceneTypes(schemaOfProgram()));
