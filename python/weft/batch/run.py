"""One run of a sweep, wherever it is done."""

import json
import os
import platform
import time
import traceback
from typing import Any

from .. import errors
from ..world import World
from .plan import Run

Row = dict[str, Any]


def do(run: Run, models: str | None, adapter: str) -> tuple[Row, bytes | None]:
    """The row of a run, and the file of its shape where one is asked for. What fails is in the row, by its sentence."""
    start = time.monotonic()
    row: Row = {
        "run": run.number,
        **run.values,
        "repeat": run.repeat,
        "end": "complete",
        "error": None,
        "worker": f"{platform.node()}:{os.getpid()}",
    }
    shape = None
    try:
        world = World(run.scene, changes=run.changes, models=models, adapter=adapter)
        row["adapter"] = world.adapter
        row["solver"] = world.description["solver"]
        row["nodes"] = world.nodes
        try:
            summary = world.run(run.frames)
            row.update(wall_s=summary.wall_s, simulated_s=summary.simulated_s, state_hash=summary.state_hash)
            row.update(summary.totals)
        except errors.DivergedError as error:
            row.update(end="diverged", error=str(error), **world.totals)
        if row["end"] == "complete":
            if run.metric:
                row.update(_measured(world, *run.metric))
            if run.export:
                shape = world.mesh_file(run.export)
    except errors.Error as error:
        row.update(end="failed", error=str(error))
    row["seconds"] = time.monotonic() - start
    return row, shape


def lost(run: Run, times: int) -> Row:
    """The row of a run whose worker died each time."""
    error = f"The worker of this run died, {times} times."
    return {"run": run.number, **run.values, "repeat": run.repeat, "end": "failed", "error": error}


def _measured(world: World, text: str, name: str) -> Row:
    """What the sweep's own function says of the last state: numbers by name."""
    names: dict[str, Any] = {}
    try:
        exec(compile(text, "the metric", "exec"), names)
        measured = names[name](world)
        said = {f"metric.{key}": float(value) for key, value in measured.items()}
        json.dumps(said)
        return said
    except Exception as error:
        line = traceback.extract_tb(error.__traceback__)[-1].lineno
        raise errors.InputError(f"The metric {name} failed in line {line}: {type(error).__name__}: {error}") from None
