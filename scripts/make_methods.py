#!/usr/bin/python3
"""Writes the tables and plots of docs/methods.md, the table of docs/how-to/choose-a-method.md, and the rows of
/methods, from a run of `weft bench methods`.

build/weft bench methods --most-ms 50 --json bench/methods_h200.json
python3 scripts/make_methods.py            writes all of them
python3 scripts/make_methods.py --check    says whether they are as the run makes them
"""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from bench.paper.svg import Line, Plot, drawing

PAGE = ROOT / "docs/methods.md"
CHOICE = ROOT / "docs/how-to/choose-a-method.md"
RUN = ROOT / "bench/methods_h200.json"
OF_PAGE = ROOT / "apps/web/methods/sheet_run.json"
MARKS = ("<!-- methods -->", "<!-- /methods -->")
FRAME = 1000 / 60  # [ms]
SCENES = {
    "sheet": "a sheet of 2 m falls from two clips",
    "strip": "a strip of 1.2 m by 0.3 m swings by one end",
    "cantilever": "a clamped strip of fabric of 0.5 m sinks by its weight, G = 10",
    "ball": "a sheet falls on a ball of triangles and the floor, self-contact included",
    "armadillo": "the same over the armadillo",
    "twist": "a sheet is wrung into a rope",
    "pull-sphere": "a sheet is pulled over a sphere, as in the paper",
    "pull-armadillo": "the same over the armadillo",
    "pull-dragon": "the same over the dragon",
}
NULL = "null"

# Grades of the paper's table. Cut-offs were written before the run.
REAL_TIME = {"High": 100_000, "Medium": 10_000}  # nodes of the sheet at 60 Hz, within CLOSE
ACCURACY = {"High": 2, "Medium": 10}  # [%], the median over all scenes at 10,000 nodes within a frame
CLOSE = 5  # [%]
GRADED_SIDE = 100  # 10,000 nodes
LARGE_SIDE = 317  # 100,489


def stored() -> dict:
    """The stored run."""
    return json.loads(RUN.read_text("utf-8"))


def method_of(row: dict) -> str:
    """The word of its method."""
    return row["variant"].split()[0]


def milliseconds(row: dict) -> float:
    """Of a frame, the median."""
    return row["ms_per_frame"]["median"]


