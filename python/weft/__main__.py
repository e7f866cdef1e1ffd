"""`weft` and `python -m weft`: the command line, docs/cli.md."""

import os
import sys
from typing import NoReturn

from .batch import command
from .machine import PROGRAM


def main() -> NoReturn:
    """Runs the program of the package; `sweep` alone is Python."""
    if sys.argv[1:2] == ["sweep"]:
        sys.exit(command.main(sys.argv[2:]))
    os.execv(PROGRAM, ["weft", *sys.argv[1:]])


if __name__ == "__main__":
    main()
