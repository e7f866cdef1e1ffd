"""Writes report/index.html: one file without scripts, with everything in it, made from stored results alone."""

import base64
import html
import json

import jinja2

from . import contact_tables, media, plots, scaling
from . import experiment_tables as tables
from .cases import SHEETS
from .store import RESULTS, ROOT, machines, write_whole
from .svg import DARK, LIGHT, STYLE, drawing
from .table import Table, left

TEMPLATES = ROOT / "bench/paper/templates"
OBJECTS = ("sphere", "armadillo", "dragon")


class Report:
    """Numbers tables and figures, and says of each where it comes from."""

    def __init__(self):
        self.tables = self.figures = 0

    def source(self, command, scene=None, hash_text=None):
        """What makes a claim checkable."""
        parts = [f"command <code>{html.escape(command)}</code>"]
        if scene:
            parts.append(
                f"scene <code>{html.escape(scene)}</code>"
                if scene.endswith(".json")
                else f"scene: {html.escape(scene)}"
            )
        if hash_text:
            parts.append(f"state hash {hash_text}")
        return f'<span class="source">Source: {"; ".join(parts)}.</span>'

    def table(self, table, caption, source):
        self.tables += 1
        return "\n".join(table.html(f"<b>Table {self.tables}.</b> {caption} {source}", f"table-{self.tables}"))

    def figure(self, content, caption, source, kind=""):
        self.figures += 1
        words = f"<figcaption><b>Figure {self.figures}.</b> {caption} {source}</figcaption>"
        return f'<figure class="{kind}">{content}{words}</figure>'

    def plot(self, plot, caption, source):
        """Nothing where there is nothing to plot: the tables say what was not measured."""
        if plot is None:
            return ""
        name = f"plot-{self.figures + 1}"
        label = html.escape(plot.title)
        scroll = f'<div class="scroll" role="group" tabindex="0" aria-label="{label}">{drawing(name, [plot])}</div>'
        return self.figure(scroll, f"{html.escape(plot.title)}. {caption}", source, "plot")

    @staticmethod
    def side_by_side(*row):
        there = "".join(filter(None, row))
        return f'<div class="plots">{there}</div>' if there else ""


def data_address(path):
    kind = {".jpg": "image/jpeg", ".mp4": "video/mp4"}[path.suffix]
    return f"data:{kind};base64,{base64.b64encode(path.read_bytes()).decode()}"


def hashes_in(number):
    return f"with each row of table {number}"


def source_of(report, machine, experiment, table_number=None):
    rows = machine.rows(experiment)
    scenes = list(dict.fromkeys(row["scene"] for row in rows if row.get("scene")))
    several = {
        "pull": "scenes/pull-OBJECT.json, grid set to each size",
        "multigrid": "scenes/sheet.json, grid set to each size, and scenes/drape-OBJECT.json",
    }
    scene = scenes[0] if len(scenes) == 1 else several.get(experiment) if scenes else None
    builds = len({row.get("binary") for row in rows})
    quick = sum(row["command"].endswith(" --quick") for row in rows)
    remarks = [f"The rows are of {builds} builds of weft."] * (builds > 1) + [
        f"{quick} rows are by <code>--quick</code>."
    ] * (quick > 0)
    return report.source(
        machine.experiment(experiment)["command"], scene, hashes_in(table_number) if table_number else None
    ) + (f'<span class="source">{" ".join(remarks)}</span>' if remarks else "")


def not_measured(missing):
    return (
        f' <span class="missing">Not measured on this machine: {html.escape(", ".join(missing))}.</span>'
        if missing
        else ""
    )


def hardware(report, all_machines, figures):
    def value(machine, key, how=str):
        found = machine.hardware.get(key)
        return how(found) if found is not None else "not recorded"

    gib = lambda size: f"{size / 2**30:,.1f} GiB"
    paper = figures["machine"]
    lines = [
        ["GPU", *(value(m, "gpu") for m in all_machines), paper["gpu"]],
        ["kind, interface", *(f"{value(m, 'gpu_type')}, {value(m, 'backend')}" for m in all_machines), "not known"],
        ["driver", *(value(m, "driver") for m in all_machines), "not known"],
        ["GPU memory", *(value(m, "gpu_memory_bytes", gib) for m in all_machines), "not known"],
        ["CPU", *(value(m, "cpu") for m in all_machines), paper["cpu"]],
        ["threads", *(value(m, "threads") for m in all_machines), "not known"],
        ["memory", *(value(m, "memory_bytes", gib) for m in all_machines), "not known"],
        ["system", *(value(m, "system") for m in all_machines), "not known"],
        ["browser", *(value(m, "browser") for m in all_machines), paper["browser"]],
        ["remark", *(m.hardware.get("remark") or "none" for m in all_machines), ""],
        [
            "libraries",
            *(
                ", ".join(f"{name} {version}" for name, version in m.hardware.get("libraries", {}).items())
                or "not recorded"
                for m in all_machines
            ),
            "not known",
        ],
    ]
    table = Table(left("", *(m.name for m in all_machines), "the paper"), lines)
    table.columns[0] = ("part", "left")
    return report.table(
        table,
        "Hardware, as each machine says of itself, beside the paper's.",
        report.source("./dev bench paper --only hardware"),
    )


