#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A straight bar by the same meshes and elements as the patterns, beside closed forms: stretching, bending and Saint-Venant's torsion.

Usage: bar_check.py [--sizes 1,0.5,0.25] [--layers 1,2] [--most SHARE] [--ccx PROGRAM]   (exit code 1 if one is off by more than SHARE)
"""
import argparse
import math
import tempfile

import cell
import solid

YOUNG, POISSON = 1000.0, 0.3
LENGTH = 8.0  # mm


def torsion_constant(width, height):
    """Timoshenko and Goodier, Theory of Elasticity, 109."""
    a, b = max(width, height), min(width, height)
    series = sum(math.tanh(n * math.pi * a / 2 / b) / n**5 for n in range(1, 40, 2))
    return a * b**3 * (1 / 3 - 64 * b / math.pi**5 / a * series)


def box(x, y, u, v):
    return [(x, y, 0.0), (x, v, 0.0), (u, v, 0.0), (u, y, 0.0)]


def bar(width, size):
    """An endless bar along x: a wide cell of which an opening above and one below leave a strip."""
    edge = 2 * width
    corners = [(0.0, -edge), (LENGTH, -edge), (LENGTH, edge), (0.0, edge)]
    openings = [box(-1, -edge - 1, LENGTH + 1, -width / 2), box(-1, width / 2, LENGTH + 1, edge + 1)]
    return cell.mesh(openings, corners, (size * width, size * width))


def stiffness(meshed, height, layers, kind, dof, program):
    """Of the whole bar against the macroscopic quantity `dof`, the others held."""
    wedges = solid.Wedges(meshed, height / 2, layers)
    slaves = {slave for slave, _ in meshed.twins}
    inside = sorted((node for node in range(len(meshed.places)) if node not in slaves), key=lambda node: meshed.places[node][1])
    low, high = inside[0], inside[-1]
    held = [(None, d) for d in (1, 2, 3) if d != dof and not (kind == solid.STRETCHING and d == 2)]
    if kind == solid.STRETCHING:
        held += [(low, 1), (low, 2), (None, 2)]
    else:
        held += [(low, 3), (high, 3)] if dof == 3 else [(low, 3)]
    with tempfile.TemporaryDirectory() as folder:
        moved = solid.macroscopic(folder, solid.deck(wedges, kind, (YOUNG, POISSON), held, (dof, 1.0)), program)
    return 2.0 / moved[dof - 1]


def errors(meshed, width, height, layers, program):
    """Of stretching, bending and torsion, relative."""
    twist = YOUNG / 2 / (1 + POISSON) * torsion_constant(width, height)
    exact = (YOUNG * width * height, YOUNG * width * height**3 / 12, twist / 4)  # the third quantity is 2 w_xy, twice the twist
    found = [stiffness(meshed, height, layers, *load, program) / LENGTH
             for load in ((solid.STRETCHING, 1), (solid.BENDING, 1), (solid.BENDING, 3))]
    return [value / wanted - 1 for value, wanted in zip(found, exact)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sizes", default="1,0.5,0.25", help="of a triangle, in widths of the bar")
    parser.add_argument("--layers", default="1,2", help="of wedges in half of the height")
    parser.add_argument("--most", type=float, default=math.inf)
    parser.add_argument("--ccx", default="ccx")
    options = parser.parse_args()
    largest = 0.0
    print("| width x height, mm | triangles | layers | stretching | bending | torsion |\n|---|---|---|---|---|---|")
    for width, height in ((2.0, 2.0), (1.0, 2.0), (3.0, 2.0)):
        for size in map(float, options.sizes.split(",")):
            meshed = bar(width, size)
            for layers in map(int, options.layers.split(",")):
                found = errors(meshed, width, height, layers, options.ccx)
                largest = max(largest, *map(abs, found))
                cells = [f"{width:g} x {height:g}", f"{size:g} w", str(layers), *(f"{100 * value:+.2f} %" for value in found)]
                print("| " + " | ".join(cells) + " |")
    raise SystemExit(1 if largest > options.most else 0)


if __name__ == "__main__":
    main()
