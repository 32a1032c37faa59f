#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do solutions at once end on the branch that many small steps end on?

Imperfect columns, Lee's frame and sine arches, each by four ways: at once, in 40 steps, on the stable branch, and
snapping; against the primary path in many small steps.
Usage: frames.py [--reference-steps N]
"""
import json
import math
import pathlib
import sys
from collections import Counter

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from module import fw  # noqa: E402
from ways import CLAMPED, Tally, reference_steps  # noqa: E402


def frame(nodes, supports, loads, prescribed=(), side=0.002, width=0.02, modulus=2e9):
    """A chain of beams of rectangular section that bends in the x-z plane."""
    return {"format": "fretwork/frame/1", "nodes": nodes,
            "materials": {"m": {"young_modulus": modulus, "poisson_ratio": 0.3}},
            "sections": {"s": {"type": "rectangle", "width": width, "height": side}},
            "beams": [{"nodes": [i, i + 1], "section": "s", "material": "m"}
                      for i in range(len(nodes) - 1)],
            "supports": supports, "loads": loads, "prescribed": list(prescribed)}


def columns(shares=(0.001, 0.004, 0.02)):
    """20 beams, 1 m; a lateral force of these shares of Euler's load; one end pushed in."""
    nodes = [[i / 20, 0, 0] for i in range(21)]
    euler = math.pi ** 2 * 2e9 * 0.02 * 0.002 ** 3 / 12
    for name, ends in (("pinned-clamped", (["ux", "uy", "uz", "rx", "rz"], ["uy", "uz", "rx", "ry", "rz"])),
                       ("guided", (CLAMPED, ["uy", "uz", "rx", "ry", "rz"]))):
        for share in shares:
            for shortening in (0.001, 0.02, 0.1, 0.3):
                supports = [{"node": 0, "fixed": ends[0]}, {"node": 20, "fixed": ends[1]}]
                supports += [{"node": i, "fixed": ["uy", "rx", "rz"]} for i in range(1, 20)]
                yield (f"{name} {share:g} {1e3 * shortening:g} mm",
                       frame(nodes, supports, [{"node": 10, "force": [0, 0, share * euler]}],
                             [{"node": 20, "ux": -shortening}]))


def lees_frame():
    """Two bars of 1.2 m at a right angle, pinned; pressed down near the corner."""
    nodes = [[0, 0, 1.2 * i / 10] for i in range(11)] + [[1.2 * i / 10, 0, 1.2] for i in range(1, 11)]
    pin = ["ux", "uy", "uz", "rx", "rz"]
    for share in (0.5, 0.9, 1.2):
        yield (f"Lee {share:g}", frame(nodes, [{"node": 0, "fixed": pin}, {"node": 20, "fixed": pin}] +
                                       [{"node": i, "fixed": ["uy", "rx", "rz"]} for i in range(1, 20)],
                                       [{"node": 12, "force": [0, 0, -18.5e3 * share]}],
                                       side=0.02, width=0.03, modulus=7.2e10))


def arches():
    """Sine arches of 24 beams, pinned or clamped, pressed down a little off the middle."""
    for ends in ("pinned", "clamped"):
        for rise in (0.01, 0.03, 0.08, 0.2):
            nodes = [[i / 24, 0, rise * math.sin(math.pi * i / 24)] for i in range(25)]
            fixed = CLAMPED if ends == "clamped" else ["ux", "uy", "uz", "rx", "rz"]
            supports = [{"node": 0, "fixed": fixed}, {"node": 24, "fixed": fixed}]
            supports += [{"node": i, "fixed": ["uy", "rx", "rz"]} for i in range(1, 24)]
            for force in (0.1, 0.5, 2.0, 8.0):
                yield (f"arch {ends} {rise:g} m {force:g} N",
                       frame(nodes, supports, [{"node": 11, "force": [0, 0, -force]}]))


def solve(problem, **options):
    return fw.solve(fw.parse_frame(json.dumps(problem)), **options).solution


def print_weak_forces():
    """How many columns end on the side of a force that is a small share of Euler's load, at once."""
    for share in (1e-4, 1e-5, 1e-6, 1e-8):
        ends = Counter()
        for _, problem in columns((share,)):
            solution = solve(problem)
            moves = solution.displacements[:, :3]
            largest = np.linalg.norm(moves, axis=1).max()
            side = "the side of the force" if moves[10, 2] > 0.01 * largest else "elsewhere"
            ends[f"{solution.termination}, {side}"] += 1
        print(f"{share:g} of Euler's load:", ", ".join(f"{number} {what}" for what, number in ends.most_common()))


def main():
    tally = Tally({"steps": 40}, {"steps": reference_steps(__doc__.splitlines()[0], 1000)})
    for name, problem in [*columns(), *lees_frame(), *arches()]:
        tally.add(name, lambda **options: solve(problem, **options))
    print_weak_forces()
    tally.print()


if __name__ == "__main__":
    main()
