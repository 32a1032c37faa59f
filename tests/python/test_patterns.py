# SPDX-License-Identifier: GPL-3.0-or-later
"""Layouts, patterns and their enumeration, against the paper's numbers."""

import csv
import unittest
from fractions import Fraction

import fretwork as fw
import support

# The paper's Table 1: valid patterns by number of edges, as the repository's census of paper7 has them.
CENSUS = support.SOURCE / "experiments" / "layouts" / "paper7.csv"


class Patterns(unittest.TestCase):
    def setUp(self):
        self.layout = fw.paper_layout()

    def test_the_census_is_that_of_the_repository(self):
        with open(CENSUS) as file:
            rows = list(csv.DictReader(file))
        census = fw.take_census(self.layout, edges=fw.default_edge_range(self.layout))
        self.assertEqual([row.valid for row in census.rows], [int(row["valid"]) for row in rows])
        self.assertEqual(census.valid, len(fw.enumerate_patterns(self.layout)))

    def test_threads_change_nothing(self):
        self.assertEqual(fw.enumerate_patterns(self.layout, threads=1), fw.enumerate_patterns(self.layout, threads=2))

    def test_ids_lead_back(self):
        for pattern in fw.enumerate_patterns(self.layout)[::100]:
            self.assertEqual(fw.parse_pattern_id(self.layout, fw.pattern_id(self.layout, pattern)), pattern)

    def test_places_are_exact(self):
        for node in self.layout.nodes:
            self.assertEqual(sum(node.place), Fraction(1))

    def test_a_visit_sees_what_the_list_holds(self):
        seen = []
        fw.for_each_pattern(self.layout, seen.append)
        self.assertEqual(seen, fw.enumerate_patterns(self.layout))

    def test_counts_beyond_64_bits_are_ints(self):
        rows = fw.take_census(fw.find_node_layout("fifths12"), edges=fw.EdgeRange(2, 4)).rows
        self.assertTrue(all(isinstance(row.patterns, int) for row in rows))

    def test_sameness_agrees_with_mirror_images(self):
        patterns = fw.enumerate_patterns(self.layout)
        report = fw.find_sameness(self.layout, patterns)
        for pattern, same in list(zip(patterns, report.of_pattern))[::50]:
            self.assertEqual(same.symmetry == "mirror", fw.is_symmetric(self.layout, pattern))

    def test_samples_are_valid(self):
        filters = fw.make_filters(self.layout)
        sampler = fw.PatternSampler(self.layout, 3)
        for pattern in sampler.draw(20):
            self.assertTrue(fw.judge(self.layout, filters, pattern).accepted)


if __name__ == "__main__":
    unittest.main()