def kernels(report, machine, rows, source):
    if not any(row.get("kernels") for row in rows):
        return "<p>Times of kernels have not been measured on this machine.</p>"
    software = (
        " A software driver's timestamps say when work was handed over; "
        "compare their sum with ms a step before using them."
        if machine.hardware.get("gpu_type") == "CPU"
        else ""
    )
    return report.table(
        tables.kernels(rows),
        f"Time per kernel of the largest sheets, each dispatch in a pass of its own between two timestamps.{software}",
        source,
    )


def hanging(report, machine, figures):
    """One machine's part of the section."""
    parts = []
    rows = machine.rows("hanging")
    if rows:
        table, missing = tables.hanging(rows)
        number = report.tables + 1
        source = source_of(report, machine, "hanging", number)
        parts.append(
            report.table(
                table,
                "Hanging: a sheet pinned at two corners, natively." + not_measured(missing),
                source_of(report, machine, "hanging"),
            )
        )
        parts.append(
            report.side_by_side(
                report.plot(
                    plots.hanging_cost(machine, figures),
                    "The exponent is fitted to the upper half of the sizes.",
                    source,
                ),
                report.plot(
                    plots.frames_of_the_paper(
                        machine.measured("hanging"), plots.MODES, "Hanging: a frame as the paper counts it"
                    ),
                    "One step, normals and a picture of 1280 × 720, the queue drained after each frame.",
                    source,
                ),
            )
        )
        parts.append(kernels(report, machine, rows, source))
    else:
        parts.append("<p>The native sheet has not been measured on this machine.</p>")
    if machine.rows("largest"):
        parts.append(
            report.table(
                tables.largest(machine.rows("largest")),
                "The largest sheet that fits WebGPU's default limits, and this adapter's.",
                source_of(report, machine, "largest"),
            )
        )
    else:
        parts.append("<p>The largest sheet that fits has not been measured on this machine.</p>")
    browser = machine.experiment("chromium")
    if browser:
        source = report.source(browser["command"], f"scenes/{browser['scene']}.json")
        adapter = html.escape(f"{browser['adapter']}; WebGL: {browser['hardware'].get('webgl2', 'none')}")
        for table, what in zip(
            tables.compare(browser), ("a step, without drawing", "a frame: one step and its picture at 960 × 540")
        ):
            parts.append(
                report.table(table, f"In Chromium ({adapter}): {what}. The page takes no state hashes.", source)
            )
        parts.append(
            report.side_by_side(
                report.plot(
                    plots.hanging_browser(machine, "ms_per_step", "In Chromium: a step", "a step [ms]"),
                    "weft beside three.js, WebGL 2 shaders and the processor.",
                    source,
                ),
                report.plot(
                    plots.hanging_browser(machine, "ms_per_frame", "In Chromium: a frame", "a frame [ms]", 1000 / 60),
                    "One step and its picture, not held back by a display.",
                    source,
                ),
            )
        )
    else:
        parts.append("<p>The page <code>/compare</code> has not been run in a browser on this machine.</p>")
    parts.append(pictures(report, machine, "hanging"))
    return "\n".join(filter(None, parts))


