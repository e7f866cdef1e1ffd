import { catalog } from "weft-cloth";
import { expect, test } from "vitest";
import { read, withSetting, write, type Asking } from "../../../apps/web/methods/address.ts";
import { offersOf, plainChoice, substepsSchema, sweepsOf } from "../../../apps/web/methods/offers.ts";

const offers = offersOf(await catalog());
const kinds = offers.map(({ kind }) => kind).join(", ");
const asking: Asking = { offers, substeps: substepsSchema((await catalog()).schema), scenes: ["sheet", "hanging"],
  usual: ["mass_spring", "xpbd"] };
const of = (query: string) => read(`http://127.0.0.1/methods/${query}`, asking);

test("the methods and their settings are those of the core's schema", async () => {
  expect(offers.map(({ kind }) => kind)).toEqual((await catalog()).methods.map(({ kind }) => kind));
  const settings = Object.fromEntries(offers.map(({ kind, settings }) => [kind, Object.keys(settings)]));
  expect(settings).toMatchObject({ mass_spring: ["forces"], xpbd: ["iterations"], multigrid: ["residual"] });
});

test("without anything in the address the page's own choice stands", () => {
  expect(of("")).toEqual({ refused: null,
    state: { scene: "sheet", nodes: null, choices: [plainChoice("mass_spring"), plainChoice("xpbd")] } });
});

test("what is written is read again, and what a method has by itself is not written", () => {
  const xpbd = offers.find(({ kind }) => kind === "xpbd")!;
  const changed = withSetting(withSetting(plainChoice("xpbd"), xpbd, "substeps", 32), xpbd, "iterations", 4);
  const state = { scene: "hanging", nodes: 24, choices: [plainChoice("mass_spring"), changed, plainChoice("xpbd")] };
  const query = "?v=1&scene=hanging&nodes=24&methods=mass_spring,xpbd:substeps=32:iterations=4,xpbd";
  expect(write(state)).toBe(query);
  expect(of(query)).toEqual({ refused: null, state });
  const back = withSetting(withSetting(changed, xpbd, "iterations", 1), xpbd, "substeps", "auto");
  expect(back).toEqual(plainChoice("xpbd"));
});

test.each([
  ["?v=2", "v is “2”, but must be 1"],
  ["?scene=<b>", "scene is “<b>”, but must be one of sheet, hanging"],
  ["?nodes=1e9", "nodes is “1e9”, but must be a whole number from 4 to 512"],
  ["?nodes=513", "nodes is “513”, but must be a whole number from 4 to 512"],
  ["?methods=cuda", `a method is “cuda”, but must be one of ${kinds}`],
  ["?methods=xpbd:substeps=0,mass_spring",
    "substeps of xpbd is “0”, but must be a whole number from 1 to 1024 or “auto”"],
  ["?methods=xpbd:substeps=4096,mass_spring",
    "substeps of xpbd is “4096”, but must be a whole number from 1 to 1024 or “auto”"],
  ["?methods=xpbd:iterations=lots,mass_spring",
    "iterations of xpbd is “lots”, but must be a whole number from 1 to 1000"],
  ["?methods=xpbd:__proto__=1,mass_spring",
    "a setting of xpbd is “__proto__”, but must be one of substeps, iterations"],
  ["?methods=mass_spring:forces=none",
    "forces of mass_spring is “none”, but must be one of “node_centric”, “spring_centric”, “spring_blocks”"],
  [`?methods=${"x".repeat(10_000)}`, `a method is “${"x".repeat(24)}…”, but must be one of ${kinds}`],
])("of the address %s a value is refused in a sentence", (query, fault) => {
  const { state, refused } = of(query);
  expect(refused).toBe(`In the page's address ${fault}; what the page has is used instead.`);
  expect(state.scene).toBe("sheet");
  for (const { substeps, settings } of state.choices)
    expect({ substeps, settings }).toEqual({ substeps: "auto", settings: {} });
});

test("more than four methods are too many, and the first four stay", () => {
  const { state, refused } = of("?methods=xpbd,xpbd,xpbd,xpbd,mass_spring");
  expect(state.choices).toEqual(Array(4).fill(plainChoice("xpbd")));
  expect(refused).toContain("must be at most 4 methods");
});

test("what a method sweeps in a substep is what its counts say", () => {
  const sweeps = (word: string) => {
    const [choice] = of(`?methods=${word}`).state.choices;
    return sweepsOf(offers.find(({ kind }) => kind === choice!.kind)!, choice!);
  };
  expect(sweeps("xpbd:iterations=7")).toBe(7);
  expect(sweeps("xpbd")).toBe(1);
  expect(sweeps("mass_spring")).toBe(1);
  expect(sweeps("multigrid:residual=0.1")).toBe(1);
});
