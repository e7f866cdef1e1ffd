import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import type { Report } from "../../../apps/web/compare/report.js";
import { violations } from "../axe.ts";
import { launch } from "../chromium.ts";
import { expectClean, until } from "../page/browser.ts";
import { compared, openedWithBoth } from "./compare.ts";

const here = openedWithBoth();
const button = (page: Page, name: string) => page.getByRole("button", { name, exact: true });

async function finished(page: Page): Promise<void> {
  await until("it is done", async () => (await page.locator("#progress").textContent()) === "Done.");
}

async function downloaded(page: Page, name: string): Promise<string> {
  const [file] = await Promise.all([page.waitForEvent("download"), button(page, name).click()]);
  return readFile(await file.path(), "utf8");
}

test("table, plots and downloads fill in, and can be read again", async () => {
  const seen = await compared(here.browser, here.site, "?sizes=16,24&budget=20", {
    permissions: ["clipboard-read", "clipboard-write"],
  });
  const { page } = seen;
  await button(page, "Start").click();
  await finished(page);

  const cells = await page.locator("#table tbody td").allInnerTexts();
  expect(cells).toHaveLength(2 * 5);
  for (const cell of cells) expect(cell).toMatch(/^[\d.,]+ fps( ▾)?\n[\d.,]+ ms a frame\n[\d.,]+ ms a step$/);
  for (const id of ["frame-plot", "step-plot"])
    expect(await page.locator(`#${id} g.series .marker`).count()).toBe(2 * 5);
  expect(await page.locator("#verdicts li").count()).toBe(5);

  const report = JSON.parse(await downloaded(page, "Download JSON")) as Report;
  expect(report.hardware.webgpu?.architecture).toBe("swiftshader");
  expect(report.hardware.webgl2).toContain("SwiftShader");
  expect(report.rows.map(({ path, nodes }) => `${path} ${nodes}`)).toEqual(
    [256, 576].flatMap((nodes) =>
      ["weft-node", "weft-spring", "three-webgpu", "webgl2", "cpu"].map((path) => `${path} ${nodes}`)
    ),
  );
  for (const { ms_per_step: step, ms_per_frame: frame, fps, note } of report.rows) {
    expect(note).toBe(null);
    expect(step!.min).toBeGreaterThan(0);
    expect(step!.median).toBeGreaterThanOrEqual(step!.min);
    expect(fps).toBeCloseTo(1000 / frame!.median, 9);
  }

  const [head, ...lines] = (await downloaded(page, "Download CSV")).trimEnd().split("\r\n").map((line) =>
    line.split(",")
  );
  expect(lines).toHaveLength(report.rows.length);
  lines.forEach((line, i) => {
    const row = Object.fromEntries(head!.map((name, k) => [name, line[k]]));
    expect(row["path"]).toBe(`"${report.rows[i]!.path}"`);
    expect(Number(row["step_ms_median"])).toBe(report.rows[i]!.ms_per_step!.median);
    expect(Number(row["fps"])).toBe(report.rows[i]!.fps);
  });

  await button(page, "Copy as text").click();
  await until("it is said", async () => (await page.locator("#copied").textContent()) === "Copied.");
  const text = await page.evaluate(() => navigator.clipboard.readText());
  expect(text.split("\n").filter((line) => line.startsWith("|"))).toHaveLength(4);
  expectClean(seen, here.site);
  await page.context().close();
});

test("it can be paused and stopped, and started again", async () => {
  const seen = await compared(here.browser, here.site, "?sizes=16&budget=1000&paths=cpu");
  const { page } = seen;
  await button(page, "Start").click();
  await button(page, "Pause").click();
  expect(await button(page, "Pause").getAttribute("aria-pressed")).toBe("true");
  await page.waitForTimeout(2500); // two timings of a second would be over
  expect(await page.locator("#progress").textContent()).toContain("Measuring");
  await button(page, "Stop").click();
  await until("it has stopped", async () => (await page.locator("#progress").textContent()) === "Stopped.");
  expect(await page.locator("#table tbody td").innerText()).toContain("Stopped.");
  await button(page, "Start").click();
  await finished(page);
  expect(await page.locator("#table tbody td").innerText()).toContain("fps");
  expectClean(seen, here.site);
  await page.context().close();
});