def pull(report, machine, figures):
    parts = []
    rows = machine.rows("pull")
    if not rows:
        return "<p>The pulls have not been measured on this machine.</p>"
    for name in OBJECTS:
        same = [row for row in rows if row["object"] == name]
        if not same:
            parts.append(f"<p>The pull over the {name} has not been measured on this machine.</p>")
            continue
        table, missing = tables.pull(same)
        number = report.tables + 1
        parts.append(
            report.table(
                table,
                f"Pull over the {name} ({same[0].get('object_triangles', 0):,} triangles). The paper's fps "
                "(one detection, one step and one picture a frame) stand beside simulated real time."
                + not_measured(missing),
                source_of(report, machine, "pull"),
            )
        )
        source = source_of(report, machine, "pull", number)
        parts.append(
            report.side_by_side(
                report.plot(
                    plots.pull_cost(machine, figures, name), "<i>bvh</i> and <i>paper</i> end in the same bits.", source
                ),
                report.plot(
                    plots.frames_of_the_paper(
                        [row for row in same if "skipped" not in row],
                        plots.METHODS,
                        f"Pull over the {name}: a frame as the paper counts it",
                    ),
                    "One detection, one step, normals and a picture of 1280 × 720.",
                    source,
                ),
                report.plot(plots.pull_real_time(machine, name), "Above the line the sheet runs in real time.", source),
            )
        )
    parts.append(kernels(report, machine, rows, source_of(report, machine, "pull")))
    parts.append(pictures(report, machine, "pull"))
    return "\n".join(filter(None, parts))


def implicit(report, machine, figures):
    results = machine.experiment("multigrid")
    if not results:
        return "<p>The implicit solver has not been measured on this machine.</p>"
    source = source_of(report, machine, "multigrid", report.tables + 1)
    parts = [
        report.table(
            contact_tables.implicit(results),
            "The sheet of the study: errors after a quarter, a half and a whole second.",
            source_of(report, machine, "multigrid"),
        ),
        report.side_by_side(
            report.plot(plots.implicit_cost(machine), "Below the line a sheet runs in real time.", source),
            report.plot(
                plots.implicit_detail(machine),
                "What is left and low is better; <i>null</i> are coarser explicit sheets, drawn finely.",
                source,
            ),
        ),
    ]
    if any(row["object"] == "fabric" for row in results["rows"]):
        parts.append(
            report.table(
                contact_tables.implicit(results, "fabric"),
                "The same sheet of measured fabric: triangles and hinges instead of springs.",
                source_of(report, machine, "multigrid"),
            )
        )
    if any(row["object"] not in SHEETS for row in results["rows"]):
        parts.append(
            report.table(
                contact_tables.implicit_drapes(results),
                "Sheets laid over objects, with self-contact: whole scenes.",
                source_of(report, machine, "multigrid"),
            )
        )
    return "\n".join(filter(None, parts))


def picture_cells(machine, rows):
    """The stored pictures of these runs, in order: a row of the figure each."""
    for row in rows:
        for moment in media.MOMENTS:
            path = media.file_of(machine, row["files"].get(moment))
            if path:
                text = f"{row['name']}, {row['view']}, frame {row['moments'][moment] + 1}"
                yield f'<div><img src="{data_address(path)}" width="640" height="360" alt="{text}"><p>{text}</p></div>'


def gallery(report, machine, rows, columns, caption):
    cells = "".join(picture_cells(machine, rows))
    commands = "; ".join(
        f"<code>{html.escape(row['command'])}</code>, state hash <code>{row['state_hash']}</code>" for row in rows
    )
    return report.figure(
        f'<div class="pictures" style="--columns:{columns}">{cells}</div>',
        f"{caption} {rows[0]['nodes']:,} nodes.",
        f'<span class="source">Source: {commands}.</span>',
        "gallery",
    )


def pictures(report, machine, experiment):
    """The paper's layout: a row an object, columns early, middle and late; in both views, and a video of each pull."""
    rows = [row for row in machine.rows("pictures") if row["name"].startswith(experiment) and row["files"]]
    if not rows:
        return "<p>No pictures of this experiment have been made on this machine.</p>"
    if experiment == "hanging":
        return gallery(report, machine, rows, len(rows), "The hanging sheet at the end of its run.")
    rows.sort(key=lambda row: OBJECTS.index(row["name"].removeprefix("pull-")))
    parts = [
        gallery(
            report,
            machine,
            [row for row in rows if row["view"] == view],
            len(media.MOMENTS),
            f"The pulls, {view}: a row an object; early, middle and late.",
        )
        for view in media.VIEWS
    ]
    videos = [row for row in rows if media.file_of(machine, row["files"].get("video"))]
    for row in videos:
        poster = media.file_of(machine, row["files"].get("middle"))
        clip = media.file_of(machine, row["files"]["video"])
        video = (
            '<video controls muted playsinline preload="none" width="640" height="360" '
            f'poster="{data_address(poster)}" '
            f'src="{data_address(clip)}" aria-label="{row["name"]}, the whole run"></video>'
        )
        parts.append(
            report.figure(
                video,
                f"{row['name']}, {row['nodes']:,} nodes: the whole run at half speed.",
                report.source(row["command"], row["scene"], f"<code>{row['state_hash']}</code>"),
                "video",
            )
        )
    return "\n".join(parts)


