"""docs/fabrics.md has the numbers that the program has and those that were measured with it; a shadow is its area."""

import json
import math
import os
import unittest

from scripts.measure_fabrics import DOCS, RESULTS, ROOT, disc, made, shadow, table_of

TABLE = table_of(os.environ["WEFT"])
MEASURED = json.loads((ROOT / RESULTS).read_text("utf-8"))
PAGE = (ROOT / DOCS).read_text("utf-8")


class Fabrics(unittest.TestCase):
    def test_the_page_is_as_the_table_and_the_results_make_it(self):
        self.assertEqual(PAGE, made(PAGE, TABLE, MEASURED), "run scripts/measure_fabrics.py --docs")

    def test_a_number_that_changes_reaches_the_page(self):
        table = json.loads(json.dumps(TABLE))
        table["fabrics"][0]["warp"] = {"value": 1234, "unit": "N/m", "source": "guess", "guess": True}
        measured = json.loads(json.dumps(MEASURED))
        measured["denim_11oz"]["drape_percent"]["mean"] = 12
        page = made(PAGE, table, measured)
        self.assertIn("| 1230? |", page)
        self.assertIn(" | 12 | ", page)

    def test_every_fabric_was_measured_and_no_other(self):
        self.assertEqual(sorted(MEASURED), sorted(fabric["name"] for fabric in TABLE["fabrics"]))

    def test_strips_hang_as_their_bending_stiffness_says(self):
        # Half the overhang at 41.5 degrees is (B/w)^(1/3) (Peirce 1930); ASTM D1388 reads lengths to 1 mm of about 40.
        for name, measured in MEASURED.items():
            for axis, length in measured["bending_length_m"].items():
                self.assertLess(abs(length["measured"] / length["from_b"] - 1), 1 / 40, f"{name}, {axis}")

    def test_a_sheet_is_round_whole_and_its_shadow_is_its_area(self):
        nodes, triangles, held = disc(10, 1)
        self.assertEqual(len(nodes), 1 + 3 * 10 * 11)
        self.assertEqual(len(triangles), 6 * 10 * 10)
        self.assertAlmostEqual(held, 0.09)
        edges = {}
        area = 0
        for a, b, c in triangles:
            side, other = [tuple(nodes[n][k] - nodes[a][k] for k in (0, 1)) for n in (b, c)]
            self.assertGreater(abs(side[0] * other[1] - side[1] * other[0]), 0)
            area += abs(side[0] * other[1] - side[1] * other[0]) / 2
            for edge in ((a, b), (b, c), (c, a)):
                edges.setdefault(tuple(sorted(edge)), []).append(edge)
        self.assertEqual(sum(len(both) == 1 for both in edges.values()), 60)  # the rim
        self.assertTrue(all(both[0] == both[1][::-1] for both in edges.values() if len(both) == 2))
        lying = shadow([(x, 0, z) for x, z in nodes], triangles)
        # A pixel in doubt along the rim, 0.5 mm of 940.
        self.assertAlmostEqual(lying, area, delta=0.0005 * 2 * math.pi * 0.15)
        # Tilted by 60 degrees, half as much; what lies double counts once.
        tilted = [(x / 2, x, z) for x, z in nodes]
        self.assertAlmostEqual(shadow(tilted, triangles), area / 2, delta=0.0005 * 2 * math.pi * 0.15)
        self.assertEqual(shadow(tilted, triangles + triangles), shadow(tilted, triangles))


if __name__ == "__main__":
    unittest.main()
