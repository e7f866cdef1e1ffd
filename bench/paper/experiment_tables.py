"""The tables of the paper's experiments: hanging, pull, copy, the largest sheet, the browser, published figures."""

from .table import NOT_MEASURED, Table, built, left, right
from .wording import megabytes, milliseconds, number

PATHS = {
    "weft-node": "weft, by node",
    "weft-spring": "weft, by spring",
    "three-webgpu": "three.js, WebGPU",
    "webgl2": "WebGL 2 shaders",
    "cpu": "CPU, JavaScript",
}


def step_ms(row):
    return row["ms_per_step"]["median"]


def noise(row):
    """The middle 90 % of the submits."""
    spread = row["ms_per_step"].get("spread")
    return f"{milliseconds(spread['p05'])} to {milliseconds(spread['p95'])}" if spread else None


def paper_fps(row):
    frame = row.get("paper_frame")
    return number(frame["fps"]) if frame else None


def maybe(key, text="{:,}"):
    return lambda row: text.format(row[key]) if row.get(key) is not None else None


def run_columns():
    """What hanging and pull have in common; the paper's fps and the simulated real time stand side by side."""
    return [
        ("ms a step", "right", lambda row: milliseconds(step_ms(row))),
        ("5 to 95 % of submits [ms]", "right", noise),
        ("substeps at 60 Hz", "right", lambda row: f"{row['substeps']:,}"),
        ("paper's fps", "right", paper_fps),
        ("real time", "right", lambda row: f"{number(row['real_time_factor'])} ×"),
        ("MB on the GPU", "right", lambda row: megabytes(row.get("gpu_bytes"))),
    ]


def with_skips(rows, columns, heads):
    """A row that was skipped says why, after its first `heads` cells."""
    measured = [row for row in rows if "skipped" not in row]
    table, missing = built(measured, columns)
    lines = iter(table.rows)
    table.rows = [
        next(lines)
        if "skipped" not in row
        else [column[2](row) for column in columns[:heads]] + [f"skipped: {row['skipped']}"]
        for row in rows
    ]
    return table, missing


def hanging(rows):
    return with_skips(
        rows,
        [
            ("nodes", "right", lambda row: f"{row['nodes']:,}"),
            ("variant", "left", lambda row: row["variant"]),
            *run_columns(),
            ("dispatches", "right", lambda row: f"{row['dispatches_per_step']:g}"),
            ("GB/s of state", "right", lambda row: number(row["bytes_per_step"] / step_ms(row) * 1e-6)),
            ("state hash", "left", lambda row: f"`{row['state_hash']}`"),
        ],
        2,
    )


def pull(rows):
    free = {
        (row["object"], row["nodes"]): step_ms(row) for row in rows if row["variant"] == "none" and "skipped" not in row
    }

    def contact(row):
        base = free.get((row["object"], row["nodes"]))
        return "" if row["variant"] == "none" or base is None else milliseconds(step_ms(row) - base)

    columns = run_columns()
    columns.insert(2, ("of it contact", "right", contact))
    objects = [("object", "left", lambda row: row["object"])] if len({row["object"] for row in rows}) > 1 else []
    return with_skips(
        rows,
        [
            *objects,
            ("nodes", "right", lambda row: f"{row['nodes']:,}"),
            ("contact", "left", lambda row: row["variant"]),
            *columns,
            ("hits in 2 steps", "right", maybe("contacts")),
            ("crossings", "right", maybe("crossings")),
            ("largest stretch", "right", maybe("max_stretch", "{:.3f}")),
            ("state hash after them", "left", lambda row: f"`{row['state_hash']}`"),
        ],
        len(objects) + 2,
    )


def kernels(rows):
    """Times of passes, of each variant's largest row that has them."""
    largest = {}
    for row in rows:
        key = row["object"], row["variant"]
        if row.get("kernels") and row["nodes"] >= largest.get(key, row)["nodes"]:
            largest[key] = row
    lines = []
    for row in largest.values():
        cells = [
            ", ".join(f"{k['kernel']} {k['ms']:.4f}" for k in row["kernels"] if k["per"] == per)
            for per in ("search", "step", "frame")
        ]
        lines.append([row["object"], row["variant"], f"{row['nodes']:,}", *cells])
    return Table(
        left("object", "variant") + right("nodes") + left("a search [ms]", "a step [ms]", "a frame [ms]"), lines
    )


