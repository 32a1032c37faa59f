#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses of corotational tiles against those of the full model, by how they are recovered.

Usage: run.py PROGRAM RECOVERIES OUT [--paintings 2]
Surfaces of some kinds of ../error_warnings/cases.py at all of their loads, painted by chance. Rows go to OUT/rows.csv.
"""
import argparse
import json
import pathlib
import sys

for name in ("common", "error_warnings"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / name))
import cases  # noqa: E402
from csv_tables import GrowingTable  # noqa: E402
from program import Fretwork  # noqa: E402
from surface import Surface, palette  # noqa: E402

KINDS = ("cantilever", "rim-moment", "corner-load", "lifted-corner", "torsion-strip", "pinch", "membrane", "cross-pinned", "sway",
         "tripod-ring", "arch", "tension")
WAYS = ("linear", "large_beams", "held_tiles", "loaded_tiles", "sprung_softly", "sprung", "sprung_stiffly", "built_in", "linear_from_full", "held_from_full")
FIELDS = ["kind", "painting", "amount", "tiles", "displacement_largest", "tile_rotation", "solve_ms"]
for name in WAYS:
    FIELDS += [f"{name}_largest", f"{name}_rms"] + ([] if name.endswith("_full") else [f"{name}_ms"])
DIGITS = 5


def row_of(case, told):
    row = {key: case[key] for key in ("kind", "painting", "amount")}
    row |= {key: value for key, value in told.items() if key in FIELDS}
    for way in WAYS:
        row |= {f"{way}_{key}": value for key, value in told.get(way, {}).items() if key != "failed"}
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("recoveries", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--paintings", type=int, default=2, help="of each kind")
    parser.add_argument("--kinds", default=",".join(KINDS))
    options = parser.parse_args()
    folder = options.out / "surface"
    folder.mkdir(parents=True, exist_ok=True)
    surface = Surface(options.program.resolve(), folder)
    recoveries = Fretwork(options.recoveries.resolve(), folder)
    surface("enumerate", "--layout", "paper7", "--list", "patterns.txt")
    patterns = (folder / "patterns.txt").read_text().split()
    table = GrowingTable.anew(options.out / "rows.csv", DIGITS, FIELDS)
    for case in cases.cases(range(1, options.paintings + 1)):
        if case["kind"] not in options.kinds.split(","):
            continue
        surface.write("case.json", case["load_case"])
        surface.tile(case["outline"], case["painting"], "--palette", palette(patterns, case["painting"]), "--setting", "paper", "--edge-length", "26mm")
        told = json.loads(recoveries("project.json", "case.json"))
        if told["converged"]:
            table.add([row_of(case, told)])


if __name__ == "__main__":
    main()
