import { readdirSync } from "node:fs";
import { join } from "node:path";
import { defineConfig } from "vitest/config";

/** Those of the four pages: in CI's part N every third has a turn, but for these. */
const DAILY = ["page/scenes.test.ts", "page/parameters.test.ts"];
const PART = process.env["WEFT_PART"];
const ofPages = ["page", "compare", "methods", "teach"].flatMap((folder) =>
  readdirSync(join(import.meta.dirname, folder)).map((file) => `${folder}/${file}`)
).filter((file) => file.endsWith(".test.ts") && !DAILY.includes(file));

// Two at once: a page compiles its kernels on one core. A time limit ends a hang and says nothing else: it is ten times
// the one under which every test passes on two idle cores.
export default defineConfig({
  test: {
    root: import.meta.dirname,
    include: ["**/*.test.ts"],
    exclude: PART === undefined ? [] : ofPages.filter((_, i) => (i + Number(PART)) % 3 !== 0),
    pool: "forks",
    maxWorkers: 2,
    testTimeout: 1_200_000,
    hookTimeout: 1_200_000,
    globalSetup: join(import.meta.dirname, "adapter.ts"),
  },
});
