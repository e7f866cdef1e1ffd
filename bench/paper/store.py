"""The results of one machine, bench/results/MACHINE.json: what was measured, with the command that did it."""

import json
import math
import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / "bench/results"
FORMAT = "weft-bench/1"
# What tells the rows of an experiment apart; everything else in a row was measured.
IDENTITY = {
    "hanging": ("variant", "side"),
    "pull": ("object", "variant", "side"),
    "copy": ("what",),
    "largest": ("limits", "variant"),
    "multigrid": ("object", "variant", "side"),
    "pictures": ("name", "view"),
}


class Unreadable(Exception):
    """A sentence for the user: this is no file of results."""


def write_whole(path, text):
    """Under a temporary name first, so that under its own name the file is whole whenever the run ends."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.tmp{os.getpid()}")
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(temporary, path)


def identity(experiment, row):
    return tuple(row.get(key) for key in IDENTITY[experiment])


class Machine:
    """Results of a machine, written whole after every change."""

    def __init__(self, name, folder=RESULTS):
        self.path = pathlib.Path(folder) / f"{name}.json"
        self.data = {"format": FORMAT, "machine": name, "hardware": {}, "experiments": {}}
        if self.path.exists():
            self.data = read(self.path)
        self.name = name

    @property
    def hardware(self):
        return self.data["hardware"]

    def experiment(self, name):
        return self.data["experiments"].get(name, {})

    def rows(self, experiment):
        return self.experiment(experiment).get("rows", [])

    def measured(self, experiment):
        return [row for row in self.rows(experiment) if "skipped" not in row]

    def save(self):
        write_whole(self.path, json.dumps(self.data, indent=1, ensure_ascii=False) + "\n")

    def add(self, experiment, head, rows):
        """Rows take the places of those that they measure again; new ones go where their size puts them."""
        kept = self.data["experiments"].setdefault(experiment, {"rows": []})
        kept.update(head)
        new = {identity(experiment, row): row for row in rows}
        old = [row for row in kept["rows"] if identity(experiment, row) not in new]
        kept["rows"] = sorted(old + list(new.values()), key=lambda row: order(experiment, row))
        kept["rows"] = kept.pop("rows")  # the head first
        self.save()


VARIANTS = [
    "none",
    "bvh",
    "proximity",
    "proximity_self",
    "paper",
    "node_centric, grid",
    "node_centric, any mesh",
    "spring_centric",
    "spring_blocks",
]
OBJECTS = ["sphere", "armadillo", "dragon"]


def place(names, name):
    return names.index(name) if name in names else len(names)


def order(experiment, row):
    return (
        place(OBJECTS, row.get("object")),
        row.get("side", 0),
        place(VARIANTS, row.get("variant")),
        str(row.get("limits", "")),
        str(row.get("what", "")),
        str(row.get("name", "")),
        str(row.get("view", "")),
    )


def with_side(row):
    """Grids are square; rows of an older binary name only their nodes."""
    return row if "side" in row or "nodes" not in row else {"side": math.isqrt(row["nodes"]), **row}


def read(path):
    try:
        data = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as reason:
        raise Unreadable(f"{path} cannot be read as results: {reason}.") from None
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise Unreadable(f'{path} is no file of a machine\'s results: its format is not "{FORMAT}".')
    return data


def machines(folder=RESULTS, first=None):
    """All machines that have results, `first` in front."""
    found = []
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        try:
            text = json.loads(path.read_text(encoding="utf-8"))
        except ValueError:
            raise Unreadable(f"{path} is not JSON.") from None
        if isinstance(text, dict) and text.get("format") == FORMAT:
            found.append(Machine(path.stem, folder))
    return sorted(found, key=lambda machine: (machine.name != first, machine.name != "h100", machine.name))
