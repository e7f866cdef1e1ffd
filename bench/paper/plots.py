"""What is plotted of the results."""

from .contact_tables import contact_ms, growth_groups, search_ms, share
from .experiment_tables import PATHS, contact_costs, step_ms
from .fits import base_and_slope, power_law
from .svg import Line, Plot, bars, drawing

MODES = {
    "node_centric, grid": "by node, grid",
    "node_centric, any mesh": "by node, any mesh",
    "spring_centric": "spring by spring",
    "spring_blocks": "spring by spring, in blocks",
}
METHODS = {
    "none": "no contact",
    "bvh": "bvh",
    "proximity": "proximity",
    "proximity_self": "proximity, itself too",
    "paper": "paper, brute force",
}


def series(rows, y=step_ms, x="nodes"):
    return sorted((row[x], y(row)) for row in rows if "skipped" not in row and y(row) and y(row) > 0)


def fitted(label, points):
    """With the exponent of its upper half, where launches no longer cover what a node costs."""
    upper = points[-max(3, len(points) // 2) :]
    return f"{label}, exponent {power_law(upper)[0]:.2f}" if len(points) > 2 else label


def lines_of(rows, names, y=step_ms, fit=False):
    found = []
    for k, (variant, label) in enumerate(names.items()):
        points = series([row for row in rows if row["variant"] == variant], y)
        if points:
            found.append(Line(fitted(label, points) if fit else label, points, k))
    return found


def over(lines):
    """From the smallest to the largest number of nodes of these lines."""
    return min(line.points[0][0] for line in lines), max(line.points[-1][0] for line in lines)


def copy_speed(machine):
    """[GB/s], read and written bytes counted; None where it was not measured."""
    return next((row["gb_per_s"] for row in machine.measured("copy") if row["what"] == "copy"), None)


def dispatch_ms(machine):
    return next((row["us"] / 1000 for row in machine.measured("copy") if row["what"] == "dispatch"), None)


def bytes_of_a_node(row):
    return row["bytes_per_step"] / row["nodes"]


def limits(machine, lines):
    """What a step cannot be faster than: one dispatch, and the copy of its state."""
    low, high = over(lines)
    rows, found = machine.measured("hanging"), []
    if dispatch_ms(machine):
        found.append(
            Line(
                "one dispatch that does nothing",
                [(low, dispatch_ms(machine)), (high, dispatch_ms(machine))],
                7,
                2,
                True,
            )
        )
    if copy_speed(machine) and rows:
        cost = bytes_of_a_node(rows[0]) / copy_speed(machine) * 1e-6  # ms a node
        start = max(low, 0.5 * min(y for line in lines for _, y in line.points) / cost)
        if start < high:
            found.append(
                Line(
                    "the state's bytes at the copy's bandwidth",
                    [(start, start * cost), (high, high * cost)],
                    7,
                    1,
                    True,
                )
            )
    return found


def authors_lines(machine, figures, object_name):
    code = figures["own_code"]
    rows = [row for row in code["rows"] if row["object"] == object_name] if code["machine"] == machine.name else []
    return [Line("the authors' shaders", series(rows, lambda row: row["ms_per_step"]), 5, 3)] if rows else []


def hanging_cost(machine, figures):
    lines = lines_of(machine.measured("hanging"), MODES, fit=True)
    if not lines:
        return None
    return Plot(
        "Hanging: cost of a step",
        "nodes of the sheet",
        "a step [ms]",
        lines + authors_lines(machine, figures, "none") + limits(machine, lines),
    )


def browser_lines(machine, key, paths):
    rows = machine.experiment("chromium").get("rows", [])
    found = []
    for k, path in enumerate(PATHS):
        points = series([row for row in rows if row["path"] == path and row[key]], lambda row: row[key]["median"])
        if points and path in paths:
            found.append((path, points, k))
    return found


def hanging_browser(machine, key, title, y_label, target=None):
    lines = [Line(PATHS[path], points, k) for path, points, k in browser_lines(machine, key, PATHS)]
    if not lines:
        return None
    low, high = over(lines)
    if target:
        lines.append(Line("60 frames a second", [(low, target), (high, target)], 7, 1, True))
    return Plot(title, "nodes of the sheet", y_label, lines)


def frame_ms(row):
    return row.get("paper_frame", {}).get("ms", {}).get("median")


def pull_cost(machine, figures, object_name):
    rows = [row for row in machine.measured("pull") if row["object"] == object_name]
    lines = lines_of(rows, METHODS)
    if not lines:
        return None
    return Plot(
        f"Pull over the {object_name}: cost of a step",
        "nodes of the sheet",
        "a step [ms]",
        lines + authors_lines(machine, figures, object_name),
    )


def pull_real_time(machine, object_name):
    rows = [row for row in machine.measured("pull") if row["object"] == object_name]
    lines = lines_of(rows, METHODS, lambda row: row["real_time_factor"])
    if not lines:
        return None
    low, high = over(lines)
    lines.append(Line("real time", [(low, 1), (high, 1)], 7, 1, True))
    return Plot(
        f"Pull over the {object_name}: simulated seconds a second",
        "nodes of the sheet",
        "simulated over wall time [s/s]",
        lines,
    )


def frame_of_sheet(row):
    return row["ms_per_frame"]["median"]


def implicit_cost(machine):
    """Of the study's sheet: a frame by the implicit solver and by explicit steps."""
    rows = [row for row in machine.measured("multigrid") if row["object"] == "sheet"]
    lines = lines_of(
        rows, {"multigrid 8": "implicit, 8 substeps", "explicit": "explicit, as many as are stable"}, frame_of_sheet
    )
    if not lines:
        return None
    low, high = over(lines)
    lines.append(Line("real time at 60 frames a second", [(low, 1000 / 60), (high, 1000 / 60)], 7, 1, True))
    return Plot("Implicit and explicit: a frame of a sixtieth of a second", "nodes of the sheet", "a frame [ms]", lines)


def implicit_detail(machine):
    """Of the largest sheet: how far normals are off after half a second, over what a frame takes."""
    rows = [row for row in machine.measured("multigrid") if row["object"] == "sheet" and len(row["error"]) > 1]
    if not rows:
        return None
    side = max(row["side"] for row in rows)
    point = lambda row: (frame_of_sheet(row), row["error"][1]["normal_degrees"])
    groups = {"implicit": "multigrid", "explicit": "explicit", "null lines": "null"}
    lines = [
        Line(label, sorted(point(row) for row in rows if row["side"] == side and row["variant"].startswith(start)), k)
        for k, (label, start) in enumerate(groups.items())
    ]
    return Plot(
        f"Detail of the sheet of {side**2:,} nodes",
        "a frame [ms]",
        "normals after half a second, off by [degrees]",
        [line for line in lines if line.points],
    )


def frames_of_the_paper(rows, names, title):
    lines = lines_of(rows, names, frame_ms)
    if not lines:
        return None
    low, high = over(lines)
    lines.append(Line("60 frames a second", [(low, 1000 / 60), (high, 1000 / 60)], 7, 1, True))
    return Plot(title, "nodes of the sheet", "a frame of one step [ms]", lines)


def readme_cost(machine, figures):
    """README's: native by formulation, the browser's baselines and the authors' code, all on one card."""
    lines = lines_of(machine.measured("hanging"), {variant: f"weft, {label}" for variant, label in MODES.items()})
    names = {"three-webgpu": "three.js on WebGPU, in Chromium", "webgl2": "WebGL 2 shaders, in Chromium"}
    lines += [
        Line(names[path], points, (4, 6)[k], 1)
        for k, (path, points, _) in enumerate(browser_lines(machine, "ms_per_step", names))
    ]
    return Plot(
        "A step of the hanging sheet",
        "nodes of the sheet",
        "a step [ms]",
        lines + authors_lines(machine, figures, "none"),
        width=720,
    )


def bandwidth(machine):
    """What a step reaches of the copy's bandwidth."""
    lines = lines_of(machine.measured("hanging"), MODES, lambda row: row["bytes_per_step"] / step_ms(row) * 1e-6)
    if not lines:
        return None
    if copy_speed(machine):
        low, high = over(lines)
        lines.append(Line("a copy on this card", [(low, copy_speed(machine)), (high, copy_speed(machine))], 7, 1, True))
    return Plot("Hanging: bandwidth reached", "nodes of the sheet", "state read and written [GB/s]", lines)


def contact_over_triangles(machine):
    """At the size at which most objects were measured."""
    rows = machine.measured("pull")
    nodes = max((row["nodes"] for row in rows), key=lambda n: (sum(row["nodes"] == n for row in rows), n), default=0)
    lines = []
    for k, (variant, label) in enumerate(METHODS.items()):
        points = sorted(
            (row["object_triangles"], ms)
            for row, ms in contact_costs(rows, variant)
            if row["nodes"] == nodes and ms > 0
        )
        if variant != "none" and len(points) > 1:
            lines.append(Line(fitted(label, points), points, k))
    return (
        Plot(
            f"Pull: cost of contact over the object's triangles, {nodes:,} nodes",
            "triangles of the object",
            "contact of a step [ms]",
            lines,
        )
        if lines
        else None
    )


def contact_over_contacts(machine):
    rows = machine.measured("pull")
    lines = []
    for k, variant in enumerate(("proximity", "proximity_self")):
        points = sorted(
            (row["contacts"], ms) for row, ms in contact_costs(rows, variant) if row["contacts"] > 0 and ms > 0
        )
        if len(points) > 1:
            lines.append(Line(METHODS[variant], points, 2 + k, joined=False))
    return (
        Plot(
            "Pull: cost of contact over contacts, all objects and sizes",
            "contacts of two steps",
            "contact of a step [ms]",
            lines,
        )
        if lines
        else None
    )


def two_parts(rows):
    """ms a step = launch + bytes over bandwidth, of rows of one formulation.

    Returns (launch [ms], GB/s, nodes where both are equal).
    """
    launch, per_node = base_and_slope(series(rows))
    if launch <= 0 or per_node <= 0:
        return None
    return launch, bytes_of_a_node(rows[0]) / per_node * 1e-6, launch / per_node


def contact_growth(results):
    rows = [row for row in results["rows"] if "skipped" not in row and row["sheets"] == 1]
    groups = [
        (what, against, group)
        for what, against, group in growth_groups(rows)
        if len({row[against] for row in group}) > 2
    ]
    most = {
        against: max((len(group) for _, a, group in groups if a == against), default=0)
        for against in ("pairs", "object_triangles")
    }

    def line(k, label, group, against, cost, dash=0):
        points = series(group, cost, against)
        return Line(f"{label}, exponent {power_law(points)[0]:.2f}", points, k % 8, dash)

    cloth = [
        (what, group) for what, against, group in groups if against == "nodes" and not group[0]["object_triangles"]
    ]
    pairs = [group for _, against, group in groups if against == "pairs" and len(group) == most["pairs"]]
    draped = [
        group
        for _, against, group in groups
        if against == "object_triangles" and len(group) == most["object_triangles"]
    ]
    plots = [
        Plot(
            "Searches over nodes",
            "nodes of the sheet",
            "a search [ms]",
            [line(k, what, group, "nodes", search_ms) for k, (what, group) in enumerate(cloth)],
        )
    ]
    if pairs:
        plots.append(
            Plot(
                "Over pairs",
                f"listed pairs, of {pairs[0][0]['nodes']:,} nodes",
                "time [ms]",
                [
                    line(2 * k + (cost is contact_ms), f"{group[0]['pose']}, {what}", group, "pairs", cost)
                    for k, group in enumerate(pairs)
                    for what, cost in (("a search", search_ms), ("a step", contact_ms))
                ],
            )
        )
    if draped:
        plots.append(
            Plot(
                "Over an object's triangles",
                f"triangles of the object, {draped[0][0]['nodes']:,} nodes",
                "contact of a step [ms]",
                [line(k, group[0]["method"], group, "object_triangles", contact_ms) for k, group in enumerate(draped)],
            )
        )
    for plot in plots:
        plot.width, plot.legend_columns = 430, 1
    return drawing("contact-growth", plots, alone=True)


def contact_kernels(results, per):
    rows = []
    for row in results["rows"]:
        if row.get("kernels") and search_ms(row) > 0 and row["part"] == 1:
            over_object = f", {row['object_triangles']:,} △" if row["object_triangles"] else ""
            itself = ", itself" if row["object_triangles"] and row["method"] == "proximity_self" else ""
            rows.append(
                (
                    f"{row['pose']}, {row['nodes']:,}{over_object}{itself}{share(row['part'])}",
                    [(k["kernel"], k["ms"]) for k in row["kernels"] if k["per"] == per],
                )
            )
    return bars(
        f"contact-{per}",
        f"Shares of the kernels of a {per}",
        f"share of the kernels' time in a {per} [%]",
        rows,
        alone=True,
    )
