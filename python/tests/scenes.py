"""Scenes of the tests."""

import json
import os
import pathlib
import subprocess
import sys
from typing import Any

import weft
from weft.machine import PROGRAM

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
FRAME = 1 / 60  # s
GRAVITY = 9.81  # m/s²


def sheet(side: int = 12, **keys: Any) -> dict[str, Any]:
    """A level sheet of side x side nodes, held by two corners."""
    cloth = {"grid": [side, side], "size": [1, 1], "plane": "xz", "density": 0.2, "pins": ["top_left", "top_right"]}
    return {
        "format": "weft-scene/1",
        "solver": {"kind": "mass_spring"},
        "contact": {"method": "none"},
        "cloths": [{**cloth, **keys}],
    }


def world(side: int = 12, **keys: Any) -> weft.World:
    return weft.World(sheet(side, **keys))


def command_line(*words: str) -> dict[str, Any]:
    """What `weft run --json` says, of the program in the package."""
    done = subprocess.run([PROGRAM, "run", *words, "--json"], capture_output=True, text=True, check=True)
    said: dict[str, Any] = json.loads(done.stdout)
    return said


def python(code: str, *words: str, **environment: str) -> subprocess.Popen[str]:
    """Another interpreter, of the same environment, with pipes."""
    return subprocess.Popen(
        [sys.executable, "-c", code, *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, **environment},
    )
