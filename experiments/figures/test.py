#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes behind Figs. 5 and 6, and the text of all figures. Usage: test.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]
import duplicates  # noqa: E402
import legible  # noqa: E402

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
                self.assertEqual(root.get("width"), "84mm")
                bars = [path for path in root.iter("{http://www.w3.org/2000/svg}path") if path.get("stroke-linecap") == "round"]
                self.assertEqual(len(bars), beams)


def drawing(body, attributes='viewBox="0 0 840 100" data-print-width="84mm"'):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


class Legibility(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def faults(self, text):
        path = self.folder / "figure.svg"
        path.write_text(text)
        return len(legible.complaints(path))

    def test_text_is_measured_as_it_is_printed(self):
        # 84 mm are 840 units: 21.17 units are 6 pt
        self.assertEqual(self.faults(drawing('<text font-size="21.2">a</text>')), 0)
        self.assertEqual(self.faults(drawing('<text font-size="21.1">a</text>')), 1)
        self.assertEqual(self.faults(drawing('<g font-size="21.1"><text>a</text><text font-size="22">b</text></g>')), 1)
        self.assertEqual(self.faults(drawing('<text style="font: 21.1px sans-serif">a</text>')), 1)
        self.assertEqual(self.faults(drawing('<text font-size="30"><tspan font-size="20">a</tspan></text>')), 1)

    def test_panels_and_groups_scale_their_text(self):
        panel = '<svg width="420" height="10" viewBox="0 0 840 20"><text font-size="{}">a</text></svg>'
        self.assertEqual(self.faults(drawing(panel.format(42))), 1)
        self.assertEqual(self.faults(drawing(panel.format(43))), 0)
        self.assertEqual(self.faults(drawing('<g transform="translate(3 4) scale(2)"><text font-size="11">a</text></g>')), 0)
        self.assertEqual(self.faults(drawing('<g transform="scale(0.5)"><text font-size="30">a</text></g>')), 1)

    def test_a_figure_with_text_says_how_wide_it_is_printed(self):
        self.assertEqual(self.faults(drawing('<text font-size="90">a</text>', 'viewBox="0 0 840 100"')), 1)
        self.assertEqual(self.faults(drawing('<text font-size="90">a</text>', 'viewBox="0 0 840 100" data-print-width="300mm"')), 1)
        self.assertEqual(self.faults(drawing("<path/>", 'viewBox="0 0 840 100"')), 0)

    def test_figures_of_the_pages_are_legible(self):
        root = HERE.parent.parent
        figures = [path for place in ("docs/pictures", "experiments") for path in sorted((root / place).rglob("*.svg"))
                   if path.name != "cut.svg"]  # which is a drawing for a machine
        self.assertGreater(len(figures), 15)
        self.assertEqual([line for path in figures for line in legible.complaints(path)], [])

    def run_program(self, *words):
        subprocess.run([PROGRAM, *map(str, words)], check=True, capture_output=True, cwd=self.folder)

    def test_figures_of_the_paper_are_legible(self):
        subprocess.run([sys.executable, HERE / "duplicates.py", LAYOUT, self.folder], check=True)
        self.run_program("enumerate", "--svg", "fig02.svg", "--sample", 60)
        self.run_program("enumerate", "--edges", "2..3", "--svg", "fig07.svg", "--reasons")
        self.run_program("enumerate", "--library", "library.db")
        self.run_program("calibrate", "--library", "library.db", "--patterns", "sample:12")
        self.run_program("library", "export", "--library", "library.db", "--svg", "fig08.svg", "--patterns", "sample:6")
        self.run_program("library", "show", "0-1+3-6", "--library", "library.db", "--scenarios", "fig10.svg")
        self.run_program("tile", HERE.parent / "outlines" / "specimen.svg", "--library", "library.db", "--patterns", "random:1", "--out", "a.json")
        self.run_program("case", "add", "a.json", HERE.parent / "cases" / "own_weight.json")
        for model in ("full", "paper6"):
            self.run_program("simulate", "a.json", "--model", model, "--out", f"{model}.json")
        self.run_program("export", "a.json", "--case", "own-weight", "--result", "full.json", "--result", "paper6.json", "--to", "fig12.svg")
        figures = sorted(self.folder.glob("fig*.svg"))
        self.assertEqual(len(figures), 7)
        self.assertEqual([line for path in figures for line in legible.complaints(path)], [])


if __name__ == "__main__":
    unittest.main()