def published(report, machine, figures):
    parts = []
    meshes = figures["meshes"]
    caption = (
        f"The paper's figures beside ours on {html.escape(str(machine.hardware.get('gpu')))}. What differs: "
        f"the GPU ({figures['machine']['gpu']} there); fps (the paper: {html.escape(figures['fps'])}; "
        "ours drain the queue after each frame and know no display); the armadillo "
        f"({meshes['armadillo']['weft'] / 1000:.1f}K triangles here, {meshes['armadillo']['paper'].split()[0]} there), "
        f"the dragon ({meshes['dragon']['weft']:,} here, {meshes['dragon']['paper'].split()[0]} there); "
        f"their sphere has {meshes['sphere']['code']} triangles, where the text says "
        f"{meshes['sphere']['paper'].split()[0]}. Our sheets have units and a step that stays stable, "
        f"so springs and steps are not theirs. {figures['not_published']}"
    )
    parts.append(
        report.table(
            tables.published(figures, machine.rows("hanging"), machine.rows("pull")),
            caption,
            report.source("./dev bench paper --only hanging,pull", "those of the rows"),
        )
    )
    code = figures["own_code"]
    if code["machine"] == machine.name:
        parts.append(
            report.table(
                tables.authors_code(figures, machine.rows("hanging"), machine.rows("pull")),
                f"On the same kind of card: {html.escape(code['source'])}. "
                "In brackets, how many times less weft's whole step takes; its scenes are its own.",
                '<span class="source">Source: bench/results/published.json.</span>',
            )
        )
    return "\n".join(parts)


def write(results=RESULTS, out=ROOT / "report", first=None):
    """The file's path."""
    all_machines = machines(results, first)
    figures = json.loads((RESULTS / "published.json").read_text())
    report = Report()
    sections = [("hardware", "Hardware", "", [(None, hardware(report, all_machines, figures))])]
    texts = {
        "hanging": ("Hanging", HANGING),
        "pull": ("Pull", PULL),
        "scaling": ("Scaling", SCALING),
        "implicit": ("The implicit solver", IMPLICIT),
        "published": ("The paper's figures beside ours", PUBLISHED),
    }
    makers = {
        "hanging": hanging,
        "pull": pull,
        "scaling": scaling.section,
        "implicit": implicit,
        "published": published,
    }
    for name, (title, text) in texts.items():
        sections.append(
            (name, title, text, [(machine, makers[name](report, machine, figures)) for machine in all_machines])
        )
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    themes = {
        name: ";".join(f"--s{k}:{colour}" for k, colour in enumerate(colours))
        for name, colours in (("light", LIGHT), ("dark", DARK))
    }
    page = environment.get_template("report.html.j2").render(
        sections=sections,
        machines=all_machines,
        figures=figures,
        themes=themes,
        css=(TEMPLATES / "report.css").read_text() + STYLE,
    )
    write_whole(out / "index.html", page)
    return out / "index.html"


HANGING = """The paper's first experiment: a sheet held at two corners. A step is one substep, timed over submits of
many, the queue drained after each. “Real time” is simulated seconds per wall second at the step that the sheet's
stiffness allows; “paper's fps” counts one step a frame, whatever time it simulates."""
PULL = """The paper's second experiment: a sheet laid over an object is pulled by its right edge. <i>none</i> is the
same step without contact; <i>paper</i> is the paper's brute force, <i>bvh</i> finds the same hits through a tree;
<i>proximity</i> keeps a distance, with friction; <i>proximity_self</i> keeps it from the sheet itself too. Each
starts where its own contact has brought the pulled sheet. Brute force is measured on larger sheets until it falls
under 0.1 frames a second."""
SCALING = """How cost grows, with exponents by least squares of the logarithms; and the lower bounds of a step: the
launch of its dispatches, and the bytes of its state."""
IMPLICIT = """Beyond the paper: eight substeps a frame whatever the resolution, beside explicit steps. A position error
alone shows little, since the coarsest sheets have it small too, so the mean angle between normals and the stretch of
the free sides stand beside it, and coarser explicit sheets drawn finely (<i>null</i>) are the lines to beat."""
PUBLISHED = """What the paper says, beside the same sizes here."""
