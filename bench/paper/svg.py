"""Plots as SVG, written here rather than by a library.

The same results give the same bytes on every machine, text stays text, and colours follow the page's theme (or, in a
file of its own, the reader's).

A plot has logarithmic axes whose labels name a unit, lines with markers of their own shape, and a legend below.
"""

import dataclasses
import html
import json
import math

COLOURS = 8
LIGHT = ("#0b62a8", "#b3440e", "#1d7a3e", "#8a3ffc", "#9a6700", "#c2185b", "#00707a", "#5c5c5c")
DARK = ("#6cb6ff", "#ff9a62", "#62d08a", "#c4a2ff", "#e3b341", "#ff8ab8", "#5cd3dc", "#b8b8b8")
STYLE = """text{font-family:system-ui,"Segoe UI","DejaVu Sans",sans-serif;font-size:13px;fill:var(--ink,#1b1f24)}
.small{font-size:12px}.grid{stroke:var(--rule,#d5d9de);stroke-width:1}.fine{stroke:var(--rule,#d5d9de);stroke-width:.5;opacity:.6}
.frame{stroke:var(--quiet,#59636e);stroke-width:1;fill:none}.line{fill:none;stroke-width:2}.guide{fill:none;stroke-width:1.5}"""
DASHES = ("", "7 4", "2 3", "9 3 2 3")


def theme_style():
    """For a file of its own: the reader's light or dark, since nothing around it says."""

    def variables(colours, ink, rule, quiet, paper):
        series = ";".join(f"--s{k}:{colour}" for k, colour in enumerate(colours))
        return f":root{{{series};--ink:{ink};--rule:{rule};--quiet:{quiet};--paper:{paper}}}"

    light = variables(LIGHT, "#1b1f24", "#d5d9de", "#59636e", "#ffffff")
    dark = variables(DARK, "#e6edf3", "#3a424c", "#9aa4af", "#0d1117")
    return f"{light}@media(prefers-color-scheme:dark){{{dark}}}svg{{background:var(--paper)}}{STYLE}"


@dataclasses.dataclass
class Line:
    """Points that were measured, joined; or, as a guide, a line without markers that they are held against."""

    label: str
    points: list
    colour: int
    dash: int = 0
    guide: bool = False
    joined: bool = True


@dataclasses.dataclass
class Plot:
    title: str
    x_label: str
    y_label: str
    lines: list
    width: int = 640
    height: int = 360
    legend_columns: int = 2

    @property
    def legend_height(self):
        return 22 * -(-len(self.lines) // self.legend_columns) + 6

    @property
    def whole_height(self):
        return self.height + self.legend_height

    def description(self):
        def ends(line):
            (x0, y0), (x1, y1) = line.points[0], line.points[-1]
            return f"{line.label}: from {y0:.3g} at {x0:,.0f} to {y1:.3g} at {x1:,.0f}"

        return f"{self.y_label} over {self.x_label}. " + ". ".join(ends(line) for line in self.lines) + "."

    def data(self):
        return {
            "x": self.x_label,
            "y": self.y_label,
            "lines": [
                {"label": line.label, "points": [[x, float(f"{y:.6g}")] for x, y in line.points]} for line in self.lines
            ],
        }


def decades(low, high):
    """Whole decades would leave half of a plot empty: ends at 1, 2 or 5 times a power of ten."""
    steps = [
        m * 10.0**e for e in range(math.floor(math.log10(low)) - 1, math.ceil(math.log10(high)) + 2) for m in (1, 2, 5)
    ]
    return max(s for s in steps if s <= low / 1.1), min(s for s in steps if s >= high * 1.1)


def ticks(low, high):
    """(value, labelled) on a logarithmic axis."""
    steps = (1, 2, 5) if high / low < 300 else (1,)
    for exponent in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1):
        for m in range(1, 10):
            value = m * 10.0**exponent
            if low * 0.999 <= value <= high * 1.001:
                yield value, m in steps


def tick_text(value):
    if value >= 1e6:
        return f"{value / 1e6:g}M"
    if value >= 1e4:
        return f"{value / 1e3:g}K"
    if value < 0.0009:
        mantissa, exponent = f"{value:e}".split("e-")
        power = "10⁻" + "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(digit)] for digit in str(int(exponent)))
        return power if float(mantissa) == 1 else f"{float(mantissa):g}·{power}"
    return f"{value:,.0f}" if value >= 1 else f"{value:.3f}".rstrip("0")


def marker(k, x, y, colour):
    """Shapes tell lines apart without colour."""
    shape = [
        "M{0:.1f} {1:.1f}m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0",
        "M{0:.1f} {1:.1f}m-3.6-3.6h7.2v7.2h-7.2z",
        "M{0:.1f} {1:.1f}m0-4.8l4.5 8.2h-9z",
        "M{0:.1f} {1:.1f}m0-4.8l4.6 4.8l-4.6 4.8l-4.6-4.8z",
        "M{0:.1f} {1:.1f}m0 4.8l4.5-8.2h-9z",
        "M{0:.1f} {1:.1f}m-4-4l8 8m0-8l-8 8",
    ][k % 6].format(x, y)
    paint = f"stroke:var(--s{colour});stroke-width:2;fill:none" if k % 6 == 5 else f"fill:var(--s{colour})"
    return f'<path d="{shape}" style="{paint}"/>'


