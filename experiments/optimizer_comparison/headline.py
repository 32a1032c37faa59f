#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Print the table of README.md from the runs in documented/: the methods that matter on each set of patterns.

Usage: headline.py      Shares have exact 95 % intervals where each pattern has one run, else by bootstrap (measures.success_interval).
"""
import pathlib

import measures  # also finds the folder common
from csv_tables import print_table

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENTED = HERE / "documented"
OURS = "ceres-multistart"
# the best known values of problems, and files of runs on them
SETS = {"60 patterns": ("best_known.csv", "results.csv.gz"),
        "all 1,824": ("best_known_all_patterns.csv", "all_patterns_results.csv.gz", "annealing_raw_results.csv.gz"),
        "held-out": ("best_known_held_out.csv", "held_out_results.csv.gz")}
METHODS = (OURS, "gauss-newton-multistart", "slsqp", "mlsl", "bobyqa", "cma-es", "differential-evolution", "annealing-cool", "annealing-reject", "simulated-annealing", "annealing-raw")


def runs_of(files):
    """method -> problem -> runs, on calibrations, with the starts that the comparison gives."""
    known = measures.read_known(HERE / files[0])
    runs = (run for results in files[1:] for run in measures.read_runs(DOCUMENTED / results, known))
    return measures.group_with_starts(run for run in runs if run.problem.startswith("calibration/"))


def means(by_problem):
    """Cost and CPU time in ms of a run: of the means over patterns."""
    return [measures.mean_of_means(by_problem, quantity) for quantity in (lambda run: run.cost, lambda run: 1e3 * run.cpu)]


def main():
    sets = {name: runs_of(files) for name, files in SETS.items()}
    sample = sets["60 patterns"]
    starts = {name: next(number for method, number in sample if method == name) for name in METHODS}
    ours = means(sample[OURS, starts[OURS]])
    lines = []
    for name in METHODS:
        cost, cpu = means(sample[name, starts[name]])
        method = name, starts[name]
        shares = [measures.success_text(groups[method]) if method in groups else "" for groups in sets.values()]
        lines.append([f"`{name}` ({starts[name]})", *shares, f"{cost:,.0f}", f"{cpu:.3g}", f"{cost / ours[0]:.3g}", f"{cpu / ours[1]:.3g}"])
    print_table(["method (starts)", *(f"{name}, %" for name in SETS), "factorizations", "CPU, ms", "factorizations, times the default's", "CPU, times"], lines)


if __name__ == "__main__":
    main()
