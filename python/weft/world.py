"""A running scene, with arrays of numpy."""

import os
import pathlib
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import InputError, ShapeError
from .machine import models_folder
from .png import png
from .progress import counted
from .scenes import Scene, scene_text, to_json

Floats = npt.NDArray[np.float32]
Point = Sequence[float] | npt.NDArray[Any]
_Point = tuple[float, float, float]


@dataclass(frozen=True)
class Camera:
    """From where a picture is taken."""

    eye: Point  # (3,) [m]
    target: Point  # (3,) [m]
    fov_degrees: float = 35  # vertical


@dataclass(frozen=True)
class Picked:
    """The place of a cloth that a ray meets first."""

    cloth: int  # in the scene's order, each of a cloth's copies counted
    triangle: int  # of World.triangles
    node: int  # the triangle's corner that is nearest to the point
    point: Floats  # (3,) [m]
    distance: float  # from the ray's origin [m]


@dataclass(frozen=True)
class Summary:
    """How a run went."""

    frames: int  # since the start of the scene
    simulated_s: float  # likewise [s]
    wall_s: float  # of this run [s]
    state_hash: str  # of the last state; that of `weft run --json` after as many frames
    totals: dict[str, int | float]  # World.totals


class World:
    """A running scene on a GPU device of its own.

    scene    a dict (docs/scene.md), a path, or the name of a shipped scene (`scene_names`)
    changes  values of keys, set before anything is checked: {"cloths.0.grid": [64, 64]}
    meshes   what the scene may name as a mesh: {"flag": (positions (n, 3) [m], triangles (m, 3))}
    models   the folder of meshes that a scene names without a path; without it WEFT_MODELS, or `models` in the package
    adapter  part of the GPU's name, in any case; empty: the fastest kind there is

    Nodes are those of all cloths and bodies, one after the other: row by row on a grid (node j * nx + i), in the order
    of its vertices on a mesh.

    Errors: InputError, the scene or a mesh is wrong or missing. NoAdapterError, LimitError, DeviceError.

    Several threads may share a world: a call waits for that of another thread, and other threads of Python run
    meanwhile.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        changes: Mapping[str, object] | None = None,
        meshes: Mapping[str, tuple[npt.ArrayLike, npt.ArrayLike]] | None = None,
        models: str | os.PathLike[str] | None = None,
        adapter: str = "",
    ) -> None:
        text, name = scene_text(scene)
        given = [(key, *_mesh(key, *mesh)) for key, mesh in (meshes or {}).items()]
        sets = [(key, to_json(value)) for key, value in (changes or {}).items()]
        self._core = _core.World(text, name, sets, given, models_folder(models), adapter)
        self._nodes = self._core.nodes()
        self._description = self._core.describe()

    def __repr__(self) -> str:
        return f"<weft.World of {self._nodes} nodes at {self.time:.4g} s on {self.adapter}>"

    def step(self, frames: int = 1) -> None:
        """Simulates frames of `description["frame_seconds"]` each.

        They are handed to the GPU; what reads the state waits for them. Ctrl-C ends between two frames.

        Errors: DivergedError, a node of an earlier frame is not finite; the state is that before this frame, and stays.
        DeviceError.
        """
        for _ in range(_count(frames)):
            self._core.advance()

    def run(self, frames: int | None = None, *, progress: bool = False) -> Summary:
        """Simulates frames, by default as many as the scene asks for, and waits for them.

        progress  shows on stderr, where that is a terminal, how far it is and the time left

        Errors: as `step`.
        """
        count = _count(self._description["frames"] if frames is None else frames)
        start = time.monotonic()
        for _ in counted(range(count), count, "frame") if progress else range(count):
            self._core.advance()
        self._core.finish()
        wall = time.monotonic() - start
        return Summary(self.frame, self.time, wall, self._core.state_hash(), self._core.totals())

    def finish(self) -> None:
        """Waits until all frames are done and have reported. Errors: as `step`."""
        self._core.finish()

    def reset(self) -> None:
        """Back to the rest state at time 0, without grabs; values of `change` stay. Errors: DeviceError."""
        self._core.reset()

    @property
    def frame(self) -> int:
        """Frames so far."""
        return self._core.frame()

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self._core.time()

    @property
    def nodes(self) -> int:
        """How many nodes there are, of all cloths and bodies."""
        return self._nodes

    @property
    def positions(self) -> Floats:
        """Where the nodes are at the end of the last frame, (nodes, 3) float32 [m]; waits for it.

        The array is new and the caller's, and the host's only copy: the state is on the GPU. `torch.from_dlpack` and
        others take it as it is. Errors: DeviceError.

        Set, (nodes, 3) [m], it is where the next frame begins; velocities stay, and contact forgets what it held.
        Errors: ShapeError. InputError, a place is not finite, or a pinned or moved node would leave its own.
        """
        return self.read_positions(self._vectors())

    @positions.setter
    def positions(self, values: npt.ArrayLike) -> None:
        self._core.set_positions(self._given(values, "positions"))

    def read_positions(self, out: Floats) -> Floats:
        """Fills `out`, (nodes, 3) float32 in C order, with the positions [m], and gives it back.

        Errors: ShapeError, it is another kind of array. DeviceError.
        """
        self._core.read_positions(self._checked(out))
        return out

    @property
    def velocities(self) -> Floats:
        """How fast the nodes move, (nodes, 3) float32 [m/s]; as `positions`. Pinned and moved nodes keep theirs."""
        return self.read_velocities(self._vectors())

    @velocities.setter
    def velocities(self, values: npt.ArrayLike) -> None:
        self._core.set_velocities(self._given(values, "velocities"))

    def push(self, impulses: npt.ArrayLike) -> None:
        """Adds an impulse to each free node at once, (nodes, 3) [N·s].

        Forces of a program's own, in each frame: `world.push(forces * world.description["frame_seconds"])`.

        Errors: ShapeError. InputError, one is not finite.
        """
        self._core.push(self._given(impulses, "impulses"))

    def read_velocities(self, out: Floats) -> Floats:
        """Fills `out` with the velocities [m/s]; as `read_positions`."""
        self._core.read_velocities(self._checked(out))
        return out

    def move(self, places: npt.ArrayLike, nodes: npt.ArrayLike | None = None) -> None:
        """Moves nodes of motions of kind "given" to places (k, 3) [m], straight and evenly through the next frame.

        nodes  their numbers, (k,); without them all of `given_nodes`

        There they stay, as the others do where they are. The next frame's velocity of each is its way over
        `frame_seconds`.

        Errors: ShapeError. InputError, a node is not given; a place is not finite, or farther than the motion's speed
        reaches in a frame.
        """
        chosen = self.given_nodes if nodes is None else _numbers(nodes)
        self._core.move(chosen, _vectors(places, len(chosen), "places"))

    @property
    def given_nodes(self) -> npt.NDArray[np.uint32]:
        """The nodes that `move` takes, (k,) uint32, rising."""
        return np.array(self._core.given_nodes(), np.uint32)

    def set_collider(
        self,
        collider: int,
        position: Point = (0, 0, 0),
        rotation: Sequence[float] | npt.NDArray[Any] = (0, 0, 0, 1),
        *,
        matrix: npt.ArrayLike | None = None,
    ) -> None:
        """Moves a collider with a motion of kind "given" through the next frame, from where the scene puts it.

        collider  its place in the scene's list, one of `given_colliders`
        position  (3,) [m]
        rotation  (4,), a unit quaternion x, y, z, w: p' = R p + position
        matrix    (4, 4), instead of both: p' = matrix @ p, without a scale

        It goes at constant velocity and spin, which cloth in contact feels; what is attached to it goes along. There it
        stays. Called again before that frame, it counts instead.

        Errors: ShapeError. InputError, another collider; a number is not finite, or the rotation none; a point of it
        would go faster than the motion's speed. It does not move then.
        """
        if collider < 0:
            raise InputError(f"Collider {collider} is not one of the world's.")
        if matrix is None:
            turn = np.asarray(rotation, np.float64)
            if turn.shape != (4,):
                raise ShapeError(f"The rotation has shape {turn.shape}; wanted is (4,).")
            x, y, z, w = turn.tolist()
            self._core.set_collider(collider, _point(position, "position"), (x, y, z, w))
            return
        numbers = np.asarray(matrix, np.float64)
        if numbers.shape != (4, 4):
            raise ShapeError(f"The matrix has shape {numbers.shape}; wanted is (4, 4).")
        self._core.set_collider_by(collider, numbers.T.ravel().tolist())

    @property
    def given_colliders(self) -> list[int]:
        """The colliders that `set_collider` takes, rising."""
        return self._core.given_colliders()

    @property
    def normals(self) -> Floats:
        """Unit vectors, (nodes, 3) float32; as `positions`."""
        out = self._vectors()
        self._core.read_normals(out)
        return out

    @property
    def stretch(self) -> Floats:
        """Length over rest length of the most stretched edge at each node, (nodes,) float32. Errors: DeviceError."""
        out = np.empty(self._nodes, np.float32)
        self._core.read_stretch(out)
        return out

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """The triangles of all cloths and bodies, (triangles, 3) uint32: numbers of nodes."""
        return self._core.triangles()

    def change(self, key: str, value: object) -> None:
        """Changes a value of the running scene from the next frame on: `change("gravity", [0, -1.62, 0])`.

        Gravity, external_force, drag, wind and, where the scene has it, air can change.

        Errors: InputError, not a valid scene, or the key cannot change while the cloth moves. LimitError, the drag
        makes the step unstable.
        """
        self._core.change(key, to_json(value))

    def grab(self, node: int, target: Point) -> None:
        """Grabs a free node and pulls it to `target` (3,) [m] from the next frame on, with limited speed.

        Errors: InputError, no such node; it is pinned, moved or grabbed already. LimitError, 1,024 nodes are grabbed.
        """
        self._core.grab(node, _point(target, "target"))

    def drag(self, node: int, target: Point) -> None:
        """Pulls a grabbed node elsewhere, (3,) [m]. Errors: InputError, it is not grabbed."""
        self._core.drag(node, _point(target, "target"))

    def release(self, node: int) -> None:
        """Lets a grabbed node go on with its velocity. Errors: InputError, it is not grabbed."""
        self._core.release(node)

    def pick(self, origin: Point, direction: Point) -> Picked | None:
        """The first cloth that a ray meets, from either side: from `origin` (3,) [m] along `direction` (3,).

        Errors: InputError, a coordinate is not finite, or the direction is 0. DeviceError.
        """
        found = self._core.pick(_point(origin, "origin"), _point(direction, "direction"))
        if found is None:
            return None
        cloth, triangle, node, point, distance = found
        return Picked(cloth, triangle, node, np.array(point, np.float32), distance)

    def render(
        self,
        width: int | None = None,
        height: int | None = None,
        *,
        view: str | None = None,
        camera: Camera | None = None,
        legend: bool = True,
    ) -> npt.NDArray[np.uint8]:
        """A picture of the state at the end of the last frame, (height, width, 4) uint8: red, green, blue, alpha, sRGB.

        width, height  [pixel]; without them the scene's render.size
        view           "textured", "wireframe", "normals", "stretch", "velocity" or "contacts"; else render.view
        camera         without it the scene's, or one that has all of it in the frame
        legend         what the colours of a view mean, in the picture's corner

        Errors: InputError, a side is 0, or the scene lacks what the view shows. LimitError, larger than the GPU can
        draw. DeviceError.
        """
        place = None if camera is None else _place(camera)
        return self._core.render(width, height, view, place, legend)

    def mesh_file(self, format: str) -> bytes:
        """The present shape as a file of the format "obj", "ply" or "glb". Errors: InputError, another format."""
        return self._core.mesh_file(format)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the present shape into a file whose name ends in .obj, .ply or .glb, or a picture (.png).

        Errors: InputError, another ending. OSError, the file cannot be written.
        """
        ending = pathlib.Path(path).suffix.removeprefix(".")
        pathlib.Path(path).write_bytes(png(self.render()) if ending == "png" else self.mesh_file(ending))

    def _repr_png_(self) -> bytes:
        """What a notebook shows of a world."""
        return png(self.render())

    def state_hash(self) -> str:
        """XXH3-64 of the bits of all positions and velocities, as 16 hexadecimal digits.

        The same for the same scene, GPU, driver and version, and in the summary of `weft run`. Errors: DeviceError.
        """
        return self._core.state_hash()

    @property
    def description(self) -> dict[str, Any]:
        """What was loaded, and what was decided before the first frame: solver, substeps, step_seconds [s], …"""
        return dict(self._description)

    @property
    def totals(self) -> dict[str, int | float]:
        """Sums over the frames that have reported: after `finish` or `run`, all. docs/cli.md has their meaning."""
        return self._core.totals()

    @property
    def adapter(self) -> str:
        """The GPU's name."""
        return self._core.adapter()

    @property
    def gpu_bytes(self) -> int:
        """What this world's device holds [byte]."""
        return self._core.gpu_bytes()

    def _vectors(self) -> Floats:
        return np.empty((self._nodes, 3), np.float32)

    def _given(self, values: npt.ArrayLike, what: str) -> Floats:
        return _vectors(values, self._nodes, what)

    def _checked(self, out: Floats) -> Floats:
        wanted = (self._nodes, 3)
        if out.shape != wanted or out.dtype != np.float32 or not out.flags.c_contiguous or not out.flags.writeable:
            raise ShapeError(f"{_kind(out)} cannot be filled; wanted is a writeable float32 {wanted} in C order.")
        return out


