import { expect, test } from "vitest";
import { optionsOf } from "../../../apps/web/compare/options.ts";

const of = (query: string) => optionsOf(`http://127.0.0.1/compare/${query}`);

test("without options all paths are measured at the paper's sizes", () => {
  expect(of("")).toEqual({ paths: ["weft-node", "weft-spring", "three-webgpu", "webgl2", "cpu"],
    sides: [64, 100, 128, 200, 256, 400, 512, 800], budget: 1500 });
});

test("the address chooses paths in the table's order, sizes, the most nodes and the budget", () => {
  expect(of("?paths=cpu,weft-node&most=65536&budget=1000"))
    .toEqual({ paths: ["weft-node", "cpu"], sides: [64, 100, 128, 200, 256], budget: 1000 });
  expect(of("?sizes=24,16,24").sides).toEqual([16, 24]);
});

test.each([
  ["?paths=cpu,cuda", `There is no path "cuda"; there are weft-node, weft-spring, three-webgpu, webgl2, cpu.`],
  ["?paths=", `There is no path ""; there are weft-node, weft-spring, three-webgpu, webgl2, cpu.`],
  ["?paths=<img src=x onerror=alert(1)>, and so on and on",
    `There is no path "<img src=x onerror=alert(1)>"; there are ` +
    "weft-node, weft-spring, three-webgpu, webgl2, cpu."],
  [`?paths=${"x".repeat(10_000)}`,
    `There is no path "${"x".repeat(40)}…"; there are weft-node, weft-spring, three-webgpu, webgl2, cpu.`],
  ["?budget=1e9", `In the address, budget is "1e9", not a whole number from 10 to 60000.`],
  ["?budget=-5", `In the address, budget is "-5", not a whole number from 10 to 60000.`],
  ["?most=Infinity", `In the address, most is "Infinity", not a whole number from 16 to 1048576.`],
  ["?most=4000", "No size has at most 4000 nodes; the smallest has 4096."],
  ["?sizes=64,100000", `In the address, a side of sizes is "100000", not a whole number from 4 to 1024.`],
  ["?sizes=64,,3", `In the address, a side of sizes is "", not a whole number from 4 to 1024.`],
  ["?budget=20&budget=30", "The address says budget more than once."],
  ["?__proto__=1", `The address has an option "__proto__"; there are paths, sizes, most and budget.`],
])("the address %s is refused with a sentence", (query, sentence) => {
  expect(() => of(query)).toThrow(new Error(sentence));
});
