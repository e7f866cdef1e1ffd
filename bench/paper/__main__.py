"""./dev bench paper: reruns the paper's experiments on this machine, and writes the report.

Measuring needs the standard library and the binary alone; the report and the docs need jinja2.
"""

import argparse
import pathlib
import sys

from . import browser, cases, hardware, measure, media
from .progress import say
from .store import RESULTS, ROOT, Machine, Unreadable

PARTS = ("hardware", "copy", "hanging", "pull", "multigrid", "largest", "chromium", "pictures", "pack", "report")
SOFTWARE_SIDE = 128  # of the largest sheet that a software adapter is asked for without --most


def options():
    parser = argparse.ArgumentParser(prog="./dev bench paper", description=__doc__.splitlines()[0])
    parser.add_argument(
        "--quick", action="store_true", help="small sizes, little repetition: under five minutes on 2 cores"
    )
    parser.add_argument("--only", metavar="NAME", help=f"comma list of {', '.join(PARTS)}")
    parser.add_argument(
        "--stored",
        action="store_true",
        help="measure nothing: write the report, README's figures and docs/performance.md from stored results",
    )
    parser.add_argument("--fresh", action="store_true", help="measure again what this binary has measured before")
    parser.add_argument(
        "--machine", metavar="NAME", help="the file of results (default: the adapter's name and the number of threads)"
    )
    parser.add_argument("--adapter", metavar="NAME", help="of weft bench: the GPU whose name contains NAME")
    parser.add_argument(
        "--most",
        metavar="SIDE",
        type=int,
        help=f"largest sheet, in nodes a side (default: {cases.LARGE_SIDE}; {SOFTWARE_SIDE} on software)",
    )
    parser.add_argument(
        "--remark",
        metavar="TEXT",
        help="what a reader of this machine's results should know, such as what else ran on it",
    )
    parser.add_argument(
        "--weft",
        metavar="PATH",
        type=pathlib.Path,
        default=ROOT / "build/weft",
        help="the binary (default: build/weft)",
    )
    parser.add_argument("--results", metavar="DIR", type=pathlib.Path, default=RESULTS, help="default: bench/results")
    parser.add_argument("--out", metavar="DIR", type=pathlib.Path, default=ROOT / "report", help="default: report")
    given = parser.parse_args()
    given.parts = given.only.split(",") if given.only else [part for part in PARTS if part != "pack"]
    for part in given.parts:
        if part not in PARTS:
            parser.error(f'--only knows {", ".join(PARTS)}, not "{part}"')
    if given.quick and not given.only:
        given.parts = [part for part in given.parts if part not in ("largest", "chromium")]
    return given


def measure_all(given, machine, found):
    """Whether all that was asked for could be measured."""
    software = found["gpu_type"] == "CPU"
    most_side = given.most or (SOFTWARE_SIDE if software else cases.LARGE_SIDE)
    well = True
    if "hardware" in given.parts or not machine.hardware:
        machine.data["hardware"] = found | {key: value for key, value in machine.hardware.items() if key == "remark"}
    if given.remark is not None:
        machine.hardware["remark"] = given.remark
    machine.save()
    plan = cases.plan(given.parts, given.quick, most_side)
    if plan:
        well = measure.run(machine, plan, given.weft, given.adapter, given.fresh)
    if "chromium" in given.parts:
        asked = given.only is not None  # without it, a machine that has no browser is measured all the same
        well = (browser.run(machine, given.quick, most_side, given.fresh) or not asked) and well
    if "pictures" in given.parts:
        media.draw(machine, given.weft, given.out, given.quick, software, given.adapter, given.fresh)
    return well


def main():
    given = options()
    try:
        well = True
        measuring = [part for part in given.parts if part not in ("report", "pack")]
        name = given.machine
        if measuring and not given.stored:
            if not given.weft.exists():
                raise measure.Failed(3, f"There is no binary {given.weft}; ./dev build makes it.")
            found = hardware.describe(given.weft, given.adapter)
            if not found["gpu"]:
                raise measure.Failed(
                    4, "No adapter" + (f' whose name contains "{given.adapter}".' if given.adapter else ".")
                )
            machine = Machine(name or hardware.slug(found), given.results)
            name = machine.name
            try:
                well = measure_all(given, machine, found)
            except KeyboardInterrupt:
                say(f"interrupted; what is measured is in {machine.path}, and the same command goes on from there")
                return 130
        if "pack" in given.parts:
            if not name:
                raise measure.Failed(2, "--only pack needs --machine NAME.")
            media.pack(Machine(name, given.results), given.out)
        if given.stored or "report" in given.parts:
            from . import report

            say(f"wrote {report.write(given.results, given.out, name)}")
        if given.stored:
            from . import docs

            for path in docs.write(given.results):
                say(f"wrote {path}")
        return 0 if well else 1
    except measure.Failed as failure:
        say(str(failure))
        return failure.code
    except (Unreadable, RuntimeError) as problem:
        say(str(problem))
        return 3 if isinstance(problem, Unreadable) else 1


sys.exit(main())
