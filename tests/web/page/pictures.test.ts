// The page at rest against stored pictures, at an eighth of its size: of letters only their grey is left, so that
// fonts' antialiasing does not count. To store new ones: WEFT_STORE_PICTURES=1.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { drawn, expectClean, opened, ready, visit } from "./browser.js";

const FOLDER = join(import.meta.dirname, "pictures");
const SMALLER = 8;
// Part of the pixels that may differ by more than 24 of 765 in colour; a line of text that wraps elsewhere is more.
const MOST_DIFFERING = 0.01;

const here = opened();

/** A PNG, made smaller where asked, as PNG and as RGBA; in the page, which has a decoder. */
function decoded(page: Page, png: Buffer, smaller: number): Promise<{ png: Buffer; rgba: Buffer }> {
  return page.evaluate(async ([base64, by]) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const [width, height] = [Math.floor(image.width / by), Math.floor(image.height / by)];
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d")!;
    context.imageSmoothingQuality = "high";
    context.drawImage(image, 0, 0, width, height);
    const text = (all: Uint8Array | Uint8ClampedArray) => {
      let letters = "";
      for (let i = 0; i < all.length; i += 4096) letters += String.fromCharCode(...all.subarray(i, i + 4096));
      return btoa(letters);
    };
    return { png: text(new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())),
      rgba: text(context.getImageData(0, 0, width, height).data) };
  }, [png.toString("base64"), smaller] as const).then(({ png, rgba }) => ({ png: Buffer.from(png, "base64"),
    rgba: Buffer.from(rgba, "base64") })
  );
}

function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 4)
    if (Math.abs(a[i]! - b[i]!) + Math.abs(a[i + 1]! - b[i + 1]!) + Math.abs(a[i + 2]! - b[i + 2]!) > 24) count++;
  return (4 * count) / a.length;
}

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]] as const)
  test(`at ${width} × ${height} the page looks as stored, in both themes`, async () => {
    const seen = await visit(here.browser, `${here.site.address}?scene=breeze&nodes=32`, { viewport: { width, height },
      reducedMotion: "reduce", colorScheme: "dark" });
    const { page } = seen;
    await ready(page);
    await page.locator("#notice-close").evaluate((button: HTMLElement) => button.click()); // it may have gone by itself
    if (width < 760) await page.getByRole("button", { name: "More" }).click();
    for (const colorScheme of ["dark", "light"] as const) {
      await page.emulateMedia({ colorScheme });
      await drawn(page);
      const now = await decoded(page, await page.screenshot(), SMALLER);
      const file = join(FOLDER, `${width}-${colorScheme}.png`);
      if (process.env["WEFT_STORE_PICTURES"]) {
        mkdirSync(FOLDER, { recursive: true });
        writeFileSync(file, now.png);
      }
      const stored = await decoded(page, readFileSync(file), 1);
      expect(now.rgba.length).toBe(stored.rgba.length);
      expect(differing(now.rgba, stored.rgba), file).toBeLessThan(MOST_DIFFERING);
    }
    expectClean(seen, here.site);
    await page.context().close();
  });
