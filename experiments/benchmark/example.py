#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A method from outside, as a submission: compass search in the box, from its middle.

Usage: example.py RELEASE OUT.csv [--budget 300]
Example: example.py out/dataset/paper7 out/benchmark/compass.csv
"""
import argparse
import csv
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from objective import PARAMETERS, Release  # noqa: E402

LEAST_STEP = 1e-3  # of the box


def parameters_at(problem, point):
    """Parameters at a point of the unit box; A, I2, I3 and J are spread evenly in their logarithms."""
    low, high = problem.lower, problem.upper
    return numpy.concatenate([low[:4] * (high[:4] / low[:4]) ** point[:4], low[4:] + point[4:] * (high[4:] - low[4:])])


def compass(problem, budget):
    """The best parameters found by steps along one variable, which halve when none helps."""
    point, step = numpy.full(len(PARAMETERS), 0.5), 0.25
    best = problem(parameters_at(problem, point))
    while step >= LEAST_STEP:
        is_better = False
        for change in step * numpy.concatenate([numpy.eye(len(point)), -numpy.eye(len(point))]):
            if problem.evaluations >= budget:
                return parameters_at(problem, point)
            trial = numpy.clip(point + change, 0.0, 1.0)
            value = problem(parameters_at(problem, trial))
            if value < best:
                point, best, is_better = trial, value, True
        step *= 1.0 if is_better else 0.5
    return parameters_at(problem, point)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("release", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--budget", type=int, default=300)
    options = parser.parse_args()
    release = Release(options.release)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    with options.out.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["pattern_id", "evaluations", *PARAMETERS])
        for name in sorted(release.held_out):
            problem = release.problem(name)
            found = compass(problem, options.budget)
            writer.writerow([name, problem.evaluations, *map(repr, map(float, found))])


if __name__ == "__main__":
    main()
