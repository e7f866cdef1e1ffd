// The built page /compare in a Chromium that has WebGPU and WebGL 2, both on SwiftShader.
import { afterAll, beforeAll } from "vitest";
import type { Browser, BrowserContextOptions } from "playwright-core";
import type { CompareHandle } from "../../../apps/web/compare/main.js";
import { launch, SOFTWARE_FLAGS } from "../chromium.ts";
import { serve, visit, type Site, type Visit } from "../page/browser.ts";

declare const window: { readonly compare: CompareHandle }; // in the functions that the page runs

/** WebGL too: ANGLE on SwiftShader of its own, beside Vulkan's for WebGPU and its canvas. */
export const BOTH_FLAGS = [...SOFTWARE_FLAGS.filter((flag) => !flag.startsWith("--use-angle")), "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader"];

/** The site and a browser with both for all tests of a file. */
export function opened(): { readonly site: Site; readonly browser: Browser } {
  const here = {} as { site: Site; browser: Browser };
  beforeAll(async () => {
    here.site = await serve();
    here.browser = await launch(BOTH_FLAGS);
  });
  afterAll(async () => {
    await here.browser.close();
    await here.site.close();
  });
  return here;
}

/** The page with this address, once it knows whether it can measure. */
export async function compared(browser: Browser, site: Site, query: string, options: BrowserContextOptions = {}): Promise<Visit> {
  const seen = await visit(browser, `${site.address}compare/${query}`, { viewport: { width: 1280, height: 900 }, ...options });
  await seen.page.evaluate(() => window.compare.ready.catch(() => undefined));
  return seen;
}
