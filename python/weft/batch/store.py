"""The folder of a sweep: a line for each run that is done, and the table of all of them."""

import contextlib
import fcntl
import importlib
import json
import os
import pathlib
from types import TracebackType
from typing import Any

from ..errors import Error, InputError
from .plan import Plan
from .run import Row

ROWS, PLAN, LOCK, TABLE, SHAPES = "runs.jsonl", "plan.json", ".weft-sweep.lock", "runs.parquet", "shapes"


class Store:
    """What is done, in a folder that no other sweep writes into meanwhile.

    A row is a line of runs.jsonl, on the disk before the next run's; a line that was cut off is not a row, and its run
    is done again. Errors: InputError, the folder has another sweep's runs, or one is at work there. OSError.
    """

    def __init__(self, folder: pathlib.Path, plan: Plan) -> None:
        self._folder, self._plan = folder, plan
        folder.mkdir(parents=True, exist_ok=True)
        self._lock = (folder / LOCK).open("a")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self._lock.close()
            raise InputError(f"Another sweep is at work in {folder}.") from None
        try:
            self._check_identity()
            self.rows = self._read()
        except BaseException:
            self._lock.close()
            raise
        self._out = (folder / ROWS).open("a", encoding="utf-8")

    def __enter__(self) -> "Store":
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, at: TracebackType | None) -> None:
        self._out.close()
        self._lock.close()

    def add(self, row: Row, shape: bytes | None, export: str | None) -> None:
        """Keeps a row, its shape first. A run that has a row already is left as it is."""
        if row["run"] in self.rows:
            return
        if shape is not None:
            path = self._folder / SHAPES / f"{row['run']:06}.{export}"
            path.parent.mkdir(exist_ok=True)
            _write(path, shape)
        self._out.write(json.dumps(row) + "\n")
        self._out.flush()
        os.fsync(self._out.fileno())
        self.rows[row["run"]] = row

    def write_table(self) -> pathlib.Path:
        """All rows by their number, as a Parquet table. Errors: Error, pyarrow is not installed."""
        try:
            pa: Any = importlib.import_module("pyarrow")
            pq: Any = importlib.import_module("pyarrow.parquet")
        except ImportError:
            raise Error("A sweep's table needs pyarrow: pip install weft[sweep].") from None
        there = self._read()  # an interrupt may have come between a line and self.rows
        rows = [there[number] for number in sorted(there)]
        names = list(dict.fromkeys(name for row in rows for name in row))
        table = pa.table({name: _column([row.get(name) for row in rows]) for name in names})
        table = table.replace_schema_metadata({"weft.keys": json.dumps(self._plan.keys)})
        path = self._folder / TABLE
        unfinished = path.with_suffix(f".{os.getpid()}.tmp")
        pq.write_table(table, unfinished)
        unfinished.replace(path)
        return path

    def _check_identity(self) -> None:
        path = self._folder / PLAN
        if not path.exists():
            _write(path, json.dumps({"identity": self._plan.identity, "runs": len(self._plan.runs)}).encode())
            return
        there = json.loads(path.read_text(encoding="utf-8"))
        if there["identity"] != self._plan.identity:
            raise InputError(
                f"{self._folder} has a sweep of {there['runs']} runs that is not this one of {len(self._plan.runs)}; "
                "take another folder."
            )

    def _read(self) -> dict[int, Row]:
        path = self._folder / ROWS
        if not path.exists():
            return {}
        data = path.read_bytes()
        whole = data[: data.rfind(b"\n") + 1]
        if len(whole) < len(data):
            with path.open("r+b") as file:
                file.truncate(len(whole))
        rows = [json.loads(line) for line in whole.splitlines()]
        return {row["run"]: row for row in rows}


def _column(values: list[Any]) -> list[Any]:
    """As they are where a column of a table can have them; lists and mixtures as JSON."""
    kinds = {type(value) for value in values if value is not None}
    if kinds <= {int, float} or kinds in ({str}, {bool}):
        return values
    return [None if value is None else json.dumps(value) for value in values]


def _write(path: pathlib.Path, data: bytes) -> None:
    """Whole or not at all."""
    unfinished = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    with contextlib.ExitStack() as undo:
        undo.callback(unfinished.unlink, missing_ok=True)
        unfinished.write_bytes(data)
        unfinished.replace(path)
