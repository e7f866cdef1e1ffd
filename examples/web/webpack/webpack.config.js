import { fileURLToPath } from "node:url";

export default {
  mode: "production",
  entry: "./main.js",
  output: { path: fileURLToPath(new URL("dist", import.meta.url)), clean: true },
  performance: { hints: false }, // the core alone has 2.6 MB, 0.9 of them on their way
};
