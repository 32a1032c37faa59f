#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An optimizer from outside, in Python alone: a compass search from random points. It speaks the lines that
`fretwork optimizers run --command NAME=COMMAND` asks for; docs/guide/own_optimizer.md says them.

Example: fretwork optimizers run --known best_known.csv --problems calibration:6 --command 'compass=./outside.py' --optimizers compass:4 --out DIR
"""
import random


def ask(point):
    """The objective at a point within the bounds. Ends the program once the budget is spent."""
    print("value", *map(repr, point), flush=True)
    answer = input()
    if answer == "spent":
        raise SystemExit
    return float(answer)


def compass(start, lower, upper):
    """Steps along the axes, forth and back; half as long once none of them helps."""
    point, best, step = start, ask(start), 0.25
    while step > 1e-7:
        found = False
        for i, (low, high) in enumerate(zip(lower, upper)):
            for sign in (-1.0, 1.0):
                trial = list(point)
                trial[i] = min(max(trial[i] + sign * step * (high - low), low), high)
                value = ask(trial)
                if value < best:
                    point, best, found = trial, value, True
        if not found:
            step /= 2.0


def main():
    _, lower, upper, (seed,), (starts,) = [input().split()[1:] for _ in range(5)]
    lower, upper = list(map(float, lower)), list(map(float, upper))
    random.seed(int(seed))
    for _ in range(int(starts)):
        compass([random.uniform(low, high) for low, high in zip(lower, upper)], lower, upper)
    print("done", flush=True)


if __name__ == "__main__":
    main()
