import { join } from "node:path";
import { defineConfig } from "vitest/config";

// One after the other: all of them share the machine's software adapter, and two cores. A time limit ends a hang and
// says nothing else: it is ten times the one under which every test passes on two idle cores.
export default defineConfig({
  test: {
    root: import.meta.dirname,
    include: ["**/*.test.ts"],
    pool: "forks",
    fileParallelism: false,
    testTimeout: 1_200_000,
    hookTimeout: 1_200_000,
    globalSetup: join(import.meta.dirname, "adapter.ts"),
  },
});