def largest(rows):
    lines = []
    for row in rows:
        ms = row.get("ms_per_step")
        ms = ms["median"] if isinstance(ms, dict) else ms
        time = f"{ms:.4f}" if ms is not None else f"not run: {row.get('skipped', 'no reason given')}"
        lines.append(
            [
                row["limits"],
                row["variant"],
                f"{row['side']:,}²",
                f"{row['nodes']:,}",
                str(row["limited_by"]),
                megabytes(row.get("gpu_bytes")) or NOT_MEASURED,
                time,
            ]
        )
    return Table(
        left("limits", "variant") + right("side", "nodes") + left("limited by") + right("MB on the GPU", "ms a step"),
        lines,
    )


def compare(experiment):
    """Of the page /compare: ms a step, then ms a frame."""
    rows = experiment["rows"]
    at = {(row["path"], row["nodes"]): row for row in rows}
    paths = list(dict.fromkeys(row["path"] for row in rows))

    def table(what, cell):
        lines = []
        for nodes in dict.fromkeys(row["nodes"] for row in rows):
            there = [at.get((path, nodes)) for path in paths]
            lines.append(
                [f"{nodes:,}"]
                + ["" if row is None else cell(row) if row["ms_per_frame"] else row["note"] for row in there]
            )
        return Table(right(f"nodes, {what}", *(PATHS[path] for path in paths)), lines)

    return (
        table("a step [ms]", lambda row: number(row["ms_per_step"]["median"])),
        table("a frame [ms]", lambda row: f"{number(row['ms_per_frame']['median'])} ({number(row['fps'])} fps)"),
    )


def nearest(rows, object_name, variant, nodes):
    """The stored row of about that size: the paper's round figures are of 64², 100², 128² … nodes."""
    same = [
        row
        for row in rows
        if row["object"] == object_name
        and row["variant"] == variant
        and "skipped" not in row
        and abs(row["nodes"] / nodes - 1) < 0.05
    ]
    return min(same, key=lambda row: abs(row["nodes"] - nodes), default=None)


def published(figures, hanging_rows, pull_rows):
    """The paper's figures beside ours: its way of counting, and steps and simulated time as we count."""
    lines = []
    for figure in figures["frames"]:
        rows, variants = (
            (hanging_rows, ["spring_centric", "node_centric, grid"])
            if figure["object"] == "none"
            else (pull_rows, ["paper", "bvh", "proximity"])
        )
        head = [figure["experiment"], f"{figure['nodes']:,}", figure["said"]]
        for variant in variants:
            row = nearest(rows, figure["object"], variant, figure["nodes"])
            if row:
                lines.append(
                    [
                        *head,
                        variant,
                        paper_fps(row) or NOT_MEASURED,
                        number(1000 / step_ms(row)),
                        f"{number(row['real_time_factor'])} ×",
                        f"`{row['state_hash']}`",
                    ]
                )
        if lines[-1:] == [] or lines[-1][:3] != head:
            lines.append([*head, "this size has not been measured on this machine"])
    return Table(
        left("experiment")
        + right("nodes")
        + left("the paper says", "weft")
        + right("weft, paper's fps", "weft, steps a second", "weft, real time")
        + left("state hash"),
        lines,
    )


def authors_code(figures, hanging_rows, pull_rows):
    """The authors' own shaders on the card that weft was measured on."""
    lines = []
    for figure in figures["own_code"]["rows"]:
        rows, variants = (
            (hanging_rows, ["spring_centric", "node_centric, grid"])
            if figure["object"] == "none"
            else (pull_rows, ["paper", "bvh"])
        )
        ours = [nearest(rows, figure["object"], variant, figure["nodes"]) for variant in variants]
        cells = [
            f"{milliseconds(step_ms(row))} ({figure['ms_per_step'] / step_ms(row):,.1f} ×)" if row else NOT_MEASURED
            for row in ours
        ]
        lines.append(
            [figure["experiment"], f"{figure['nodes']:,}", f"{figure['ms_per_step']:g}", figure["stretch"], *cells]
        )
    return Table(
        left("experiment")
        + right(
            "nodes",
            "authors' shaders, ms a step",
            "their largest stretch",
            "weft spring by spring, or paper: ms a step",
            "weft by node, or bvh: ms a step",
        ),
        lines,
    )


def contact_costs(pull_rows, variant):
    """(row, ms of its step that are contact's) of every measured row of a method."""
    free = {
        (row["object"], row["nodes"]): step_ms(row)
        for row in pull_rows
        if row["variant"] == "none" and "skipped" not in row
    }
    return [
        (row, step_ms(row) - free[row["object"], row["nodes"]])
        for row in pull_rows
        if row["variant"] == variant and "skipped" not in row and (row["object"], row["nodes"]) in free
    ]
