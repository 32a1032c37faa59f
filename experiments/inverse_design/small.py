#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How often the search of inverse_design_small found the best of all paintings. Usage: small.py BEST.csv FOUND.csv"""
import csv
import statistics
import sys


def rows(path):
    with open(path) as file:
        return {(int(row[0]), int(row[1])): row for row in csv.reader(file)}


best, found = rows(sys.argv[1]), rows(sys.argv[2])
assert best.keys() == found.keys() and best, "not of the same targets"
ratios = {key: float(found[key][2]) / float(best[key][2]) for key in best}
# The same painting from another equilibrium agrees to the solver's tolerance.
optimal = sum(ratio <= 1 + 1e-6 for ratio in ratios.values())
print(f"targets {len(ratios)}; the best painting found {optimal} times; misfit over the best: worst "
      f"{max(ratios.values()):.3f}, others {sorted(round(r, 3) for r in ratios.values() if r > 1 + 1e-6)}")
print(f"solutions: median {statistics.median(int(row[4]) for row in found.values()):.0f}, most "
      f"{max(int(row[4]) for row in found.values())}; seconds: median "
      f"{statistics.median(float(row[6]) for row in found.values()):.2f}; paintings enumerated: "
      f"{sorted({int(row[4]) for row in best.values()})}")
