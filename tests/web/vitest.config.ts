import { join } from "node:path";
import { defineConfig } from "vitest/config";

// Two at once: a page compiles its kernels on one core. A time limit ends a hang and says nothing else: it is ten times
// the one under which every test passes on two idle cores.
export default defineConfig({
  test: {
    root: import.meta.dirname,
    include: ["**/*.test.ts"],
    pool: "forks",
    maxWorkers: 2,
    testTimeout: 1_200_000,
    hookTimeout: 1_200_000,
    globalSetup: join(import.meta.dirname, "adapter.ts"),
  },
});
