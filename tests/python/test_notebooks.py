# SPDX-License-Identifier: GPL-3.0-or-later
"""Each notebook runs from its first cell to its last; what a cell shows can be shown."""

import ast
import importlib.util
import json
import unittest

import support

FOLDER = support.SOURCE / "experiments" / "notebooks"


def show(value):
    """What a notebook asks of the last value of a cell."""
    for name in ("_repr_html_", "_repr_svg_"):
        if hasattr(value, name):
            return getattr(value, name)()
    return repr(value)


def run(source, names):
    """Run a cell as a notebook does: the value of a last expression is shown."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return show(eval(compile(ast.Expression(last.value), "cell", "eval"), names)) if last else ""


class Notebooks(unittest.TestCase):
    def test_run_from_top_to_bottom(self):
        notebooks = sorted(FOLDER.glob("*.ipynb"))
        self.assertGreater(len(notebooks), 3)
        for path in notebooks:
            cells = [cell for cell in json.loads(path.read_text())["cells"] if cell["cell_type"] == "code"]
            sources = ["".join(cell["source"]) for cell in cells]
            if any("scipy" in source for source in sources) and importlib.util.find_spec("scipy") is None:
                continue
            names = {}
            for number, source in enumerate(sources):
                with self.subTest(path.name, cell=number):
                    shown = run(source, names)
                    self.assertIsInstance(shown, str)


if __name__ == "__main__":
    unittest.main()