def render(scene: Scene, frames: int = 0, **picture: Any) -> npt.NDArray[np.uint8]:
    """A picture of a scene after so many frames, (height, width, 4) uint8. `picture`: as World.render."""
    world = World(scene)
    world.step(frames)
    return world.render(**picture)


def _vectors(values: npt.ArrayLike, count: int, what: str) -> Floats:
    """As float32 in C order, and no copy where it is that."""
    array = np.ascontiguousarray(values, np.float32)
    if array.shape != (count, 3):
        raise ShapeError(f"The {what} have shape {array.shape}; wanted is {(count, 3)}.")
    return array


def _numbers(nodes: npt.ArrayLike) -> npt.NDArray[np.uint32]:
    array = np.asarray(nodes)
    if array.ndim != 1 or (array.size and not np.issubdtype(array.dtype, np.integer)):
        raise ShapeError(f"The nodes have shape {array.shape} of {array.dtype}; wanted are whole numbers (k,).")
    if array.size and (array.min() < 0 or array.max() > 0xFFFFFFFF):
        raise InputError(f"Node {array.min() if array.min() < 0 else array.max()} is not one of the world's.")
    return np.ascontiguousarray(array, np.uint32)


def _place(camera: Camera) -> tuple[_Point, _Point, float]:
    return _point(camera.eye, "eye"), _point(camera.target, "target"), camera.fov_degrees


