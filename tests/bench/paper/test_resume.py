"""A run that is cut off leaves whole results, and the next one measures only what is missing."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


class Resume(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.weft = self.folder / "weft"
        shutil.copy(HERE / "fake_weft.py", self.weft)

    def run_bench(self, *options, only="copy,hanging", do="0 none", **environment):
        """Exit code, what was said, calls of the binary."""
        log = self.folder / "calls"
        log.write_text("")
        done = subprocess.run(
            [
                sys.executable,
                "-B",
                "-m",
                "bench.paper",
                "--machine",
                "loom",
                "--only",
                only,
                "--weft",
                str(self.weft),
                "--results",
                str(self.folder),
                "--out",
                str(self.folder / "report"),
                *options,
            ],
            cwd=ROOT,
            capture_output=True,
            text=True,
            env={**os.environ, "FAKE_LOG": str(log), "FAKE_DO": do, "CHROMIUM": "true", **environment},
            check=False,
        )
        return done.returncode, done.stderr, log.read_text().splitlines()

    def stored(self):
        return json.loads((self.folder / "loom.json").read_text())

    def rows(self, experiment):
        return self.stored()["experiments"].get(experiment, {"rows": []})["rows"]

    def test_a_whole_run_stores_every_row_with_its_command_scene_and_binary(self):
        code, said, calls = self.run_bench("--most", "128")
        self.assertEqual(code, 0, said)
        self.assertEqual(calls, ["copy", "hanging --sides 64", "hanging --sides 100", "hanging --sides 128"])
        self.assertEqual([row["side"] for row in self.rows("hanging")], [64, 64, 100, 100, 128, 128])
        for row in self.rows("hanging"):
            self.assertEqual(row["command"], f"weft bench hanging --sides {row['side']}")
            self.assertRegex(row["binary"], "^sha256:[0-9a-f]{16}$")
            self.assertIn("hanging", row["scene"])
        self.assertEqual(self.stored()["format"], "weft-bench/1")
        self.assertIn("left", said)

    def test_a_remark_stays_with_the_machine(self):
        self.run_bench("--most", "64", "--remark", "a loom ran beside it")
        self.run_bench("--most", "100", only="hardware,hanging")
        self.assertEqual(self.stored()["hardware"]["remark"], "a loom ran beside it")

    def test_nothing_is_measured_twice(self):
        self.run_bench("--most", "100")
        code, said, calls = self.run_bench("--most", "100")
        self.assertEqual((code, calls), (0, []), said)

    def test_ctrl_c_leaves_what_was_measured_and_says_how_to_go_on(self):
        code, said, calls = self.run_bench("--most", "128", do="3 interrupt")
        self.assertEqual(code, 130, said)
        self.assertIn("the same command goes on", said)
        self.assertEqual([row["side"] for row in self.rows("hanging")], [64, 64])
        code, _, calls = self.run_bench("--most", "128")
        self.assertEqual((code, calls), (0, ["hanging --sides 100", "hanging --sides 128"]))
        self.assertEqual([row["side"] for row in self.rows("hanging")], [64, 64, 100, 100, 128, 128])

    def test_a_run_that_is_killed_leaves_a_whole_file(self):
        code, _, _ = self.run_bench("--most", "128", do="3 kill")
        self.assertEqual(code, -9)
        self.assertEqual(len(self.rows("hanging")), 2)
        self.assertEqual(self.run_bench("--most", "128")[2], ["hanging --sides 100", "hanging --sides 128"])

    def test_another_binary_or_fresh_measures_again_and_replaces(self):
        self.run_bench("--most", "64")
        before = self.rows("hanging")[0]["binary"]
        self.assertEqual(len(self.run_bench("--most", "64", "--fresh")[2]), 2)
        with self.weft.open("a") as file:
            file.write("# built anew\n")
        self.assertEqual(len(self.run_bench("--most", "64")[2]), 2)
        self.assertEqual(len(self.rows("hanging")), 2)
        self.assertNotEqual(self.rows("hanging")[0]["binary"], before)

    def test_quick_rows_do_not_take_the_places_of_whole_ones_but_whole_ones_theirs(self):
        self.run_bench("--quick")
        self.assertTrue(all(row["command"].endswith("--quick") for row in self.rows("hanging")))
        self.assertEqual(len(self.run_bench("--most", "100")[2]), 3)
        self.assertEqual(self.run_bench("--quick")[2], [])
        self.assertFalse(any(row["command"].endswith("--quick") for row in self.rows("hanging")))

    def test_brute_force_is_not_asked_for_sizes_after_one_of_over_ten_seconds(self):
        code, said, calls = self.run_bench("--most", "128", only="pull")
        self.assertEqual(code, 0, said)
        brute = [call for call in calls if call.endswith("--only paper")]
        self.assertEqual(
            brute, [f"pull --objects {thing} --sides 64 --only paper" for thing in ("sphere", "armadillo", "dragon")]
        )
        skipped = [row for row in self.rows("pull") if "skipped" in row]
        self.assertEqual([(row["side"], row["variant"]) for row in skipped], [(100, "paper"), (128, "paper")] * 3)
        self.assertIn("12.3 s", skipped[0]["skipped"])

    def test_a_failure_of_one_case_is_said_and_the_others_are_measured(self):
        code, said, calls = self.run_bench("--most", "128", do="2 1")
        self.assertEqual((code, len(calls)), (1, 4))
        self.assertIn("weft bench hanging --sides 64: The adapter is asleep.", said)
        self.assertEqual([row["side"] for row in self.rows("hanging")], [100, 100, 128, 128])

    def test_without_an_adapter_nothing_more_is_tried(self):
        code, said, calls = self.run_bench("--most", "128", do="1 4")
        self.assertEqual((code, len(calls)), (4, 1), said)

    def test_a_binary_that_is_built_anew_meanwhile_is_not_measured_as_one(self):
        code, said, calls = self.run_bench("--most", "128", do="3 rebuild")
        self.assertEqual((code, len(calls)), (1, 3))
        self.assertIn("was built anew while", said)
        self.assertEqual([row["side"] for row in self.rows("hanging")], [64, 64])

    def test_rows_of_two_adapters_do_not_meet_in_one_file(self):
        self.run_bench("--most", "64")
        code, said, _ = self.run_bench("--most", "100", FAKE_ADAPTER="Spinning Jenny")
        self.assertEqual(code, 3)
        self.assertIn("Loom 3000, not of Spinning Jenny", said)

    def test_a_foreign_file_is_refused(self):
        (self.folder / "loom.json").write_text('{"format": "weft-bench/9"}')
        code, said, calls = self.run_bench()
        self.assertEqual((code, calls), (3, []))
        self.assertIn("weft-bench/1", said)

    def test_a_machine_has_a_name_of_its_own(self):
        from bench.paper import hardware

        found = hardware.describe(self.weft)
        self.assertEqual(
            (found["gpu"], found["gpu_type"], found["driver"]), ("Loom 3000", "CPU", "Mesa 22.3.6 (LLVM 15.0.6)")
        )
        self.assertEqual(hardware.slug(found), f"loom-3000-{os.cpu_count()}core")

    def test_unknown_parts_are_refused(self):
        code, said, _ = self.run_bench(only="hangng")
        self.assertEqual(code, 2)
        self.assertIn('not "hangng"', said)


if __name__ == "__main__":
    unittest.main()
