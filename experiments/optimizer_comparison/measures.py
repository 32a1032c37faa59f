# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured on a table of runs. Definitions: README.md. Every random number comes from a seeded generator."""
import dataclasses
import math
import pathlib
import sys
import warnings

import numpy as np
from scipy import stats

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import each_row  # noqa: E402
from intervals import exact_interval  # noqa: E402

TARGETS = (1e-1, 1e-2, 1e-3)  # shares of the scale above the best known value
SUCCESS = TARGETS[-1]
PROFILE_TARGETS = tuple(10.0**-exponent for exponent in np.linspace(0.0, 3.0, 41))
BUDGETS = (100, 250, 500, 1000, 2500, 5000, 10000, 20000, 40000)
ANALYTIC_TARGET = 1e-6  # where the optimum is known, and exact


@dataclasses.dataclass(frozen=True)
class Run:
    problem: str
    optimizer: str
    best: float
    last: float
    distance: float  # NaN where the optimum is not known
    starts: int
    cost: int
    failures: int
    termination: str
    cpu: float
    gaps: tuple  # of (cost, gap) pairs; a gap is (value - best known) / scale

    def runtime(self, target):
        """Cost at which the gap first was at most the target; infinite if it never was."""
        return next((float(cost) for cost, gap in self.gaps if gap <= target), math.inf)

    @property
    def gap(self):
        return self.gaps[-1][1] if self.gaps else math.inf


@dataclasses.dataclass(frozen=True)
class Known:
    best: float
    scale: float

    def gap(self, value):
        return (value - self.best) / self.scale


def read_known(path):
    return {row["problem"]: Known(float(row["best_value"]), float(row["scale"])) for row in each_row(path)}


def read_runs(path, known):
    """The rows of results.csv, which may be compressed by gzip."""

    def number(text):
        return float(text) if text else math.nan

    runs = []
    for row in each_row(path):
        reference = known[row["problem"]]
        pairs = [point.split(":") for point in row["trace"].split()]
        gaps = [(int(cost), reference.gap(float(value))) for cost, value in pairs]
        if gaps:  # the trace is rounded, the value is not
            gaps[-1] = (gaps[-1][0], reference.gap(float(row["best_value"])))
        runs.append(Run(row["problem"], row["optimizer"], number(row["best_value"]), number(row["last_value"]),
                        number(row["distance"]), int(row["starts"]), int(row["cost"]), int(row["failures"]), row["termination"],
                        float(row["cpu_seconds"]), tuple(gaps)))
    return runs


def group(runs, method=lambda run: run.optimizer):
    """method -> problem -> runs, in the order of the table."""
    groups = {}
    for run in runs:
        groups.setdefault(method(run), {}).setdefault(run.problem, []).append(run)
    return groups


def group_with_starts(runs):
    """(optimizer, starts) -> problem -> runs."""
    return group(runs, lambda run: (run.optimizer, run.starts))


def spent(run, target):
    """What a run cost until the target, or in the whole if it missed it."""
    return min(run.runtime(target), float(run.cost))


def average_runtime(runs, target):
    """aRT: all cost until the target or the end, over the number of runs that hit it. Infinite if none did."""
    hits = sum(run.runtime(target) < math.inf for run in runs)
    return sum(spent(run, target) for run in runs) / hits if hits else math.inf


def bootstrap_sums(by_problem, quantities, draws, seed):
    """Row by draw, column by quantity: sums over the runs drawn. Problems are drawn with replacement, then their runs."""
    random = np.random.default_rng(seed)
    counts = np.array([len(runs) for runs in by_problem.values()])
    table = np.zeros((len(quantities), len(counts), counts.max()))
    for row, runs in enumerate(by_problem.values()):
        table[:, row, :len(runs)] = [[quantity(run) for run in runs] for quantity in quantities]
    is_run = np.arange(counts.max()) < counts[:, None]  # problems may have different numbers of runs
    sums = np.empty((draws, len(quantities)))
    for draw in range(draws):
        rows = random.integers(len(counts), size=len(counts))
        chosen = random.integers(counts[rows, None], size=(len(counts), counts.max()))
        sums[draw] = (table[:, rows[:, None], chosen] * is_run[rows]).sum(axis=(1, 2))
    return sums


def bootstrap_runtime(by_problem, target, draws=1000, seed=1):
    """95 % interval of the aRT over problems and their runs."""
    cost, hits = bootstrap_sums(by_problem, [lambda run: spent(run, target), lambda run: run.runtime(target) < math.inf],
                                draws, seed).T
    values = np.divide(cost, hits, out=np.full(draws, math.inf), where=hits > 0)
    return np.quantile(values, [0.025, 0.975], method="inverted_cdf")


def bootstrap_success(by_problem, target, draws=1000, seed=1):
    """95 % interval of the success rate over problems and their runs."""
    hits, count = bootstrap_sums(by_problem, [lambda run: run.gap <= target, lambda run: 1.0], draws, seed).T
    return np.quantile(hits / count, [0.025, 0.975], method="inverted_cdf")


