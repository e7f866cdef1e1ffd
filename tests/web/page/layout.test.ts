import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { expectClean, opened, ready, visit } from "./browser.js";

const here = opened();

/** Controls that are too small to touch, stick out of the window or have no name. */
const badControls = (page: Page) =>
  page.evaluate(() => {
    const found: string[] = [];
    for (const control of document.querySelectorAll<HTMLElement>("button, select, input, summary")) {
      if (control.offsetParent === null) continue;
      const name = control.getAttribute("aria-label") ??
        control.textContent + ((control as HTMLInputElement).labels?.[0]?.textContent ?? "");
      if (!name.trim()) found.push(`${control.id} has no name`);
      const box = (control.closest("label") ?? control).getBoundingClientRect();
      if (box.width < 44 || box.height < 44) found.push(`${name.trim()}: ${box.width} × ${box.height} pixels`);
      if (box.left < 0 || box.right > innerWidth) found.push(`${name.trim()} sticks out: ${box.left} to ${box.right}`);
      if (control.scrollWidth > control.clientWidth + 1 && control.tagName === "BUTTON")
        found.push(
          `${name.trim()} is clipped`,
        );
    }
    return found;
  });

/** Texts with less contrast than WCAG AA asks for, 4.5 : 1. */
const faintTexts = (page: Page) =>
  page.evaluate(() => {
    const channels = (color: string) => color.match(/[\d.]+/g)!.map(Number);
    const luminance = (color: string) => {
      const [r, g, b] = channels(color).slice(0, 3).map((value) =>
        value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4
      );
      return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
    };
    const ground = (start: Element) => {
      for (let at: Element | null = start; at; at = at.parentElement) {
        const color = getComputedStyle(at).backgroundColor;
        if (channels(color)[3] !== 0) return color;
      }
      return "rgb(255, 255, 255)";
    };
    const found: string[] = [];
    for (const each of document.querySelectorAll<HTMLElement>(".panel *")) {
      if (each.offsetParent === null ||
        ![...each.childNodes].some((node) => node.nodeType === 3 && node.textContent!.trim())) continue;
      const [a, b] = [luminance(getComputedStyle(each).color), luminance(ground(each))];
      const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      if (contrast < 4.5) found.push(`${each.textContent!.trim()}: ${contrast.toFixed(2)}`);
    }
    return found;
  });

for (const [device, viewport] of [["desktop", { width: 1024, height: 600 }], ["phone", { width: 360,
  height: 640 }]] as const)
  for (const colorScheme of ["dark", "light"] as const)
    test(`on a ${colorScheme} ${device} every control has a name, room and contrast`, async () => {
      const seen = await visit(here.browser, `${here.site.address}?scene=hanging&nodes=24`, { viewport, colorScheme,
        reducedMotion: "reduce" });
      const { page } = seen;
      await ready(page);
      expect(await badControls(page)).toEqual([]);
      if (device === "phone") await page.getByRole("button", { name: "More" }).click();
      for (const summary of await page.locator("summary").all()) await summary.click();
      expect(await badControls(page)).toEqual([]);
      expect(await faintTexts(page)).toEqual([]);
      await page.getByRole("button", { name: "Help" }).click();
      expect(await badControls(page)).toEqual([]);
      await page.keyboard.press("Escape");
      expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
      expect(await page.locator("h1").count()).toBe(1);
      expect(
        await page.locator("#canvas").evaluate((
          canvas: HTMLCanvasElement,
        ) => [canvas.width - Math.round(canvas.clientWidth * devicePixelRatio),
          canvas.height - Math.round(canvas.clientHeight * devicePixelRatio)]
        ),
      )
        .toEqual([0, 0]);
      expectClean(seen, here.site);
      await page.context().close();
    });

test("the page comes with the headers that confine it", async () => {
  const { headers } = await fetch(here.site.address);
  expect(headers.get("content-security-policy")).toContain("script-src 'self' 'wasm-unsafe-eval'");
  expect(headers.get("cross-origin-opener-policy")).toBe("same-origin");
  expect(headers.get("cross-origin-embedder-policy")).toBe("require-corp");
  expect(headers.get("x-content-type-options")).toBe("nosniff");
  expect(headers.get("referrer-policy")).toBe("no-referrer");
});
