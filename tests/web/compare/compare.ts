// The built page /compare in a Chromium that has WebGPU and WebGL 2, both on SwiftShader.
import type { Browser, BrowserContextOptions } from "playwright-core";
import type { CompareHandle } from "../../../apps/web/compare/main.js";
import { WEBGL_TOO_FLAGS } from "../chromium.ts";
import { opened, visit, type Site, type Visit } from "../page/browser.ts";

declare const window: { readonly compare: CompareHandle }; // in the functions that the page runs

/** The site and a browser with both for all tests of a file. */
export const openedWithBoth = () => opened(WEBGL_TOO_FLAGS);

/** The page with this address, once it knows whether it can measure. */
export async function compared(browser: Browser, site: Site, query: string,
  options: BrowserContextOptions = {}): Promise<Visit> {
  const seen = await visit(browser, `${site.address}compare/${query}`, { viewport: { width: 1280, height: 900 },
    ...options });
  await seen.page.evaluate(() => window.compare.ready.catch(() => undefined));
  return seen;
}
