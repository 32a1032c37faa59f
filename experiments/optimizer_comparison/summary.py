#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Print a table of runs as one row a method and number of starts, the quickest first.

Usage: summary.py KNOWN.csv RESULTS.csv..     The results may be compressed by gzip. Gaps are (E - best known) / best known.
"""
import sys

import numpy as np

import measures


def rows(runs):
    groups = {}
    for run in runs:
        groups.setdefault((run.optimizer, run.starts), []).append(run)
    for (name, starts), of_one in sorted(groups.items(), key=lambda group: np.mean([run.cpu for run in group[1]])):
        by_problem = {}
        for run in of_one:
            by_problem.setdefault(run.problem, []).append(run)
        gaps = np.array([run.gap for run in of_one])
        low, high = measures.success_interval(by_problem, measures.SUCCESS)
        yield (f"`{name}` ({starts})", f"{len(by_problem):,}", f"{len(of_one):,}",
               f"{100 * np.mean(gaps <= 1e-3):.1f} ({100 * low:.1f} to {100 * high:.1f})", f"{100 * np.mean(gaps <= 1e-2):.1f}",
               f"{np.sum(gaps > 1e-3):,}", f"{100 * gaps.max():.2g}", f"{np.mean([run.cost for run in of_one]):,.0f}",
               f"{1e3 * np.mean([run.cpu for run in of_one]):.3g}",
               f"{1e6 * sum(run.cpu for run in of_one) / sum(run.cost for run in of_one):.3g}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    known = measures.read_known(sys.argv[1])
    runs = [run for path in sys.argv[2:] for run in measures.read_runs(path, known)]
    print("| method (starts) | problems | runs | within 0.1 %, % (95 %) | within 1 %, % | misses | worst gap, % | factorizations, mean | "
          "CPU, ms | us a factorization |")
    print("|---" * 10 + "|")
    for row in rows(runs):
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
