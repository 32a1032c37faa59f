#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which hypothesis gives the paper's mean and deviation of E (9.7 and 9.9)? Intervals by bootstrap.

Usage: run.py PROGRAM OUT [--every N]     Goes on where it was stopped. Prints a table; rows go to OUT/objectives.csv.
--every N: every N-th pattern is taken (default 8, which takes ten minutes).
"""
import argparse
import json
import pathlib
import random
import sqlite3
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import print_table, write_table  # noqa: E402
from program import Fretwork  # noqa: E402

PAPER_MEAN, PAPER_DEVIATION = 9.7, 9.9
EVERY = 8
RESAMPLES = 2000
# what was supposed, the method, its starts, its budget
HYPOTHESES = (
    ("the optimum is printed", "ceres-multistart", 8, 20000),
    ("annealing of the logarithms", "simulated-annealing", 1, 20000),
    ("annealing of the quantities", "annealing-raw", 1, 20000),
    ("annealing of the quantities, twice as long", "annealing-raw", 1, 40000),
)


def interval(values, statistic):
    """The middle 95 % of the statistic over resampled patterns; the seed is fixed."""
    generator = random.Random(1)
    found = sorted(statistic(generator.choices(values, k=len(values))) for _ in range(RESAMPLES))
    return found[round(0.025 * (RESAMPLES - 1))], found[round(0.975 * (RESAMPLES - 1))]


def ratio(values):
    """Deviation of the population over the mean."""
    return statistics.pstdev(values) / statistics.fmean(values)


def verdict(means, ratios):
    inside = [low <= paper <= high for (low, high), paper in ((means, PAPER_MEAN), (ratios, PAPER_DEVIATION / PAPER_MEAN))]
    return {(True, True): "agrees with the paper", (False, True): "ratio agrees, mean does not", (True, False): "mean agrees, ratio does not",
            (False, False): "excluded"}[tuple(inside)]


def objectives(database, method, starts, budget):
    rows = database.execute("SELECT pattern_id, objective FROM calibration WHERE model = 'paper6' AND optimizer = ? AND starts = ? AND budget = ? "
                            "ORDER BY pattern_id", (method, starts, budget))
    return dict(rows.fetchall())


def calibrate(fretwork, every):
    if not (fretwork.folder / "sample.db").exists():
        fretwork("enumerate", "--layout", "paper7", "--library", "sample.db")
    ids = [row["id"] for row in json.loads(fretwork("library", "list", "--library", "sample.db", "--json"))["patterns"]][::every]
    for _, method, starts, budget in HYPOTHESES:
        fretwork("calibrate", "--library", "sample.db", "--patterns", ",".join(ids), "--optimizer", method, "--starts", starts, "--budget", budget)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=EVERY)
    options = parser.parse_args()
    out = options.out
    out.mkdir(parents=True, exist_ok=True)
    calibrate(Fretwork(options.program.resolve(), out), options.every)
    database = sqlite3.connect(out / "sample.db")
    rows, lines = [], []
    for words, method, starts, budget in HYPOTHESES:
        found = objectives(database, method, starts, budget)
        rows += [[method, budget, name, value] for name, value in found.items()]
        values = list(found.values())
        means, ratios = interval(values, statistics.fmean), interval(values, ratio)
        lines.append([words, budget, len(values), f"{statistics.fmean(values):.2f}", f"{means[0]:.1f} to {means[1]:.1f}", f"{ratio(values):.2f}",
                      f"{ratios[0]:.2f} to {ratios[1]:.2f}", verdict(means, ratios)])
    write_table(out / "objectives.csv", ["optimizer", "budget", "pattern_id", "objective"], rows)
    print_table(["hypothesis", "evaluations", "patterns", "mean E", "its 95 %", "deviation / mean", "its 95 %", "verdict"], lines)


if __name__ == "__main__":
    main()
