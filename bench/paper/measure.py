"""Runs the cases whose rows are not stored yet, and stores each as soon as it has ended."""

import hashlib
import json
import pathlib
import subprocess
import tempfile
import time

from .cases import SHEETS, SLOWEST_STEP_MS, too_slow_before
from .progress import TimeLeft, in_words, say
from .store import with_side

STOPS_ALL = {2, 4, 5, 130}  # usage, no adapter, device lost, interrupted: the next case would end alike
SCENES = {
    "hanging": "2 m × 2 m, pinned at two corners (src/bench/hanging.cpp)",
    "pull": "scenes/pull-{object}.json",
    "multigrid": "scenes/{sheet_or_drape}.json",
}


class Failed(Exception):
    """A run of the binary that ended with an exit code."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


def hash_of(binary):
    """Which binary measured a row."""
    return "sha256:" + hashlib.sha256(pathlib.Path(binary).read_bytes()).hexdigest()[:16]


def check_same(binary, binary_hash):
    if hash_of(binary) != binary_hash:
        raise Failed(
            1, f"{binary} was built anew while it was being measured; the same command measures again by the new one."
        )


def scene_of(experiment, row):
    thing = row.get("object", "")
    return SCENES.get(experiment, "no scene").format(
        object=thing, sheet_or_drape=thing if thing in SHEETS else f"drape-{thing}"
    )


def ask(binary, case, adapter=None):
    """One call of the binary: {bench, adapter, driver, rows}."""
    with tempfile.TemporaryDirectory() as folder:
        answer = pathlib.Path(folder) / "rows.json"
        command = [str(binary), "bench", *case.arguments, "--json", str(answer)]
        if adapter:
            command += ["--adapter", adapter]
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
            raise Failed(done.returncode, f"{case.command}: {lines[0].removeprefix('weft: ')}")
        return json.loads(answer.read_text())


def is_done(case, machine, binary_hash):
    """Rows of the whole case stand for those of a quick one, not the other way round."""
    commands = {case.command, case.command.removesuffix(" --quick")}
    return any(
        row.get("command") in commands and row.get("binary") == binary_hash for row in machine.rows(case.experiment)
    )


def skip(case, before):
    seconds = before["ms_per_step"]["median"] / 1000
    return {
        "object": case.object,
        "variant": "paper",
        "side": case.side,
        "nodes": case.side**2,
        "skipped": f"at {before['nodes']:,} nodes a step took {seconds:.1f} s, "
        f"under {1000 / SLOWEST_STEP_MS:g} frames a second",
    }


def run(machine, cases, binary, adapter=None, fresh=False):
    """Whether all cases ended well. Rows of another binary are measured again; `fresh` measures all again."""
    binary_hash = hash_of(binary)
    waiting = [case for case in cases if fresh or not is_done(case, machine, binary_hash)]
    say(f"{len(waiting)} of {len(cases)} cases to measure, the others are stored in {machine.path}")
    clock, failures = TimeLeft(), 0
    for k, case in enumerate(waiting):
        say(f"[{k + 1}/{len(waiting)}] {case.command}: {in_words(clock.left(c.weight for c in waiting[k:]))}")
        before = too_slow_before(case, machine.rows("pull")) if case.brute_force else None
        head = {"command": f"./dev bench paper --only {case.experiment}"}
        began = time.monotonic()
        if before:
            rows = [skip(case, before)]
        else:
            try:
                answer = ask(binary, case, adapter)
            except Failed as failure:
                if failure.code in STOPS_ALL:
                    raise
                say(str(failure))
                failures += 1
                continue
            check_same(binary, binary_hash)
            check_adapter(machine, case.experiment, answer)
            head |= {key: answer[key] for key in ("adapter", "driver", "unchecked") if key in answer}
            rows = [with_side(row) for row in answer["rows"]]
        seconds = time.monotonic() - began
        if not before:
            clock.add(case.weight, seconds)
        for row in rows:
            row.update(command=case.command, scene=scene_of(case.experiment, row), binary=binary_hash)
        machine.add(case.experiment, head, rows)
    return failures == 0


def check_adapter(machine, experiment, answer):
    stored = machine.experiment(experiment).get("adapter")
    if stored and stored != answer.get("adapter"):
        raise Failed(
            3,
            f"{machine.path} holds rows of {stored}, not of {answer.get('adapter')}; "
            "name another --machine, or an --adapter.",
        )
