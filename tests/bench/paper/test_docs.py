"""docs/performance.md, its plots and README's figures are what the stored results say, and change when they do."""

import json
import pathlib
import re
import shutil
import tempfile
import unittest

from bench.paper import docs
from bench.paper.facts import Facts, Missing
from bench.paper.store import RESULTS, ROOT

EXPRESSION = re.compile(r"{{.*?}}|{%.*?%}|{#.*?#}", re.S)
MEASURED = re.compile(r"\d[\d.,]*\s*(?:ms|µs|GB/s|TB/s|fps|frames a second|times)\b")


def slower(value, key=""):
    """The same results, with every time half as long again."""
    if isinstance(value, dict):
        return {k: slower(v, k) for k, v in value.items()}
    if isinstance(value, list):
        return [slower(v, key) for v in value]
    return value * 1.5 if key in ("median", "min") and isinstance(value, float) else value


class Docs(unittest.TestCase):
    def test_files_are_what_the_stored_results_say(self):
        for name, text in docs.generate().items():
            self.assertEqual(
                (ROOT / name).read_text(encoding="utf-8"),
                text,
                f"{name} differs: ./dev bench paper --stored writes it.",
            )

    def test_other_results_make_another_page_plot_and_readme(self):
        with tempfile.TemporaryDirectory() as folder:
            results = pathlib.Path(folder)
            for path in RESULTS.glob("*.json"):
                shutil.copy(path, results)
            machine = json.loads((results / "h100.json").read_text())
            (results / "h100.json").write_text(json.dumps(slower(machine)))
            before, after = docs.generate(), docs.generate(results)
        for name in ("docs/performance.md", "README.md", "docs/images/cost.svg"):
            self.assertNotEqual(before[name], after[name], name)
        sentence = re.compile(r"On the grid, 4,096 nodes take ([\d.]+) ms")
        words = [" ".join(pages["docs/performance.md"].split()) for pages in (before, after)]
        times = [float(sentence.search(page)[1]) for page in words]
        self.assertAlmostEqual(times[1] / times[0], 1.5, delta=0.1)

    def test_no_measured_number_is_typed(self):
        for name in ("performance.md.j2", "readme.md.j2"):
            typed = MEASURED.findall(EXPRESSION.sub("", (docs.TEMPLATES / name).read_text()))
            self.assertEqual(typed, [], name)
        outside = docs.README_BLOCK.sub("", (ROOT / "README.md").read_text())
        self.assertEqual(MEASURED.findall(outside), [])

    def test_a_sentence_about_a_row_that_is_not_stored_fails(self):
        with self.assertRaises(Missing):
            Facts("h100").step("grid", 4097)

    def test_every_stored_file_of_results_is_read_by_something(self):
        used = "".join(
            path.read_text() for path in (ROOT / "bench/paper").rglob("*.*") if path.suffix in (".py", ".j2")
        )
        for path in RESULTS.glob("*.json"):
            machine = json.loads(path.read_text()).get("format") == "weft-bench/1"
            self.assertTrue(machine or path.name in used, f"nothing reads {path.name}")


if __name__ == "__main__":
    unittest.main()
