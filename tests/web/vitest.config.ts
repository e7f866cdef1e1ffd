import { join } from "node:path";
import { defineConfig } from "vitest/config";

// One after the other: all of them share the machine's software adapter, and two cores.
export default defineConfig({
  test: {
    root: import.meta.dirname,
    include: ["**/*.test.ts"],
    pool: "forks",
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 120_000,
    globalSetup: join(import.meta.dirname, "adapter.ts"),
  },
});
