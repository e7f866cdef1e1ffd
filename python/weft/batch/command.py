"""`weft sweep`."""

import argparse
import contextlib
import os
import pathlib
import sys

from ..errors import Error, InputError
from ..machine import adapters
from ..progress import Progress
from . import on_ray, processes
from .plan import read_plan
from .store import Store


def sweep(
    file: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    workers: int | None = None,
    models: str | os.PathLike[str] | None = None,
    adapter: str = "",
    progress: bool = False,
    ray: str | None = None,
    cpus: float = 1,
    gpus: float = 0,
) -> pathlib.Path:
    """Does the runs of a sweep that `out` does not have yet, and gives the path of the table of all (docs/sweep.md).

    file      the sweep, JSON
    out       the folder of its results; the same call goes on where another was ended
    workers   processes; by default one for each core where the GPU is a software one, else one
    models, adapter   as of World
    progress  shows on stderr, where that is a terminal, how far it is and the time left
    ray       the address of a Ray cluster that does the runs instead, "auto" for the one at hand, "local" for a new one
    cpus, gpus   what a run takes of the cluster's; parts of a GPU too

    Errors: InputError, the sweep is wrong, the folder has another's runs, or there is no such cluster. Error, pyarrow
    or ray is missing.
    """
    plan = read_plan(pathlib.Path(file))
    count = workers if workers is not None else _default_workers(adapter)
    if count < 1:
        raise InputError(f"{count} workers cannot work; wanted is 1 or more.")
    folder = None if models is None else os.fspath(models)
    with Store(pathlib.Path(out), plan) as store:
        missing = [run for run in plan.runs if run.number not in store.rows]
        before = len(store.rows)
        bar = Progress(len(plan.runs), "run") if progress else None
        try:
            done = (
                on_ray.results(missing, ray, cpus, gpus, folder, adapter)
                if ray
                else processes.results(missing, count, folder, adapter)
            )
            with contextlib.closing(done) as results:
                for run, row, shape in results:
                    store.add(row, shape, run.export)
                    if bar:
                        bar.show(len(store.rows), before)
        finally:
            if bar:
                bar.end()
            table = store.write_table()
    return table


def main(words: list[str]) -> int:
    """The command, with its exit code (docs/cli.md)."""
    parser = argparse.ArgumentParser(
        prog="weft sweep", description=sweep.__doc__.split("\n")[0] if sweep.__doc__ else ""
    )
    parser.add_argument("file", metavar="SWEEP.json", help="what to run")
    parser.add_argument("--out", required=True, metavar="DIR", help="the folder of the results")
    parser.add_argument("--workers", type=int, metavar="N", help="processes")
    parser.add_argument("--models", metavar="DIR", help="the folder of models")
    parser.add_argument("--adapter", default="", metavar="NAME", help="use the GPU whose name contains this")
    parser.add_argument("--ray", metavar="ADDRESS", help='run on a Ray cluster; "auto", "local" or its address')
    parser.add_argument("--cpus", type=float, default=1, metavar="N", help="processors that a run takes there")
    parser.add_argument("--gpus", type=float, default=0, metavar="N", help="GPUs that a run takes there")
    given = parser.parse_args(words)
    try:
        table = sweep(**vars(given), progress=True)
    except KeyboardInterrupt:
        print(f"weft: The sweep was interrupted; the same command goes on in {given.out}.", file=sys.stderr)
        return 130
    except (Error, OSError) as error:
        print(f"weft: {error}", file=sys.stderr)
        return 3 if isinstance(error, InputError) else 1
    print(table)
    return 0


def _default_workers(adapter: str) -> int:
    chosen = [one for one in adapters() if adapter.lower() in one.name.lower()]
    return os.cpu_count() or 1 if chosen and all(one.type == "CPU" for one in chosen) else 1
