"""The meshes of a run, one at a time, as `weft export` of the program in the package reads them."""

import json
import os
import subprocess
from collections.abc import Iterator
from typing import IO, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..commands import failure
from ..errors import Error
from ..machine import PROGRAM
from ..progress import Progress


class Part(NamedTuple):
    """A cloth or body: the vertices and triangles that follow those of the parts before."""

    name: str
    vertices: slice
    triangles: slice
    color: tuple[float, float, float] | None  # linear


class Shape(NamedTuple):
    frame: int  # its number in the run
    positions: NDArray[np.float32]  # (vertices, 3) [m]
    normals: NDArray[np.float32]  # (vertices, 3), unit


class RunMeshes:
    """What all meshes of a run have in common, and the shapes as an iterator, to go through once."""

    def __init__(self, run: str | os.PathLike[str], first: int | None, last: int | None, every: int) -> None:
        self._words = ["export", os.fspath(run), "--format", "stream", "--every", str(every)]
        self._words += ["--first", str(first)] if first is not None else []
        self._words += ["--last", str(last)] if last is not None else []
        self._program = subprocess.Popen([PROGRAM, *self._words], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        size = self._out.readline()
        if not size:
            raise self._failure()
        about = json.loads(self._take(int(size)))
        self.frames: list[int] = about["frames"]
        self.frame_seconds: float = about["meshes"]["frame_s"]
        self.vertices: int = about["vertices"]
        self.parts = _parts(about["meshes"]["parts"])
        self.triangles = np.frombuffer(self._take(12 * about["triangles"]), "<u4").reshape(-1, 3)
        self.texture: NDArray[np.float32] | None = None
        if about["texture"]:
            self.texture = np.frombuffer(self._take(8 * self.vertices), "<f4").reshape(-1, 2)

    def shapes(self, progress: bool) -> Iterator[Shape]:
        """`progress`: shows on stderr, where that is a terminal, how far it is. Errors: InputError, a mesh cannot be
        read or differs from the first in its triangles."""
        bar = Progress(len(self.frames), "mesh") if progress else None
        try:
            for done, frame in enumerate(self.frames, 1):
                values = np.frombuffer(self._take(24 * self.vertices), "<f4").reshape(2, -1, 3)
                yield Shape(frame, values[0], values[1])
                if bar:
                    bar.show(done)
        finally:
            if bar:
                bar.end()
        if self._program.wait() != 0:
            raise self._failure()

    def close(self) -> None:
        self._program.kill()
        self._program.wait()
        self._out.close()
        if self._program.stderr:
            self._program.stderr.close()

    @property
    def _out(self) -> IO[bytes]:
        assert self._program.stdout is not None
        return self._program.stdout

    def _take(self, size: int) -> bytes:
        taken = self._out.read(size)
        if len(taken) != size:
            raise self._failure()
        return taken

    def _failure(self) -> Error:
        _, said = self._program.communicate()
        if self._program.returncode == 130:  # it has heard the signal before this process
            raise KeyboardInterrupt
        return failure(self._program.returncode, said.decode(errors="replace"), *self._words)


def _parts(listed: list[dict[str, Any]]) -> list[Part]:
    parts = []
    vertex = triangle = 0
    for one in listed:
        vertices = slice(vertex, vertex + one["vertices"])
        triangles = slice(triangle, triangle + one["triangles"])
        parts.append(Part(one["name"], vertices, triangles, tuple(one["color"]) if "color" in one else None))
        vertex, triangle = vertices.stop, triangles.stop
    return parts
