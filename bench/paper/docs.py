"""Writes what the repository shows of the stored results: docs/performance.md, its plots, and README's figures.

Every number in docs/performance.md comes from a stored row or from bench/results/aims.json; a test fails where the
files differ from what this writes.
"""

import json
import pathlib
import re

import jinja2

from scripts import lines

from . import contact_tables, experiment_tables, facts, plots
from .store import RESULTS, ROOT, write_whole
from .svg import drawing
from .wording import number, rounded, span

TEMPLATES = ROOT / "bench/paper/templates"
README_BLOCK = re.compile(r"(<!--\s+results\s+(\w+)\s+-->).*?(<!--\s+end\s+-->)", re.S)


def environment(folder):
    made = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    made.filters |= {
        "digits": rounded,
        "span": span,
        "number": number,
        "commas": lambda value: f"{value:,.0f}",
        "percent": lambda value: f"{100 * value:.0f} %",
    }

    def stored(name):
        return json.loads((folder / name).read_text())

    def head(results):
        """Which machine a table is of."""
        driver = f", driver {results['driver']}" if "driver" in results else ""
        host = (
            f"{results['processor']}, {results['threads']} threads, Embree {results['embree']}; "
            if "embree" in results
            else ""
        )
        unchecked = ", kernels without run-time checks" if results.get("unchecked") else ""
        return f"{host}{results['adapter']}{driver}{unchecked}:"

    def table(results, of):
        made_table = of(results)
        return head(results) + "\n\n" + "\n".join(made_table.markdown())

    def run_table(one, experiment):
        results = one.machine.experiment(experiment)
        made_table, missing = getattr(experiment_tables, experiment)(results["rows"])
        note = f"\n\nNot measured there: {', '.join(missing)}." if missing else ""
        return head(results) + "\n\n" + "\n".join(made_table.markdown()) + note

    def compare_tables(one):
        results = one.machine.experiment("chromium")
        return (
            head(results)
            + "\n\n"
            + "\n\n".join("\n".join(made_table.markdown()) for made_table in experiment_tables.compare(results))
        )

    h100 = facts.Facts("h100", folder)
    made.globals |= {
        "h100": h100,
        "two": facts.Facts("2core", folder),
        "aims": h100.aims,
        "stored": stored,
        "tables": contact_tables,
        "table": table,
        "run_table": run_table,
        "compare_tables": compare_tables,
        "facts": facts,
    }
    return made


def readme(text, macros):
    """README with its marked blocks written again."""
    return README_BLOCK.sub(lambda match: match[1] + str(getattr(macros, match[2])()) + match[3], text)


def generate(folder=RESULTS):
    """{path from the repository's root: text}."""
    made = environment(folder)
    contact = json.loads((folder / "h100_contact.json").read_text())
    figures = json.loads((folder / "published.json").read_text())
    machine = made.globals["h100"].machine
    texts = {
        "docs/performance.md": made.get_template("performance.md.j2").render(),
        "README.md": readme((ROOT / "README.md").read_text(encoding="utf-8"), made.get_template("readme.md.j2").module),
        "docs/images/cost.svg": drawing("cost", [plots.readme_cost(machine, figures)], alone=True) + "\n",
        "docs/images/contact-growth.svg": plots.contact_growth(contact) + "\n",
        "docs/images/contact-search.svg": plots.contact_kernels(contact, "search") + "\n",
        "docs/images/contact-step.svg": plots.contact_kernels(contact, "step") + "\n",
    }
    # Paragraphs are filled here: in a template figures stand for longer expressions.
    texts |= {
        name: "\n".join(lines.filled(text.split("\n"), always=True))
        for name, text in texts.items()
        if name.endswith(".md")
    }
    return {name: lines.mended(pathlib.Path(name), text) for name, text in texts.items()}


def write(folder=RESULTS):
    for name, text in generate(folder).items():
        write_whole(ROOT / name, text)
        yield name
