// The two plots of the page: milliseconds over nodes.
import type { Chart } from "../src/plot.js";

const RATES = [{ rate: 60, before: true }, { rate: 30, before: false }]; // frames a second, as lines

const nodesLabel = (nodes: number): string =>
  nodes >= 1e6 ? `${nodes / 1e6}M` : nodes >= 1000 ? `${nodes / 1000}K` : String(nodes);

export const chartOf = (which: "frame" | "step"): Chart => ({
  title: `a ${which} over nodes`,
  x: { name: "nodes", empty: [1000, 1_000_000], label: nodesLabel },
  y: { name: `a ${which} [ms]`, empty: [1, 100], label: String },
  guides: RATES.map(({ rate, before }) => ({ axis: "y", at: 1000 / rate, name: `${rate} fps`, before })),
});
