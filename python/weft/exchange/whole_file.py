"""Files that are there whole or not at all."""

import contextlib
import os
import pathlib
from collections.abc import Iterator

from ..errors import Error, InputError


@contextlib.contextmanager
def whole_file(path: pathlib.Path, ending: str, others: tuple[str, ...] = ()) -> Iterator[pathlib.Path]:
    """A temporary name, by which the file is synced and renamed at the end; it is removed where that does not come.

    Errors: InputError, the name ends neither in `ending` nor in one of the `others`. Error, there is no such folder.
    """
    if path.suffix not in (ending, *others):
        wanted = " or ".join((ending, *others))
        raise InputError(f"File {path} would not be read as {ending[1:]}: its name must end in {wanted}.")
    if not path.parent.is_dir():  # libraries make it
        raise Error(f"File {path} cannot be written: there is no folder {path.parent}.")
    temporary = path.with_name(f"{path.name}.tmp{os.getpid()}{ending}")
    try:
        yield temporary
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
