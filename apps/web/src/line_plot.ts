// Curves over linear axes, as SVG, with a line at the time that is shown. The readings beside it have the figures, so
// to a screen reader it is one picture.
import { significant } from "./digits.js";
import { svg } from "./svg.js";

const MARGIN = { left: 56, right: 12, top: 10, bottom: 40 };

export interface Curve {
  /** Chooses its colour. */
  readonly order: number;
  readonly name: string;
  readonly points: readonly (readonly [x: number, y: number])[];
  /** By a formula, not by the engine: drawn in dashes. */
  readonly formula?: boolean;
  /** Single points instead of a line. */
  readonly dots?: boolean;
}

export interface Axes {
  readonly x: string;
  readonly y: string;
}

/** Round values between the two, some five of them. */
function ticks(low: number, high: number): number[] {
  const rough = (high - low) / 5, decade = 10 ** Math.floor(Math.log10(rough));
  const step = decade * [1, 2, 5, 10].find((factor) => factor * decade >= rough)!;
  const count = Math.floor(high / step + 1e-9) - Math.ceil(low / step - 1e-9) + 1;
  return Array.from({ length: count }, (_, i) => (Math.ceil(low / step - 1e-9) + i) * step);
}

export class LinePlot {
  private cursor: SVGElement | null = null;
  private toX = (at: number): number => at;
  private span: readonly [number, number] = [0, 1];

  constructor(private readonly place: HTMLElement, private readonly axes: Axes, private readonly height = 250) {}

  draw(curves: readonly Curve[], range: readonly [number, number] | undefined): void {
    const width = Math.max(260, this.place.clientWidth), { height } = this;
    const all = curves.flatMap(({ points }) => points);
    const bounds = (values: readonly number[]) =>
      [Math.min(0, ...values), values.length > 0 ? Math.max(...values) : 0] as const;
    const [left, latest] = bounds(all.map(([x]) => x));
    const right = latest > left ? latest : left + 1;
    const [low, most] = range ?? bounds(all.map(([, y]) => y));
    const high = range ? most : most > low ? most + 0.06 * (most - low) : low + 1; // all may be 0
    const x = (at: number) => MARGIN.left + ((at - left) / (right - left)) * (width - MARGIN.left - MARGIN.right);
    const y = (at: number) =>
      height - MARGIN.bottom - ((at - low) / (high - low)) * (height - MARGIN.top - MARGIN.bottom);
    const names = curves.map(({ name }) => name).join(", ");
    const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
      "aria-label": `${this.axes.y} over ${this.axes.x}: ${names}.` });
    for (const at of ticks(left, right))
      picture.append(svg("path", { d: `M${x(at)} ${MARGIN.top}V${height - MARGIN.bottom}`, class: "grid" }),
        svg("text", { x: x(at), y: height - MARGIN.bottom + 16, "text-anchor": "middle" }, significant(at)));
    for (const at of ticks(low, high))
      picture.append(svg("path", { d: `M${MARGIN.left} ${y(at)}H${width - MARGIN.right}`, class: "grid" }),
        svg("text", { x: MARGIN.left - 7, y: y(at) + 4, "text-anchor": "end" }, significant(at)));
    picture.append(
      svg("path", { d: `M${MARGIN.left} ${MARGIN.top}V${height - MARGIN.bottom}H${width - MARGIN.right}`,
        class: "axis" }),
      svg("text", { x: (MARGIN.left + width - MARGIN.right) / 2, y: height - 5, "text-anchor": "middle",
        class: "name" }, this.axes.x),
      svg("text", { transform: `translate(13 ${(MARGIN.top + height - MARGIN.bottom) / 2}) rotate(-90)`,
        "text-anchor": "middle", class: "name" }, this.axes.y),
    );
    const inside = (at: number) => Math.min(high, Math.max(low, at));
    for (const { order, points, formula = false, dots = false } of curves) {
      const places = points.map(([across, up]) => `${x(across).toFixed(1)} ${y(inside(up)).toFixed(1)}`);
      const line = dots ? places.map((place) => `M${place}h0`).join("") : places.length > 0 ?
        `M${places.join("L")}` :
        "";
      picture.append(
        svg("g", { class: `series series-${order}` },
          svg("path", { d: line, class: dots ? "line dots" : "line", "stroke-dasharray": formula ? "6 4" : "none" })),
      );
    }
    this.cursor = svg("path", { class: "cursor", d: "" });
    picture.append(this.cursor);
    this.toX = x;
    this.span = [MARGIN.top, height - MARGIN.bottom];
    this.place.replaceChildren(picture);
  }

  /** null: nowhere. */
  point(at: number | null): void {
    const [top, bottom] = this.span;
    this.cursor?.setAttribute("d", at === null ? "" : `M${this.toX(at).toFixed(1)} ${top}V${bottom}`);
  }
}
