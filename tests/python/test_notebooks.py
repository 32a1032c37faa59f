# SPDX-License-Identifier: GPL-3.0-or-later
"""Each notebook runs from its first cell to its last; the pictures that are kept are those that it shows."""

import importlib.util
import re
import sys
import unittest

import support

FOLDER = support.SOURCE / "experiments" / "notebooks"
sys.path.insert(0, str(FOLDER))

import figures  # noqa: E402


def shape_of(svg):
    """A picture without its numbers, whose last digits another machine may round differently."""
    return re.sub(r"-?\d+(\.\d+)?(e-?\d+)?", "0", svg)


class Notebooks(unittest.TestCase):
    def check_figure(self, path, cell, text):
        kept = FOLDER / "figures" / figures.figure_name(path, cell)
        if len(text) <= figures.LARGEST:
            self.assertTrue(kept.exists(), f"{kept.name} is missing: run figures.py")
            self.assertTrue(shape_of(kept.read_text()) == shape_of(text), f"{kept.name} is another one: run figures.py")

    def test_run_from_top_to_bottom(self):
        notebooks = sorted(FOLDER.glob("*.ipynb"))
        self.assertGreater(len(notebooks), 3)
        for path in notebooks:
            cells = figures.sources(path)
            if any("scipy" in source for source in cells) and importlib.util.find_spec("scipy") is None:
                continue
            names = {}
            for cell, source in enumerate(cells):
                with self.subTest(path.name, cell=cell):
                    ending, text = figures.run_cell(source, names)
                    if ending == ".svg":
                        self.check_figure(path, cell, text)


if __name__ == "__main__":
    unittest.main()
