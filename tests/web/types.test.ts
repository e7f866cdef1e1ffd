// The page, the tests and the scripts are of the types that they name.
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { expect, it } from "vitest";
import { ROOT } from "./chromium.ts";

it("the compiler finds no error in the page, its tests and the scripts", () => {
  const run = spawnSync(join(ROOT, "node_modules/.bin/tsc"), ["--noEmit"], { cwd: ROOT, encoding: "utf8" });
  expect(run.stdout).toBe("");
  expect(run.status).toBe(0);
});
