# SPDX-License-Identifier: GPL-3.0-or-later
"""Load a release: load(FOLDER) gives arrays, plate properties (pattern id -> name -> value, SI), and the ids that are held out."""
import csv
import pathlib

import numpy


def load(folder):
    folder = pathlib.Path(folder)
    with numpy.load(folder / "arrays.npz") as file:
        arrays = dict(file)
    properties = {}
    with (folder / "tables" / "property.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            properties.setdefault(row["pattern_id"], {})[row["name"]] = float(row["value"])
    return arrays, properties, set((folder / "held_out.txt").read_text().split())