def success_interval(by_problem, target):
    """95 % interval of the success rate.

    Of one run a problem it is Clopper and Pearson's, which is exact. Runs of one problem are not independent, so of more runs it is the bootstrap's;
    but where all runs hit, or none, that has no width, and it is the exact one of as many trials as there are problems.
    """
    hits = [run.gap <= target for runs in by_problem.values() for run in runs]
    if len(hits) == len(by_problem):
        return exact_interval(sum(hits), len(hits))
    if all(hits) or not any(hits):
        return exact_interval(len(by_problem) if all(hits) else 0, len(by_problem))
    return bootstrap_success(by_problem, target)


def success_text(by_problem):
    """The success rate in percent with its interval, as tables show it."""
    rate = success_rate([run for runs in by_problem.values() for run in runs], SUCCESS)
    low, high = success_interval(by_problem, SUCCESS)
    return f"{100 * rate:.1f} ({100 * low:.1f} to {100 * high:.1f})"


def mean_of_means(by_problem, quantity):
    """The mean over problems of the means over runs."""
    return float(np.mean([np.mean([quantity(run) for run in runs]) for runs in by_problem.values()]))


def ratio_of_means(theirs, ours, quantity):
    return mean_of_means(theirs, quantity) / mean_of_means(ours, quantity)


def bootstrap_ratio(theirs, ours, quantity, draws=1000, seed=1):
    """95 % interval of the ratio of two methods' means over the same problems, which are drawn with replacement."""
    random = np.random.default_rng(seed)
    pairs = np.array([[np.mean([quantity(run) for run in of_one[problem]]) for of_one in (theirs, ours)] for problem in ours])
    chosen = pairs[random.integers(len(pairs), size=(draws, len(pairs)))].mean(axis=1)
    return np.quantile(chosen[:, 0] / chosen[:, 1], [0.025, 0.975])


def never_hit(by_problem, target):
    """Problems on which no run hit the target: the pooled aRT hides them."""
    return sum(all(run.runtime(target) == math.inf for run in runs) for runs in by_problem.values())


def share_within_budget(runs, target, budget):
    return float(np.mean([run.runtime(target) <= budget for run in runs]))


def restarted_runtimes(runs, target, draws, random):
    """Runtimes of a method that is restarted until it hits the target: runs are drawn with replacement."""
    costs = np.array([spent(run, target) for run in runs])
    hits = np.array([run.runtime(target) < math.inf for run in runs])
    if not hits.any():
        return np.full(draws, math.inf)
    result = random.choice(costs[hits], size=draws)
    missed = costs[~hits]
    if len(missed):  # the number of misses before a hit is geometric; each is any of the missed runs
        misses = random.geometric(np.mean(hits), size=draws) - 1
        result += random.multinomial(misses, np.full(len(missed), 1.0 / len(missed))) @ missed
    return result


def data_profile(by_problem, targets=PROFILE_TARGETS, draws=30, seed=1):
    """Sorted runtimes of all pairs of problem and target, with simulated restarts: the ECDF's jumps."""
    random = np.random.default_rng(seed)
    return np.sort(np.concatenate([restarted_runtimes(runs, target, draws, random)
                                   for runs in by_problem.values() for target in targets]))


def performance_ratios(groups, target):
    """optimizer -> for each problem its aRT over the best method's; infinite where it never hit the target."""
    problems = sorted({problem for by_problem in groups.values() for problem in by_problem})
    table = {name: np.array([average_runtime(by_problem.get(problem, []), target) for problem in problems])
             for name, by_problem in groups.items()}
    best = np.min(list(table.values()), axis=0)
    solved = np.isfinite(best)
    return {name: np.where(solved, row, math.inf) / np.where(solved, best, 1.0) for name, row in table.items()}


def median_gaps(by_problem, problems):
    return np.array([np.median([run.gap for run in by_problem[problem]]) for problem in problems])


def holm(values):
    """p values adjusted by Holm's step-down method, in the order given."""
    order = np.argsort(values)
    adjusted = np.empty(len(values))
    largest = 0.0
    for rank, index in enumerate(order):
        largest = max(largest, min(1.0, (len(values) - rank) * values[index]))
        adjusted[index] = largest
    return adjusted


def compare_pairs(ours, theirs, tie=SUCCESS):
    """Wilcoxon's signed-rank test of paired gaps: its p; how often ours is better, a tie counting half; pairs that differ.

    Differences of at most `tie` are ties: what counts as success is not told apart. The test is Pratt's, which keeps them
    in the ranks.
    """
    difference = np.where(np.abs(ours - theirs) <= tie, 0.0, ours - theirs)
    better = float(np.mean(difference < 0.0) + 0.5 * np.mean(difference == 0.0))
    differing = int(np.count_nonzero(difference))
    if not differing:
        return 1.0, better, 0
    # Without ties among the differences and zeros the distribution is known exactly.
    method = "exact" if len(difference) <= 50 and len(set(np.abs(difference)) - {0.0}) == len(difference) else "approx"
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Sample size too small")  # as in the subset: the report says how many
        return float(stats.wilcoxon(difference, zero_method="pratt", method=method).pvalue), better, differing


def success_rate(runs, target):
    return float(np.mean([run.gap <= target for run in runs]))
