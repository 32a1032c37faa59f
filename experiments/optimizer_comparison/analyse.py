#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a table of runs to tables, figures and a report in one HTML file.

Usage: analyse.py RESULTS.csv KNOWN.csv OUT [--ours NAME] [--annealing NAME]
"""
import argparse
import html
import math
import pathlib
import sys

try:
    import numpy as np
except ModuleNotFoundError as missing:
    sys.exit(f"analyse.py needs {missing.name}: Debian's packages python3-numpy, python3-scipy and python3-matplotlib")

import figures
import measures  # also finds the folder common
from csv_tables import write_table
from measures import SUCCESS, TARGETS

BELOW_KNOWN = 1e-9  # a gap that is not rounding


def success(runs):
    return measures.success_rate(runs, SUCCESS)


def family(problem):
    return problem.split("/")[0]


def number(value, digits=3):
    if isinstance(value, str):
        return value
    if value is None or math.isnan(value):
        return "-"
    if math.isinf(value):
        return "never"
    if value != 0.0 and (abs(value) < 1e-3 or abs(value) >= 1e6):
        return f"{value:.{digits - 1}e}"
    return f"{value:.{digits}g}" if abs(value) < 1000 else f"{value:.0f}"


def shared_problems(groups):
    """Problems that every method has run on: only there may all be compared."""
    return sorted(set.intersection(*(set(by_problem) for by_problem in groups.values()))) if groups else []


def restrict(groups, problems):
    return {name: {problem: by_problem[problem] for problem in problems} for name, by_problem in groups.items()}


def in_order(groups):
    """Alike methods beside each other; those that the figures do not know come last."""
    known = [name for name in figures.ORDER if name in groups]
    return {name: groups[name] for name in known + sorted(set(groups) - set(known))}


class Analysis:
    def __init__(self, groups, known, ours, annealing):
        self.known = known
        self.problems = shared_problems(groups)
        self.groups = in_order(restrict(groups, self.problems))
        self.ours = ours
        self.annealing = annealing
        self.runtimes = {name: [(self.pooled(by_problem, target), *measures.bootstrap_runtime(by_problem, target))
                                for target in TARGETS] for name, by_problem in self.groups.items()}

    @staticmethod
    def all_runs(by_problem):
        return [run for runs in by_problem.values() for run in runs]

    def pooled(self, by_problem, target):
        return measures.average_runtime(self.all_runs(by_problem), target)

    def milliseconds(self):
        """The mean CPU time that a unit of cost takes each method."""
        runs = {name: self.all_runs(by_problem) for name, by_problem in self.groups.items()}
        return {name: 1e3 * sum(run.cpu for run in of_one) / sum(run.cost for run in of_one) for name, of_one in runs.items()}

    def runtime_table(self):
        header = ["optimizer"] + [f"{what} {100 * target:g} %" for target in TARGETS
                                  for what in ("aRT to", "low", "high")]
        return header, [[name] + [value for entry in entries for value in entry]
                        for name, entries in self.runtimes.items()]

    def final_table(self):
        header = ["optimizer", "starts", "runs", "median gap", "quartile 1", "quartile 3", "best so far within 1 %",
                  "best so far within 0.1 %", "low", "high", "last point within 0.1 %", "patterns within 0.1 % (median run)",
                  "patterns never within 0.1 %", "mean cost", "mean CPU ms", "us per factorization", "failed evaluations",
                  "budget spent", "stalled"]
        rows = []
        for name, by_problem in self.groups.items():
            runs = self.all_runs(by_problem)
            gaps = [run.gap for run in runs]
            starts = runs[0].starts
            # Where a method starts several times, its last point is that of the last start, which means nothing.
            last = math.nan if starts > 1 else float(np.mean([self.known[run.problem].gap(run.last) <= SUCCESS for run in runs]))
            cost = sum(run.cost for run in runs)
            cpu = sum(run.cpu for run in runs)
            rows.append([name, starts, len(runs), float(np.median(gaps)), *map(float, np.quantile(gaps, [0.25, 0.75])),
                         measures.success_rate(runs, 1e-2), success(runs), *map(float, measures.success_interval(by_problem, SUCCESS)), last,
                         float(np.mean(measures.median_gaps(by_problem, self.problems) <= SUCCESS)),
                         measures.never_hit(by_problem, SUCCESS), cost / len(runs),
                         1e3 * cpu / len(runs), 1e6 * cpu / cost, sum(run.failures for run in runs),
                         *(float(np.mean([run.termination == end for run in runs])) for end in ("budget-spent", "stalled"))])
        return header, rows

    def budget_table(self):
        header = ["optimizer"] + [f"within 0.1 % after {budget}" for budget in measures.BUDGETS]
        return header, [[name] + [measures.share_within_budget(self.all_runs(by_problem), SUCCESS, budget)
                                  for budget in measures.BUDGETS] for name, by_problem in self.groups.items()]

    def calibrators(self):
        return [self.ours] + [other for other in figures.OURS if other in self.groups and other != self.ours]

    def test_table(self):
        header = ["calibrator", "optimizer", "Wilcoxon p", "p by Holm", "calibrator is better (ties count half)",
                  "patterns that differ"]
        rows = []
        for calibrator in self.calibrators():
            ours = measures.median_gaps(self.groups[calibrator], self.problems)
            names = [name for name in self.groups if name != calibrator]
            pairs = [measures.compare_pairs(ours, measures.median_gaps(self.groups[name], self.problems)) for name in names]
            adjusted = measures.holm(np.array([p for p, _, _ in pairs]))
            rows += [[calibrator, name, p, float(q), better, differing]
                     for name, (p, better, differing), q in zip(names, pairs, adjusted)]
        return header, rows

    def ratio_table(self):
        """What each variant of annealing costs over each calibrator, on the runs of this table alone."""
        rows = []
        for name in self.calibrators():
            for other in (other for other in self.groups if other in figures.ANNEALING):
                row = [name, other, success(self.all_runs(self.groups[other]))]
                for quantity in (lambda run: run.cost, lambda run: run.cpu):
                    row += [self.ratio(other, name, quantity),
                            *map(float, measures.bootstrap_ratio(self.groups[other], self.groups[name], quantity))]
                rows.append(row)
        return (["calibrator", "annealing", "its runs within 0.1 %", "factorizations, times", "low", "high", "CPU time, times", "low",
                 "high"], rows)

    def ratio(self, theirs, ours, quantity):
        return measures.ratio_of_means(self.groups[theirs], self.groups[ours], quantity)

    def verdicts(self):
        """The targets for this project's calibrators: share within 0.1 %, and cost and CPU time beside annealing's."""
        theirs = self.groups[self.annealing]
        rows = []
        for name in self.calibrators():
            ours = self.groups[name]
            share = (success(self.all_runs(ours)), *measures.success_interval(ours, SUCCESS))
            rows.append([name, "runs within 0.1 % of the best known", 0.99, *share])
            for what, wanted, quantity in (("factorizations", 50, lambda run: run.cost), ("CPU time", 25, lambda run: run.cpu)):
                rows.append([name, f"{what} of {self.annealing} over its own", wanted, self.ratio(self.annealing, name, quantity),
                             *measures.bootstrap_ratio(theirs, ours, quantity)])
        return (["calibrator", "claim", "wanted", "measured", "low", "high", "met"],
                [[name, claim, f">= {wanted}", measured, float(low), float(high), "yes" if measured >= wanted else "no"]
                 for name, claim, wanted, measured, low, high in rows])


def of_family(runs, name):
    """Grouped; a method that has not run on the family is not among them."""
    return measures.group([run for run in runs if family(run.problem) == name])


def family_table(groups, target):
    """Success and aRT of every method on the problems of a family whose optimum is known."""
    problems = shared_problems(groups)
    header = ["optimizer", "problems", f"success within {target:g} of the scale", "aRT",
              "median miss of the optimum, share of the box"]
    rows = []
    for name, by_problem in in_order(groups).items():
        runs = [run for problem in problems for run in by_problem[problem]]
        if runs:
            rows.append([name, len(problems), measures.success_rate(runs, target),
                         measures.average_runtime(runs, target), float(np.median([run.distance for run in runs]))])
    return header, rows


def better_than_known(runs, known):
    """The least gap of each pair of a problem and a method that is below zero by more than rounding."""
    least = {}
    for run in runs:
        pair = (run.problem, run.optimizer)
        least[pair] = min(least.get(pair, 0.0), known[run.problem].gap(run.best))
    return [[*pair, gap] for pair, gap in sorted(least.items()) if gap < -BELOW_KNOWN]


def html_table(header, rows):
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in header)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(number(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<div class=wide><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table></div>"


STYLE = """body{font:15px/1.5 'DejaVu Sans',sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}
h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em}.wide{overflow-x:auto}table{border-collapse:collapse;font-size:12px}
th{text-align:left;border-bottom:2px solid #444;padding:3px 8px;vertical-align:bottom}td{padding:2px 8px;border-bottom:1px solid #ddd;
white-space:nowrap;font-variant-numeric:tabular-nums}figure{margin:1.5em 0}svg{max-width:100%;height:auto}figcaption{font-size:13px;color:#444}"""


def report(title, sections):
    parts = [f"<!doctype html><html lang=en><meta charset=utf-8><title>{html.escape(title)}</title><style>{STYLE}</style>"
             f"<h1>{html.escape(title)}</h1>"]
    for heading, text, content in sections:
        parts.append(f"<h2>{html.escape(heading)}</h2><p>{html.escape(text)}</p>{content}")
    return "\n".join(parts) + "\n"


def figure(name, svg, out):
    (out / f"{name}.svg").write_text('<?xml version="1.0" encoding="utf-8"?>\n' + svg)
    return f"<figure>{svg}</figure>"


def sections_of(analysis, runs, known, out):
    tables = {"verdicts": analysis.verdicts(), "final": analysis.final_table(), "runtimes": analysis.runtime_table(),
              "budgets": analysis.budget_table(), "tests": analysis.test_table(), "ratios": analysis.ratio_table()}
    for name, (header, rows) in tables.items():
        write_table(out / f"{name}.csv", header, rows)
    count = len(analysis.problems)
    repetitions = max(len(r) for by_problem in analysis.groups.values() for r in by_problem.values())
    yield ("What was run", f"{len(runs)} runs; {count} calibration problems on which all {len(analysis.groups)} methods have "
           f"run, with up to {repetitions} repetitions of each method that uses the seed. Every method is scored on the paper's "
           "objective E, unsmoothed; cost is counted in stiffness factorizations, and a value with derivatives costs one as well, "
           "since they come from the same factorization. Definitions are in README.md. Low and high: 95 % intervals, of shares exact where "
           "each pattern has one run, else by bootstrap.",
           html_table(*tables["verdicts"]))
    yield ("Annealing's cost over the calibrators'", "Ratios of the means over patterns, with 95 % bootstrap intervals, for every "
           "variant of annealing in this table.", html_table(*tables["ratios"]))
    profiles = {name: measures.data_profile(by_problem) for name, by_problem in analysis.groups.items()}
    yield ("Data profile", "Share of all pairs of a pattern and a target (41 targets, 100 % to 0.1 % above the best known E) that "
           "are hit within a cost. A run that misses is restarted, by drawing from the runs there are.",
           figure("data_profile", figures.data_profiles(profiles), out))
    yield ("The same in CPU time", "Cost times the mean CPU time that a unit of it takes the method: derivatives, and a method's own "
           "work, are not free. An approximation: within a run, values cost less than derivatives, and come first in some methods.",
           figure("data_profile_time", figures.data_profiles(profiles, analysis.milliseconds()), out))
    yield ("Performance profile", "For 0.1 %: share of patterns on which a method's aRT is within a factor of the least one. With "
           "many methods the order of two of them can depend on a third (Gould and Scott 2016): see the pairs below.",
           figure("performance_profile", figures.performance_profiles(analysis.groups, SUCCESS), out))
    yield ("Average runtime to three targets", "All cost over the number of hits, pooled over patterns; intervals from 1,000 "
           "bootstrap draws of patterns and runs.", figure("runtimes", figures.runtimes(analysis.runtimes, TARGETS), out)
           + html_table(*tables["runtimes"]))
    yield ("At equal cost", "Share of runs, without restarts, that are within 0.1 % of the best known E after so many factorizations.",
           html_table(*tables["budgets"]))
    yield ("Where runs end", "Circle: median; bar: quartiles; points: runs (of many, evenly over their ranks, the last among them); "
           "dashed: 0.1 %. What lies outside is drawn at the edge. The published annealing ends on its last point, not on the best "
           "that it saw: both are counted; for methods of several starts the last point is that of the last start, and is left out.",
           figure("final_gaps", figures.final_gaps(analysis.groups), out) + html_table(*tables["final"]))
    yield ("On the way", "The median run, best so far.", figure(
        "convergence", figures.convergence(analysis.groups, ["ceres-multistart", "gauss-newton-multistart",
                                                             "ceres-residuals", "ceres-smoothed", "slsqp", "mlsl", "bobyqa", "cma-es",
                                                             "simulated-annealing", "annealing-cool", "random-search"]), out))
    yield ("Pairs", "This project's calibrators beside each other method: Wilcoxon's signed-rank test of the gaps, paired by pattern "
           "(median of the repetitions), two-sided, corrected by Holm; and the share of patterns on which the calibrator ends lower. "
           "Gaps that differ by at most 0.1 % are ties.", html_table(*tables["tests"]))
    for name, target in (("synthetic", 1e-3), ("analytic", measures.ANALYTIC_TARGET)):
        header, rows = family_table(of_family(runs, name), target)
        if rows:
            write_table(out / f"{name}.csv", header, rows)
            yield (f"Problems with a known optimum: {name}", "Success and aRT within the given share of the scale that README.md "
                   "defines. Synthetic problems fit the model to itself, so parameters must be recovered.",
                   html_table(header, rows))
    better = better_than_known(runs, known)
    yield ("Better than the best known", f"{len(better)} pairs of a problem and a method lie below the frozen best known value.",
           html_table(["problem", "optimizer", "gap"], better) if better else "")


def main():
    parser = argparse.ArgumentParser(description="From a table of runs to tables, figures and a report.")
    parser.add_argument("results")
    parser.add_argument("known")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--ours", default=figures.OURS[0])
    parser.add_argument("--annealing", default="simulated-annealing")
    options = parser.parse_args()
    known = measures.read_known(options.known)
    runs = measures.read_runs(options.results, known)
    calibrations = of_family(runs, "calibration")
    missing = {options.ours, options.annealing} - set(calibrations)
    if missing:
        sys.exit(f"analyse.py: {options.results}: no calibration runs of {', '.join(sorted(missing))}")
    if not shared_problems(calibrations):
        fewest = min(calibrations, key=lambda name: len(calibrations[name]))
        sys.exit(f"analyse.py: {options.results}: no calibration problem on which all methods have run; {fewest} has run on "
                 f"{len(calibrations[fewest])} only")
    options.out.mkdir(parents=True, exist_ok=True)
    analysis = Analysis(calibrations, known, options.ours, options.annealing)
    text = report("How optimizers compare on the calibration of the paper's model",
                  sections_of(analysis, runs, known, options.out))
    (options.out / "report.html").write_text(text)
    for row in analysis.verdicts()[1]:
        print(" | ".join(number(cell) for cell in row))


if __name__ == "__main__":
    main()
