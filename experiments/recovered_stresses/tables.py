#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of README.md from the rows. Usage: tables.py ROWS.csv"""
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import percent, print_table, read_rows  # noqa: E402

WAYS = ("linear", "large_beams", "held_tiles", "loaded_tiles", "sprung_softly", "sprung", "sprung_stiffly")
FAR = 0.1  # rad: the limits between the groups, of the largest turn in a tile
FARTHER = 0.3


def summary(rows, way):
    """Median and largest of both errors; how many tiles alone found no equilibrium; and how often it is better than `linear`."""
    known = [row for row in rows if row[f"{way}_rms"]]
    cells = []
    for error in ("largest", "rms"):
        values = [float(row[f"{way}_{error}"]) for row in known]
        better = sum(value < float(row[f"linear_{error}"]) for value, row in zip(values, known))
        cells += [f"{percent(statistics.median(values))}; {percent(max(values))}", "" if way == "linear" else f"{better} of {len(rows)}"]
    return [way.replace("_", " "), *cells, len(rows) - len(known)]


def main():
    rows = read_rows(sys.argv[1])
    groups = [(f"to {FAR} rad", [r for r in rows if float(r["tile_rotation"]) <= FAR]),
              (f"{FAR} to {FARTHER} rad", [r for r in rows if FAR < float(r["tile_rotation"]) <= FARTHER]),
              (f"beyond {FARTHER} rad", [r for r in rows if float(r["tile_rotation"]) > FARTHER])]
    for name, own in groups:
        print(f"Largest turn in a tile {name}: {len(own)} surfaces\n")
        print_table(["way", "largest stress: median; most, %", "better than linear", "all beams: median; most, %", "better than linear", "failed"],
                    [summary(own, way) for way in WAYS])
    differ = [row for row in rows if row["built_in_rms"] != row["linear_rms"]]
    print(f"`fretwork beams` differs from linear on {len(differ)} surfaces.")
    held = max(float(row["held_from_full_rms"]) for row in rows)
    print(f"Tiles held where the full model has their interface nodes: at most {held:.1e} off.")


if __name__ == "__main__":
    main()
