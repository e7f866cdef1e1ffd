// The built page, served as its users get it, in a Chromium whose GPU is SwiftShader.
import { existsSync } from "node:fs";
import { join } from "node:path";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { preview } from "vite";
import { afterAll, afterEach, beforeAll } from "vitest";
import { launch, PATIENCE, SOFTWARE_FLAGS } from "../chromium.ts";
import type { PageHandle } from "../../../apps/web/src/main.js";

declare const window: { readonly weft: PageHandle }; // in the functions that the page runs

const WEB = join(import.meta.dirname, "../../../apps/web");
/** Whether all is to be seen, however long it takes: ./dev test --long. */
export const LONG = process.env["WEFT_LONG"] === "1";

export interface Site {
  readonly address: string;
  close(): Promise<void>;
}

/** apps/web/dist on a free port, with the headers of its configuration. */
export async function serve(): Promise<Site> {
  if (!existsSync(join(WEB, "dist/index.html"))) throw new Error("apps/web/dist is missing: npx vite build apps/web.");
  const server = await preview({ root: WEB, configFile: join(WEB, "vite.config.ts"), logLevel: "error",
    preview: { port: 0, host: "127.0.0.1" } });
  const at = server.httpServer.address();
  if (at === null || typeof at === "string") throw new Error("The server has no port.");
  return { address: `http://127.0.0.1:${at.port}/`, close: () => server.close() };
}

/** The site and a browser with WebGPU for all tests of a file. */
export function opened(flags: readonly string[] = SOFTWARE_FLAGS): { readonly site: Site; readonly browser: Browser } {
  const here = {} as { site: Site; browser: Browser };
  beforeAll(async () => {
    here.site = await serve();
    here.browser = await launch(flags);
  });
  afterAll(async () => {
    await here.browser.close();
    await here.site.close();
  });
  return here;
}

/** A page that keeps what went wrong on it, and where it asked for what. */
export interface Visit {
  readonly page: Page;
  /** Errors of the console and of scripts. */
  readonly errors: string[];
  readonly requests: string[];
}

export async function visit(browser: Browser, address: string, options: BrowserContextOptions = {}): Promise<Visit> {
  const context = await browser.newContext({ viewport: { width: 800, height: 400 }, ...options });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  const errors: string[] = [];
  const requests: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(address);
  return { page, errors, requests };
}

/** A page a test, with these options unless it has others: opens what a query asks for. The page must end clean. */
export function pages(defaults: BrowserContextOptions = {}) {
  const here = opened();
  let seen: Visit | null = null;
  afterEach(async () => {
    if (!seen) return;
    expectClean(seen, here.site);
    await seen.page.context().close();
    seen = null;
  });
  return async (query: string, options: BrowserContextOptions = {}): Promise<Page> => {
    seen = await visit(here.browser, `${here.site.address}${query}`, { ...defaults, ...options });
    await ready(seen.page);
    return seen.page;
  };
}

/** Asks until it holds. Not in the page: its policy lets no text be run as a script. */
export async function until(what: string, holds: () => Promise<boolean>): Promise<void> {
  const end = performance.now() + PATIENCE;
  while (!(await holds())) {
    if (performance.now() > end) throw new Error(`After ${PATIENCE} ms still not: ${what}.`);
    await new Promise((wake) => setTimeout(wake, 50));
  }
}

/** The world is open and the page says so. */
export async function ready(page: Page): Promise<void> {
  await page.evaluate(async () => void (await window.weft.ready));
}

export const frames = (page: Page): Promise<number> => page.evaluate(() => window.weft.world!.statistics.frames);
export const running = (page: Page): Promise<boolean> => page.evaluate(() => window.weft.world!.running);
export const hash = (page: Page): Promise<string> =>
  page.evaluate(async () => (await window.weft.world!.snapshot()).hash);
/** x, y, z of every node [m]. */
export const positions = (page: Page): Promise<number[]> =>
  page.evaluate(async () => Array.from((await window.weft.world!.snapshot()).positions));

/** Waits for this many frames more. */
export async function play(page: Page, count: number): Promise<void> {
  const start = await frames(page);
  await until(`${count} more frames`, async () => (await frames(page)) >= start + count);
}

/** Returns when the browser has composed what the page has given it. */
export const composed = (page: Page): Promise<void> =>
  page.evaluate(() => new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));

/** Returns when the page's last change is on the screen: drawn, through the queue of the GPU, and composed. */
export async function drawn(page: Page): Promise<void> {
  await composed(page);
  await page.evaluate(async () => void (await window.weft.world!.snapshot()));
  await composed(page);
}

/** What is drawn: the canvas alone, as the compositor shows it, as RGBA. */
export async function picture(page: Page, canvas = "#canvas"): Promise<Uint8Array> {
  const box = (await page.locator(canvas).boundingBox())!;
  const png = (await page.screenshot({ clip: box })).toString("base64");
  const text = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d")!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let letters = "";
    for (let i = 0; i < data.length; i += 4096) letters += String.fromCharCode(...data.subarray(i, i + 4096));
    return btoa(letters);
  }, png);
  return new Uint8Array(Buffer.from(text, "base64"));
}

/** How much of two pictures differs by more than dithering and the rounding of colours. */
export function difference(a: Uint8Array, b: Uint8Array): number {
  let differing = 0;
  for (let i = 0; i < a.length; i += 4)
    if (Math.abs(a[i]! - b[i]!) + Math.abs(a[i + 1]! - b[i + 1]!) + Math.abs(a[i + 2]! - b[i + 2]!) > 24) differing++;
  return differing / (a.length / 4);
}

/** Standard deviation of the brightness, and its mean. */
export function brightness(image: Uint8Array): { mean: number; deviation: number } {
  let sum = 0, squares = 0;
  for (let i = 0; i < image.length; i += 4) {
    const value = (image[i]! + image[i + 1]! + image[i + 2]!) / 3;
    sum += value;
    squares += value * value;
  }
  const count = image.length / 4, mean = sum / count;
  return { mean, deviation: Math.sqrt(Math.max(0, squares / count - mean * mean)) };
}

/** Nothing went wrong in the page, and it asked nobody but its own server. */
export function expectClean({ errors, requests }: Visit, site: Site): void {
  if (errors.length > 0) throw new Error(`The page reports: ${errors.join(" | ")}`);
  const foreign = requests.filter((request) => !request.startsWith(site.address) && !request.startsWith("blob:"));
  if (foreign.length > 0) throw new Error(`The page asks elsewhere: ${foreign.join(", ")}`);
}

/** One frame from the rest state: the mean velocity of the nodes [m/s], what a change of gravity or wind shows in. */
export async function meanVelocity(page: Page): Promise<[number, number, number]> {
  return page.evaluate(async () => {
    const world = window.weft.world!;
    world.pause();
    await world.reset();
    await world.step();
    const { velocities } = await world.snapshot();
    const sum: [number, number, number] = [0, 0, 0];
    for (let i = 0; i < velocities.length; i++) sum[i % 3]! += (3 * velocities[i]!) / velocities.length;
    return sum;
  });
}
