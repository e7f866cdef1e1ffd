"""`weft export`, where a format has a library in Python alone; the others are the program's."""

import argparse
import contextlib
import os
import pathlib
import signal
import sys

from ..commands import call
from ..errors import Error, InputError, LimitError
from .alembic import write_alembic
from .meshes import RunMeshes
from .usd import write_usd

FORMATS = ("usda", "usdc", "abc")
_ENDS = {"obj": "_obj", "ply": "_ply"}  # folders


def export(
    run: str | os.PathLike[str],
    format: str,
    out: str | os.PathLike[str] | None = None,
    *,
    first: int | None = None,
    last: int | None = None,
    every: int = 1,
    progress: bool = False,
) -> pathlib.Path:
    """Writes the meshes of a run (`weft run --meshes-every`) as one animation, and gives its path (docs/export.md).

    run       the folder of the run
    format    "usdc", "usda", "abc", "glb", "pc2", "mdd"; or "obj" or "ply", a folder of single meshes
    out       the file or folder; by default beside the run, with its name
    first, last   only frames from this to that number
    every     only the first of these meshes and every so manieth after it
    progress  shows on stderr, where that is a terminal, how far it is

    Errors: InputError, a mesh is missing or differs, or the format is unknown. LimitError, too large for the format.
    Error, the place cannot be written, or the format's library is missing.
    """
    path = pathlib.Path(out) if out is not None else _beside(run, _ENDS.get(format, f".{format}"))
    if format not in FORMATS:
        words = ["export", os.fspath(run), "--format", format, "--out", str(path), "--every", str(every)]
        words += ["--first", str(first)] if first is not None else []
        words += ["--last", str(last)] if last is not None else []
        call(*words)
        return path
    if format == "abc":
        write_alembic(os.fspath(run), path, first, last, every, progress)
        return path
    with contextlib.closing(RunMeshes(run, first, last, every)) as meshes:
        write_usd(meshes, path, format, progress)
    return path


def is_ours(words: list[str]) -> bool:
    """Whether these words of a command line ask for one of FORMATS."""
    pairs = zip(words, [*words[1:], ""], strict=True)
    return any(
        word in (f"--format={name}",) or (word == "--format" and value == name)
        for word, value in pairs
        for name in FORMATS
    )


def main(words: list[str]) -> int:
    """The command, with its exit code (docs/cli.md)."""
    parser = argparse.ArgumentParser(prog="weft export", description="Write the meshes of a run as one animation.")
    parser.add_argument("run", metavar="RUN", help="the folder of a run")
    parser.add_argument("--format", required=True, choices=FORMATS, help="of the file")
    parser.add_argument("-o", "--out", metavar="PATH", help="the file; else beside RUN")
    parser.add_argument("--first", type=_whole, metavar="N", help="no frame before this")
    parser.add_argument("--last", type=_whole, metavar="N", help="no frame after this")
    parser.add_argument("--every", type=_positive, default=1, metavar="N", help="every N-th of these meshes")
    parser.add_argument("-q", "--quiet", action="store_true", help="do not say what was written")
    given = vars(parser.parse_args(words))
    quiet = given.pop("quiet")
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # it leaves nothing either
    try:
        path = export(**given, progress=True)
    except KeyboardInterrupt:
        print("weft: Interrupted; nothing is written.", file=sys.stderr)
        return 130
    except (Error, OSError) as error:
        print(f"weft: {error}", file=sys.stderr)
        return 3 if isinstance(error, InputError) else 4 if isinstance(error, LimitError) else 1
    if not quiet:
        print(path)
    return 0


def _beside(run: str | os.PathLike[str], end: str) -> pathlib.Path:
    path = pathlib.Path(os.path.normpath(run))
    path = path.resolve() if path.name in ("", "..") else path
    return path.with_name(path.name + end)


def _whole(text: str) -> int:
    number = int(text)
    if not 0 <= number <= 1000000:
        raise argparse.ArgumentTypeError(f"{text} is not from 0 to 1000000")
    return number


def _positive(text: str) -> int:
    if int(text) == 0:
        raise argparse.ArgumentTypeError("0 is not from 1 to 1000000")
    return _whole(text)
