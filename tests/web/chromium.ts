// A real Chromium, headless, and a server for it with the headers that the package must live under.
import { createServer, type Server } from "node:http";
import { readFile } from "node:fs/promises";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { chromium, type Browser, type Page } from "playwright-core";
import { SLOW_ON_SWIFTSHADER } from "./adapter.ts";

declare global {
  interface Window {
    weft: typeof import("weft-cloth");
  }
}

export const ROOT = join(import.meta.dirname, "../..");
const TYPES: Record<string, string> = { ".js": "text/javascript", ".wasm": "application/wasm",
  ".json": "application/json" };

const PACKAGE = "/packages/weft/build/index.js";

/** Compute alone needs the first two; a canvas needs all but the last (a subset fails at the first canvas texture). */
export const SOFTWARE_FLAGS = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan",
  "--use-vulkan=swiftshader", "--use-angle=vulkan", `--disable-dawn-features=${SLOW_ON_SWIFTSHADER}`];

/** WebGL 2 too: ANGLE on SwiftShader of its own, beside Vulkan's for WebGPU and its canvas. */
export const WEBGL_TOO_FLAGS = [...SOFTWARE_FLAGS.filter((flag) => !flag.startsWith("--use-angle")),
  "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** A machine's own browser and GPU: CHROMIUM names the one, WEBGPU_FLAGS, separated by spaces, stand for `flags`. */
export function launchOwn(flags: readonly string[]): Promise<Browser> {
  return launch(process.env["WEBGPU_FLAGS"]?.split(/\s+/).filter(Boolean) ?? flags, process.env["CHROMIUM"]);
}

/** Ends a hang, as the limits of vitest.config.ts do: a loaded machine may take its time [ms]. */
export const PATIENCE = 300_000;

export function launch(flags: readonly string[], executablePath = "/usr/bin/chromium"): Promise<Browser> {
  return chromium.launch({ executablePath, args: ["--headless=new", "--no-sandbox", ...flags], timeout: PATIENCE });
}

export interface Harness {
  page: Page;
  /** What the page said that it should not have: console errors, page errors, requests to elsewhere. */
  complaints: string[];
  /** Runs a module's text in the page, where "weft-cloth" stands for the package. */
  script(text: string): Promise<void>;
  close(): Promise<void>;
}

/** A page with window.weft and a canvas of 640 x 400, on an origin that serves the repository. */
export async function openPage(flags: readonly string[] = SOFTWARE_FLAGS, executablePath?: string): Promise<Harness> {
  const scripts = new Map<string, string>();
  const server = await serve(scripts);
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  const browser = await launch(flags, executablePath);
  const page = await browser.newPage({ viewport: { width: 700, height: 460 } });
  page.setDefaultTimeout(PATIENCE);
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!request.url().startsWith(origin)) complaints.push(request.url());
  });
  await page.goto(origin);
  await page.waitForFunction(() => "weft" in window);
  const script = async (text: string) => {
    const path = `/script${scripts.size}.js`;
    scripts.set(path, text.replaceAll(`"weft-cloth"`, `"${PACKAGE}"`));
    await page.addScriptTag({ type: "module", url: path });
  };
  const close = async () => {
    await browser.close();
    await new Promise((done) => server.close(done));
  };
  return { page, complaints, script, close };
}

async function serve(scripts: ReadonlyMap<string, string>): Promise<Server> {
  const server = createServer((request, response) => {
    response.setHeader("Content-Security-Policy",
      "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data:");
    // Isolated, a page has the clock's full resolution.
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Embedder-Policy", "require-corp");
    const path = normalize(decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname));
    if (path === "/") {
      response.setHeader("Content-Type", "text/html");
      response.end(
        "<!doctype html><link rel=\"icon\" href=\"data:,\"><script type=\"module\" src=\"/weft.js\"></script>" +
          "<canvas width=\"640\" height=\"400\"></canvas>",
      );
      return;
    }
    const script = path === "/weft.js" ? `import * as weft from "${PACKAGE}"; window.weft = weft;` : scripts.get(path);
    if (script !== undefined) {
      response.setHeader("Content-Type", "text/javascript");
      response.end(script);
      return;
    }
    readFile(join(ROOT, path)).then((bytes) => {
      response.setHeader("Content-Type", TYPES[extname(path)] ?? "application/octet-stream");
      response.end(bytes);
    }, () => {
      response.statusCode = 404;
      response.end();
    });
  });
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
  return server;
}
