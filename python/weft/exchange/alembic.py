"""Alembic, by alembic3d: the unofficial wheels of the project's own Python bindings."""

import importlib.util
import json
import pathlib
import subprocess
import sys

from ..commands import failure
from ..errors import Error
from .whole_file import whole_file


def write_alembic(
    run: str, path: pathlib.Path, first: int | None, last: int | None, every: int, progress: bool
) -> None:
    """Writes an animation, whole or not at all, in a process of its own: the library ends its process, without an
    exception, where a disk is full while it closes a file.

    Errors: InputError, the name has another ending, or a mesh cannot be read. Error, alembic3d is missing, or the place
    cannot be written.
    """
    if not importlib.util.find_spec("alembic3d"):
        raise Error("The format abc needs alembic3d: pip install 'weft[alembic]'.")
    with whole_file(path, ".abc") as temporary:
        words = json.dumps([run, str(temporary), path.stem, first, last, every, progress])
        done = subprocess.run(
            [sys.executable, "-m", f"{__package__}.alembic_writer", words],
            stdout=subprocess.PIPE,
            stderr=None if progress and sys.stderr.isatty() else subprocess.DEVNULL,
            text=True,
            check=False,
        )
        if done.returncode == 130:
            raise KeyboardInterrupt
        if done.returncode < 0:
            raise Error(f"File {path} cannot be written: Alembic gives up, as it does where a disk is full.")
        if done.returncode != 0:
            raise failure(done.returncode, done.stdout, "export", run)
