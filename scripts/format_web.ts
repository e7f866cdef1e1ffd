// Formats TypeScript, JavaScript, CSS and HTML: node scripts/format_web.ts [--check] FILE...
import { readFileSync, writeFileSync } from "node:fs";
import { formatted } from "./web_formatter.ts";

const check = process.argv.includes("--check");
for (const path of process.argv.slice(2).filter((word) => word !== "--check")) {
  const text = readFileSync(path, "utf8");
  const wanted = formatted(path, text);
  if (wanted === text) continue;
  if (check) {
    process.exitCode = 1;
    console.log(`${path}: not as ./dev format writes it`);
  } else {
    writeFileSync(path, wanted);
  }
}
