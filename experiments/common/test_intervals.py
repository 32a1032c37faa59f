#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals against closed forms and a published table."""
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from intervals import binomial_tail, exact_interval, resampled_interval  # noqa: E402


class Intervals(unittest.TestCase):
    def test_all_or_no_hits_have_a_closed_form(self):
        for count in (1, 10, 60, 1824):
            least = 0.025 ** (1.0 / count)
            self.assertAlmostEqual(exact_interval(count, count)[0], least, places=12)
            self.assertEqual(exact_interval(count, count)[1], 1.0)
            self.assertAlmostEqual(exact_interval(0, count)[1], 1.0 - least, places=12)

    def test_is_that_of_the_literature(self):
        """81 of 263: 25.27 to 36.76 %, Newcombe 1998, Statistics in Medicine 17, 857, Table I, method 5. 15 of 148: 5.78 to 16.17 %."""
        for (hits, count), expected in (((81, 263), (0.2527, 0.3676)), ((15, 148), (0.0578, 0.1617)), ((1, 29), (0.0009, 0.1776))):
            for found, value in zip(exact_interval(hits, count), expected):
                self.assertAlmostEqual(found, value, delta=5e-5)

    def test_ends_have_tails_of_a_fortieth(self):
        low, high = exact_interval(7, 20)
        self.assertAlmostEqual(binomial_tail(7, 20, low), 0.025, places=12)
        self.assertAlmostEqual(1.0 - binomial_tail(8, 20, high), 0.025, places=12)

    def test_interval_of_a_mean_is_that_of_the_normal_law(self):
        generator = random.Random(5)
        values = [generator.gauss(4.0, 3.0) for _ in range(400)]
        mean = math.fsum(values) / 400
        half = 1.96 * math.sqrt(math.fsum((value - mean) ** 2 for value in values) / 400) / 20.0
        low, high = resampled_interval(values, lambda items: math.fsum(items) / len(items))
        self.assertAlmostEqual(low, mean - half, delta=0.1 * half)
        self.assertAlmostEqual(high, mean + half, delta=0.1 * half)


if __name__ == "__main__":
    unittest.main()
