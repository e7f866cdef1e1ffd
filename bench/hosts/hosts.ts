// The same core on three hosts, one adapter: ms a step, and what a frame costs the host itself.
//   node bench/hosts/hosts.ts [--quick] [--sides 64,100,128] [--json FILE]
// CHROMIUM and WEBGPU_FLAGS name another browser and its flags; Vulkan's own variables choose the driver.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import * as weft from "weft-cloth";
import { openPage, ROOT, SOFTWARE_FLAGS, type Harness } from "../../tests/web/chromium.ts";
import { gpu } from "../../tests/web/node_gpu.ts";
import { changes, measureHost, measureSteps, STEPS_A_FRAME } from "./measure.js";

interface Summary {
  median: number;
  min: number;
  p95: number;
}
interface Row {
  host: string;
  nodes: number;
  adapter: string;
  ms_per_step: Summary;
  state_hash: string;
}

const args = process.argv.slice(2);
const quick = args.includes("--quick");
const option = (name: string) => (args.includes(name) ? args[args.indexOf(name) + 1] : undefined);
const json = option("--json");
const sizes = option("--sides")?.split(",").map(Number) ?? (quick ? [64, 128] : [64, 100, 128, 200, 256]);
const frames = quick ? 4 : 20;
const scene = readFileSync(join(ROOT, "scenes/hanging.json"), "utf8");

function native(n: number): Omit<Row, "host" | "nodes"> {
  const set = Object.entries(changes(n)).flatMap(([key, value]) => ["--set", `${key}=${JSON.stringify(value)}`]);
  const out = execFileSync(join(ROOT, "build/weft"), ["run", join(ROOT, "scenes/hanging.json"), "--frames",
    String(frames + 2), "--json", ...set], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  const { adapter, ms_per_frame, state_hash } = JSON.parse(out) as { adapter: string;
    ms_per_frame: { median: number; min: number }; state_hash: string };
  const a_step = (ms: number) => ms / STEPS_A_FRAME;
  return { adapter, ms_per_step: { median: a_step(ms_per_frame.median), min: a_step(ms_per_frame.min), p95: NaN },
    state_hash };
}

/** Measures in the page, which runs the same measure.js. */
async function inPage<T>(harness: Harness, call: string): Promise<T> {
  await harness.page.evaluate(() => {
    delete (window as { result?: unknown }).result;
  });
  await harness.script(`import * as weft from "weft-cloth"; import * as measure from "/bench/hosts/measure.js";
    const scene = await (await fetch("/scenes/hanging.json")).text();
    const where = { scene, canvas: document.querySelector("canvas") };
    window.result = await measure.${call};`);
  await harness.page.waitForFunction(() => "result" in window, undefined, { timeout: 0 });
  return harness.page.evaluate(() => (window as unknown as { result: T }).result);
}

const harness = await openPage(process.env["WEBGPU_FLAGS"]?.split(" ") ?? SOFTWARE_FLAGS, process.env["CHROMIUM"]);
const rows: Row[] = [];
for (const n of sizes) {
  const at = (host: string, row: Omit<Row, "host" | "nodes">) => {
    rows.push({ host, nodes: n * n, ...row });
    console.log(
      `${host.padEnd(9)} ${String(n * n).padStart(7)} nodes  ${row.ms_per_step.median.toFixed(4)} ms a step  ` +
        `${row.state_hash}  ${row.adapter}`,
    );
  };
  at("native", native(n));
  at("Node", await measureSteps(weft, { scene, canvas: null, gpu }, n, frames));
  at("Chromium", await inPage(harness, `measureSteps(weft, where, ${n}, ${frames})`));
}
const host = {
  "Node, nothing drawn": await measureHost(weft, { scene, canvas: null, gpu }, quick ? 40 : 200),
  "Chromium, drawn": await inPage<Summary>(harness, `measureHost(weft, where, ${quick ? 40 : 200})`),
};
for (const [name, times] of Object.entries(host))
  console.log(
    `${name}: ${times.median.toFixed(3)} ms of the host a frame of 64 substeps (95 %: ${times.p95.toFixed(3)})`,
  );
if (json)
  writeFileSync(json, `${JSON.stringify({ bench: "hosts", adapter: rows[0]!.adapter, rows, host }, null, 2)}\n`);
for (const complaint of harness.complaints) console.error(complaint);
await harness.close();
process.exit(harness.complaints.length > 0 ? 1 : 0);
