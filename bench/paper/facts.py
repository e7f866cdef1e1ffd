"""Numbers for sentences: what docs/performance.md.j2 and README's figures ask the stored results for."""

import json
import math

from .experiment_tables import step_ms
from .plots import copy_speed
from .store import RESULTS, Machine

MODES = {
    "grid": "node_centric, grid",
    "mesh": "node_centric, any mesh",
    "springs": "spring_centric",
    "blocks": "spring_blocks",
}


class Missing(Exception):
    """A sentence asks for a row that is not stored."""


def one(rows, **wanted):
    found = [
        row for row in rows if all(row.get(key) == value for key, value in wanted.items()) and "skipped" not in row
    ]
    if len(found) != 1:
        raise Missing(f"{len(found)} stored rows have {wanted}; a sentence needs one.")
    return found[0]


class Facts:
    """Of one machine."""

    def __init__(self, name, folder=RESULTS):
        self.machine = Machine(name, folder)
        self.aims = json.loads((folder / "aims.json").read_text())

    def step(self, mode, nodes):
        """ms of a step of the hanging sheet."""
        return step_ms(one(self.machine.rows("hanging"), variant=MODES[mode], nodes=nodes))

    def aim(self, mode, nodes):
        return self.aims["hanging_ms"][MODES[mode]][str(nodes)]

    def pull(self, thing, nodes, variant):
        return one(self.machine.rows("pull"), object=thing, nodes=nodes, variant=variant)

    def contact(self, thing, nodes, variant):
        """ms of a step that are contact's."""
        return step_ms(self.pull(thing, nodes, variant)) - step_ms(self.pull(thing, nodes, "none"))

    def contact_aim(self, thing, nodes):
        return self.aims["contact_ms"][thing][str(nodes)]

    def cheaper(self, against, than, objects=("armadillo", "dragon"), sizes=None):
        """How many times less the contact of one method costs than that of another: least and most."""
        rows = self.machine.measured("pull")
        ratios = []
        for row in rows:
            if row["variant"] != than or row["object"] not in objects or sizes and row["nodes"] not in sizes:
                continue
            if any(
                r["variant"] == against and (r["object"], r["nodes"]) == (row["object"], row["nodes"]) for r in rows
            ):
                ratios.append(
                    self.contact(row["object"], row["nodes"], than) / self.contact(row["object"], row["nodes"], against)
                )
        return min(ratios), max(ratios)

    def contacts(self, nodes, variant, objects=("sphere", "armadillo", "dragon")):
        """Least and most ms of contact over the objects."""
        costs = [self.contact(thing, nodes, variant) for thing in objects]
        return min(costs), max(costs)

    def real_time(self, nodes, variant, objects=("sphere", "armadillo", "dragon")):
        factors = [self.pull(thing, nodes, variant)["real_time_factor"] for thing in objects]
        return min(factors), max(factors)

    def copy_gb_per_s(self):
        return copy_speed(self.machine) or self.aims["copy_gb_per_s"][self.machine.name]

    def bytes_alone(self, bytes_per_node, nodes):
        """ms at the copy's bandwidth."""
        return bytes_per_node * nodes / self.copy_gb_per_s() * 1e-6

    def browser(self, path, nodes):
        return one(self.machine.rows("chromium"), path=path, nodes=nodes)

    def ratio(self, path, nodes, to="weft-node", key="ms_per_step"):
        return self.browser(path, nodes)[key]["median"] / self.browser(to, nodes)[key]["median"]

    def authors(self, thing, nodes):
        figures = json.loads((self.machine.path.parent / "published.json").read_text())
        return one(figures["own_code"]["rows"], object=thing, nodes=nodes)["ms_per_step"]


def sheet(results, side, variant):
    """A row of `weft bench multigrid` on the study's sheet."""
    return one(results["rows"], object="sheet", side=side, variant=variant)


def embree_ratios(results):
    """Least, most and geometric mean of weft's time over Embree's: of self queries, of queries against objects."""

    def summary(ratios):
        return min(ratios), max(ratios), math.exp(sum(map(math.log, ratios)) / len(ratios))

    rows = results["rows"]
    return (
        summary([row["ratio"] for row in rows if not row["object_triangles"]]),
        summary([row["ratio"] for row in rows if row["object_triangles"]]),
    )
