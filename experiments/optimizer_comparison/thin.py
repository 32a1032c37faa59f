#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Thin the traces of a table of runs to the points at which a level is first reached, and the last.

Usage: thin.py RESULTS.csv KNOWN.csv OUT.csv.gz [--ends]     With --ends the last point alone, which is all that summary.py looks at.
Levels are all targets of the analysis and, above them, a fifth of a decade
apart: every table of analyse.py comes out the same from what is left, and its figures but for that fifth, high up.
"""
import csv
import gzip
import io
import sys

import measures
from csv_tables import each_row

ABOVE_TARGETS = tuple(10.0 ** (fifth / 5) for fifth in range(1, 16))
LEVELS = sorted({*ABOVE_TARGETS, *measures.PROFILE_TARGETS, *measures.TARGETS, measures.ANALYTIC_TARGET}, reverse=True)


def thinned(trace, gap_of):
    """`cost:value ..`, costs ascending and values descending."""
    points = trace.split()
    kept = []
    missed = 0  # levels before this one are reached
    for point in points:
        gap = gap_of(float(point.split(":")[1]))
        hit = missed
        while hit < len(LEVELS) and gap <= LEVELS[hit]:
            hit += 1
        if hit > missed:
            kept.append(point)
            missed = hit
    return " ".join(kept if not points or (kept and kept[-1] == points[-1]) else kept + points[-1:])


def main():
    arguments = [word for word in sys.argv[1:] if word != "--ends"]
    if len(arguments) != 3:
        sys.exit(__doc__)
    source, known_path, target = arguments
    ends_only = "--ends" in sys.argv
    known = measures.read_known(known_path)
    text = io.StringIO()
    writer = None
    for row in each_row(source):
        if writer is None:
            writer = csv.DictWriter(text, row, lineterminator="\n")
            writer.writeheader()
        trace = " ".join(row["trace"].split()[-1:]) if ends_only else thinned(row["trace"], known[row["problem"]].gap)
        writer.writerow(row | {"trace": trace})
    with open(target, "wb") as file, gzip.GzipFile(fileobj=file, mode="wb", mtime=0, filename="") as packed:
        packed.write(text.getvalue().encode())


if __name__ == "__main__":
    main()
