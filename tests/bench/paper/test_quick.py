"""A fresh run of the smallest sizes on a software adapter, brute force up to 32² nodes, and the report of it."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Quick(unittest.TestCase):
    def test_it_measures_draws_and_reports(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            done = subprocess.run(
                [
                    sys.executable,
                    "-B",
                    "-m",
                    "bench.paper",
                    "--quick",
                    "--machine",
                    "here",
                    "--weft",
                    os.environ["WEFT_BINARY"],
                    "--results",
                    str(folder),
                    "--out",
                    str(folder / "report"),
                ],
                cwd=ROOT,
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            stored = json.loads((folder / "here.json").read_text())
            page = (folder / "report/index.html").read_text()
        rows = {name: experiment["rows"] for name, experiment in stored["experiments"].items()}
        self.assertEqual(
            {(row["variant"], row["side"]) for row in rows["hanging"]},
            {
                (variant, side)
                for variant in ("node_centric, grid", "node_centric, any mesh", "spring_centric", "spring_blocks")
                for side in (64, 100)
            },
        )
        pulls = {(row["object"], row["variant"], row["side"]): row for row in rows["pull"]}
        for thing in ("sphere", "armadillo"):
            self.assertEqual(
                {variant for name, variant, side in pulls if (name, side) == (thing, 64)},
                {"none", "bvh", "proximity", "proximity_self"},
            )
            self.assertEqual(pulls[thing, "paper", 32]["state_hash"], pulls[thing, "bvh", 32]["state_hash"])
            self.assertEqual(pulls[thing, "proximity", 64].get("crossings"), 0)
        self.assertEqual({row["what"] for row in rows["copy"]}, {"copy", "dispatch"})
        hashes = {}
        for row in rows["pictures"]:
            hashes.setdefault(row["name"], set()).add(row["state_hash"])
            self.assertTrue(row["files"])
        self.assertEqual(
            {name: len(found) for name, found in hashes.items()}, {"hanging": 1, "pull-sphere": 1, "pull-armadillo": 1}
        )
        for row in rows["hanging"] + rows["pull"]:
            self.assertIn(row["state_hash"], page)
            self.assertGreater(row["paper_frame"]["fps"], 0)


if __name__ == "__main__":
    unittest.main()
