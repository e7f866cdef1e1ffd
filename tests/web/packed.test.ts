// The package as other people get it: packed, installed into an empty project without a network, and taken into pages
// by two bundlers, as in examples/web/vite and examples/web/webpack.
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { createServer, preview, type PreviewServer, type ViteDevServer } from "vite";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launch, ROOT, SOFTWARE_FLAGS } from "./chromium.ts";
import { until, visit } from "./page/browser.ts";

/** Within the checkout, where bundlers and compiler are found; weft-cloth is found in the project itself. */
const BUILD = join(ROOT, "build");
let project: string;
let browser: Browser;

function run(command: readonly string[], cwd: string): string {
  const [program, ...words] = command;
  const { status, stdout, stderr } = spawnSync(program!, words, { cwd, encoding: "utf8" });
  if (status !== 0) throw new Error(`"${command.join(" ")}" has failed:\n${stdout}${stderr}`);
  return stdout + stderr;
}
const tool = (name: string) => join(ROOT, "node_modules/.bin", name);

beforeAll(async () => {
  mkdirSync(BUILD, { recursive: true });
  project = mkdtempSync(join(BUILD, "packed-"));
  run(["npm", "pack", "--pack-destination", project], join(ROOT, "packages/weft"));
  writeFileSync(join(project, "package.json"), `{ "name": "project", "private": true, "type": "module" }`);
  const tarball = readdirSync(project).find((name) => name.endsWith(".tgz"))!;
  run(["npm", "install", "--offline", "--no-audit", "--no-fund", `./${tarball}`], project);
  for (const name of ["vite", "webpack"])
    cpSync(join(ROOT, "examples/web", name), join(project, name), { recursive: true });
  browser = await launch(SOFTWARE_FLAGS);
});
afterAll(async () => {
  await browser?.close();
  rmSync(project, { recursive: true, force: true });
});

describe("the packed package", () => {
  it("has licences, declarations and the core, no source and nothing else", () => {
    const installed = join(project, "node_modules/weft-cloth");
    const files = readdirSync(installed, { recursive: true, encoding: "utf8" }).filter((name) =>
      /\.\w+$|^[A-Z]/.test(name)
    );
    const scripts = readdirSync(join(ROOT, "packages/weft/src")).filter((name) => !name.endsWith(".d.ts"))
      .map((name) => name.replace(".ts", ""));
    expect(files.toSorted()).toEqual(
      ["LICENSE", "NOTICE", "THIRD_PARTY.md", "README.md", "package.json",
        ...["core", "reference"].flatMap((name) => [`build/${name}_module.js`, `build/${name}_module.wasm`]),
        ...scripts.flatMap((name) => [`build/${name}.js`, `build/${name}.d.ts`])].toSorted(),
    );
    for (const name of ["LICENSE", "NOTICE", "THIRD_PARTY.md"]) {
      expect(readFileSync(join(installed, name), "utf8")).toBe(readFileSync(join(ROOT, name), "utf8"));
      expect(existsSync(join(ROOT, "packages/weft", name))).toBe(false); // they were there to be packed
    }
  });

  it("is not packed before it is built", () => {
    const unbuilt = join(project, "unbuilt");
    mkdirSync(unbuilt);
    cpSync(join(ROOT, "packages/weft/package.json"), join(unbuilt, "package.json"));
    const { status, stdout } = spawnSync("npm", ["pack"], { cwd: unbuilt, encoding: "utf8" });
    expect([status, stdout]).toEqual([1, expect.stringContaining("The package is not built; ./dev web builds it.")]);
  });

  it("types a scene, and needs no types of others", () => {
    const checked = (text: string) => {
      writeFileSync(join(project, "vite/scene.ts"), text);
      return spawnSync(tool("tsc"), ["--ignoreConfig", "--noEmit", "--strict", "--skipLibCheck", "false", "--target",
        "es2023", "--module", "esnext", "--moduleResolution", "bundler", "--types", "", "main.ts", "checker.ts",
        "scene.ts"], { cwd: join(project, "vite"), encoding: "utf8" });
    };
    const scene = (keys: string) =>
      `import type { Scene } from "weft-cloth";
      export const scene: Scene = { format: "weft-scene/1", ${keys} };`;
    const right = checked(scene(`cloths: [{ grid: [4, 4], size: [1, 1], density: 0.2 }]`));
    expect([right.stdout, right.status]).toEqual(["", 0]);
    const wrong = checked(`${scene(`cloths: [{ grid: [4, 4], dens: 0.2 }]`)}
      export const other: Scene = { format: "weft-scene/1", solver: { kind: "magic" } };`);
    expect(wrong.stdout).toContain("dens");
    expect(wrong.stdout).toContain("magic");
  });
});

describe("a bundled page", () => {
  const headers = {
    "Content-Security-Policy": "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src data:",
  };

  /** Opens what a server serves until the flag has been stepped, or core and worker are there, and ends both. */
  async function flies(server: PreviewServer | ViteDevServer, stepped = true): Promise<void> {
    const at = server.httpServer!.address() as { port: number };
    const { page, errors, requests } = await visit(browser, `http://127.0.0.1:${at.port}/`);
    try {
      const line = () => page.locator("output").innerText();
      const wasm = () => requests.filter((url) => url.endsWith(".wasm"));
      await until("the flag has been stepped", async () => {
        const said = await line();
        if (errors.length > 0 || /[a-z]{3} [a-z]/.test(said)) throw new Error(`${said} ${errors.join(" ")}`);
        const seconds = /^1536 nodes(?:, (.*) s)?$/.exec(said)?.[1];
        return wasm().length >= 2 && (Number(seconds ?? 0) > 0 || !stepped && said !== ""); // page and worker
      });
      expect(new Set(wasm()).size).toBe(1);
    } finally {
      await page.context().close();
      await server.close();
    }
  }
  const served = (folder: string, outDir: string) =>
    preview({ root: join(project, folder), configFile: false, logLevel: "error", build: { outDir },
      preview: { port: 0, host: "127.0.0.1", headers } });

  it("by Vite finds the core and its worker, as a build and while it is developed", async () => {
    expect(run([tool("vite"), "build"], join(project, "vite"))).not.toMatch(/warn/i);
    await flies(await served("vite", "dist"));
    const server = await createServer({ root: join(project, "vite"), logLevel: "error",
      server: { port: 0, host: "127.0.0.1" } });
    await flies(await server.listen(), false);
  });

  it("by webpack finds the core and its worker", async () => {
    expect(run([tool("webpack")], join(project, "webpack"))).not.toMatch(/warn/i);
    await flies(await served("webpack", "."));
  });
});
