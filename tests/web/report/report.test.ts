// report/index.html, made from the stored results, in a browser: by itself, without complaints, and to be read by
// everyone.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { violations } from "../axe.ts";
import { launch, ROOT } from "../chromium.ts";
import { visit } from "../page/browser.ts";

const out = mkdtempSync(join(tmpdir(), "weft-report-"));
const address = pathToFileURL(join(out, "index.html")).href;
let browser: Browser;
beforeAll(async () => {
  execFileSync("/usr/bin/python3", ["-B", "-m", "bench.paper", "--only", "report", "--out", out], { cwd: ROOT,
    stdio: "pipe" });
  browser = await launch([]);
});
afterAll(async () => {
  await browser.close();
  rmSync(out, { recursive: true });
});

for (const colorScheme of ["light", "dark"] as const)
  test(`it opens without errors or requests, and axe finds nothing, in the ${colorScheme} theme`, async () => {
    const { page, errors, requests } = await visit(browser, address, { viewport: { width: 1280, height: 900 },
      colorScheme });
    expect(await page.locator("figure, table").count()).toBeGreaterThan(20);
    expect(await violations(page)).toEqual([]);
    expect(errors).toEqual([]);
    expect(requests.filter((one) => one !== address && !one.startsWith("data:"))).toEqual([]);
    await page.context().close();
  });

test("every picture and every video is whole", async () => {
  const { page } = await visit(browser, address);
  const broken = await page.evaluate(async () => {
    const pictures = [...document.querySelectorAll("img")];
    await Promise.all(pictures.map((one) => one.decode().catch(() => undefined)));
    const videos = [...document.querySelectorAll("video")];
    await Promise.all(videos.map((one) =>
      new Promise((done) => {
        one.onloadedmetadata = one.onerror = done;
        one.preload = "metadata";
        one.load();
      })
    ));
    return [pictures.length, videos.length, ...pictures.filter((one) => one.naturalWidth < 300).map((one) => one.alt),
      ...videos.filter((one) => !(one.duration > 1)).map((one) => one.getAttribute("aria-label"))];
  });
  expect(broken.slice(2)).toEqual([]);
  expect(Number(broken[0])).toBeGreaterThan(10);
  expect(Number(broken[1])).toBeGreaterThan(1);
  await page.context().close();
});

test("no text of a plot is cut off, and none lies on another", async () => {
  const { page } = await visit(browser, address, { viewport: { width: 1280, height: 900 } });
  const faults = await page.evaluate(() =>
    [...document.querySelectorAll("svg")].flatMap((svg) => {
      const frame = svg.getBoundingClientRect();
      const boxes = [...svg.querySelectorAll("text")].map((text) => ({ text: text.textContent!,
        box: text.getBoundingClientRect() })
      );
      const cut = boxes.filter(({ box }) =>
        box.left < frame.left || box.right > frame.right || box.top < frame.top || box.bottom > frame.bottom
      );
      const over = boxes.flatMap((a, k) =>
        boxes.slice(k + 1).filter((b) =>
          a.box.left < b.box.right && b.box.left < a.box.right &&
          a.box.top + 2 < b.box.bottom && b.box.top + 2 < a.box.bottom
        ).map((b) => `${a.text} on ${b.text}`)
      );
      return [...cut.map(({ text }) => `cut: ${text}`), ...over];
    })
  );
  expect(faults).toEqual([]);
  await page.context().close();
});

for (const width of [320, 400, 1280])
  test(`at ${width} pixels only tables and plots are scrolled sideways`, async () => {
    const { page } = await visit(browser, address, { viewport: { width, height: 800 } });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
    await page.context().close();
  });

test("on paper every table fits", async () => {
  const { page } = await visit(browser, address, { viewport: { width: 1017, height: 718 } }); // A4 less margins
  await page.emulateMedia({ media: "print" });
  const wide = await page.evaluate(() =>
    [...document.querySelectorAll("table, svg")].filter((one) => one.getBoundingClientRect().right > innerWidth + 1)
      .map((one) => one.textContent!.slice(0, 60))
  );
  expect(wide).toEqual([]);
  await page.context().close();
});
