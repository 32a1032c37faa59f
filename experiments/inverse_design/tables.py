#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of run.sh as one file of rows and a table of medians."""
import collections
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import print_table, write_table  # noqa: E402

COLUMNS = ("method tiles target patterns seed bent uniform error ratio solutions full_solutions used_patterns swaps seconds unit "
           "units half_units model_error end equal relaxed outside").split()


def read_rows(folder):
    rows = []
    for path in sorted(pathlib.Path(folder).glob("*.csv")):
        values = path.read_text().strip().split(",")
        row = dict(zip(COLUMNS, values))
        if "arc" in path.stem.split("_")[1]:
            row["target"] = path.stem.split("_")[1]
        if "linear" in path.stem:
            row["target"] += " linear"
        rows.append(row)
    return rows


def median(rows, column):
    values = [float(row[column]) for row in rows if row[column] not in ("", "nan", "-nan")]
    return statistics.median(values) if values else None


def text(value, digits=3):
    return "" if value is None else f"{value:.{digits}g}"


def percent(value):
    return text(None if value is None else 100 * value)


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = read_rows(folder)
    write_table(folder.parent / "rows.csv", COLUMNS, ([row[column] for column in COLUMNS] for row in rows))
    groups = collections.defaultdict(list)
    for row in rows:
        groups[(row["method"], int(row["tiles"]), row["target"], row["patterns"])].append(row)
    header = ("search | tiles | target | patterns | runs | u_max / span | best uniform, % | error, % | ratio | worst ratio | solutions | swaps scored | "
              "units | units to half | tiles as hidden | mixtures, % | curvatures outside, %").split(" | ")
    lines = []
    for key in sorted(groups, key=lambda k: (k[1], k[2], k[0])):
        group = groups[key]
        ratios = [float(row["ratio"]) for row in group]
        uniform, error = median(group, "uniform"), median(group, "error")
        lines.append([*key, len(group), text(median(group, "bent"), 2), percent(uniform), percent(error), text(statistics.median(ratios)),
                      text(max(ratios)), text(median(group, "solutions")), text(median(group, "swaps") or None), text(median(group, "units")),
                      text(median(group, "half_units")), text(median(group, "equal")), percent(median(group, "relaxed")),
                      percent(median(group, "outside"))])
    print_table(header, lines)


main()
