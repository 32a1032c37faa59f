# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve a structure in several ways, and count how each stands to the primary path in many small steps."""
import argparse
import math
from collections import Counter

import numpy as np

CLAMPED = ["ux", "uy", "uz", "rx", "ry", "rz"]


def ways(steps):
    """Options by name; `steps` is one of them with its value, as the solver calls it."""
    (count,) = steps.values()
    return {"at once": {}, f"{count} steps": steps, "stable": {"branch": "stable"}, "snapping": {"branch": "snapping"}}


def reference_steps(description, default):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--reference-steps", type=int, default=default)
    return parser.parse_args().reference_steps


def verdict(found, reference):
    """How a solution stands to the reference's."""
    if not found.converged:
        same = reference.termination == found.termination == "limit-load" and math.isclose(
            found.load_factor, reference.load_factor, rel_tol=0.02)
        return "agree" if same else f"false {found.termination}"
    if not reference.converged:
        return "snapped" if found.stability_losses else "other branch"
    a, b = found.displacements[:, :3], reference.displacements[:, :3]
    if np.linalg.norm(a - b, axis=1).max() <= 1e-3 * np.linalg.norm(b, axis=1).max():
        return "agree"
    return "left, and told" if found.stability_losses or not found.stable else "other branch"


class Tally:
    def __init__(self, steps, reference):
        self.ways, self.reference = ways(steps), reference
        self.counts = {way: Counter() for way in self.ways}

    def add(self, name, solve):
        """Count a structure, and print its row. `solve(..)` takes options and gives a solution."""
        reference = solve(**self.reference)
        row = []
        for way, options in self.ways.items():
            found = solve(**options)
            how = verdict(found, reference)
            self.counts[way][how] += 1
            row.append(f"{how} ({found.iterations})")
        print(f"{name:36} {reference.termination:10} | " + " | ".join(row), flush=True)

    def print(self):
        for way, count in self.counts.items():
            print(f"{way:10}", ", ".join(f"{number} {what}" for what, number in count.most_common()))
