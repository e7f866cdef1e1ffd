"""What is measured: one case is one call of `weft bench`, so that a run goes on where it was cut off."""

import dataclasses

# The sheets by two clips of `weft bench multigrid`; its other objects are what sheets are laid over.
SHEETS = ("sheet", "fabric")

SIDES = (64, 100, 128, 200, 256, 400, 512, 800)
LARGE_SIDE = 2048  # hanging only, to see the bandwidth
TRIANGLES = {"sphere": 760, "armadillo": 52_000, "dragon": 99_784}
CONTACT = "none,bvh,proximity,proximity_self"
SLOWEST_STEP_MS = 10_000  # under 0.1 frames a second; brute force is not asked for larger sizes of that object


@dataclasses.dataclass(frozen=True)
class Case:
    experiment: str
    arguments: tuple  # of weft bench
    weight: float  # what it costs beside the others
    object: str = ""
    side: int = 0
    brute_force: bool = False

    @property
    def command(self):
        return " ".join(("weft", "bench", *self.arguments))


def plan(experiments, quick, most_side):
    """The cases of these experiments, cheap ones first within each."""
    cases = []
    hurry = ("--quick",) if quick else ()
    if "copy" in experiments:
        cases.append(Case("copy", ("copy", *hurry), 2))
    if "hanging" in experiments:
        for side in (64, 100) if quick else (*SIDES, LARGE_SIDE):
            if side <= most_side:
                cases.append(
                    Case("hanging", ("hanging", "--sides", str(side), *hurry), 4 + side**2 / 5000, "none", side)
                )
    if "pull" in experiments:
        for name in ("sphere", "armadillo") if quick else TRIANGLES:
            for side in (32, 64) if quick else SIDES:
                if side > most_side:
                    continue
                which = ("pull", "--objects", name, "--sides", str(side))
                cases.append(Case("pull", (*which, "--only", CONTACT, *hurry), 6 + side**2 / 800, name, side))
                if side == 32 or not quick:
                    pairs = side**2 * TRIANGLES[name] / 1e8
                    cases.append(
                        Case("pull", (*which, "--only", "paper", *hurry), 4 + side**2 / 800 + pairs, name, side, True)
                    )
    if "multigrid" in experiments:
        for side in (32,) if quick else (64, 128, 256, 512, 800):
            if side <= most_side:
                cases.append(
                    Case(
                        "multigrid",
                        ("multigrid", "--sides", str(side), "--only", "multigrid,explicit,null", *hurry),
                        10 + side**2 / 5000,
                        "sheet",
                        side,
                    )
                )
        for only, thing, start, rate, sides in (
            ("fabric", "fabric", 10, 3000, (64, 128, 256, 512, 800)),
            ("drape", "", 20, 2000, (256, 800)),
        ):
            for side in () if quick else sides:
                if side <= most_side:
                    which = ("multigrid", "--sides", str(side), "--only", only)
                    cases.append(Case("multigrid", which, start + side**2 / rate, thing, side))
    if "largest" in experiments and not quick:
        cases.append(Case("largest", ("largest",), 60))
    return cases


def too_slow_before(case, rows):
    """The stored row of a smaller sheet over the same object for which brute force took too long, if there is one."""
    for row in rows:
        slow = row.get("ms_per_step", {}).get("median", 0) > SLOWEST_STEP_MS
        if (
            slow
            and row.get("variant") == "paper"
            and row.get("object") == case.object
            and row.get("side", 0) < case.side
        ):
            return row
    return None
