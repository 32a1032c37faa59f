# SPDX-License-Identifier: GPL-3.0-or-later
"""What both sides of the comparison share: patterns, bars, and how the program is asked."""
import json
import math
import pathlib
import sqlite3
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import GrowingTable, read_rows, write_rows  # noqa: E402, F401
from program import Fretwork  # noqa: E402, F401

LAYOUT = "paper8"
SIDE = 25.980762113533156  # mm, of the tile; the paper's
YOUNG, POISSON = 1e9, 0.3  # Pa
SHEAR_FACTOR = 5.0 / 6.0
TENSORS = ("A11", "A12", "A66", "D11", "D12", "D66")  # N/m, N m
MODELS = ("centreline", "sheared", "stiff", "stiff_sheared")
DIGITS = 7  # of the numbers in tables


def torsion_constant(side):
    """Of a square: Saint-Venant's, as the program has it for rectangles."""
    series = sum(math.tanh(n * math.pi / 2) / n**5 for n in range(1, 40, 2))
    return side**4 * (1 / 3 - 64 / math.pi**5 * series)


def section(width, model):
    """A square bar (m) as a setting file has it."""
    if not model.endswith("sheared"):
        return {"type": "rectangle", "width": width, "height": width}
    return {"area": width**2, "I2": width**4 / 12, "I3": width**4 / 12, "J": torsion_constant(width),
            "shear_area2": SHEAR_FACTOR * width**2, "shear_area3": SHEAR_FACTOR * width**2}


def sample(fretwork, count):
    """So many patterns of the layout, spread over the numbers of edges by the program's own rule."""
    return sorted(properties(fretwork.folder / library(fretwork, 2.0, "centreline", f"sample:{count}", name=f"sample{count}")))


def library(fretwork, width, model, patterns, name=""):
    """The name of a library with some patterns' properties as plates. The responses that come with them are to next to no load."""
    name = name or f"{model}{width:g}"
    setting = {"format": "fretwork/setting/2", "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": 1240},
               "section": section(width / 1e3, model), "joints": "stiff" if model.startswith("stiff") else "centreline",
               "tile_side": SIDE / 1e3, "magnitudes": 1, "divisions": 1, "scenarios": [{"use": "bending", "max_magnitude": 1e-6}]}
    (fretwork.folder / f"{name}.json").write_text(json.dumps(setting))
    if not (fretwork.folder / f"{name}.db").exists():
        fretwork("enumerate", "--layout", LAYOUT, "--library", f"{name}.db")
    fretwork("calibrate", "--library", f"{name}.db", "--setting", f"{name}.json", "--patterns", patterns, "--model", "condensed")
    return f"{name}.db"


def properties(path):
    """Of each pattern of a library that has them, by name, SI."""
    found = {}
    with sqlite3.connect(path) as database:
        for pattern, name, value in database.execute("select pattern_id, name, value from property"):
            found.setdefault(pattern, {})[name] = value
    return found
