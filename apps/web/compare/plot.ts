// A plot of milliseconds over nodes, both logarithmic, as SVG. Series differ by marker and dash as well as by colour,
// which the style sheet gives to series-NAME. The figures stand in the table too, so to a screen reader the plot is one
// picture.

export interface Series {
  readonly name: string;
  /** Chooses marker and dash: its place among all that there are. */
  readonly order: number;
  readonly points: readonly (readonly [nodes: number, ms: number])[];
}

const MARGIN = { left: 52, right: 14, top: 14, bottom: 44 };
const MARKERS = ["M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0", "M-4.5-4.5h9v9h-9z", "M0-6L5.5 4h-11z", "M0-6L6 0L0 6L-6 0z",
  "M-5-5L5 5M5-5L-5 5"];
const DASHES = ["none", "7 3", "2 3", "9 3 2 3", "4 4"];
const RATES = [60, 30]; // frames a second, as lines

type Attributes = Readonly<Record<string, string | number>>;

function svg(tag: string, attributes: Attributes, ...children: (Node | string)[]): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...children);
  return made;
}

/** What stands for a series in the legend. */
export function mark({ name, order }: Series): SVGElement {
  return svg("svg", { viewBox: "0 0 40 16", width: 40, height: 16, "aria-hidden": "true",
    class: `series series-${name}` },
    svg("path", { d: "M0 8H40", class: "line", "stroke-dasharray": DASHES[order % DASHES.length]! }),
    svg("path", { d: MARKERS[order % MARKERS.length]!, transform: "translate(20 8)", class: "marker" }));
}

export function plot(title: string, series: readonly Series[], width: number, height: number): SVGElement {
  const points = series.flatMap(({ points: own }) => own);
  const [left, right] = span(points.map(([nodes]) => nodes), 1000, 1_000_000);
  const [low, high] = span([...points.map(([, ms]) => ms), 1000 / 60, 1000 / 30], 1, 100);
  const x = scale(left / 1.15, right * 1.15, MARGIN.left, width - MARGIN.right);
  const y = scale(low / 1.3, high * 1.3, height - MARGIN.bottom, MARGIN.top);
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
    "aria-label": `${title} over nodes, both axes logarithmic; the table has the figures.` });

  for (const at of ticks(left / 1.15, right * 1.15, width > 420 ? [1, 2, 5] : [1, 3]))
    picture.append(svg("path", { d: `M${x(at)} ${MARGIN.top}V${height - MARGIN.bottom}`, class: "grid" }),
      svg("text", { x: x(at), y: height - MARGIN.bottom + 17, "text-anchor": "middle" }, nodesLabel(at)));
  for (const at of ticks(low / 1.3, high * 1.3, high / low > 1000 ? [1] : [1, 3]))
    picture.append(svg("path", { d: `M${MARGIN.left} ${y(at)}H${width - MARGIN.right}`, class: "grid" }),
      svg("text", { x: MARGIN.left - 7, y: y(at) + 4, "text-anchor": "end" }, String(at)));
  for (const rate of RATES)
    picture.append(svg("path", { d: `M${MARGIN.left} ${y(1000 / rate)}H${width - MARGIN.right}`, class: "rate" }),
      svg("text", { x: width - MARGIN.right - 4, y: y(1000 / rate) + (rate === 60 ? 14 : -5), "text-anchor": "end",
        class: "rate-name" }, `${rate} fps`));
  picture.append(
    svg("path", { d: `M${MARGIN.left} ${MARGIN.top}V${height - MARGIN.bottom}H${width - MARGIN.right}`,
      class: "axis" }),
    svg("text", { x: (MARGIN.left + width - MARGIN.right) / 2, y: height - 6, "text-anchor": "middle", class: "name" },
      "nodes"),
    svg("text", { transform: `translate(13 ${(MARGIN.top + height - MARGIN.bottom) / 2}) rotate(-90)`,
      "text-anchor": "middle", class: "name" }, `${title} [ms]`),
  );

  for (const { name, order, points: own } of series) {
    const places = own.map(([nodes, ms]) => `${x(nodes).toFixed(1)} ${y(ms).toFixed(1)}`);
    picture.append(
      svg("g", { class: `series series-${name}` },
        svg("path", { d: places.length > 0 ? `M${places.join("L")}` : "", class: "line",
          "stroke-dasharray": DASHES[order % DASHES.length]! }), ...places.map((place) =>
          svg("path", { d: MARKERS[order % MARKERS.length]!, transform: `translate(${place})`, class: "marker" }))),
    );
  }
  return picture;
}

function span(values: readonly number[], low: number, high: number): [number, number] {
  if (values.length === 0) return [low, high];
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return most / least < 4 ? [least / 2, most * 2] : [least, most];
}

const scale = (from: number, to: number, start: number, end: number) => (value: number) =>
  start + ((end - start) * Math.log(value / from)) / Math.log(to / from);

function ticks(from: number, to: number, steps: readonly number[]): number[] {
  const found: number[] = [];
  for (let decade = Math.floor(Math.log10(from)); decade <= Math.log10(to); decade++)
    for (const step of steps) {
      const at = Number(`${step}e${decade}`);
      if (at >= from && at <= to) found.push(at);
    }
  return found;
}

const nodesLabel = (nodes: number): string =>
  nodes >= 1e6 ? `${nodes / 1e6}M` : nodes >= 1000 ? `${nodes / 1000}K` : String(nodes);
