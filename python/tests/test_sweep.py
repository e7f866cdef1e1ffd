"""A sweep: which runs, each once whatever happens to it, and their table."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from typing import Any

import pyarrow.parquet as pq  # type: ignore[import-untyped]
import scenes
import weft
from weft.batch.plan import read_plan
from weft.batch.store import Store

METRIC = """
def lowest(world):
    return {"lowest": world.positions[:, 1].min(), "broken": 1 / (world.nodes - 25)} if world.nodes == 25 else {
        "lowest": world.positions[:, 1].min()}
"""


class Sweep(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def write(self, **keys: Any) -> pathlib.Path:
        path = self.folder / "sweep.json"
        path.write_text(json.dumps({"format": "weft-sweep/1", "scene": scenes.sheet(8), "frames": 2, **keys}))
        return path

    def table(self) -> list[dict[str, Any]]:
        rows: list[dict[str, Any]] = pq.read_table(self.out / "runs.parquet").to_pylist()
        return rows

    def begin(self, path: pathlib.Path, *words: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-m", "weft", "sweep", path, "--out", self.out, *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def wait_for_rows(self, count: int) -> list[dict[str, Any]]:
        """The first rows, while the sweep goes on."""
        path = self.out / "runs.jsonl"
        for _ in range(6000):
            lines = path.read_bytes().split(b"\n")[:-1] if path.exists() else []
            if len(lines) >= count:
                return [json.loads(line) for line in lines]
            time.sleep(0.01)
        self.fail(f"{count} rows have not come.")


class Plans(Sweep):
    def test_a_grid_is_every_combination_and_draws_are_the_same_again(self) -> None:
        path = self.write(
            grid={"a.b": [1, 2], "c": ["x", "y", "z"]},
            random={"count": 4, "seed": 7, "keys": {"d": {"from": 1, "to": 100, "log": True}, "e": {"of": [5, 6]}}},
            repeats=2,
        )
        runs = read_plan(path).runs
        self.assertEqual(len(runs), 2 * 3 * 4 * 2)
        self.assertEqual([run.number for run in runs], list(range(48)))
        pairs = {(run.values["a.b"], run.values["c"]) for run in runs}
        self.assertEqual(len(pairs), 6)
        self.assertTrue(all(1 <= run.values["d"] <= 100 and run.values["e"] in (5, 6) for run in runs))
        self.assertEqual(len({run.values["d"] for run in runs}), 24)  # repeats share theirs
        self.assertEqual(read_plan(path), read_plan(path))

    def test_the_sweep_of_the_guide_has_the_runs_that_it_says(self) -> None:
        guide = (scenes.CHECKOUT / "docs/sweep.md").read_text(encoding="utf-8")
        example = guide.split("```json\n")[1].split("```")[0]
        (self.folder / "m.py").write_text(METRIC)
        path = self.folder / "sweep.json"
        path.write_text(example)
        self.assertIn("These are 3 × 2 × 10 runs.", guide)
        runs = read_plan(path).runs
        self.assertEqual(len(runs), 3 * 2 * 10)
        for run in (runs[0], runs[-1]):
            weft.World(run.scene, changes=run.changes)

    def test_what_is_wrong_is_said_with_its_key(self) -> None:
        for keys, sentence in (
            ({"format": "weft-sweep/2"}, 'format is "weft-sweep/2", not "weft-sweep/1"'),
            ({"gird": {}}, 'there is no key "gird"; there are format, scene,'),
            ({"grid": {"a": 3}}, "grid.a must be a list of values"),
            ({"repeats": 0}, "repeats must be a whole number from 1 to 1000000"),
            ({"export": "fbx"}, 'export is "fbx", not "obj", "ply" or "glb"'),
            ({"random": {"count": 2, "keys": {"a": {"from": 2, "to": 1}}}}, "random.keys.a must rise from a number"),
            ({"random": {"count": 2, "keys": {"a": {"from": 0, "to": 1, "log": True}}}}, "must be more than 0"),
            ({"random": {"count": 2, "keys": {"a": {"of": [1]}}}, "grid": {"a": [1]}}, "a is in grid and in random"),
            ({"grid": {"a": list(range(1001)), "b": list(range(1000))}}, "1001000 runs, more than 1000000"),
            ({"metric": "nowhere.py:f"}, "metric nowhere.py cannot be read: No such file"),
            ({"scene": "hangin"}, 'no scene "hangin"'),
        ):
            with self.assertRaises(weft.InputError, msg=sentence) as raised:
                read_plan(self.write(**keys))
            self.assertIn(sentence, str(raised.exception))


class Runs(Sweep):
    def test_each_run_is_a_row_with_its_values_bits_and_sentence(self) -> None:
        (self.folder / "metric.py").write_text(METRIC)
        path = self.write(
            grid={"cloths.0.grid": [[6, 6], [5, 5]], "cloths.0.density": [0.1, -1]},
            metric="metric.py:lowest",
            export="ply",
        )
        table = weft.sweep(path, self.out, workers=2)
        self.assertEqual(table, self.out / "runs.parquet")
        rows = self.table()
        self.assertEqual([row["run"] for row in rows], [0, 1, 2, 3])
        self.assertEqual([row["end"] for row in rows], ["complete", "failed", "failed", "failed"])
        alone = weft.World(scenes.sheet(8), changes={"cloths.0.grid": [6, 6], "cloths.0.density": 0.1})
        self.assertEqual(rows[0]["state_hash"], alone.run(2).state_hash)
        self.assertAlmostEqual(rows[0]["metric.lowest"], alone.positions[:, 1].min())
        self.assertEqual((rows[0]["cloths.0.grid"], rows[0]["cloths.0.density"]), ("[6, 6]", 0.1))
        self.assertIn("cloths[0].density is -1", rows[1]["error"])
        self.assertIn("The metric lowest failed in line 3: ZeroDivisionError", rows[2]["error"])
        self.assertEqual([path.name for path in (self.out / "shapes").iterdir()], ["000000.ply"])
        self.assertEqual((self.out / "shapes/000000.ply").read_bytes(), alone.mesh_file("ply"))

    def test_a_folder_is_one_sweeps_and_one_at_a_time(self) -> None:
        path = self.write()
        weft.sweep(path, self.out, workers=1)
        before = (self.out / "runs.jsonl").read_bytes()
        weft.sweep(path, self.out, workers=1)  # nothing is left to do
        self.assertEqual((self.out / "runs.jsonl").read_bytes(), before)
        with self.assertRaisesRegex(
            weft.InputError, "a sweep of 1 runs that is not this one of 2; take another folder"
        ):
            weft.sweep(self.write(repeats=2), self.out)
        with Store(self.out, read_plan(self.write())), self.assertRaisesRegex(weft.InputError, "at work in"):
            weft.sweep(self.write(), self.out)

    def test_a_killed_sweep_goes_on_where_it_was(self) -> None:
        counted = self.folder / "counted"  # a letter for each run that was done, whatever became of it
        metric = f"def count(world):\n    open({str(counted)!r}, 'a').write('x')\n    return {{}}\n"
        (self.folder / "metric.py").write_text(metric)
        path = self.write(repeats=12, metric="metric.py:count")
        child = self.begin(path, "--workers", "2")
        self.wait_for_rows(3)
        child.kill()
        child.communicate()
        with (self.out / "runs.jsonl").open("ab") as file:
            file.write(b'{"run": 11, "cut o')
        done = {row["run"]: row for row in self.wait_for_rows(3)}
        self.assertLess(len(done), 12)
        again = self.begin(path, "--workers", "2")
        said, wrong = again.communicate(timeout=120)
        self.assertEqual((again.returncode, wrong), (0, ""))
        self.assertEqual(said, f"{self.out / 'runs.parquet'}\n")
        rows = self.table()
        self.assertEqual([row["run"] for row in rows], list(range(12)))
        self.assertEqual({row["state_hash"] for row in rows}, {rows[0]["state_hash"]})
        for number, row in done.items():
            self.assertEqual(rows[number]["seconds"], row["seconds"])
        again_done = len(counted.read_text()) - 12  # at most what the two workers had at hand
        self.assertLessEqual(again_done, 2)

    def test_an_interrupt_keeps_what_is_done(self) -> None:
        child = self.begin(self.write(repeats=200), "--workers", "2")
        self.wait_for_rows(2)
        child.send_signal(signal.SIGINT)
        _, wrong = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 130)
        self.assertEqual(wrong, f"weft: The sweep was interrupted; the same command goes on in {self.out}.\n")
        self.assertGreaterEqual(len(self.table()), 2)

    def test_a_worker_that_is_killed_loses_nothing_and_doubles_nothing(self) -> None:
        child = self.begin(self.write(repeats=16), "--workers", "2")
        killed = self.wait_for_rows(2)[0]["worker"]
        os.kill(int(killed.rpartition(":")[2]), signal.SIGKILL)
        _, wrong = child.communicate(timeout=120)
        self.assertEqual((child.returncode, wrong), (0, ""))
        numbers = [json.loads(line)["run"] for line in (self.out / "runs.jsonl").read_text().splitlines()]
        self.assertEqual(sorted(numbers), list(range(16)))
        rows = self.table()
        self.assertEqual({row["end"] for row in rows}, {"complete"})
        self.assertEqual(len({row["worker"] for row in rows}), 3)

    def test_a_run_that_ends_every_worker_is_a_failed_row(self) -> None:
        (self.folder / "metric.py").write_text("import os\ndef end(world): os._exit(9)\n")
        weft.sweep(self.write(metric="metric.py:end"), self.out, workers=1)
        (row,) = self.table()
        self.assertEqual((row["end"], row["error"]), ("failed", "The worker of this run died, 3 times."))


if __name__ == "__main__":
    unittest.main()
