// The page as a visitor has it, headless: from opening to the first frame that moves, then how fast it plays, and a
// picture of it.
//   node bench/web/page.ts [--json FILE] [--pictures FOLDER] [--seconds S] [QUERY …]
// QUERY: of the page's address, as "scene=breeze". What it needs, and how another browser is named:
// bench/web/compare.ts.
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import type { Page } from "playwright-core";
import type { PageHandle } from "../../apps/web/src/main.ts";
import { launchOwn, WEBGL_TOO_FLAGS } from "../../tests/web/chromium.ts";
import { serveFiles } from "./serve.ts";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const ROOT = join(import.meta.dirname, "../..");
const { values: asked, positionals } = parseArgs({ allowPositionals: true, options: {
  json: { type: "string" },
  pictures: { type: "string" },
  seconds: { type: "string", default: "4" },
} });
const queries = positionals.length > 0 ? positionals : ["scene=breeze"];

interface Row {
  query: string;
  adapter: string;
  nodes: number;
  substeps: number;
  /** From opening the page to a frame that has moved; the page has been open in this browser before. */
  first_frame_ms: number;
  real_time_factor: number;
  frames_per_second: number;
  /** What the last frame cost the page's thread. */
  host_ms: number;
  contacts: number;
}

const readings = (page: Page) =>
  page.evaluate(() => {
    const { world } = window.weft;
    if (!world) return null;
    const { frames, seconds, contacts } = world.statistics;
    return { frames, seconds, contacts, at: performance.now(), host: world.hostMilliseconds };
  });

async function firstFrame(page: Page, address: string): Promise<number> {
  const start = performance.now();
  await page.goto(address);
  await page.evaluate(async () => void (await window.weft.ready));
  while (((await readings(page))?.frames ?? 0) < 1) await new Promise((wake) => setTimeout(wake, 5));
  return performance.now() - start;
}

async function measure(page: Page, site: string, query: string): Promise<Row> {
  const address = `${site}?${query}`;
  await firstFrame(page, address);
  await page.goto("about:blank");
  const first = await firstFrame(page, address);
  const before = (await readings(page))!;
  await new Promise((wake) => setTimeout(wake, 1000 * Number(asked.seconds)));
  const after = (await readings(page))!;
  const info = await page.evaluate(() => window.weft.world!.info);
  const seconds = (after.at - before.at) / 1000;
  return { query, adapter: info.adapter, nodes: info.nodes, substeps: info.substeps, first_frame_ms: first,
    real_time_factor: (after.seconds - before.seconds) / seconds,
    frames_per_second: (after.frames - before.frames) / seconds, host_ms: after.host, contacts: after.contacts };
}

const site = await serveFiles(join(ROOT, "apps/web/dist"));
const browser = await launchOwn(WEBGL_TOO_FLAGS);
const rows: Row[] = [];
let failed = false;
for (const [index, query] of queries.entries()) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 },
    colorScheme: index % 2 === 0 ? "light" : "dark" });
  const page = await context.newPage();
  page.on("pageerror", (error) => {
    failed = true;
    console.error(error.message);
  });
  const row = await measure(page, site.address, query);
  rows.push(row);
  console.log(
    `${query}: ${row.nodes} nodes, ${row.substeps} steps a frame, first frame after ${
      Math.round(row.first_frame_ms)
    } ms, ` +
      `${row.real_time_factor.toFixed(2)} × real time, ${row.frames_per_second.toFixed(1)} fps, host ${
        row.host_ms.toFixed(2)
      } ms`,
  );
  if (asked.pictures !== undefined) {
    mkdirSync(asked.pictures, { recursive: true });
    await page.screenshot({ path: join(asked.pictures, `${index}-${query.replace(/[^\w-]+/g, "_")}.png`) });
  }
  await context.close();
}
if (asked.json !== undefined) {
  mkdirSync(dirname(asked.json), { recursive: true });
  writeFileSync(asked.json, `${JSON.stringify({ bench: "page", browser: browser.version(), rows }, null, 2)}\n`);
}
await browser.close();
site.close();
process.exit(failed ? 1 : 0);