def position(row: dict) -> float:
    """The error of its places at the second of three times, in percent."""
    return 100 * row["error"][len(row["error"]) // 2]["position"]


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


def scenes(run: dict) -> list[str]:
    """Those of the run."""
    return [scene for scene in SCENES if any(row["object"] == scene for row in run["rows"])]


def groups(run: dict, scene: str, side: int) -> dict[str, list[dict]]:
    """The rows of each method on a scene of so many nodes."""
    made: dict[str, list[dict]] = {}
    for row in run["rows"]:
        if row["object"] == scene and row["side"] == side:
            made.setdefault(method_of(row), []).append(row)
    return made


def sides(run: dict, scene: str) -> list[int]:
    """Of its grids."""
    return sorted({row["side"] for row in run["rows"] if row["object"] == scene})


def methods(run: dict) -> list[str]:
    """All methods, in the order of the run."""
    return list(dict.fromkeys(method_of(row) for row in run["rows"] if method_of(row) != NULL))


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


def summary(run: dict, scene: str) -> str:
    """A line a method and size: what it reaches within a frame, and what 5 % and 1 % take."""
    lines = [
        "| nodes | method | least error in 16.7 ms a frame | ms a frame for 5 % | for 1 % |",
        "|---:|---|---|---|---|",
    ]
    for side in sides(run, scene):
        for name, rows in groups(run, scene, side).items():
            best, five, one = best_in(rows, FRAME), cheapest_within(rows, 5), cheapest_within(rows, 1)
            cells = [
                named(best, f"{position(best):.2g} %" if best else ""),
                named(five, f"{milliseconds(five):.3g}" if five else ""),
                named(one, f"{milliseconds(one):.3g}" if one else ""),
            ]
            lines.append(f"| {side * side:,} | `{name}` | {' | '.join(cells)} |")
    return "\n".join(lines)


def table(run: dict, scene: str) -> str:
    """All rows."""
    lines = [
        "| nodes | steps | ms a frame | real time | dispatches a step | position, % | normals, ° | kinetic energy, % | "
        "state hash |",
        "|---:|---|---:|---:|---:|---:|---:|---:|---|",
    ]
    for side in sides(run, scene):
        for row in (row for rows in groups(run, scene, side).values() for row in rows):
            if "skipped" in row:
                lines.append(f"| {side * side:,} | `{row['variant']}` | {row['skipped']} | | | | | | |")
                continue
            places, normals = (
                " / ".join("none" if error[key] is None else f"{scale * error[key]:.3g}" for error in row["error"])
                for key, scale in (("position", 100), ("normal_degrees", 1))
            )
            energies = " / ".join(
                "none"
                if error["kinetic_energy"] is None
                else f"{100 * error['kinetic_energy'] / error['kinetic_energy_reference']:.4g}"
                for error in row["error"]
            )
            cells = [
                f"{milliseconds(row):.3g}",
                f"{row['real_time_factor']:.3g} ×",
                f"{row['dispatches_per_step']:.4g}",
                places,
                normals,
                energies,
                f"`{row['state_hash']}`",
            ]
            lines.append(f"| {side * side:,} | `{row['variant']}` | {' | '.join(cells)} |")
    return "\n".join(lines)


def graded(run: dict, method: str) -> dict[str, dict | None]:
    """Of each scene the row of 10,000 nodes that is nearest within a frame; None: there is none."""
    made = {}
    for scene in scenes(run):
        size = GRADED_SIDE if GRADED_SIDE in sides(run, scene) else max(sides(run, scene))
        made[scene] = best_in(groups(run, scene, size).get(method, []), FRAME)
    return made


def median_error(rows: list[dict | None]) -> float:
    """Of scenes; one that a method does not do within a frame counts as infinite. The upper of two in the middle."""
    errors = sorted(float("inf") if row is None else position(row) for row in rows)
    return errors[len(errors) // 2]


def largest(run: dict, method: str) -> int:
    """The most nodes of the sheet that it steps within a frame and within CLOSE; 0: none."""
    fits = [
        side * side
        for side in sides(run, "sheet")
        if any(
            is_number(row) and milliseconds(row) <= FRAME and position(row) <= CLOSE
            for row in groups(run, "sheet", side).get(method, [])
        )
    ]
    return max(fits, default=0)


def grade_of(value: float, least: dict[str, float]) -> str:
    """Of what should be large."""
    return next((name for name, cut in least.items() if value >= cut), "Low")


def accuracy_of(error: float) -> str:
    """Of an error [%]."""
    return next((name for name, cut in ACCURACY.items() if error <= cut), "Low")


def percent(error: float) -> str:
    """A cell."""
    return "none" if error == float("inf") else f"{error:.2g} %"


def longest_step(run: dict, method: str) -> str:
    """That is stable on the sheet of 10,000 nodes: of the explicit method what its row took, of others any."""
    rows = groups(run, "sheet", GRADED_SIDE).get(method, [])
    if not rows or "substeps" not in rows[0]:
        return "none"
    return "any" if len(rows[0]["variant"].split()) > 1 else f"{1000 * FRAME / rows[0]['substeps']:.0f} µs"


def grades(run: dict) -> str:
    """The paper's table, with numbers."""
    lines = [
        "| method | nodes at 60 Hz within 5 % | error in 16.7 ms at 10,000 nodes: the sheet, the median of scenes | "
        "the sheet at 100,000 | longest step | crossings | stretch | real time | accuracy |",
        "|---|---:|---|---:|---:|---:|---:|---|---|",
    ]
    for method in methods(run):
        rows = graded(run, method)
        nodes, error = largest(run, method), median_error(list(rows.values()))
        sheet = median_error([rows["sheet"]])
        large = median_error([best_in(groups(run, "sheet", LARGE_SIDE).get(method, []), FRAME)])
        met = [row for row in run["rows"] if method_of(row) == method and "crossings" in row]
        stretch = [row["max_stretch"] for row in rows.values() if row and "max_stretch" in row]
        lines.append(
            f"| `{method}` | {f'{nodes:,}' if nodes else 'none'} | {percent(sheet)}, {percent(error)} | "
            f"{percent(large)} | {longest_step(run, method)} | {max((row['crossings'] for row in met), default=0)} | "
            f"{f'{max(stretch):.2f}' if stretch else 'none'} | {grade_of(nodes, REAL_TIME)} | {accuracy_of(error)} |"
        )
    return "\n".join(lines)


def drawn(run: dict) -> list[tuple[str, int]]:
    """The scenes and sizes that have a plot."""
    return [("sheet", side) for side in sides(run, "sheet")] + [
        (scene, max(sides(run, scene))) for scene in scenes(run) if scene != "sheet"
    ]


def image(scene: str, side: int) -> Path:
    """The file of a plot."""
    return ROOT / f"docs/images/methods-{scene}-{side}.svg"


def plot(run: dict, scene: str, side: int) -> str:
    """Error over time a frame, a line along each method's best rows, and along the null lines."""
    lines = []
    colours = [*methods(run), NULL]
    for name, rows in groups(run, scene, side).items():
        points = [(milliseconds(row), position(row)) for row in front([row for row in rows if is_number(row)])]
        if points:
            lines.append(Line(name, points, colours.index(name), guide=name == NULL))
    frame = [(FRAME, y) for y in (0.1, 100)]
    lines.append(Line("a frame at 60 Hz", frame, colours.index(NULL), dash=1, guide=True))
    title = f"{scene}, {side * side:,} nodes: error over time"
    name = f"methods-{scene}-{side}"
    return drawing(name, [Plot(title, "ms a frame", "places off at the second time [%]", lines)], True) + "\n"


def pictures(run: dict, scene: str) -> str:
    """The plots of a scene."""
    return "\n".join(
        f"![Error over time a frame of every method, {scene}, {side * side:,} nodes](images/{image(scene, side).name})"
        for name, side in drawn(run)
        if name == scene
    )


def made(page: str, run: dict) -> str:
    """The page with what the run says between its marks."""
    before, rest = page.split(MARKS[0], 1)
    after = rest.split(MARKS[1], 1)[1]
    parts = [f"{run['adapter']}, {run['driver']}:", grades(run)]
    for scene in scenes(run):
        parts += [f"### {scene.capitalize()}: {SCENES[scene]}", summary(run, scene), pictures(run, scene)]
    parts += ["### All rows of the sheet", table(run, "sheet")]
    return before + MARKS[0] + "\n" + "\n\n".join(parts) + "\n" + MARKS[1] + after


def fastest(found: dict[str, list[dict]], error: float) -> str:
    """A cell: of all methods on a scene the fastest that is as near [%], and what its frame takes."""
    row = cheapest_within([row for name, rows in found.items() if name != NULL for row in rows], error)
    return "none" if row is None else f"`{row['variant']}`, {milliseconds(row):.3g} ms"


def nearest(found: dict[str, list[dict]]) -> str:
    """A cell: of all methods on a scene the nearest within a frame, and its error."""
    row = best_in([row for name, rows in found.items() if name != NULL for row in rows], FRAME)
    return "none" if row is None else f"`{row['variant']}`, {position(row):.2g} %"


def choice(page: str, run: dict) -> str:
    """The page on which method to take, with a line a scene and size between its marks."""
    before, rest = page.split(MARKS[0], 1)
    after = rest.split(MARKS[1], 1)[1]
    lines = [
        f"{run['adapter']}, {run['driver']}:\n",
        "| scene | nodes | fastest within 5 % | fastest within 1 % | nearest in 16.7 ms |",
        "|---|---:|---|---|---|",
    ]
    for scene in scenes(run):
        for side in sides(run, scene):
            found = groups(run, scene, side)
            cells = [fastest(found, 5), fastest(found, 1), nearest(found)]
            lines.append(f"| {scene} | {side * side:,} | {' | '.join(cells)} |")
    return before + MARKS[0] + "\n" + "\n".join(lines) + "\n" + MARKS[1] + after


def of_page(run: dict) -> str:
    """What /methods shows: the rows of the sheet without null lines, a line each, with what the page reads."""
    members = ("variant", "side", "skipped", "real_time_factor", "dispatches_per_step")
    rows = []
    for row in run["rows"]:
        if row["object"] != "sheet" or method_of(row) == NULL:
            continue
        kept = {member: row[member] for member in members if member in row}
        if "error" in row:
            kept["ms_per_frame"] = {"median": milliseconds(row)}
            kept["error"] = [{key: error[key] for key in ("t", "position", "normal_degrees")} for error in row["error"]]
        rows.append(json.dumps(kept))
    head = {member: run[member] for member in ("adapter", "driver")}
    return json.dumps(head)[:-1] + ', "rows": [\n' + ",\n".join(rows) + "\n]}\n"


def main() -> int:
    run = stored()
    files = {PAGE: made(PAGE.read_text("utf-8"), run), OF_PAGE: of_page(run)}
    files[CHOICE] = choice(CHOICE.read_text("utf-8"), run)
    files |= {image(*one): plot(run, *one) for one in drawn(run)}
    if sys.argv[1:] == ["--check"]:
        same = all(path.exists() and path.read_text("utf-8") == text for path, text in files.items())
        print("The pages and /methods are as their run makes them." if same else "Run scripts/make_methods.py.")
        return int(not same)
    for path, text in files.items():
        path.write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
