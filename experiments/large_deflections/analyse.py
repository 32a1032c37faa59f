#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the table of run.py to the tables of README.md (on standard output) and figure.svg.

Usage: analyse.py ROWS.csv FIGURE.svg
"""
import math
import statistics
import sys

import figure  # also finds the folder common
import surfaces
from csv_tables import percent, print_table, read_rows, with_numbers

MODELS = ("condensed", "corotational", "mixed:0.05", "mixed:0.1", "mixed:0.3")
TELLING = 1e-3  # errors of the mean below a tenth of a percent are of no interest to an estimate


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, math.ceil(share * len(ordered)) - 1)] if ordered else math.nan


def group_table(rows):
    kinds = [(kind, [row for row in rows if row["kind"] == kind]) for kind in surfaces.KINDS]
    weight = [row for row in rows if row["kind"] in ("cantilever", "bridge")]
    other = [row for row in rows if row["kind"] not in ("cantilever", "bridge")]
    lines = []
    for name, own in [*kinds, ("**cantilevers and bridges**", weight), ("**others**", other)]:
        if not own:
            continue
        low, high = min(r["deflection"] for r in own), max(r["deflection"] for r in own)
        cells = [f"{name} ({len(own)})", f"{100 * low:.1f} to {100 * high:.0f}"]
        for model in MODELS:
            means, largest = ([r[f"{model}_{what}"] for r in own] for what in ("mean", "largest"))
            cells.append(f"{percent(statistics.median(means))}; {percent(quantile(means, 0.9))}; {percent(max(means))} / "
                         f"{percent(max(largest))}")
        lines.append(cells)
    print_table(["load (surfaces)", "deflection, % of the span", *MODELS], lines)


def time_table(rows):
    lines = []
    for model in ("full", "full_linear", *MODELS[1:]):
        ratios = [row[f"{model}_s"] / row["condensed_s"] for row in rows]
        lines.append([model.replace("_", ", "), f"{1e3 * statistics.median(row[f'{model}_s'] for row in rows):.0f}",
                      f"{statistics.median(ratios):.1f}", f"{quantile(ratios, 0.9):.1f}", f"{max(ratios):.0f}"])
    ratios = [row["full_s"] / row["full_linear_s"] for row in rows]
    print_table(["model", "median ms", "times condensed: median", "90 % below", "most"], lines)
    print(f"`full` takes {statistics.median(ratios):.1f} times its own linear solution in the median; 90 % below {quantile(ratios, 0.9):.1f}; "
          f"most {max(ratios):.0f}.\n")


def estimate_table(rows):
    lines = []
    for name, key, truth in (("corotational, mean", "estimate_mean", "corotational_mean"),
                             ("corotational, largest", "estimate_largest", "corotational_largest"),
                             ("corotational, L2", "estimate_l2", "corotational_l2"),
                             ("condensed, mean", "condensed_by_30", "condensed_mean"),
                             ("mixed:0.05, mean", "mixed_by_30", "mixed:0.05_mean"),
                             ("corotational, mean, with 5 % in full", "by_5", "corotational_mean"),
                             ("corotational, mean, with 10 % in full", "by_10", "corotational_mean")):
        own = [row for row in rows if row[truth] >= TELLING]
        if not own:
            continue
        ratios = [row[key] / row[truth] for row in own]
        small = [r for r in ratios if r < 0.7]
        lines.append([f"{name} ({len(own)})", f"{statistics.median(ratios):.2f}", f"{min(ratios):.2f} to {max(ratios):.2f}",
                      f"{100 * sum(0.7 <= r <= 1.3 for r in ratios) / len(ratios):.0f} %",
                      f"{100 * len(small) / len(ratios):.0f} %",
                      f"{max(row[truth] - row[key] for row in own) * 100:.2g} %"])
    print_table(["estimate / truth (surfaces)", "median", "all", "0.7 to 1.3", "below 0.7", "most that is missing"], lines)


def main():
    rows = with_numbers(read_rows(sys.argv[1]), "kind", "shape", "note")
    failed = [row for row in rows if row["note"]]
    rows = [row for row in rows if not row["note"]]
    print(f"{len(rows)} surfaces of {rows and int(min(r['tiles'] for r in rows))} to {int(max(r['tiles'] for r in rows))} tiles; "
          f"{len(failed)} without an equilibrium.\n")
    group_table(rows)
    time_table(rows)
    estimate_table(rows)
    buckled = [row for row in rows if row["buckled"] > 0]
    print(f"Tiles that buckle inside: on {len(buckled)} surfaces.\n")
    for row in failed:
        print(f"Without a result: {row['number']} ({row['kind']}, {row['shape']}): {row['note']}")
    open(sys.argv[2], "w").write(figure.errors_over_deflection(rows, MODELS))


if __name__ == "__main__":
    main()
