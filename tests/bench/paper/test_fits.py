"""Fits find what the points were made of; the time left follows from the time taken."""

import math
import unittest

from bench.paper import cases, fits, wording
from bench.paper.progress import TimeLeft, in_words


class Fits(unittest.TestCase):
    def test_a_power_law_is_found_exactly(self):
        exponent, explained = fits.power_law([(x, 3 * x**1.5) for x in (10, 100, 2000)])
        self.assertAlmostEqual(exponent, 1.5)
        self.assertAlmostEqual(explained, 1)

    def test_noise_lowers_what_a_power_law_explains(self):
        _, explained = fits.power_law([(1, 1), (10, 30), (100, 20), (1000, 900)])
        self.assertTrue(0.5 < explained < 0.99)

    def test_launch_and_slope_are_found_exactly(self):
        base, slope = fits.base_and_slope([(n, 0.006 + 2e-8 * n) for n in (4096, 65536, 640000)])
        self.assertAlmostEqual(base, 0.006)
        self.assertAlmostEqual(slope, 2e-8)

    def test_a_relative_fit_does_not_give_up_small_sizes_for_large_ones(self):
        base, _ = fits.base_and_slope([(100, 1.0), (1000, 1.0), (500_000, 50.0), (1_000_000, 130.0)])
        self.assertAlmostEqual(base, 1, delta=0.1)  # by absolute errors it would be -7

    def test_a_level_is_crossed_between_points_on_logarithmic_axes(self):
        nodes, beyond = fits.crossing([(100, 10), (10_000, 0.1)], 1)
        self.assertAlmostEqual(nodes, 1000)
        self.assertFalse(beyond)

    def test_a_level_that_is_never_left_or_never_reached(self):
        self.assertEqual(fits.crossing([(100, 10), (400, 5)], 1), (400, True))
        self.assertIsNone(fits.crossing([(100, 0.5), (400, 0.1)], 1))

    def test_numbers_in_sentences_have_no_powers_of_ten(self):
        self.assertEqual(
            [wording.rounded(x) for x in (1414, 0.0000123, 0.01416, 26)], ["1,400", "0.000012", "0.014", "26"]
        )
        self.assertEqual(wording.span((9.73, 20.1)), "9.7 to 20")


class TimeIsLeft(unittest.TestCase):
    def test_it_is_unknown_until_a_case_has_ended(self):
        self.assertIsNone(TimeLeft().left([1, 2]))

    def test_cases_that_cost_more_take_longer(self):
        clock = TimeLeft()
        clock.add(2, 10)
        clock.add(4, 26)
        self.assertAlmostEqual(clock.left([1, 9]), 60)

    def test_words(self):
        self.assertEqual(
            [in_words(s) for s in (None, 42.4, 600, 7200)],
            ["time left not known yet", "about 42 s left", "about 10 min left", "about 2.0 h left"],
        )

    def test_brute_force_costs_by_pairs(self):
        costs = {
            case.side: case.weight
            for case in cases.plan(["pull"], False, 800)
            if case.brute_force and case.object == "dragon"
        }
        self.assertGreater(costs[800] / costs[400], 3)
        self.assertTrue(math.isfinite(sum(costs.values())))


if __name__ == "__main__":
    unittest.main()
