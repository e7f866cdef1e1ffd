"""What this machine has: the GPUs, the command line, and where scenes and models are."""

import os
import pathlib
from dataclasses import dataclass

from . import _core

PACKAGE = pathlib.Path(__file__).resolve().parent
PROGRAM = PACKAGE / "bin" / "weft"
# Mesa's drivers ask for a desktop session, and complain on stderr where there is none. weft opens no window.
os.environ.setdefault("XDG_RUNTIME_DIR", "/nonexistent")


@dataclass(frozen=True)
class Adapter:
    """A GPU that weft can use."""

    name: str  # "llvmpipe (LLVM 15.0.6, 256 bits)"
    vendor: str
    driver: str  # the driver's own description
    backend: str  # "Vulkan"
    type: str  # "discrete GPU", "integrated GPU", "CPU"


def adapters() -> list[Adapter]:
    """The GPUs of this machine, software rasterizers among them; none where there is no driver."""
    return [Adapter(**one) for one in _core.adapters()]


def models_folder(models: str | os.PathLike[str] | None) -> str:
    """Where meshes are that a scene names without a path: as given, else WEFT_MODELS, else `models` in the package."""
    return os.fspath(models or os.environ.get("WEFT_MODELS") or PACKAGE / "models")
