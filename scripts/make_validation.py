#!/usr/bin/python3
"""Writes the table and the plot of docs/validation.md from stored runs of `weft validate --json`.

build/weft validate --json > bench/validation_2core.json
python3 scripts/make_validation.py            writes the page and its plot
python3 scripts/make_validation.py --check    says whether it is as the runs make it
"""

import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from bench.paper.svg import Line, Plot, drawing  # noqa: E402 (the root is no package's folder)

PAGE = ROOT / "docs/validation.md"
PLOT = ROOT / "docs/images/convergence.svg"
RUNS = sorted((ROOT / "bench").glob("validation_*.json"))
MARKS = ("<!-- validation -->", "<!-- /validation -->")


def allowed(row: dict) -> str:
    """What a value may be, as "0.7002 ± 2 %"."""
    sign = {"near": "±", "at_most": "+", "at_least": "−"}[row["bound"]]
    if row["expected"] == 0:
        return f"0 {sign} {row['tolerance']:g}"
    return f"{row['expected']:.4g} {sign} {100 * row['tolerance']:g} %"


def cell(row: dict | None) -> str:
    """A measured value, marked where it does not hold."""
    if row is None:
        return ""
    text = "none" if row["value"] is None else f"{row['value']:.4g}"
    return text if row["holds"] else f"**{text}**"


def table(run: dict) -> str:
    """The rows of a run, a column a solver."""
    solvers = list(dict.fromkeys(row["solver"] for row in run["rows"]))
    lines = [
        f"### {run['adapter']}",
        "",
        f"| law | number | unit | by the law | {' | '.join(solvers)} |",
        "|---|---|---|---|" + "---|" * len(solvers),
    ]
    numbers: dict[tuple, dict] = {}
    for law in run["laws"]:
        for row in run["rows"]:
            if row["law"] == law["name"]:
                key = (row["law"], row["what"], row["unit"], allowed(row))
                numbers.setdefault(key, {})[row["solver"]] = row
    for (law, what, unit, bounds), by in numbers.items():
        lines.append(f"| `{law}` | {what} | {unit} | {bounds} | {' | '.join(cell(by.get(s)) for s in solvers)} |")
    held = sum(row["holds"] for row in run["rows"])
    return "\n".join([*lines, "", f"{held} of {len(run['rows'])} numbers hold."])


def made(page: str, runs: list[dict]) -> str:
    """The page with the tables of these runs between its marks."""
    before, rest = page.split(MARKS[0], 1)
    after = rest.split(MARKS[1], 1)[1]
    return before + MARKS[0] + "\n" + "\n\n".join(table(run) for run in runs) + "\n" + MARKS[1] + after


def convergence(run: dict) -> str:
    """How far strips of coarse cells are off the elastica by the run's first solver, and what order 2 would be."""
    errors: dict[str, list] = {}
    for row in run["rows"]:
        found = re.fullmatch(r"strip of (\d+) cells, (.*) triangles: drop by the length", row["what"])
        if found and row["law"] == "refine" and row["solver"] == run["rows"][0]["solver"]:
            error = 100 * abs(row["value"] / row["expected"] - 1)
            errors.setdefault(found[2], []).append((int(found[1]), error))
    lines = [Line(f"{pattern} triangles", points, k) for k, (pattern, points) in enumerate(errors.items())]
    cells, first = lines[0].points[0]
    second = [(cells * scale, first / scale**2) for scale in (1, 4)]
    lines.append(Line("order 2", second, len(lines), guide=True))
    plot = Plot("Error of a heavy cantilever", "cells along it", "drop of its tip, off by [%]", lines)
    return drawing("convergence", [plot], alone=True) + "\n"


def stored() -> list[dict]:
    """The stored runs."""
    return [json.loads(path.read_text("utf-8")) for path in RUNS]


def main() -> int:
    page = PAGE.read_text("utf-8")
    runs = stored()
    new, plot = made(page, runs), convergence(runs[0])
    if sys.argv[1:] == ["--check"]:
        same = page == new and PLOT.read_text("utf-8") == plot
        print("docs/validation.md is as its runs make it." if same else "Run scripts/make_validation.py.")
        return int(not same)
    PAGE.write_text(new, "utf-8")
    PLOT.write_text(plot, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
