"""docs/validation.md has the numbers of its stored runs, and says which do not hold."""

import json
import unittest

from scripts.make_validation import PAGE, PLOT, convergence, made, stored


class Validation(unittest.TestCase):
    def test_the_page_is_as_its_runs_make_it(self):
        page = PAGE.read_text("utf-8")
        self.assertEqual(page, made(page, stored()), "run scripts/make_validation.py")

    def test_the_plot_is_as_its_runs_make_it(self):
        self.assertEqual(PLOT.read_text("utf-8"), convergence(stored()[0]), "run scripts/make_validation.py")

    def test_a_number_that_fails_is_marked(self):
        runs = json.loads(json.dumps(stored()))
        runs[0]["rows"][0].update(value=12345, holds=False)
        self.assertIn("| **1.234e+04** |", made(PAGE.read_text("utf-8"), runs))
        runs[0]["rows"][0].update(value=None)
        self.assertIn("| **none** |", made(PAGE.read_text("utf-8"), runs))

    def test_every_law_has_a_number_in_every_run(self):
        for run in stored():
            self.assertEqual({law["name"] for law in run["laws"]}, {row["law"] for row in run["rows"]})


if __name__ == "__main__":
    unittest.main()
