"""The tables of docs/performance.md beyond the paper's experiments.

They compare contact by itself, the implicit solver, hosts, the page, Embree and Newton.
"""

from .cases import SHEETS
from .fits import power_law
from .table import Table, left, right
from .wording import number


def measured_or_skipped(row, cells):
    return [f"skipped: {row['skipped']}"] if "skipped" in row else [*cells(row), f"`{row['state_hash']}`"]


def hosts(results):
    rows = results["rows"]
    names = ["native", "Node", "Chromium"]
    lines = []
    for nodes in dict.fromkeys(row["nodes"] for row in rows):
        at = {row["host"]: row for row in rows if row["nodes"] == nodes}
        hashes = {row["state_hash"] for row in at.values()}
        assert len(hashes) == 1, f"{nodes} nodes end in different bits: {hashes}"
        lines.append(
            [f"{nodes:,}", *(f"{at[name]['ms_per_step']['median']:.4f}" for name in names), f"`{hashes.pop()}`"]
        )
    return Table(right("nodes", *(f"{name}, ms a step" for name in names)) + left("state hash, all three"), lines)


def newton(results):
    def cell(row, key):
        if row.get("failed"):
            return "fails"
        return f"{'≤ ' if row.get('upper_bound') else ''}{row[key]:g}" if key in row else "–"

    lines = [
        [
            row["experiment"],
            f"{row['nodes']:,}",
            row["solver"],
            results["settings"][row["solver"]],
            cell(row, "ms"),
            cell(row, "ms_self"),
        ]
        for row in results["rows"]
    ]
    return Table(
        left("scene") + right("nodes") + left("solver", "settings") + right("ms a frame", "with self-contact"), lines
    )


def auto_choice(results):
    """What "auto" predicts for a frame, and what frames take by either method."""
    methods = list(results["rows"][0]["runs"])

    def cells(row):
        for method in methods:
            run, predicted = row["runs"][method], row["predicted"].get(method)
            yield f"{predicted:g}" if predicted is not None else "–"
            yield f"{run['ms_per_frame']:.3g}" if "ms_per_frame" in run else "–"

    lines = [[row["what"], f"{row['nodes']:,}", *cells(row), row["chosen"]] for row in results["rows"]]
    heads = [f"{method}, {what}" for method in methods for what in ("predicted", "ms a frame")]
    return Table(left("scene") + right("nodes", *heads) + left("chosen"), lines)


def implicit(results, sheet="sheet"):
    """The study's sheet: time and error of the implicit solver, explicit steps, and coarser sheets drawn finely."""
    lines = []
    for row in results["rows"]:
        if row["object"] != sheet or "skipped" in row:
            continue
        compared = row.get("error", [])
        errors = [
            [f"{100 * error['position']:.2f}" for error in compared],
            [f"{error['normal_degrees']:.1f}" for error in compared],
        ]
        stretch = [f"{100 * (error['edge_stretch'] / error['edge_stretch_reference'] - 1):+.0f}" for error in compared]
        lines.append(
            [
                f"{row['nodes']:,}",
                row["variant"],
                f"{row['substeps']:,}",
                f"{row['ms_per_frame']['median']:.2f}",
                f"{number(row['real_time_factor'])} ×",
                *(" / ".join(cells) or "–" for cells in (*errors, stretch)),
                f"`{row['state_hash']}`",
            ]
        )
    return Table(
        right("nodes")
        + left("variant")
        + right("substeps", "ms a frame", "real time", "position error, %", "normals, °", "side stretch, %")
        + left("state hash"),
        lines,
    )


def implicit_drapes(results):
    def cells(row):
        return [
            f"{row['substeps']:,}",
            f"{row['ms_per_frame']['median']:.1f}",
            f"{number(row['real_time_factor'])} ×",
            f"{row['crossings']}",
            f"{row['max_stretch']:.2f}",
        ]

    lines = [
        [row["object"], f"{row['side'] ** 2:,}", row["variant"]] + measured_or_skipped(row, cells)
        for row in results["rows"]
        if row["object"] not in SHEETS
    ]
    return Table(
        left("object")
        + right("nodes")
        + left("variant")
        + right("substeps", "ms a frame", "real time", "crossings", "largest stretch")
        + left("state hash"),
        lines,
    )


def share(part):
    """Of a sheet, that is folded."""
    return "" if part == 1 else f", {part:g} of it"


def contact_ms(row):
    return row["ms_per_step"]["median"] - row["ms_per_step_without_contact"]["median"]


def search_ms(row):
    return row["ms_per_search"]["median"]


# The columns of contact that every table of it has: heads, and the cells of a row.
CONTACT_HEADS = (
    "ms a search",
    "searches at 60 Hz",
    "ms a step",
    "of it contact",
    "pairs",
    "candidates",
    "contacts a step",
    "crossings",
)


def contact_cells(row):
    """Under CONTACT_HEADS. A method that searches in every step has no separate search and no lists."""
    searches = search_ms(row)
    listed = lambda text: text if searches else ""
    return [
        listed(f"{searches:.4f}"),
        listed(number(row["searches_per_frame"])),
        f"{row['ms_per_step']['median']:.4f}",
        f"{contact_ms(row):.4f}",
        listed(f"{row['pairs']:,}"),
        listed(f"{row['candidates']:,}"),
        f"{row['contacts'] / row['counted_steps']:,.0f}",
        listed(f"{row['crossings']}"),
    ]


