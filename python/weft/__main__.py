"""`weft` and `python -m weft`: the command line, docs/cli.md."""

import os
import sys
from typing import NoReturn

from .batch import command
from .exchange import command as exchange
from .machine import PROGRAM


def main() -> NoReturn:
    """Runs the program of the package; `sweep`, and `export` of some formats, are Python."""
    if sys.argv[1:2] == ["sweep"]:
        sys.exit(command.main(sys.argv[2:]))
    if sys.argv[1:2] == ["export"] and exchange.is_ours(sys.argv[2:]):
        sys.exit(exchange.main(sys.argv[2:]))
    os.execv(PROGRAM, ["weft", *sys.argv[1:]])


if __name__ == "__main__":
    main()
