"""A sweep on a Ray cluster: each run once, also where a worker is killed."""

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


class Cluster(test_sweep.Sweep):
    """Two machines of one and two processors, each a set of processes of this one."""

    cluster: Any
    home: tempfile.TemporaryDirectory[str]

    @classmethod
    def setUpClass(cls) -> None:
        cls.home = tempfile.TemporaryDirectory()  # Ray keeps a key and its logs there
        os.environ.update(HOME=cls.home.name, RAY_TMPDIR=cls.home.name, RAY_USAGE_STATS_ENABLED="0")
        utils: Any = importlib.import_module("ray.cluster_utils")
        cls.cluster = utils.Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
        cls.cluster.add_node(num_cpus=2)

    @classmethod
    def tearDownClass(cls) -> None:
        cls.cluster.shutdown()
        cls.home.cleanup()

    def test_a_worker_that_is_killed_loses_nothing_and_doubles_nothing_there(self) -> None:
        child = self.begin(self.write(repeats=24), "--ray", self.cluster.address)
        killed = self.wait_for_rows(3)[0]["worker"]
        os.kill(int(killed.rpartition(":")[2]), signal.SIGKILL)
        _, wrong = child.communicate(timeout=240)
        self.assertEqual((child.returncode, wrong), (0, ""))
        numbers = [json.loads(line)["run"] for line in (self.out / "runs.jsonl").read_text().splitlines()]
        self.assertEqual(sorted(numbers), list(range(24)))
        rows = self.table()
        self.assertEqual({row["end"] for row in rows}, {"complete"})
        self.assertEqual({row["state_hash"] for row in rows}, {weft.World(scenes.sheet(8)).run(2).state_hash})
        self.assertGreaterEqual(len({row["worker"] for row in rows}), 3)
        late = [row["worker"] for row in rows if row["run"] >= 18]
        self.assertNotIn(killed, late)

    def test_a_sweep_goes_on_from_processes_to_a_cluster(self) -> None:
        path = self.write(grid={"cloths.0.density": [0.1, 0.2, -1]}, repeats=4)
        child = self.begin(path, "--workers", "1")
        self.wait_for_rows(2)
        child.kill()
        child.communicate()
        done = len(self.wait_for_rows(2))
        weft.sweep(path, self.out, ray=self.cluster.address)
        rows = self.table()
        self.assertGreater(12, done)
        self.assertEqual([row["run"] for row in rows], list(range(12)))
        self.assertEqual([row["end"] for row in rows], ["complete"] * 8 + ["failed"] * 4)

    def test_what_the_cluster_does_not_have_is_said(self) -> None:
        with self.assertRaisesRegex(
            weft.InputError, "A run takes 1 processors and 1 GPUs; the machines .* 1 and 0, 2 and 0"
        ):
            weft.sweep(self.write(), self.out, ray=self.cluster.address, gpus=1)


if __name__ == "__main__":
    unittest.main()