test("an odd address is refused on the page, and nothing can be started", async () => {
  const seen = await compared(here.browser, here.site, "?paths=<b>cuda</b>");
  await until("it is said", () => seen.page.locator("#error").isVisible());
  expect(await seen.page.locator("#error").textContent()).toContain(`There is no path "<b>cuda</b>"`);
  expect(await button(seen.page, "Start").isDisabled()).toBe(true);
  expectClean(seen, here.site);
  await seen.page.context().close();
});

test("without WebGPU its paths say so and the others run; without WebGL 2 likewise", async () => {
  for (const [flags, missing, sentence] of [
    [["--use-angle=swiftshader", "--enable-unsafe-swiftshader"], [0, 1, 2], "This browser offers no WebGPU adapter."],
    [["--disable-3d-apis"], [0, 1, 2, 3, 4], null],
  ] as const) {
    const browser = await launch(flags);
    try {
      const seen = await compared(browser, here.site, "?sizes=16&budget=20");
      await button(seen.page, "Start").click();
      await finished(seen.page);
      const cells = await seen.page.locator("#table tbody td").allInnerTexts();
      cells.forEach((cell, i) => {
        if (!(missing as readonly number[]).includes(i)) expect(cell).toContain("fps");
        else expect(cell).toBe(sentence ?? `This browser offers no WebG${i < 3 ? "PU adapter" : "L 2"}.`);
      });
      expectClean(seen, here.site);
    } finally {
      await browser.close();
    }
  }
});

for (const [device, viewport, colorScheme] of [["desktop", { width: 1440, height: 900 }, "dark"], ["phone", {
  width: 390,
  height: 844,
}, "light"]] as const)
  test(`on a ${device} the page has no fault that axe knows, and nothing sticks out`, async () => {
    const seen = await compared(here.browser, here.site, "?sizes=16,24&budget=10&paths=cpu,webgl2", { viewport,
      colorScheme, bypassCSP: true });
    const { page } = seen;
    await button(page, "Start").click();
    await finished(page);
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    const small = await page.locator("button, .home").evaluateAll((all) =>
      all.map((one) => [one.textContent, one.getBoundingClientRect()] as const)
        .filter(([, box]) => box.width < 44 || box.height < 44).map(([name]) => name)
    );
    expect(small).toEqual([]);
    await page.context().close();
  });

test("the pages lead to each other, and the main page loads nothing of three.js and less than 1 MB", async () => {
  const seen = await compared(here.browser, here.site, "?paths=weft-node&sizes=16");
  const { page } = seen;
  await page.getByRole("link", { name: "weft", exact: true }).click();
  await page.waitForURL(here.site.address);
  await page.waitForLoadState("networkidle");
  const main = seen.requests.slice(seen.requests.lastIndexOf(here.site.address));
  const own = await Promise.all(
    main.filter((address) => !/\.(ply|json|webp)$/.test(address)).map(async (address) =>
      Buffer.from(await (await fetch(address)).arrayBuffer())
    ),
  );
  expect(main.filter((address) => address.endsWith(".js")).length).toBeGreaterThan(1);
  for (const file of own) expect(file.includes("WebGLRenderer")).toBe(false);
  expect(own.reduce((sum, file) => sum + gzipSync(file).length, 0)).toBeLessThan(1e6);
  await page.getByRole("link", { name: "Speed test" }).click();
  await page.waitForURL(`${here.site.address}compare/`);
  expect(await page.locator("h1").textContent()).toContain("compared");
  expectClean(seen, here.site);
  await page.context().close();
});
