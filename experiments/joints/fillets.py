#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fillets in the inner corners add, and whether a longer reach of the joints accounts for it: solids beside beams.

Usage: fillets.py draw PROGRAM OUT     prints the ids of 20 patterns that nothing was chosen on, joined by commas
       fillets.py judge PROGRAM OUT    reads OUT/solids.csv and prints the tables
A fillet of radius r touches the bars (w / 2 + r) cot(angle / 2) from the node, where the bare joint reaches w / 2 cot(angle / 2).
"""
import pathlib
import sys

import numpy as np

import frames
import loads
import scan
import study
import unseen

COUNT, DRAWN = 20, 30
SHARE, LEAST = 0.35, 0.5  # of the program's stiff joints
ADDED = (0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5)  # shares of the fillet's own reach


def patterns(fretwork):
    seen = {row["pattern"] for row in study.read_rows(unseen.HERE / "rows.csv")} | set(unseen.drawn(fretwork, *unseen.EARLIER))
    return [one for one in unseen.drawn(fretwork, "--sample", DRAWN, "--seed", unseen.SEED) if one not in seen][:COUNT]


def ratios(row, lines, added):
    """Solid over beams with stiff joints that reach farther by a share of the fillet's reach."""
    bars, reaches = lines[row["pattern"]]
    width = float(row["width_mm"])
    longer = 1 + added * 2 * float(row["fillet_mm"]) / width
    shares = scan.elastic_shares(bars, [longer * reach for reach in reaches], width, SHARE, LEAST)
    return np.array(loads.ratios(row, frames.plate(bars, study.SIDE, width, shares)))


def print_gains(by_radius):
    print("Solids with fillets over those without: median, least and most\n")
    print("| fillet, mm | patterns | " + " | ".join(loads.LOADS) + " |\n|---|---|" + "---|" * len(loads.LOADS))
    bare = {row["pattern"]: loads.stiffnesses(row, "solid_") for row in by_radius[0.0]}
    for radius, rows in by_radius.items():
        if radius:
            found = np.array([np.divide(loads.stiffnesses(row, "solid_"), bare[row["pattern"]]) for row in rows])
            print(f"| {radius:g} | {len(rows)} | " + " | ".join(f"{np.median(c):.2f} ({c.min():.2f} to {c.max():.2f})" for c in found.T) + " |")
    print()


def print_errors(by_radius, lines):
    print("Mean of |log(solid / beams)| by the share of the fillet's reach that joints reach farther: every second pattern, and the others\n")
    print("| fillet, mm | share | " + " | ".join(f"{load}, {half}" for half in ("chosen on", "held out") for load in loads.LOADS) + " |\n|---|---|" + "---|" * 8)
    for radius, rows in by_radius.items():
        for added in ADDED if radius else ADDED[:1]:
            cells = []
            for half in loads.halves(rows):
                found = np.abs(np.log([ratios(row, lines, added) for row in rows if row["pattern"] in half])).mean(axis=0)
                cells += [f"{100 * value:.1f} %" for value in found]
            print("| " + " | ".join([f"{radius:g}", f"{added:g}", *cells]) + " |")
    print()


def print_summary(by_radius, lines):
    print("Mean of |log(solid / beams)| over all patterns: bare joints, and joints that reach to where the fillet touches\n")
    print("| fillet, mm | reach of the joints | " + " | ".join(loads.LOADS) + " |\n|---|---|" + "---|" * len(loads.LOADS))
    for radius, rows in by_radius.items():
        for added, name in ((0.0, "bare"), (1.0, "to the fillet"))[:2 if radius else 1]:
            found = np.abs(np.log([ratios(row, lines, added) for row in rows])).mean(axis=0)
            print(f"| {radius:g} | {name} | " + " | ".join(f"{100 * value:.1f} %" for value in found) + " |")
    print()


def main():
    program, out = pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    if sys.argv[1] == "draw":
        print(",".join(patterns(study.Fretwork(program, out))))
        return
    by_radius = {}
    for row in study.read_rows(out / "solids.csv"):
        by_radius.setdefault(float(row["fillet_mm"]), []).append(row)
    lines = {}
    for row in by_radius[0.0]:
        bars = scan.centrelines(program, row["pattern"])
        lines[row["pattern"]] = bars, frames.reaches(bars, study.SIDE)
    print_gains(by_radius)
    print_summary(by_radius, lines)
    print_errors(by_radius, lines)


if __name__ == "__main__":
    main()
