# SPDX-License-Identifier: GPL-3.0-or-later
"""Run the notebooks from top to bottom without Jupyter, and keep the pictures that their cells show.

Usage: figures.py [FOLDER]: writes NOTEBOOK-CELL.svg for each picture into the folder (figures, beside this file).
"""

import ast
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
LARGEST = 300_000  # bytes of a picture that is kept


def show(value):
    """What a notebook asks of the last value of a cell: its ending and its text."""
    for name, ending in (("_repr_html_", ".html"), ("_repr_svg_", ".svg")):
        if hasattr(value, name):
            return ending, getattr(value, name)()
    return ".txt", repr(value)


def run_cell(source, names):
    """Run a cell as a notebook does: the value of a last expression is shown."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return show(eval(compile(ast.Expression(last.value), "cell", "eval"), names)) if last else (".txt", "")


def sources(path):
    """The code cells of a notebook."""
    cells = json.loads(path.read_text())["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def figure_name(path, cell):
    return f"{path.stem}-{cell}.svg"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "figures"
    folder.mkdir(exist_ok=True)
    for path in sorted(HERE.glob("*.ipynb")):
        names = {}
        for cell, source in enumerate(sources(path)):
            ending, text = run_cell(source, names)
            if ending == ".svg" and len(text) <= LARGEST:
                (folder / figure_name(path, cell)).write_text(text)


if __name__ == "__main__":
    main()
