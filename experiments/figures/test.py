#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes behind Figs. 5 and 6. Usage: test.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import duplicates  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else ""
LAYOUT = HERE.parent / "layouts" / "paper7.json"
PLACES = duplicates.layout_nodes(json.loads(LAYOUT.read_text()))


class Shapes(unittest.TestCase):
    def test_pairs_of_the_figures_have_one_shape(self):
        for _, _, patterns in (duplicates.RADIAL, duplicates.PASSED):
            self.assertTrue(duplicates.same_shape(PLACES, *patterns))

    def test_other_graphs_have_other_shapes(self):
        first = duplicates.RADIAL[2][0]
        for other in ("0-1+1-2+2-5+4-5", "0-1+1-4+2-5+4-5+5-6", "0-5+1-2+2-5+4-5+5-6", "0-1+2-5+4-5+5-6"):
            self.assertFalse(duplicates.same_shape(PLACES, first, other), other)

    def test_beams_that_pass_over_each_other_are_parted_once(self):
        cross = [((0, 0), (2, 0)), ((2, 0), (0, 0)), ((0, 0), (1, 0))]
        points = {(0, 0), (1, 0), (2, 0)}
        self.assertEqual(duplicates.pieces(cross, points), {frozenset({(0, 0), (1, 0)}), frozenset({(1, 0), (2, 0)})})

    def test_the_program_makes_the_first_graph_of_each_pair_and_not_the_second(self):
        with tempfile.TemporaryDirectory() as folder:
            listed = pathlib.Path(folder) / "patterns.txt"
            subprocess.run([PROGRAM, "enumerate", "--list", listed], check=True, capture_output=True)
            valid = set(listed.read_text().split())
        for _, _, (first, second) in (duplicates.RADIAL, duplicates.PASSED):
            self.assertIn(first, valid)
            self.assertNotIn(second, valid)

    def test_draws_both_figures_as_wide_as_a_column(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, HERE / "duplicates.py", LAYOUT, folder], check=True)
            for name, beams in (("fig05", 2 * 5 + 30), ("fig06", 5 + 4 + 30)):
                root = xml.parse(f"{folder}/{name}.svg").getroot()
                self.assertEqual(root.get("width"), "85mm")
                bars = [path for path in root.iter("{http://www.w3.org/2000/svg}path") if path.get("stroke-linecap") == "round"]
                self.assertEqual(len(bars), beams)


if __name__ == "__main__":
    unittest.main()
