#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Predict plate constants of the held-out patterns from their edges by ridge regression: a first number for learners.

Usage: predict.py RELEASE OUT.csv [--features none|edges|pairs]
Example: predict.py out/dataset/paper7 out/benchmark/ridge-pairs.csv --features pairs
`none` predicts the mean, `edges` has one column for each candidate edge, `pairs` also one for each two edges that a pattern has. The penalty is
chosen by five-fold cross-validation on the patterns that are not held out. Stiffness is predicted in logarithms.
"""
import argparse
import itertools
import pathlib
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parent / "dataset"))
sys.path.insert(0, str(HERE.parent / "common"))
from csv_tables import write_table  # noqa: E402
from load import load  # noqa: E402
from score import RATIOS, STIFFNESS  # noqa: E402

PENALTIES = tuple(10.0**power for power in range(-3, 4))
FOLDS = 5


def words_of(pattern_id, kind):
    """What a pattern is described by."""
    edges = sorted(pattern_id.split("+"))
    return {"none": [], "edges": edges, "pairs": edges + [" ".join(pair) for pair in itertools.combinations(edges, 2)]}[kind]


def features(patterns, kind, vocabulary):
    table = numpy.zeros((len(patterns), len(vocabulary)))
    at = {word: place for place, word in enumerate(vocabulary)}
    for row, name in enumerate(patterns):
        table[row, [at[word] for word in words_of(name, kind) if word in at]] = 1.0
    return table


def fit(table, targets, penalty):
    """Ridge regression with a free constant: weights and constant."""
    centre, mean = table.mean(axis=0), targets.mean(axis=0)
    shifted = table - centre
    weights = numpy.linalg.solve(shifted.T @ shifted + penalty * numpy.eye(table.shape[1]), shifted.T @ (targets - mean))
    return weights, mean - centre @ weights


def validated_penalty(table, targets):
    """The penalty of least squared error in cross-validation; each target has its own spread as the unit."""
    folds, scale = numpy.arange(len(table)) % FOLDS, targets.std(axis=0)

    def error(penalty):
        total = 0.0
        for fold in range(FOLDS):
            weights, constant = fit(table[folds != fold], targets[folds != fold], penalty)
            total += (((table[folds == fold] @ weights + constant - targets[folds == fold]) / scale) ** 2).sum()
        return total

    return min(PENALTIES, key=error)


def targets_of(patterns, properties):
    return numpy.array([[*(numpy.log(properties[name][key]) for key in STIFFNESS), *(properties[name][key] for key in RATIOS)] for name in patterns])


def predict(patterns, properties, held_out, kind):
    """Rows of a submission."""
    training = [name for name in patterns if name not in held_out]
    wanted = [name for name in patterns if name in held_out]
    vocabulary = sorted({word for name in training for word in words_of(name, kind)})
    table, targets = features(training, kind, vocabulary), targets_of(training, properties)
    weights, constant = fit(table, targets, validated_penalty(table, targets))
    found = features(wanted, kind, vocabulary) @ weights + constant
    found[:, :len(STIFFNESS)] = numpy.exp(found[:, :len(STIFFNESS)])
    return [[name, *map(float, row)] for name, row in zip(wanted, found)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("release", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--features", choices=("none", "edges", "pairs"), default="pairs")
    options = parser.parse_args()
    arrays, properties, held_out = load(options.release)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    write_table(options.out, ["pattern_id", *STIFFNESS, *RATIOS],
                predict([str(name) for name in arrays["patterns"]], properties, held_out, options.features))


if __name__ == "__main__":
    main()
