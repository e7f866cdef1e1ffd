#!/usr/bin/python3
"""Writes the tables and the plots of docs/methods.md from a stored run of `weft bench methods`.

build/weft bench methods --json bench/methods_h100.json
python3 scripts/make_methods.py            writes the page and its plots
python3 scripts/make_methods.py --check    says whether they are as the run makes them
"""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from bench.paper.svg import Line, Plot, drawing

PAGE = ROOT / "docs/methods.md"
RUN = ROOT / "bench/methods_h100.json"
MARKS = ("<!-- methods -->", "<!-- /methods -->")
TIME = 0.5  # of the errors that are plotted and graded [s]
FRAME = 1000 / 60  # [ms]


def stored() -> dict:
    """The stored run."""
    return json.loads(RUN.read_text("utf-8"))


def method_of(row: dict) -> str:
    """The word of its method."""
    return row["variant"].split()[0]


def error_at(row: dict, time: float) -> dict:
    """Its errors at this time."""
    return next(error for error in row["error"] if error["t"] == time)


def milliseconds(row: dict) -> float:
    """Of a frame, the median."""
    return row["ms_per_frame"]["median"]


def position(row: dict) -> float:
    """The error of its places after half a second, in percent."""
    return 100 * error_at(row, TIME)["position"]


def is_number(row: dict) -> bool:
    """Whether it was run, and ended in numbers."""
    return "error" in row and all(error["position"] is not None for error in row["error"])


def front(rows: list[dict]) -> list[dict]:
    """Of these rows those that no other is both faster and nearer than, the fastest first."""
    best, kept = float("inf"), []
    for row in sorted(rows, key=milliseconds):
        if position(row) < best:
            best = position(row)
            kept.append(row)
    return kept


def groups(run: dict, side: int) -> dict[str, list[dict]]:
    """The rows of each method on a sheet."""
    made: dict[str, list[dict]] = {}
    for row in run["rows"]:
        if row["side"] == side:
            made.setdefault(method_of(row), []).append(row)
    return made


def sides(run: dict) -> list[int]:
    """Of its sheets."""
    return sorted({row["side"] for row in run["rows"]})


def best_in(rows: list[dict], limit: float) -> dict | None:
    """The nearest of those that take no longer [ms]."""
    within = [row for row in rows if is_number(row) and milliseconds(row) <= limit]
    return min(within, key=position, default=None)


def cheapest_within(rows: list[dict], error: float) -> dict | None:
    """The fastest of those that are as near [%]."""
    near = [row for row in rows if is_number(row) and position(row) <= error]
    return min(near, key=milliseconds, default=None)


def named(row: dict | None, text: str) -> str:
    """A cell with the steps that it was made by."""
    return "none" if row is None else f"{text} (`{row['variant']}`)"


def summary(run: dict) -> str:
    """A line a method and sheet: what it reaches within a frame, and what 5 % and 1 % take."""
    lines = [
        "| nodes | method | least error in 16.7 ms a frame | ms a frame for 5 % | for 1 % |",
        "|---:|---|---|---|---|",
    ]
    for side in sides(run):
        for name, rows in groups(run, side).items():
            best, five, one = best_in(rows, FRAME), cheapest_within(rows, 5), cheapest_within(rows, 1)
            cells = [
                named(best, f"{position(best):.2g} %" if best else ""),
                named(five, f"{milliseconds(five):.3g}" if five else ""),
                named(one, f"{milliseconds(one):.3g}" if one else ""),
            ]
            lines.append(f"| {side * side:,} | `{name}` | {' | '.join(cells)} |")
    return "\n".join(lines)


def table(run: dict) -> str:
    """All rows."""
    lines = [
        "| nodes | steps | ms a frame | real time | dispatches a step | position, % | normals, ° | state hash |",
        "|---:|---|---:|---:|---:|---:|---:|---|",
    ]
    for side in sides(run):
        for row in (row for rows in groups(run, side).values() for row in rows):
            if "skipped" in row:
                lines.append(f"| {side * side:,} | `{row['variant']}` | {row['skipped']} | | | | | |")
                continue
            places, normals = (
                " / ".join("none" if error[key] is None else f"{scale * error[key]:.3g}" for error in row["error"])
                for key, scale in (("position", 100), ("normal_degrees", 1))
            )
            lines.append(
                f"| {side * side:,} | `{row['variant']}` | {milliseconds(row):.3g} | {row['real_time_factor']:.3g} × | "
                f"{row['dispatches_per_step']:.4g} | {places} | {normals} | `{row['state_hash']}` |"
            )
    return "\n".join(lines)


def image(side: int) -> Path:
    """The file of a sheet's plot."""
    return ROOT / f"docs/images/methods-{side}.svg"


def plot(run: dict, side: int) -> str:
    """Error over time a frame, a line along each method's best rows."""
    lines = []
    for name, rows in groups(run, side).items():
        points = [(milliseconds(row), position(row)) for row in front([row for row in rows if is_number(row)])]
        if points:
            lines.append(Line(name, points, len(lines)))
    lines.append(Line("a frame at 60 Hz", [(FRAME, y) for y in (0.1, 100)], len(lines), dash=1, guide=True))
    title = f"Error over time, {side * side:,} nodes"
    return (
        drawing(f"methods-{side}", [Plot(title, "ms a frame", "places off after half a second [%]", lines)], True)
        + "\n"
    )


def made(page: str, run: dict) -> str:
    """The page with what the run says between its marks."""
    before, rest = page.split(MARKS[0], 1)
    after = rest.split(MARKS[1], 1)[1]
    pictures = "\n".join(
        f"![Error over time a frame of every method, {side * side:,} nodes](images/{image(side).name})"
        for side in sides(run)
    )
    parts = [f"{run['adapter']}, {run['driver']}:", summary(run), pictures, "### All rows", table(run)]
    return before + MARKS[0] + "\n" + "\n\n".join(parts) + "\n" + MARKS[1] + after


def main() -> int:
    run = stored()
    files = {PAGE: made(PAGE.read_text("utf-8"), run)} | {image(side): plot(run, side) for side in sides(run)}
    if sys.argv[1:] == ["--check"]:
        same = all(path.exists() and path.read_text("utf-8") == text for path, text in files.items())
        print("docs/methods.md is as its run makes it." if same else "Run scripts/make_methods.py.")
        return int(not same)
    for path, text in files.items():
        path.write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
