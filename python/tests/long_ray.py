"""Two hundred runs on four workers of a Ray cluster, one of which is killed among them."""

import importlib
import json
import os
import signal
import tempfile
import unittest
from typing import Any

import scenes
import test_sweep
import weft

RUNS, WORKERS = 200, 4


class Sweep(test_sweep.Sweep):
    def setUp(self) -> None:
        super().setUp()
        home = tempfile.TemporaryDirectory()  # Ray keeps a key and its logs there
        self.addCleanup(home.cleanup)
        os.environ.update(HOME=home.name, RAY_TMPDIR=home.name, RAY_USAGE_STATS_ENABLED="0")
        utils: Any = importlib.import_module("ray.cluster_utils")
        head = {"num_cpus": WORKERS, "include_dashboard": False}
        self.cluster = utils.Cluster(initialize_head=True, head_node_args=head)
        self.addCleanup(self.cluster.shutdown)

    def test_a_worker_that_is_killed_among_two_hundred_runs_loses_nothing_and_doubles_nothing(self) -> None:
        sides, repeats = [8, 9, 10, 11], RUNS // 4
        path = self.write(grid={"cloths.0.grid": [[side, side] for side in sides]}, repeats=repeats)
        child = self.begin(path, "--ray", self.cluster.address)
        early = self.wait_for_rows(RUNS // 4)
        killed = early[-1]["worker"]
        os.kill(int(killed.rpartition(":")[2]), signal.SIGKILL)
        self.assertLess(len(self.wait_for_rows(1)), RUNS)  # it was killed among them
        _, wrong = child.communicate(timeout=6000)
        self.assertEqual((child.returncode, wrong), (0, ""))

        lines = [json.loads(line) for line in (self.out / "runs.jsonl").read_text().splitlines()]
        self.assertEqual(sorted(line["run"] for line in lines), list(range(RUNS)))
        rows = self.table()
        self.assertEqual([row["run"] for row in rows], list(range(RUNS)))
        self.assertEqual({row["end"] for row in rows}, {"complete"})
        alone = {side: weft.World(scenes.sheet(side)).run(2).state_hash for side in sides}
        for row in rows:
            side = json.loads(row["cloths.0.grid"])[0]
            self.assertEqual((row["nodes"], row["state_hash"]), (side * side, alone[side]))
        workers = {row["worker"] for row in rows}
        self.assertGreater(len(workers), WORKERS)  # another in the place of the one that was killed
        self.assertNotIn(killed, [row["worker"] for row in rows[3 * RUNS // 4 :]])


if __name__ == "__main__":
    unittest.main()
