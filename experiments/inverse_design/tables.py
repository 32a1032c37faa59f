#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of run.sh as one file of rows and a table of medians."""
import collections
import pathlib
import statistics
import sys

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
    (folder.parent / "rows.csv").write_text(
        "\n".join([",".join(COLUMNS)] + [",".join(row[c] for c in COLUMNS) for row in rows]) + "\n")
    groups = collections.defaultdict(list)
    for row in rows:
        groups[(row["method"], int(row["tiles"]), row["target"], row["patterns"])].append(row)
    print("| search | tiles | target | patterns | runs | u_max / span | best uniform, % | error, % | ratio | worst ratio | solutions | swaps scored | units | units to half | tiles as hidden | mixtures, % | curvatures outside, % |")
    print("|---" * 17 + "|")
    for key in sorted(groups, key=lambda k: (k[1], k[2], k[0])):
        group = groups[key]
        ratios = [float(row["ratio"]) for row in group]
        uniform, error = median(group, "uniform"), median(group, "error")
        print(f"| {key[0]} | {key[1]} | {key[2]} | {key[3]} | {len(group)} | {text(median(group, 'bent'), 2)} | "
              f"{text(uniform and 100 * uniform)} | {text(error and 100 * error)} | {text(statistics.median(ratios))} | "
              f"{text(max(ratios))} | {text(median(group, 'solutions'))} | {text(median(group, 'swaps') or None)} | {text(median(group, 'units'))} | "
              f"{text(median(group, 'half_units'))} | {text(median(group, 'equal'))} | {percent(median(group, 'relaxed'))} | "
              f"{percent(median(group, 'outside'))} |")


main()
