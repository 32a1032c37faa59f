#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Print a table of runs as one row a method and number of starts, the quickest first.

Usage: summary.py KNOWN.csv RESULTS.csv..     The results may be compressed by gzip. Gaps are (E - best known) / best known.
"""
import sys

import numpy as np

import measures  # also finds the folder common
from csv_tables import print_table


def rows(runs):
    def seconds(row):
        return np.mean([run.cpu for runs in row[1].values() for run in runs])

    for (name, starts), by_problem in sorted(measures.group_with_starts(runs).items(), key=seconds):
        of_one = [run for runs in by_problem.values() for run in runs]
        gaps = np.array([run.gap for run in of_one])
        yield (f"`{name}` ({starts})", f"{len(by_problem):,}", f"{len(of_one):,}", measures.success_text(by_problem),
               f"{100 * np.mean(gaps <= 1e-2):.1f}", f"{np.sum(gaps > measures.SUCCESS):,}", f"{100 * gaps.max():.2g}", f"{np.mean([run.cost for run in of_one]):,.0f}",
               f"{1e3 * np.mean([run.cpu for run in of_one]):.3g}",
               f"{1e6 * sum(run.cpu for run in of_one) / sum(run.cost for run in of_one):.3g}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    known = measures.read_known(sys.argv[1])
    runs = [run for path in sys.argv[2:] for run in measures.read_runs(path, known)]
    print_table(["method (starts)", "problems", "runs", "within 0.1 %, % (95 %)", "within 1 %, %", "misses", "worst gap, %", "factorizations, mean",
                 "CPU, ms", "us a factorization"], rows(runs))


if __name__ == "__main__":
    main()
