#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Score submissions on the held-out patterns of a release. The rules are in README.md.

Usage: score.py calibrate RELEASE SUBMISSION.csv.. [--known FILE] [--json]     columns: pattern_id,evaluations,A,I2,I3,J,theta,R
       score.py predict RELEASE SUBMISSION.csv.. [--json]                      columns: pattern_id and the four plate constants
Example: score.py calibrate out/dataset/paper7 out/benchmark/slsqp-16.csv
Prints one row of a table for each submission. A submission that breaks a rule is refused with its file and line.
"""
import argparse
import csv
import json
import math
import pathlib
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
sys.path.insert(0, str(HERE))
from csv_tables import read_rows  # noqa: E402
from intervals import exact_interval, resampled_interval  # noqa: E402
from objective import PARAMETERS, Release  # noqa: E402

TARGET = 1e-6  # of the best known E
KNOWN = HERE.parent / "optimizer_comparison" / "best_known_all_patterns.csv"
STIFFNESS = ("membrane_stiffness", "bending_stiffness")
RATIOS = ("membrane_poisson", "bending_poisson")


class Refused(SystemExit):
    def __init__(self, path, line, complaint):
        print(f"score.py: {path}:{line}: {complaint}", file=sys.stderr)
        super().__init__(2)


def read_submission(path, columns, held_out):
    """The rows of a submission as numbers, by pattern; one row for each held-out pattern."""
    try:
        with open(path, newline="") as file:
            reader = csv.DictReader(file)
            if tuple(reader.fieldnames or ()) != ("pattern_id", *columns):
                raise Refused(path, 1, f"the columns are {','.join(reader.fieldnames or ())}, expected pattern_id,{','.join(columns)}")
            rows = {}
            for line, row in enumerate(reader, 2):
                rows[row["pattern_id"]] = read_row(path, line, row, columns, held_out, rows)
    except OSError as error:
        raise Refused(path, 0, f"cannot be read: {error.strerror}") from None
    missing = sorted(held_out - set(rows))
    if missing:
        raise Refused(path, 1, f"has no row for {len(missing)} held-out patterns, such as {missing[0]}; expected one for each of held_out.txt")
    return rows


def read_row(path, line, row, columns, held_out, rows):
    name = row["pattern_id"]
    if name not in held_out:
        raise Refused(path, line, f"'{name}' is not a held-out pattern; expected one of held_out.txt")
    if name in rows:
        raise Refused(path, line, f"'{name}' has a row already; expected one")
    values = {}
    for column in columns:
        try:
            values[column] = float(row[column])
        except (TypeError, ValueError):
            raise Refused(path, line, f"{column} is '{row[column]}', expected a number") from None
        if not math.isfinite(values[column]):
            raise Refused(path, line, f"{column} is {row[column]}, expected a finite number")
    return {"line": line, **values}


# ---- calibrate ----

def best_known(path):
    return {row["problem"].removeprefix("calibration/"): float(row["best_value"]) for row in read_rows(path)}


def gap_of(path, release, name, row, known):
    """How far the submitted parameters are above the best known E, as a share of it. E is computed here, not believed."""
    problem = release.problem(name)
    if row["evaluations"] < 1 or row["evaluations"] != int(row["evaluations"]):
        raise Refused(path, row["line"], f"evaluations is {row['evaluations']:g}, expected a whole number from 1")
    for column, low, high in zip(PARAMETERS, problem.lower, problem.upper):
        slack = 1e-12 * max(abs(low), abs(high))  # of digits
        if not low - slack <= row[column] <= high + slack:
            raise Refused(path, row["line"], f"{column} is {row[column]!r}, expected {low!r} to {high!r}")
    return problem([row[column] for column in PARAMETERS]) / known[name] - 1.0


def expected_evaluations(runs):
    """All evaluations over the number of hits: the cost of restarting until the target is hit. `runs`: pairs of evaluations and whether they hit."""
    hits = sum(hit for _, hit in runs)
    return sum(evaluations for evaluations, _ in runs) / hits if hits else math.inf


def score_calibration(path, release, known):
    rows = read_submission(path, ("evaluations", *PARAMETERS), release.held_out)
    gaps = {name: gap_of(path, release, name, row, known) for name, row in rows.items()}
    runs = [(int(rows[name]["evaluations"]), gap <= TARGET) for name, gap in sorted(gaps.items())]
    hits = sum(hit for _, hit in runs)
    return {"submission": pathlib.Path(path).stem, "patterns": len(runs), "hits": hits, "share": hits / len(runs), "share_interval": exact_interval(hits, len(runs)),
            "evaluations_mean": statistics.fmean(evaluations for evaluations, _ in runs), "expected_evaluations": expected_evaluations(runs),
            "expected_interval": resampled_interval(runs, expected_evaluations), "worst_gap": max(gaps.values()),
            "below_best_known": sum(gap < -TARGET for gap in gaps.values())}


def calibration_table(scores):
    yield "| submission | patterns | hits | hits, % (exact 95 %) | evaluations, mean | expected evaluations to a hit (95 %) | worst gap, % |\n|---|---|---|---|---|---|---|"
    for s in scores:
        (low, high), (least, most) = s["share_interval"], s["expected_interval"]
        yield (f"| `{s['submission']}` | {s['patterns']} | {s['hits']} | {100 * s['share']:.1f} ({100 * low:.1f} to {100 * high:.1f}) | {s['evaluations_mean']:.0f} | "
               f"{s['expected_evaluations']:.0f} ({least:.0f} to {most:.0f}) | {100 * s['worst_gap']:.2g} |")


# ---- predict ----

def median_error(pairs):
    return statistics.median(abs(predicted - true) for predicted, true in pairs)


def explained(pairs):
    """R^2: one minus the squared errors over those of the mean; minus infinity where all true values are equal."""
    mean = statistics.fmean(true for _, true in pairs)
    spread = sum((true - mean) ** 2 for _, true in pairs)
    return 1.0 - sum((predicted - true) ** 2 for predicted, true in pairs) / spread if spread > 0.0 else -math.inf


def score_prediction(path, release):
    rows = read_submission(path, (*STIFFNESS, *RATIOS), release.held_out)
    score = {"submission": pathlib.Path(path).stem, "patterns": len(rows)}
    for name in (*STIFFNESS, *RATIOS):
        pairs = []
        for pattern, row in sorted(rows.items()):
            pair = (row[name], release.properties[pattern][name])
            if name in STIFFNESS:
                if pair[0] <= 0.0:
                    raise Refused(path, row["line"], f"{name} is {pair[0]!r}, expected a number above 0")
                pair = tuple(map(math.log, pair))
            pairs.append(pair)
        score[name] = {"error": median_error(pairs), "error_interval": resampled_interval(pairs, median_error), "r2": explained(pairs),
                       "r2_interval": resampled_interval(pairs, explained)}
    return score


def prediction_table(scores):
    yield "| submission | constant | median error (95 %) | R² (95 %) |\n|---|---|---|---|"
    for score in scores:
        for name in (*STIFFNESS, *RATIOS):
            s = score[name]
            shown = [f"{100 * math.expm1(value):.1f} %" if name in STIFFNESS else f"{value:.3f}" for value in (s["error"], *s["error_interval"])]
            yield (f"| `{score['submission']}` | {name} | {shown[0]} ({shown[1]} to {shown[2]}) | {s['r2']:.3f} ({s['r2_interval'][0]:.3f} to {s['r2_interval'][1]:.3f}) |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=("calibrate", "predict"))
    parser.add_argument("release", type=pathlib.Path)
    parser.add_argument("submissions", nargs="+")
    parser.add_argument("--known", type=pathlib.Path, default=KNOWN, help="best known E (default: those of the comparison of optimizers)")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    release = Release(options.release)
    if options.task == "calibrate":
        known = best_known(options.known)
        unknown = sorted(release.held_out - set(known))
        if unknown:
            raise SystemExit(f"score.py: {options.known}: has no best known E of {unknown[0]}")
        scores = [score_calibration(path, release, known) for path in options.submissions]
    else:
        scores = [score_prediction(path, release) for path in options.submissions]
    table = calibration_table if options.task == "calibrate" else prediction_table
    print(json.dumps(scores, indent=1) if options.json else "\n".join(table(scores)))


if __name__ == "__main__":
    main()
