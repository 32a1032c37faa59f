#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The intervals and verdicts of run.py."""
import pathlib
import random
import statistics
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import run  # noqa: E402


class Statistics(unittest.TestCase):
    def test_interval_of_a_mean_is_that_of_the_normal_law(self):
        generator = random.Random(5)
        values = [generator.gauss(4.0, 3.0) for _ in range(400)]
        low, high = run.interval(values, statistics.fmean)
        half = 1.96 * statistics.pstdev(values) / 20.0
        self.assertAlmostEqual(low, statistics.fmean(values) - half, delta=0.1 * half)
        self.assertAlmostEqual(high, statistics.fmean(values) + half, delta=0.1 * half)

    def test_ratio_is_deviation_over_mean(self):
        self.assertEqual(run.ratio([1.0, 3.0]), 0.5)

    def test_verdict_says_which_number_agrees(self):
        near, far = (9.0, 10.0), (1.0, 2.0)
        ratio = (0.9, 1.1)
        self.assertEqual(run.verdict(near, ratio), "agrees with the paper")
        self.assertEqual(run.verdict(far, ratio), "ratio agrees, mean does not")
        self.assertEqual(run.verdict(near, (0.5, 0.6)), "mean agrees, ratio does not")
        self.assertEqual(run.verdict(far, (0.5, 0.6)), "excluded")


if __name__ == "__main__":
    unittest.main()
