"""`weft` and `python -m weft`: the command line, docs/cli.md."""

import os
import sys
from typing import NoReturn

from .machine import PROGRAM


def main() -> NoReturn:
    os.execv(PROGRAM, ["weft", *sys.argv[1:]])


if __name__ == "__main__":
    main()
