"""The runs that a sweep asks for. The same file gives the same runs, in the same order."""

import dataclasses
import hashlib
import itertools
import json
import math
import pathlib
import random
from collections.abc import Callable, Mapping
from typing import Any

from ..errors import InputError
from ..scenes import SceneText, read_text, scene_text, to_json

FORMAT = "weft-sweep/1"
KEYS = ("format", "scene", "frames", "set", "grid", "random", "repeats", "metric", "export")
MOST_RUNS = 1_000_000
MOST_FRAMES = 1_000_000  # as of `weft run`


@dataclasses.dataclass(frozen=True)
class Run:
    """One run, whole: it can go to any process."""

    number: int
    repeat: int  # from 0
    values: dict[str, Any]  # of the keys that the sweep varies
    scene: SceneText
    changes: dict[str, Any]  # all values that are set, in order
    frames: int | None  # none: the scene's
    metric: tuple[str, str] | None  # Python's text, and the name of the function in it
    export: str | None  # "obj", "ply", "glb"


@dataclasses.dataclass(frozen=True)
class Plan:
    runs: list[Run]
    identity: str  # of all that decides what the runs are

    @property
    def keys(self) -> list[str]:
        return list(self.runs[0].values)


def read_plan(path: pathlib.Path) -> Plan:
    """The plan in a file. Errors: InputError, with the key and its limit."""
    text = read_text(path)
    try:
        sweep = json.loads(text)
    except ValueError as error:
        raise InputError(f"{path} is not JSON: {error}.") from None
    try:
        return _plan(sweep, path.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _plan(sweep: Any, folder: pathlib.Path) -> Plan:
    _check(isinstance(sweep, dict), "a sweep is an object")
    for key in sweep:
        _check(key in KEYS, f"there is no key {json.dumps(key)}; there are {', '.join(KEYS)}")
    _check(sweep.get("format") == FORMAT, f'format is {json.dumps(sweep.get("format"))}, not "{FORMAT}"')
    frames = sweep.get("frames")
    _check(frames is None or _whole(frames, 0, MOST_FRAMES), f"frames must be a whole number up to {MOST_FRAMES}")
    repeats = sweep.get("repeats", 1)
    _check(_whole(repeats, 1, MOST_RUNS), f"repeats must be a whole number from 1 to {MOST_RUNS}")
    export = sweep.get("export")
    _check(export in (None, "obj", "ply", "glb"), f'export is {json.dumps(export)}, not "obj", "ply" or "glb"')
    scene = _scene(sweep.get("scene"), folder)
    fixed = _object(sweep, "set")
    variants = _variants(_object(sweep, "grid"), _object(sweep, "random"), repeats)
    metric = _metric(sweep.get("metric"), folder)
    runs = [
        Run(number, repeat, values, scene, {**fixed, **values}, frames, metric, export)
        for number, (values, repeat) in enumerate((v, r) for v in variants for r in range(repeats))
    ]
    whole = json.dumps([dataclasses.asdict(run) for run in runs], sort_keys=True)
    return Plan(runs, hashlib.sha256(whole.encode()).hexdigest())


def _variants(grid: dict[str, Any], draws: dict[str, Any], repeats: int) -> list[dict[str, Any]]:
    """Every combination of the grid, with so many draws of the random keys each."""
    for key, values in grid.items():
        _check(isinstance(values, list) and values != [], f"grid.{key} must be a list of values")
    count: Any = 1
    sampled: list[tuple[str, Callable[[random.Random], Any]]] = []
    if draws:
        extra = set(draws) - {"count", "seed", "keys"}
        _check(not extra, f"random has no key {json.dumps(min(extra, default=''))}; there are count, seed, keys")
        count = draws.get("count")
        _check(_whole(count, 1, MOST_RUNS), f"random.count must be a whole number from 1 to {MOST_RUNS}")
        sampled = [(key, _sampler(key, how)) for key, how in _object(draws, "keys").items()]
        _check(bool(sampled), "random.keys is empty")
        twice = [key for key, _ in sampled if key in grid]
        _check(not twice, f"{twice[0] if twice else ''} is in grid and in random")
    total = math.prod(map(len, grid.values())) * count * repeats
    _check(total <= MOST_RUNS, f"there would be {total} runs, more than {MOST_RUNS}")
    source = random.Random(draws.get("seed", 0))
    return [
        {**dict(zip(grid, values, strict=True)), **{key: sample(source) for key, sample in sampled}}
        for values in itertools.product(*grid.values())
        for _ in range(count)
    ]


def _sampler(key: str, how: Any) -> Callable[[random.Random], Any]:
    """Draws a value: {"from", "to"}, evenly or with "log": true evenly in the logarithm, or {"of": [...]}.

    Of Python's generator only random() is used, whose numbers are the same in every version.
    """
    where = f"random.keys.{key}"
    _check(isinstance(how, dict), f'{where} must be {{"from": a, "to": b}} or {{"of": [...]}}')
    if set(how) == {"of"}:
        choices = how["of"]
        _check(isinstance(choices, list) and choices != [], f"{where}.of must be a list of values")
        return lambda source: choices[int(source.random() * len(choices))]
    log = how.get("log", False)
    _check(set(how) - {"log"} == {"from", "to"} and isinstance(log, bool), f"{where} must have from and to, or of")
    low, high = how["from"], how["to"]
    _check(_number(low) and _number(high) and low <= high, f"{where} must rise from a number to a number")
    if not log:
        return lambda source: low + (high - low) * source.random()
    _check(low > 0, f"{where}.from is {low}; of a logarithm it must be more than 0")
    return lambda source: low * (high / low) ** source.random()


def _scene(scene: Any, folder: pathlib.Path) -> SceneText:
    if isinstance(scene, Mapping):
        return SceneText(to_json(scene), str(folder / "scene"))
    _check(isinstance(scene, str), "scene must be an object, a path or a shipped name")
    beside = folder / scene
    return scene_text(beside if beside.is_file() else scene)


def _metric(metric: Any, folder: pathlib.Path) -> tuple[str, str] | None:
    if metric is None:
        return None
    file, _, function = metric.rpartition(":") if isinstance(metric, str) else ("", "", "")
    _check(bool(file) and function.isidentifier(), 'metric must be "FILE.py:FUNCTION"')
    return read_text(folder / file, f"metric {file}"), function


def _object(sweep: dict[str, Any], key: str) -> dict[str, Any]:
    value = sweep.get(key, {})
    _check(isinstance(value, dict), f"{key} must be an object")
    return dict(value)


def _whole(value: Any, least: int, most: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _check(good: bool, sentence: str) -> None:
    if not good:
        raise InputError(f"{sentence}.")
