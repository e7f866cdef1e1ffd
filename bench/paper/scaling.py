"""The section on how cost grows, and on how far a step is from what the card can do."""

from . import plots
from .experiment_tables import contact_costs, step_ms
from .fits import crossing, power_law
from .table import NOT_MEASURED, Table, left, right
from .wording import number, rounded

ENOUGH = 3  # points that an exponent is fitted to


def exponent_line(what, against, points):
    points = sorted(points)
    if len({x for x, _ in points}) < ENOUGH:
        return None
    exponent, explained = power_law(points)
    return [
        what,
        against,
        f"{points[0][0]:,}",
        f"{points[-1][0]:,}",
        f"{len(points)}",
        f"{exponent:.2f}",
        f"{explained:.3f}",
    ]


def upper_half(points):
    """Sizes whose time is not the launch's."""
    points = sorted(points)
    return points[-max(ENOUGH, (len(points) + 1) // 2) :]


def exponents(machine):
    lines = []
    hanging, pull = machine.measured("hanging"), machine.measured("pull")
    for variant in dict.fromkeys(row["variant"] for row in hanging):
        same = [row for row in hanging if row["variant"] == variant]
        for against in ("nodes", "springs"):
            lines.append(
                exponent_line(
                    f"hanging, {variant}: a step", f"{against}, upper half", upper_half(plots.series(same, x=against))
                )
            )
    for thing in dict.fromkeys(row["object"] for row in pull):
        for variant in dict.fromkeys(row["variant"] for row in pull):
            same = [row for row in pull if (row["object"], row["variant"]) == (thing, variant)]
            lines.append(
                exponent_line(f"{thing}, {variant}: a step", "nodes, upper half", upper_half(plots.series(same)))
            )
    largest = max((row["nodes"] for row in pull), key=lambda n: (sum(row["nodes"] == n for row in pull), n), default=0)
    for variant in ("bvh", "proximity", "paper"):
        costs = [
            (row["object_triangles"], ms)
            for row, ms in contact_costs(pull, variant)
            if row["nodes"] == largest and ms > 0
        ]
        lines.append(exponent_line(f"{variant}: contact of a step, {largest:,} nodes", "object triangles", costs))
    touching = [
        (row["contacts"], ms) for row, ms in contact_costs(pull, "proximity_self") if row["contacts"] > 0 and ms > 0
    ]
    lines.append(
        exponent_line("proximity_self: contact of a step, all objects and sizes", "contacts of two steps", touching)
    )
    table = Table(
        left("what", "over") + right("from", "to", "points", "exponent", "R²"), [line for line in lines if line]
    )
    return table if table.rows else None


def launch_and_bandwidth(machine):
    """Of each formulation: time = launch + bytes / bandwidth, and where the two parts are equal."""
    lines = []
    hanging = machine.measured("hanging")
    copy, dispatch = plots.copy_speed(machine), plots.dispatch_ms(machine)
    for variant in dict.fromkeys(row["variant"] for row in hanging):
        rows = [row for row in hanging if row["variant"] == variant]
        fit = plots.two_parts(rows) if len(rows) >= ENOUGH else None
        if fit is None:
            continue
        launch, speed, equal = fit
        largest = max(rows, key=lambda row: row["nodes"])
        reached = largest["bytes_per_step"] / step_ms(largest) * 1e-6
        lines.append(
            [
                variant,
                number(1000 * launch),
                number(1000 * dispatch * rows[0]["dispatches_per_step"]) if dispatch else NOT_MEASURED,
                number(speed),
                f"{equal:,.0f}",
                f"{largest['nodes']:,}",
                number(reached),
                number(copy) if copy else NOT_MEASURED,
                f"{number(100 * reached / copy, 2)} %" if copy else NOT_MEASURED,
            ]
        )
    columns = left("variant") + right(
        "launch, fitted [µs]",
        "its empty dispatches [µs]",
        "bandwidth, fitted [GB/s of state]",
        "equal at nodes",
        "largest: nodes",
        "its GB/s of state",
        "the card's copy [GB/s]",
        "of the copy",
    )
    return Table(columns, lines) if lines else None


def largest_at(machine):
    """The most nodes at 60 frames a second as the paper counts them, and in real time."""
    lines = []
    groups = [("hanging", variant, machine.measured("hanging")) for variant in plots.MODES]
    groups += [
        (thing, variant, [row for row in machine.measured("pull") if row["object"] == thing])
        for thing in ("sphere", "armadillo", "dragon")
        for variant in plots.METHODS
        if variant != "none"
    ]
    for what, variant, rows in groups:
        rows = [row for row in rows if row["variant"] == variant]
        if not rows:
            continue
        frames = [(row["nodes"], 1000 / plots.frame_ms(row)) for row in rows if plots.frame_ms(row)]
        lines.append(
            [
                what,
                variant,
                nodes_at(frames, 60),
                nodes_at([(row["nodes"], row["real_time_factor"]) for row in rows], 1),
            ]
        )
    return (
        Table(left("experiment", "variant") + right("nodes at 60 fps, the paper's way", "nodes in real time"), lines)
        if lines
        else None
    )


def nodes_at(points, level):
    if not points:
        return NOT_MEASURED
    found = crossing(points, level)
    if found is None:
        return f"fewer than {min(points)[0]:,}"
    nodes, beyond = found
    return f"{nodes:,.0f} or more" if beyond else f"about {rounded(nodes)}"


def section(report, machine, _):
    parts = []
    source = report.source("./dev bench paper --only copy,hanging,pull", "those of the rows fitted", "with those rows")
    for make, caption in (
        (exponents, "Exponents of cost. The upper half of the sizes is fitted where small ones cost their launches."),
        (
            launch_and_bandwidth,
            "Where launch ends and bandwidth begins: time = launch + bytes of state over bandwidth, "
            "by least relative squares; below “equal at nodes” a step costs mostly its launch.",
        ),
        (
            largest_at,
            "The largest sheet at 60 frames a second and in real time, between the measured sizes on logarithmic axes.",
        ),
    ):
        table = make(machine)
        parts.append(
            report.table(table, caption, source)
            if table
            else f"<p>Not measured on this machine: {caption[0].lower()}{caption[1:]}</p>"
        )
    parts.append(
        report.side_by_side(
            report.plot(plots.bandwidth(machine), "Position and velocity, read and written once.", source),
            report.plot(
                plots.contact_over_triangles(machine),
                "What a step takes more than the same step without contact.",
                source,
            ),
            report.plot(plots.contact_over_contacts(machine), "Each point is an object at a size.", source),
        )
    )
    return "\n".join(filter(None, parts))
