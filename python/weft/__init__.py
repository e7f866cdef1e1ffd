"""Real-time cloth on any GPU: a host of weft's C++ library, with arrays of numpy.

Units are SI. A failure is an exception of `weft.errors` whose text is the engine's sentence.

    import weft

    world = weft.World("hanging")      # a shipped scene, a path, or a dict
    world.step(60)                     # one second, at 1/60 s a frame
    world.positions                    # (nodes, 3) float32 [m]
    world.render()                     # (height, width, 4) uint8, sRGB
"""

from importlib.metadata import version as _version

from .batch.command import sweep
from .commands import bench, validate
from .errors import (
    DeviceError,
    DeviceLostError,
    DivergedError,
    Error,
    InputError,
    LimitError,
    NoAdapterError,
    OutOfMemoryError,
    ShaderError,
    ShapeError,
)
from .exchange.command import export
from .exchange.usd import read_usd
from .machine import Adapter, adapters
from .scenes import load_scene, scene_names, schema
from .world import Camera, Picked, Summary, World, render

__version__ = _version("weft")

__all__ = [
    "Adapter",
    "Camera",
    "DeviceError",
    "DeviceLostError",
    "DivergedError",
    "Error",
    "InputError",
    "LimitError",
    "NoAdapterError",
    "OutOfMemoryError",
    "Picked",
    "ShaderError",
    "ShapeError",
    "Summary",
    "World",
    "__version__",
    "adapters",
    "bench",
    "export",
    "load_scene",
    "read_usd",
    "render",
    "scene_names",
    "schema",
    "sweep",
    "validate",
]
