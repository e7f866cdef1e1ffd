// A plot whose axes are both logarithmic, as SVG. Series differ by marker and dash as well as by colour, which the
// style sheet gives to series-0, series-1 and so on. A table beside it has the figures, so to a screen reader it is one
// picture.
import { svg } from "./svg.js";

export interface Series {
  /** Chooses colour, marker and dash: its place among all that there are. */
  readonly order: number;
  readonly points: readonly (readonly [x: number, y: number])[];
}

export interface Axis {
  readonly name: string;
  /** Its ends where there is no point. */
  readonly empty: readonly [low: number, high: number];
  label(value: number): string;
}

/** A value that matters, as a line across. */
export interface Guide {
  readonly axis: "x" | "y";
  readonly at: number;
  readonly name: string;
  /** Whether its name stands below it, or left of it. */
  readonly before: boolean;
}

export interface Chart {
  /** What is over what. */
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  /** Always in view. */
  readonly guides: readonly Guide[];
}

const MARGIN = { left: 52, right: 14, top: 14, bottom: 44 };
const MARKERS = ["M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0", "M-4.5-4.5h9v9h-9z", "M0-6L5.5 4h-11z", "M0-6L6 0L0 6L-6 0z",
  "M-5-5L5 5M5-5L-5 5"];
const DASHES = ["none", "7 3", "2 3", "9 3 2 3", "4 4"];
const COLOURS = 8; // of the style sheet

/** What stands for a series in the legend. */
export function mark(order: number): SVGElement {
  return svg("svg", { viewBox: "0 0 40 16", width: 40, height: 16, "aria-hidden": "true", class: classOf(order) },
    svg("path", { d: "M0 8H40", class: "line", "stroke-dasharray": DASHES[order % DASHES.length]! }),
    svg("path", { d: MARKERS[order % MARKERS.length]!, transform: "translate(20 8)", class: "marker" }));
}

const classOf = (order: number): string => `series series-${order % COLOURS}`;

export function plot({ title, x: xAxis, y: yAxis, guides }: Chart, series: readonly Series[], width: number,
  height: number): SVGElement {
  const points = series.flatMap(({ points: own }) => own);
  const held = (axis: "x" | "y") => guides.flatMap((guide) => (guide.axis === axis ? [guide.at] : []));
  const [left, right] = span(points.map(([at]) => at), held("x"), xAxis.empty);
  const [low, high] = span(points.map(([, at]) => at), held("y"), yAxis.empty);
  const x = scale(left / 1.15, right * 1.15, MARGIN.left, width - MARGIN.right);
  const y = scale(low / 1.3, high * 1.3, height - MARGIN.bottom, MARGIN.top);
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
    "aria-label": `${title}, both axes logarithmic; the table has the figures.` });
  const upright = (at: number) => `M${x(at)} ${MARGIN.top}V${height - MARGIN.bottom}`;
  const level = (at: number) => `M${MARGIN.left} ${y(at)}H${width - MARGIN.right}`;

  for (const at of ticks(left / 1.15, right * 1.15, width > 420 && right / left < 1000 ? [1, 2, 5] : [1, 3]))
    picture.append(svg("path", { d: upright(at), class: "grid" }),
      svg("text", { x: x(at), y: height - MARGIN.bottom + 17, "text-anchor": "middle" }, xAxis.label(at)));
  for (const at of ticks(low / 1.3, high * 1.3, high / low > 1000 ? [1] : [1, 3]))
    picture.append(svg("path", { d: level(at), class: "grid" }),
      svg("text", { x: MARGIN.left - 7, y: y(at) + 4, "text-anchor": "end" }, yAxis.label(at)));
  for (const { axis, at, name, before } of guides)
    picture.append(
      svg("path", { d: axis === "x" ? upright(at) : level(at), class: "guide" }),
      svg("text", {
        x: axis === "x" ? x(at) + (before ? -5 : 5) : width - MARGIN.right - 4,
        y: axis === "x" ? MARGIN.top + 12 : y(at) + (before ? 14 : -5),
        "text-anchor": axis === "x" && !before ? "start" : "end",
        class: "guide-name",
      }, name),
    );
  picture.append(
    svg("path", { d: `M${MARGIN.left} ${MARGIN.top}V${height - MARGIN.bottom}H${width - MARGIN.right}`,
      class: "axis" }),
    svg("text", { x: (MARGIN.left + width - MARGIN.right) / 2, y: height - 6, "text-anchor": "middle", class: "name" },
      xAxis.name),
    svg("text", { transform: `translate(13 ${(MARGIN.top + height - MARGIN.bottom) / 2}) rotate(-90)`,
      "text-anchor": "middle", class: "name" }, yAxis.name),
  );

  for (const { order, points: own } of series) {
    const places = own.map(([across, up]) => `${x(across).toFixed(1)} ${y(up).toFixed(1)}`);
    picture.append(
      svg("g", { class: classOf(order) },
        svg("path", { d: places.length > 0 ? `M${places.join("L")}` : "", class: "line",
          "stroke-dasharray": DASHES[order % DASHES.length]! }), ...places.map((place) =>
          svg("path", { d: MARKERS[order % MARKERS.length]!, transform: `translate(${place})`, class: "marker" }))),
    );
  }
  return picture;
}

function span(points: readonly number[], held: readonly number[], empty: Axis["empty"]): readonly [number, number] {
  const values = points.length > 0 || held.length > 0 ? [...points, ...held] : empty;
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
