// The page /compare, headless: the paper's hanging cloth on WebGPU, WebGL 2 and the processor, in one browser.
//   node bench/web/compare.ts [--quick] [--json FILE] [--paths weft-node,cpu] [--sizes 64,128] [--most NODES]
//                             [--budget MS]
// It needs Node 24, node_modules/playwright-core, apps/web/dist (./dev bench web builds it) and a Chromium.
// CHROMIUM names another browser; WEBGPU_FLAGS, separated by spaces, replace the flags of the software adapters.
//
// On a machine with an NVIDIA GPU and its Vulkan driver, from the folder of the repository:
//   CHROMIUM=/path/to/chromium WEBGPU_FLAGS="--enable-unsafe-webgpu --enable-features=Vulkan --use-angle=vulkan \
//     --ignore-gpu-blocklist" python3 -m bench.paper --machine h100 --only chromium
// which runs this and stores what it measured in bench/results/h100.json.
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import type { CompareHandle } from "../../apps/web/compare/main.ts";
import { launchOwn, WEBGL_TOO_FLAGS } from "../../tests/web/chromium.ts";
import { serveFiles } from "./serve.ts";

declare const window: { readonly compare: CompareHandle }; // in the functions that the page runs

const ROOT = join(import.meta.dirname, "../..");
const PASSED_ON = ["paths", "sizes", "most", "budget"] as const; // to the page, which checks them

const { values: asked } = parseArgs({
  options: { quick: { type: "boolean", default: false },
    json: { type: "string", default: join(ROOT, "out/compare.json") }, paths: { type: "string" },
    sizes: { type: "string" }, most: { type: "string" }, budget: { type: "string" } },
});
const address = new URLSearchParams(asked.quick ? { most: "16384", budget: "500" } : {});
for (const key of PASSED_ON) if (asked[key] !== undefined) address.set(key, asked[key]);

const site = await serveFiles(join(ROOT, "apps/web/dist"));
const browser = await launchOwn(WEBGL_TOO_FLAGS);
let failed = false;
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  page.setDefaultTimeout(0);
  const complain = (text: string) => {
    failed = true;
    console.error(text);
  };
  page.on("console", (message) => {
    if (message.type() === "error") complain(message.text());
  });
  page.on("pageerror", (error) => complain(error.message));
  await page.goto(`${site.address}compare/?${address}`);
  await page.evaluate(() => window.compare.ready);

  const progress = page.locator("#progress");
  let said = "";
  const watch = setInterval(() =>
    void progress.textContent().then((text) => {
      if (text !== said) console.error(said = text ?? "");
    }, () => undefined), 500);
  await page.evaluate(() => window.compare.start());
  clearInterval(watch);
  const { report, text } = await page.evaluate(() => ({ report: window.compare.report(),
    text: window.compare.text() })
  );
  console.log(text);
  for (const { path, nodes, note } of report.rows) if (note !== null) console.log(`${path}, ${nodes} nodes: ${note}`);
  mkdirSync(dirname(asked.json), { recursive: true });
  writeFileSync(asked.json, `${JSON.stringify(report, null, 2)}\n`);
} catch (reason) {
  console.error(reason instanceof Error ? reason.message.replace(/^page\.\w+: (\w+: )?/, "").split("\n")[0] : reason);
  failed = true;
} finally {
  await browser.close();
  site.close();
}
process.exit(failed ? 1 : 0);
