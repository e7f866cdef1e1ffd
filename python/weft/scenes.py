"""Scenes: those that ship with the package, and what `World` takes for one."""

import json
import os
import pathlib
from collections.abc import Mapping
from typing import Any, NamedTuple, cast

from . import _core
from .errors import InputError
from .machine import PACKAGE


class SceneText(NamedTuple):
    """A scene that was read already."""

    text: str  # JSON
    name: str  # what messages call it: its path, where relative paths of meshes start


Scene = Mapping[str, Any] | SceneText | str | os.PathLike[str]
FOLDER = PACKAGE / "scenes"


def scene_names() -> list[str]:
    """The names of the shipped scenes."""
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def load_scene(scene: str | os.PathLike[str]) -> dict[str, Any]:
    """A scene as a dict, to change and to give to `World`. `scene`: a path or a shipped name.

    Errors: InputError, the file cannot be read or is not JSON. What it means is checked by `World`.
    """
    text, name = scene_text(scene)
    try:
        return cast("dict[str, Any]", json.loads(text))
    except ValueError as error:
        raise InputError(f"{name} is not JSON: {error}.") from None


def schema() -> dict[str, Any]:
    """The JSON Schema (2020-12) of scenes."""
    return cast("dict[str, Any]", json.loads(_core.schema()))


def to_json(value: object) -> str:
    """The JSON of a value, arrays and numbers of numpy included. Errors: InputError, it has none."""

    def plain(other: Any) -> Any:
        if hasattr(other, "tolist"):
            return other.tolist()
        raise TypeError(f"a {type(other).__name__} has no JSON")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise InputError(f"A value of the scene cannot be written as JSON: {error}.") from None


def scene_text(scene: Scene) -> SceneText:
    """The JSON of a scene. Errors: InputError, there is no such file or name, or the dict has no JSON."""
    if isinstance(scene, SceneText):
        return scene
    if isinstance(scene, Mapping):
        return SceneText(to_json(scene), "scene")
    path = pathlib.Path(scene)
    if isinstance(scene, str) and path.name == scene and not path.suffix and not path.is_file():
        path = FOLDER / f"{scene}.json"
        if not path.is_file():
            names = ", ".join(scene_names())
            raise InputError(f'There is no scene "{scene}", neither as a file nor shipped; those are {names}.')
    return SceneText(read_text(path), str(path))


def read_text(path: pathlib.Path, name: str = "") -> str:
    """The text of a file, which messages call `name`, else by its path. Errors: InputError, it cannot be read."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{name or path} cannot be read: {getattr(error, 'strerror', None) or error}.") from None
