#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Are stiff joints nearer to solids on patterns that nobody had looked at when they were chosen?

Usage: unseen.py draw PROGRAM OUT     prints the ids of the patterns, joined by commas
       unseen.py judge ROWS.csv       prints their table
"""
import pathlib
import sys

import numpy as np

import loads
import study

COUNT, DRAWN, SEED = 14, 20, 29
EARLIER = ("--sample", 10, "--seed", 5)  # the ten further patterns of the page
HERE = pathlib.Path(__file__).resolve().parent
MODELS = {"centreline": "centrelines", "stiff": "stiff joints"}


def drawn(fretwork, *options):
    fretwork("enumerate", "--layout", study.LAYOUT, *options, "--list", "drawn.txt")
    return (fretwork.folder / "drawn.txt").read_text().split()


def unseen(fretwork):
    """The first ones of a draw that are neither in the stored rows nor among the ten further patterns."""
    seen = {row["pattern"] for row in study.read_rows(HERE / "rows.csv")} | set(drawn(fretwork, *EARLIER))
    return [pattern for pattern in drawn(fretwork, "--sample", DRAWN, "--seed", SEED) if pattern not in seen][:COUNT]


def print_table(rows):
    print("| beams | |" + " | ".join(f" {load}" for load in loads.LOADS) + " |\n|" + "---|" * (2 + len(loads.LOADS)))
    for model, name in MODELS.items():
        found = np.array([loads.ratios(row, row, f"{model}_") for row in rows])
        spread = [f"{np.median(c):.3f} ({c.min():.3f} to {c.max():.3f})" for c in found.T]
        errors = [f"{100 * np.abs(np.log(c)).mean():.1f} %" for c in found.T]
        print(f"| {name} | solid / beams: median, all | " + " | ".join(spread) + " |")
        print(f"| {name} | mean error | " + " | ".join(errors) + " |")
    stiff, centreline = (np.abs(np.log([loads.ratios(row, row, f"{model}_") for row in rows])) for model in ("stiff", "centreline"))
    nearer = (stiff < centreline).sum(axis=0)
    print("| stiff joints | nearer than centrelines | " + " | ".join(f"{count} of {len(rows)}" for count in nearer) + " |")


def main():
    if sys.argv[1] == "draw":
        out = pathlib.Path(sys.argv[3]).resolve()
        out.mkdir(parents=True, exist_ok=True)
        print(",".join(unseen(study.Fretwork(pathlib.Path(sys.argv[2]).resolve(), out))))
    else:
        print_table(loads.main_rows(study.read_rows(sys.argv[2])))


if __name__ == "__main__":
    main()
