#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures on cases that can be counted by hand."""
import math
import unittest

import numpy as np

import measures
from measures import Run


def run(problem, cost, *gaps, optimizer="a"):
    return Run(problem, optimizer, 0.0, 0.0, math.nan, 1, cost, 0, "converged", 0.0, tuple(gaps))


class Measures(unittest.TestCase):
    def test_runtime_is_the_first_cost_at_or_below_the_target(self):
        one = run("p", 100, (1, 0.5), (7, 0.01), (9, 0.001))
        self.assertEqual(one.runtime(0.01), 7.0)
        self.assertEqual(one.runtime(1e-5), math.inf)
        self.assertEqual(one.gap, 0.001)

    def test_average_runtime_charges_misses_to_the_hits(self):
        runs = [run("p", 100, (10, 0.0)), run("p", 50, (1, 0.5)), run("p", 100, (20, 0.0))]
        self.assertEqual(measures.average_runtime(runs, 0.01), (10 + 50 + 20) / 2)
        self.assertEqual(measures.average_runtime(runs[1:2], 0.01), math.inf)

    def test_bootstrap_of_equal_runs_is_their_runtime(self):
        low, high = measures.bootstrap_runtime({"p": [run("p", 9, (5, 0.0))] * 3, "q": [run("q", 9, (5, 0.0))]}, 0.01, 50)
        self.assertEqual((low, high), (5.0, 5.0))

    def test_restarts_add_up_until_a_hit(self):
        runs = [run("p", 100, (10, 0.0)), run("p", 50, (1, 0.5))]
        times = measures.restarted_runtimes(runs, 0.01, 20000, np.random.default_rng(1))
        self.assertTrue(set(np.unique((times - 10) / 50)) <= set(range(40)))
        # The number of misses before a hit is geometric with mean 1: the same as the aRT.
        self.assertAlmostEqual(times.mean(), measures.average_runtime(runs, 0.01), delta=2.0)

    def test_performance_ratios_compare_with_the_best_method(self):
        groups = measures.group([run("p", 9, (2, 0.0)), run("p", 9, (6, 0.0), optimizer="b"), run("q", 9, (8, 0.0)),
                                 run("q", 9, (1, 1.0), optimizer="b")])
        ratios = measures.performance_ratios(groups, 0.01)
        self.assertEqual(ratios["a"].tolist(), [1.0, 1.0])
        self.assertEqual(ratios["b"].tolist(), [3.0, math.inf])

    def test_holm_multiplies_by_the_number_of_tests_left_and_never_decreases(self):
        # The example of the method's definition: 0.01, 0.02, 0.03 and 0.04 with four tests.
        np.testing.assert_allclose(measures.holm(np.array([0.04, 0.01, 0.03, 0.02])), [0.06, 0.04, 0.06, 0.06])
        np.testing.assert_allclose(measures.holm(np.array([0.5, 0.9])), [1.0, 1.0])

    def test_pairs_that_found_the_same_minimum_are_ties(self):
        ours = np.array([0.0, 0.0, 0.0, 0.0])
        self.assertEqual(measures.compare_pairs(ours, ours + 1e-4), (1.0, 0.5, 0))
        p, better, differing = measures.compare_pairs(np.zeros(10), np.arange(1.0, 11.0))
        self.assertEqual((better, differing), (1.0, 10))
        self.assertAlmostEqual(p, 2 * 0.5**10, places=12)  # exact: all ten signs agree

    def test_problems_that_are_never_hit_are_counted(self):
        missed = [run("p", 100, (1, 0.5)), run("p", 100, (1, 0.4))]
        self.assertEqual(measures.never_hit({"p": missed, "q": [*missed, run("q", 9, (5, 0.0))]}, 0.01), 1)

    def test_a_budget_cuts_runs(self):
        runs = [run("p", 100, (10, 0.0)), run("p", 100, (20, 0.0)), run("p", 100, (1, 0.5))]
        self.assertEqual([measures.share_within_budget(runs, 0.01, budget) for budget in (9, 10, 40)], [0.0, 1 / 3, 2 / 3])

    def test_intervals_hold_what_does_not_vary(self):
        runs = {name: [run(name, 40, (5, 0.0))] * 3 for name in "pq"}
        self.assertEqual(tuple(measures.bootstrap_success(runs, 0.01, 50)), (1.0, 1.0))
        dearer = {name: [run(name, 120, (5, 0.0))] for name in "pq"}
        self.assertEqual(tuple(measures.bootstrap_ratio(dearer, runs, lambda one: one.cost, 50)), (3.0, 3.0))

    def test_intervals_of_shares_are_exact_where_each_problem_has_one_run(self):
        single = {str(i): [run(str(i), 40, (5, 0.0 if i < 59 else 1.0))] for i in range(60)}
        low, high = measures.success_interval(single, 0.01)
        self.assertEqual((round(low, 4), round(high, 4)), (0.9106, 0.9996))  # SciPy: binomtest(59, 60).proportion_ci(method="exact")
        exact = measures.stats.binomtest(59, 60).proportion_ci(method="exact")
        np.testing.assert_allclose((low, high), (exact.low, exact.high), rtol=1e-9)

    def test_intervals_have_a_width_where_all_runs_hit(self):
        certain = {str(i): [run(str(i), 40, (5, 0.0))] * 3 for i in range(60)}
        low, high = measures.success_interval(certain, 0.01)
        self.assertAlmostEqual(low, 0.025 ** (1 / 60), places=9)
        self.assertEqual(high, 1.0)
        mixed = {name: [run(name, 40, (5, 0.0)), run(name, 40, (5, 1.0))] for name in "pq"}
        self.assertEqual(tuple(measures.success_interval(mixed, 0.01)), tuple(measures.bootstrap_success(mixed, 0.01)))


if __name__ == "__main__":
    unittest.main()
