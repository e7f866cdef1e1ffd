"""docs/methods.md, its plots and the page on which method to take have the numbers of their stored run."""

import copy
import unittest

from scripts import make_methods as page


class MethodRows(unittest.TestCase):
    def test_the_page_and_its_plots_are_as_the_run_makes_them(self):
        run = page.stored()
        text = page.PAGE.read_text("utf-8")
        self.assertEqual(text, page.made(text, run), "run scripts/make_methods.py")
        text = page.CHOICE.read_text("utf-8")
        self.assertEqual(text, page.choice(text, run), "run scripts/make_methods.py")
        self.assertEqual(page.OF_PAGE.read_text("utf-8"), page.of_page(run), "run scripts/make_methods.py")
        for one in page.drawn(run):
            self.assertEqual(page.image(*one).read_text("utf-8"), page.plot(run, *one), "run scripts/make_methods.py")

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

    def test_the_choice_is_the_fastest_of_those_that_are_near_and_the_nearest_of_those_that_are_fast(self):
        def row(variant, ms, error):
            return {"variant": variant, "ms_per_frame": {"median": ms}, "error": [{"position": error / 100}]}

        found = {
            "a": [row("a 4", 3, 4.5), row("a 8", 30, 0.5)],
            "b": [row("b", 12, 0.9)],
            "null": [row("null 9", 1, 0.1)],
        }
        self.assertEqual(page.fastest(found, 5), "`a 4`, 3 ms")
        self.assertEqual(page.fastest(found, 1), "`b`, 12 ms")
        self.assertEqual(page.fastest(found, 0.2), "none")
        self.assertEqual(page.nearest(found), "`b`, 0.9 %")

    def test_what_was_not_run_or_came_to_nothing_is_said(self):
        run = copy.deepcopy(page.stored())
        run["rows"][0] = {key: run["rows"][0][key] for key in ("object", "variant", "side", "nodes")} | {
            "skipped": "why"
        }
        for error in run["rows"][1]["error"]:
            error.update(position=None, normal_degrees=None)
        text = page.table(run, "sheet")
        self.assertIn("| why |", text)
        self.assertIn("| none / none / none |", text)

    def test_grades_are_of_numbers(self):
        def row(scene, side, variant, ms, error, **more):
            errors = [{"position": part * error / 100} for part in (3, 1, 2)]
            return {
                "object": scene,
                "side": side,
                "variant": variant,
                "ms_per_frame": {"median": ms},
                "error": errors,
            } | more

        rows = [
            row("sheet", 100, "a 4", 5, 3.0, substeps=4),
            row("sheet", 100, "a 8", 16, 1.0, substeps=8),
            row("sheet", 100, "a 16", 17, 0.1, substeps=16),  # more than a frame
            row("sheet", 317, "a 4", 10, 4.0),
            row("sheet", 800, "a 4", 16, 6.0),  # farther than it may be
            row("ball", 100, "a 4", 10, 12.0, crossings=0, max_stretch=1.5),
            row("ball", 100, "a 8", 30, 2.0, crossings=3, max_stretch=9.0),
            row("twist", 100, "a 8", 10, 2.5, crossings=0, max_stretch=1.25),
            row("sheet", 100, "b", 2, 20.0, substeps=100),
        ]
        run = {"rows": rows}
        self.assertEqual(page.largest(run, "a"), 317 * 317)
        self.assertEqual(page.median_error(list(page.graded(run, "a").values())), 2.5)
        self.assertEqual(page.accuracy_of(2.5), "Medium")
        self.assertEqual([page.accuracy_of(error) for error in (2, 10, 10.1)], ["High", "Medium", "Low"])
        self.assertEqual(
            [page.grade_of(n, page.REAL_TIME) for n in (99_999, 100_000, 9_999)], ["Medium", "High", "Low"]
        )
        line_a, line_b = page.grades(run).split("\n")[2:]
        self.assertEqual(line_a, "| `a` | 100,489 | 1 %, 2.5 % | 4 % | any | 3 | 1.50 | High | Medium |")
        self.assertEqual(line_b, "| `b` | none | 20 %, none | none | 167 µs | 0 | none | Low | Low |")


if __name__ == "__main__":
    unittest.main()
