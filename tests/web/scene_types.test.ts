// The types of scenes are those of the schema; the compiler takes what the program takes, and refuses mistakes.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, expect, it } from "vitest";
import { sceneTypes, schemaOfProgram } from "../../scripts/make_scene_types.ts";
import { ROOT } from "./chromium.ts";

const folder = mkdtempSync(join(ROOT, "build/scene_types-"));
afterAll(() => rmSync(folder, { recursive: true }));

/** The lines of these scenes, one each, in which the compiler finds an error. */
function wrongLines(scenes: readonly string[]): number[] {
  const path = join(folder, "scenes.ts");
  const types = join(ROOT, "packages/weft/src/scene_types.ts");
  writeFileSync(path,
    scenes.map((scene, i) => `export const scene${i}: import(${JSON.stringify(types)}).SceneObject = ${scene};`).join(
      "\n",
    ));
  const options = ["--ignoreConfig", "--noEmit", "--strict", "--exactOptionalPropertyTypes",
    "--allowImportingTsExtensions", "--module", "ESNext", "--moduleResolution", "bundler"];
  const run = spawnSync(join(ROOT, "node_modules/.bin/tsc"), [...options, path], { cwd: ROOT, encoding: "utf8" });
  return [...new Set([...run.stdout.matchAll(/scenes\.ts\((\d+),/g)].map(([, line]) => Number(line) - 1))];
}

it("the types are those of the program's schema", () => {
  const types = readFileSync(join(ROOT, "packages/weft/src/scene_types.ts"), "utf8");
  expect(types === sceneTypes(schemaOfProgram()), "node scripts/make_scene_types.ts writes others").toBe(true);
});

it("every shipped scene is of the type", () => {
  const names = readdirSync(join(ROOT, "scenes")).filter((name) => name.endsWith(".json"));
  expect(names.length).toBeGreaterThan(20);
  const scenes = names.map((name) => JSON.stringify(JSON.parse(readFileSync(join(ROOT, "scenes", name), "utf8"))));
  expect(wrongLines(scenes).map((line) => names[line])).toEqual([]);
});

it("a mistake in a scene is found where it is typed", () => {
  const cloth = (more: string) => `{ format: "weft-scene/1", cloths: [{ density: 0.2, size: [1, 1], ${more} }] }`;
  const ball = (more: string) =>
    `{ format: "weft-scene/1", colliders: [{ kind: "sphere", center: [0, 0, 0], ${more} }] }`;
  const right = [cloth("grid: [4, 4]"), cloth("grid: [4, 4], pins: [\"top\", { nodes: [3] }]"),
    cloth("grid: [4, 4], fabric: \"denim_11oz\""), ball("radius: 1"),
    "{ format: \"weft-scene/1\", solver: { kind: \"xpbd\", iterations: 2 } }"];
  const wrong = [cloth("grid: [4, 4, 4]"), cloth("grid: [4, 4], pins: [\"topleft\"]"),
    cloth("grid: [4, 4], stifness: {}"), cloth("grid: [4, 4], fabric: \"denim\""), ball("radius: \"1\""),
    ball("size: [1, 1, 1]"), "{ cloths: [] }",
    "{ format: \"weft-scene/1\", solver: { kind: \"multigrid\", iterations: 2 } }"];
  expect(wrongLines([...right, ...wrong])).toEqual(wrong.map((_, i) => right.length + i));
});
