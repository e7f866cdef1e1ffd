"""Measuring and validating, by the command line in the package: rows as dicts."""

import json
import pathlib
import subprocess
import tempfile
from typing import Any, cast

from . import errors
from .machine import PROGRAM

# docs/cli.md, "Exit codes"
_ERRORS: dict[int, type[errors.Error]] = {
    2: errors.InputError,
    3: errors.InputError,
    4: errors.LimitError,
    5: errors.DeviceLostError,
    6: errors.DivergedError,
}


def bench(name: str, *options: str) -> dict[str, Any]:
    """What `weft bench NAME [options]` measures, as its file of --json: bench, adapter, driver, unchecked and rows.

    bench("hanging", "--quick", "--sides", "64")

    docs/cli.md, "Benchmarks", has names, options, and the members of rows with their units.
    Errors: InputError, no such benchmark or option. LimitError, no such adapter, or too large for it. DeviceLostError.
    """
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bench.json"
        call("bench", name, *options, "--json", str(file))
        return cast("dict[str, Any]", json.loads(file.read_text(encoding="utf-8")))


def validate(solver: str | None = None, only: list[str] | None = None, adapter: str = "") -> dict[str, Any]:
    """What `weft validate --json` says: how the cloth of this GPU obeys laws of mechanics (docs/validation.md).

    solver   only by this kind; else by each
    only     only these laws

    A number that does not hold is no error: its row says so. Errors: InputError, no such solver or law. LimitError, no
    such adapter.
    """
    words = ["--solver", solver] if solver else []
    words += ["--only", ",".join(only)] if only else []
    words += ["--adapter", adapter] if adapter else []
    return cast("dict[str, Any]", json.loads(call("validate", "--json", *words, good=(0, 1))))


def call(*words: str, good: tuple[int, ...] = (0,)) -> str:
    """What the program says on stdout. Errors: as its exit code says."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    if done.returncode in good:
        return done.stdout
    raise failure(done.returncode, done.stderr, *words)


def failure(code: int, stderr: str, *words: str) -> errors.Error:
    """The error of an exit code, with what the program said last."""
    said = [line.removeprefix("weft: ") for line in stderr.splitlines() if line.startswith("weft: ")]
    sentence = said[-1] if said else f"weft {' '.join(words)} ended with exit code {code}."
    return _ERRORS.get(code, errors.Error)(sentence)