def contact_self(results):
    lines = [
        [f"{row['pose']}{share(row['part'])}", f"{row['nodes']:,}", f"{row['sheets']}"]
        + measured_or_skipped(row, lambda row: [*contact_cells(row), f"{row['dispatches_per_step']:g}"])
        for row in results["rows"]
        if not row["object_triangles"]
    ]
    return Table(
        left("pose") + right("nodes", "sheets", *CONTACT_HEADS, "dispatches a step") + left("state hash"), lines
    )


def contact_objects(results):
    lines = [
        [row["pose"], f"{row['object_triangles']:,}", f"{row['nodes']:,}", row["method"]]
        + measured_or_skipped(row, contact_cells)
        for row in results["rows"]
        if row["object_triangles"]
    ]
    return Table(
        left("pose")
        + right("object triangles", "nodes")
        + left("contact")
        + right(*CONTACT_HEADS)
        + left("state hash"),
        lines,
    )


def contact_kernels(results):
    """Of the rows of each pose with the most nodes."""
    largest = {}
    for row in results["rows"]:
        key = row["pose"], row["method"]
        timed = row.get("kernels") and row["part"] == 1 and row["method"] != "bvh"
        if timed and (key not in largest or row["nodes"] > largest[key]["nodes"]):
            largest[key] = row
    lines = [
        [row["pose"], row["method"], f"{row['nodes']:,}"]
        + [
            ", ".join(f"{k['kernel']} {k['ms']:.4f}" for k in row["kernels"] if k["per"] == per)
            for per in ("search", "step")
        ]
        for row in largest.values()
    ]
    return Table(
        left("pose", "contact") + right("nodes") + left("a search, ms by kernel", "a step, ms by kernel"), lines
    )


def growth_groups(rows):
    """Rows that differ in one thing: (what, over what, rows)."""
    cloth = [row for row in rows if not row["object_triangles"]]
    draped = [row for row in rows if row["pose"] == "draped"]
    for pose, part in dict.fromkeys((row["pose"], row["part"]) for row in cloth):
        yield pose + share(part), "nodes", [r for r in cloth if (r["pose"], r["part"]) == (pose, part)]
    for nodes in dict.fromkeys(row["nodes"] for row in cloth):
        for pose in ("folded", "crumpled"):
            yield f"{pose}, {nodes:,} nodes", "pairs", [r for r in cloth if (r["pose"], r["nodes"]) == (pose, nodes)]
    for method in dict.fromkeys(row["method"] for row in draped):
        same = [row for row in draped if row["method"] == method]
        for triangles in dict.fromkeys(row["object_triangles"] for row in same):
            yield (
                f"{method}, {triangles:,} object triangles",
                "nodes",
                [r for r in same if r["object_triangles"] == triangles],
            )
        for nodes in dict.fromkeys(row["nodes"] for row in same):
            yield f"{method}, {nodes:,} nodes", "object_triangles", [r for r in same if r["nodes"] == nodes]


def contact_growth(results):
    """How cost grows: with nodes for each pose, with pairs at one size, with an object's triangles."""
    lines = []
    for what, over, group in growth_groups(
        [row for row in results["rows"] if "skipped" not in row and row["sheets"] == 1]
    ):
        if len({row[over] for row in group}) < 3:
            continue
        cells = []
        for cost in (search_ms, contact_ms):
            points = [(row[over], cost(row)) for row in group if cost(row) > 0]
            cells.append("{:.2f} ({:.3f})".format(*power_law(points)) if len(points) == len(group) else "")
        ends = [row[over] for row in group]
        lines.append([what, over.replace("_", " "), f"{min(ends):,}", f"{max(ends):,}", f"{len(group)}", *cells])
    return Table(
        left("what", "over")
        + right("from", "to", "points", "search: exponent (R²)", "contact part of a step: exponent (R²)"),
        lines,
    )


def page(results):
    """Of bench/web/page.ts."""
    lines = [
        [
            f"`{row['query']}`",
            f"{row['nodes']:,}",
            f"{row['substeps']:,}",
            f"{row['first_frame_ms']:,.0f}",
            f"{number(row['real_time_factor'])} ×",
            f"{row['frames_per_second']:.1f}",
            f"{row['host_ms']:.2f}",
        ]
        for row in results["rows"]
    ]
    return Table(
        left("address")
        + right(
            "nodes",
            "steps a frame",
            "first moving frame [ms]",
            "real time",
            "frames a second",
            "page's thread, a frame [ms]",
        ),
        lines,
    )


def embree(results):
    lines = []
    for row in results["rows"]:
        best = row["embree_ms"][row["embree_best"]]
        lines.append(
            [
                row["pose"],
                f"{row['nodes']:,}",
                f"{row['object_triangles']:,}" if row["object_triangles"] else "",
                f"{row['pairs']:,}",
                f"`{row['pair_hash']}`",
                f"{row['weft_ms']['median']:.1f}",
                f"{best['update']['median']:.1f}",
                f"{best['collide']['median']:.1f}",
                row["embree_best"].replace("_", " "),
                f"{row['ratio']:.1f}",
            ]
        )
    return Table(
        left("query")
        + right("nodes", "object triangles", "pairs, equal")
        + left("their hash")
        + right("weft, ms", "Embree's tree, ms", "Embree's query, ms")
        + left("Embree's faster way")
        + right("weft over Embree"),
        lines,
    )
