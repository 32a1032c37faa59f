# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve a structure in several ways, and count how each stands to the primary path in many small steps."""
import argparse
import math
import pathlib
from collections import Counter

CLAMPED = ["ux", "uy", "uz", "rx", "ry", "rz"]
BRANCHES = {"stable": ["--branch", "stable"], "snapping": ["--branch", "snapping"]}


def ways(steps):
    return {"at once": [], f"{steps} steps": ["--steps", str(steps)], **BRANCHES}


def arguments_of(description, reference_steps):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("program", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--reference-steps", type=int, default=reference_steps)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    return arguments


def displacements(result):
    return [row[:3] for row in result["displacements"]]


def verdict(found, losses, reference):
    """How a result with its losses of stability stands to the reference's result."""
    if not found["converged"]:
        same = reference["termination"] == found["termination"] == "limit-load" and math.isclose(
            found["load_factor"], reference["load_factor"], rel_tol=0.02)
        return "agree" if same else "false " + found["termination"]
    if not reference["converged"]:
        return "snapped" if losses else "other branch"
    a, b = displacements(found), displacements(reference)
    size = max(math.dist(p, (0, 0, 0)) for p in b)
    if max(math.dist(p, q) for p, q in zip(a, b)) <= 1e-3 * size:
        return "agree"
    return "left, and told" if losses or not found["stable"] else "other branch"


class Tally:
    def __init__(self, steps, reference_steps):
        self.ways, self.reference = ways(steps), ["--steps", str(reference_steps)]
        self.counts = {way: Counter() for way in self.ways}

    def add(self, name, solve):
        """Count a structure, and print its row. `solve(options)` gives the losses of stability and the result."""
        _, reference = solve(self.reference)
        row = []
        for way, options in self.ways.items():
            losses, found = solve(options)
            how = verdict(found, losses, reference)
            self.counts[way][how] += 1
            row.append(f"{how} ({found['iterations']})")
        print(f"{name:36} {reference['termination']:10} | " + " | ".join(row), flush=True)

    def print(self):
        for way, count in self.counts.items():
            print(f"{way:10}", ", ".join(f"{number} {what}" for what, number in count.most_common()))
