#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Print the tables of results.md from the tables and the raw runs in documented/.

Usage: page_tables.py TABLE..     of final budgets held-out annealing annealing-raw analytic
"""
import math
import pathlib
import sys

import numpy as np

import figures
import measures  # also finds the folder common
from csv_tables import print_table, read_rows

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENTED = HERE / "documented"
BUDGET_METHODS = ("ceres-multistart", "gauss-newton-multistart", "slsqp", "mlsl", "bobyqa", "cma-es", "crs2", "differential-evolution", "annealing-cool",
                  "simulated-annealing")
ANALYTIC_METHODS = ("ceres-multistart", "gauss-newton-multistart", "ceres-residuals", "slsqp", "mlsl", "direct-l", "bobyqa", "subplex", "crs2", "cma-es",
                    "differential-evolution", "simulated-annealing", "annealing-reject", "annealing-cool", "annealing-then-ceres")
FUNCTIONS = ("sphere", "beale", "rosenbrock", "powell-singular", "levy", "distance-sum", "rastrigin")


def amount(text):
    """Three digits, or all digits before the point."""
    value = float(text)
    return "never" if math.isinf(value) else f"{value:,.0f}" if value >= 99.95 else f"{value:.3g}"


def tenth_percent(text):
    return f"{100 * float(text):.1f}"


def between(low, high, words=amount):
    return f"({words(low)} to {words(high)})"


def final():
    runtimes = {row["optimizer"]: row for row in read_rows(DOCUMENTED / "runtimes.csv")}
    lines = []
    for row in read_rows(DOCUMENTED / "final.csv"):
        of_target = runtimes[row["optimizer"]]
        ends = [f"{tenth_percent(row[column])} {word}" for column, word in (("budget spent", "budget"), ("stalled", "stalled")) if float(row[column]) > 0.0]
        runtime = amount(of_target["aRT to 0.1 %"])
        if runtime != "never":
            runtime += " " + between(of_target["low 0.1 %"], of_target["high 0.1 %"])
        lines.append([f"`{row['optimizer']}` ({row['starts']})", amount(row["runs"]),
                      f"{tenth_percent(row['best so far within 0.1 %'])} {between(row['low'], row['high'], tenth_percent)}", row["patterns never within 0.1 %"],
                      f"{float(row['median gap']):.1e}", runtime, amount(row["mean cost"]), f"{float(row['mean CPU ms']):.3g}", ", ".join(ends)])
    print_table(["method (starts)", "runs", "within 0.1 %, % (95 %)", "patterns never", "median gap", "aRT to 0.1 % (95 %)", "cost", "CPU, ms", "ends otherwise"], lines)


def budgets():
    rows = {row["optimizer"]: row for row in read_rows(DOCUMENTED / "budgets.csv")}
    lines = [[f"`{name}`", *(tenth_percent(rows[name][f"within 0.1 % after {budget}"]) for budget in measures.BUDGETS)] for name in BUDGET_METHODS]
    print_table(["method", *(f"{budget:,}" for budget in measures.BUDGETS)], lines)


def held_out():
    runs = measures.read_runs(DOCUMENTED / "held_out_results.csv.gz", measures.read_known(HERE / "best_known_held_out.csv"))
    groups = measures.group_with_starts(runs)
    ours = None
    lines = []
    for name, starts in sorted(groups, key=lambda method: figures.ORDER.index(method[0])):
        by_problem = groups[name, starts]
        own = [run for of_one in by_problem.values() for run in of_one]
        gaps = np.array([run.gap for run in own])
        means = [float(np.mean([getattr(run, quantity) for run in own])) for quantity in ("cost", "cpu")]
        ours = ours or means
        lines.append([f"`{name}` ({starts})", len(own), measures.success_text(by_problem), f"{100 * np.mean(gaps <= 1e-2):.1f}", f"{100 * gaps.max():.2g}",
                      amount(means[0]), f"{1e3 * means[1]:.3g}", f"{means[0] / ours[0]:.3g}", f"{means[1] / ours[1]:.3g}"])
    print_table(["method (starts)", "runs", "within 0.1 %, % (95 %)", "within 1 %, %", "worst gap, %", "factorizations", "CPU, ms",
                 "factorizations, times the default's", "CPU, times"], lines)


def annealing():
    groups = measures.group(run for run in sample() if run.problem.startswith("calibration/"))
    descents = (*figures.OURS, "slsqp")
    lines = []
    for variant in figures.ANNEALING:
        line = [f"`{variant}`", f"{100 * measures.success_rate([run for runs in groups[variant].values() for run in runs], measures.SUCCESS):.1f}"]
        for descent in descents:
            for quantity in (lambda run: run.cost, lambda run: run.cpu):
                ratio = measures.ratio_of_means(groups[variant], groups[descent], quantity)
                low, high = measures.bootstrap_ratio(groups[variant], groups[descent], quantity)
                line.append(f"{ratio:.3g} ({low:.3g} to {high:.3g})")
        lines.append(line)
    print_table(["variant", "succeeds, %", *(name for descent in descents for name in (f"factorizations over `{descent}`", "CPU"))], lines)


def annealing_raw():
    """Mean and deviation of E on all patterns, as the paper prints them."""
    known = measures.read_known(HERE / "best_known_all_patterns.csv")
    lines = []
    for budget, file in ((20000, "annealing_raw_20000_results.csv.gz"), (40000, "annealing_raw_results.csv.gz")):
        ends = np.array([run.best for run in measures.read_runs(DOCUMENTED / file, known)])
        lines.append([f"{budget:,}", f"{len(ends):,}", f"{ends.mean():.2f}", f"{ends.std():.2f}", f"{ends.std() / ends.mean():.2f}"])
    print_table(["evaluations, at most", "patterns", "mean E", "deviation", "deviation / mean"], lines)


def sample():
    """The runs on the 60 patterns, and on problems with a known optimum."""
    return measures.read_runs(DOCUMENTED / "results.csv.gz", measures.read_known(HERE / "best_known.csv"))


def analytic():
    groups = measures.group(run for run in sample() if run.problem.startswith("analytic/"))
    lines = []
    for name in ANALYTIC_METHODS:
        shares = [measures.success_rate(groups[name][f"analytic/{function}"], measures.ANALYTIC_TARGET) for function in FUNCTIONS]
        lines.append([f"`{name}`", f"{sum(share == 1.0 for share in shares)} of {len(FUNCTIONS)}", *("yes" if share == 1.0 else "no" for share in shares)])
    print_table(["method", "all", *FUNCTIONS], lines)


TABLES = {"final": final, "budgets": budgets, "held-out": held_out, "annealing": annealing, "annealing-raw": annealing_raw, "analytic": analytic}


def main():
    if len(sys.argv) < 2 or any(name not in TABLES for name in sys.argv[1:]):
        sys.exit(__doc__)
    for name in sys.argv[1:]:
        TABLES[name]()


if __name__ == "__main__":
    main()