def _count(frames: int) -> int:
    if frames < 0:
        raise InputError(f"{frames} frames cannot be simulated; wanted are 0 or more.")
    return frames


def _kind(array: npt.NDArray[Any]) -> str:
    return f"An array of {array.dtype} {array.shape}"


def _point(point: Point, name: str) -> _Point:
    values = np.asarray(point, np.float64)
    if values.shape != (3,):
        raise ShapeError(f"The {name} has shape {values.shape}; wanted is (3,).")
    x, y, z = values.tolist()
    return x, y, z


def _mesh(name: str, positions: npt.ArrayLike, triangles: npt.ArrayLike) -> tuple[Floats, npt.NDArray[np.uint32]]:
    places = np.ascontiguousarray(positions, np.float32)
    corners = np.asarray(triangles)
    for array, what in ((places, "positions"), (corners, "triangles")):
        if array.ndim != 2 or array.shape[1] != 3:
            raise ShapeError(f'The {what} of mesh "{name}" have shape {array.shape}; wanted is (n, 3).')
    if corners.size and (corners.min() < 0 or corners.max() > 0xFFFFFFFF):
        raise InputError(f'The triangles of mesh "{name}" number vertices below 0 or beyond {0xFFFFFFFF}.')
    return places, np.ascontiguousarray(corners, np.uint32)