def body(plot):
    """The drawing, from (0, 0) to (width, whole_height)."""
    left, right, top, bottom = 66, 18, 12, 48
    points = [point for line in plot.lines for point in line.points]
    x_low, x_high = decades(min(x for x, _ in points), max(x for x, _ in points))
    y_low, y_high = decades(min(y for _, y in points), max(y for _, y in points))
    wide, high = plot.width - left - right, plot.height - top - bottom

    def at(x, y):
        return (
            left + wide * math.log(x / x_low) / math.log(x_high / x_low),
            top + high * (1 - math.log(y / y_low) / math.log(y_high / y_low)),
        )

    for value, labelled in ticks(x_low, x_high):
        x, _ = at(value, y_low)
        yield f'<path class="{"grid" if labelled else "fine"}" d="M{x:.1f} {top}v{high}"/>'
        if labelled:
            below = top + high + 18
            yield f'<text class="small" x="{x:.1f}" y="{below}" text-anchor="middle">{tick_text(value)}</text>'
    for value, labelled in ticks(y_low, y_high):
        _, y = at(x_low, value)
        yield f'<path class="{"grid" if labelled else "fine"}" d="M{left} {y:.1f}h{wide}"/>'
        if labelled:
            yield f'<text class="small" x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{tick_text(value)}</text>'
    yield f'<path class="frame" d="M{left} {top}v{high}h{wide}"/>'
    yield (
        f'<text class="x-label" x="{left + wide / 2:.0f}" y="{plot.height - 8}" text-anchor="middle">'
        f"{html.escape(plot.x_label)}</text>"
    )
    middle = top + high / 2
    yield (
        f'<text class="y-label" x="16" y="{middle:.0f}" text-anchor="middle" transform="rotate(-90 16 {middle:.0f})">'
        f"{html.escape(plot.y_label)}</text>"
    )
    markers = 0
    for k, line in enumerate(plot.lines):
        places = [at(x, y) for x, y in line.points]
        dash = f";stroke-dasharray:{DASHES[line.dash]}" if line.dash else ""
        style = f"stroke:var(--s{line.colour}){dash}"
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
        if line.joined:
            yield f'<path class="{"guide" if line.guide else "line"}" d="{path}" style="{style}"/>'
        column, row = k % plot.legend_columns, k // plot.legend_columns
        x, y = left - 46 + column * (plot.width - 20) / plot.legend_columns, plot.height + 14 + 22 * row
        if line.joined:
            yield f'<path class="line" d="M{x:.1f} {y:.1f}h26" style="{style}"/>'
        if not line.guide:
            yield "".join(marker(markers, *place, line.colour) for place in [*places, (x + 13, y)])
            markers += 1
        yield f'<text class="small" x="{x + 34:.1f}" y="{y + 4:.1f}">{html.escape(line.label)}</text>'


def drawing(name, plots, alone=False):
    """Plots side by side as one <svg>. `name` makes its ids; `alone`: a file of its own."""
    width, height = sum(plot.width for plot in plots), max(plot.whole_height for plot in plots)
    title = "; ".join(plot.title for plot in plots)
    data = json.dumps([plot.data() for plot in plots], ensure_ascii=False)
    parts, x = [], 0
    for plot in plots:
        parts.append(f'<g transform="translate({x} 0)">' + "".join(body(plot)) + "</g>")
        x += plot.width
    return wrap(
        name, width, height, title, " ".join(plot.description() for plot in plots), data, "\n".join(parts), alone
    )


def wrap(name, width, height, title, description, data, content, alone):
    spaces = ' xmlns="http://www.w3.org/2000/svg"' if alone else ""
    style = f"<style>{theme_style()}</style>" if alone else ""
    return (
        f'<svg{spaces} viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
        f'aria-labelledby="{name}-title {name}-desc">'
        f'<title id="{name}-title">{html.escape(title)}</title><desc id="{name}-desc">{html.escape(description)}</desc>'
        f"<metadata>{html.escape(data, quote=False)}</metadata>{style}\n{content}\n</svg>"
    )


def bars(name, title, unit, rows, alone=False):
    """Stacked bars of 100 %: rows are (label, [(part, value)])."""
    parts = list(dict.fromkeys(part for _, values in rows for part, _ in values))
    left, wide, columns = 250, 520, 4
    width, top = left + wide + 20, 30
    legend = top + 24 * len(rows) + 22
    height = legend + 22 * -(-len(parts) // columns) + 6
    content = [
        f'<text class="x-label" x="{left + wide / 2:.0f}" y="16" text-anchor="middle">{html.escape(unit)}</text>'
    ]
    for k, (label, values) in enumerate(rows):
        y, x, whole = top + 24 * k, float(left), sum(value for _, value in values)
        content.append(f'<text class="small" x="{left - 8}" y="{y + 13}" text-anchor="end">{html.escape(label)}</text>')
        for part, value in values:
            length = wide * value / whole
            content.append(
                f'<rect x="{x:.1f}" y="{y}" width="{length:.1f}" height="18" '
                f'style="fill:var(--s{parts.index(part) % COLOURS});stroke:var(--paper,#fff);stroke-width:1"/>'
            )
            x += length
    for k, part in enumerate(parts):
        x, y = 20 + (k % columns) * (width - 30) / columns, legend + 22 * (k // columns)
        content.append(
            f'<rect x="{x:.1f}" y="{y}" width="14" height="14" style="fill:var(--s{k % COLOURS})"/>'
            f'<text class="small" x="{x + 20:.1f}" y="{y + 12}">{html.escape(part)}</text>'
        )
    data = json.dumps(
        [{"row": label, "parts": [[part, float(f"{value:.6g}")] for part, value in values]} for label, values in rows]
    )
    description = "; ".join(
        f"{label}: " + ", ".join(f"{part} {100 * value / sum(v for _, v in values):.0f} %" for part, value in values)
        for label, values in rows
    )
    return wrap(name, width, height, title, description, data, "\n".join(content), alone)
