"""docs/methods.md and its plots have the numbers of their stored run."""

import copy
import unittest

from scripts import make_methods as page


class MethodRows(unittest.TestCase):
    def test_the_page_and_its_plots_are_as_the_run_makes_them(self):
        run = page.stored()
        text = page.PAGE.read_text("utf-8")
        self.assertEqual(text, page.made(text, run), "run scripts/make_methods.py")
        for side in page.sides(run):
            self.assertEqual(page.image(side).read_text("utf-8"), page.plot(run, side), "run scripts/make_methods.py")

    def test_a_front_has_only_rows_that_nothing_beats(self):
        rows = [row for row in page.stored()["rows"] if page.is_number(row)]
        kept = page.front(rows)
        for row in rows:
            beaten = any(
                page.milliseconds(other) < page.milliseconds(row) and page.position(other) < page.position(row)
                for other in rows
            )
            if row in kept:
                self.assertFalse(beaten)

    def test_what_was_not_run_or_came_to_nothing_is_said(self):
        run = copy.deepcopy(page.stored())
        run["rows"][0] = {key: run["rows"][0][key] for key in ("object", "variant", "side", "nodes")} | {
            "skipped": "why"
        }
        for error in run["rows"][1]["error"]:
            error.update(position=None, normal_degrees=None)
        text = page.table(run)
        self.assertIn("| why |", text)
        self.assertIn("| none / none / none |", text)


if __name__ == "__main__":
    unittest.main()
