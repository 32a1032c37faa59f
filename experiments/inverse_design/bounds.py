#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lower bounds of the misfit of any painting of a strip of hexagons (linear, out of the plane), beside the best of all
paintings: derivation.md, section 5. Needs numpy and cvxopt (Debian: python3-cvxopt).

Usage: inverse_design_numbers --patterns 5 --seed 1 --json | bounds.py [--tiles 4] [--targets 5] [--seed 1]
Prints a row of CSV for each target."""
import argparse
import itertools
import json
import sys

import cvxopt
import numpy as np

cvxopt.solvers.options.update(show_progress=False, abstol=1e-9, reltol=1e-8, feastol=1e-9, maxiters=200)


class Strip:
    """A row of hexagons, zigzag along x; three dofs a node (uz, rx, ry, these two times the tile's side)."""

    def __init__(self, places, tiles, side):
        self.nodes = {}
        self.members = []
        for t in range(tiles):
            centre = np.array([1.5 * side * t, np.sqrt(3.0) * side * 0.5 * (t % 2)])
            own = []
            for place in places:
                key = tuple(np.round((centre + place) * 1e6).astype(int))
                own.append(self.nodes.setdefault(key, len(self.nodes)))
            self.members.append(own)
        self.at = np.array([key for key in self.nodes]) * 1e-6
        left = self.at[:, 0] < -0.5 * side
        right = self.at[:, 0] > 1.5 * side * (tiles - 1) + 0.5 * side
        self.free = np.repeat(~left, 3)
        self.loads = np.zeros(3 * len(self.nodes))
        self.loads[0::3][right] = 1.0 / right.sum()
        self.loads = self.loads[self.free]

    def slopes(self, strains):
        """B_t of each tile: from free dofs to its strains."""
        result = []
        for own in self.members:
            pick = np.zeros((18, 3 * len(self.nodes)))
            for i, node in enumerate(own):
                pick[3 * i:3 * i + 3, 3 * node:3 * node + 3] = np.eye(3)
            result.append(strains.T @ pick[:, self.free])
        return result


def strain_basis(places, side):
    rigid = np.zeros((18, 3))
    for i, (x, y) in enumerate(places):
        rigid[3 * i:3 * i + 3] = [[1, y, -x], [0, side, 0], [0, 0, side]]
    return np.linalg.qr(rigid, mode="complete")[0][:, 3:]


def sixth_of_a_turn(strains):
    turn = np.zeros((18, 18))
    c, s = 0.5, np.sqrt(0.75)
    block = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    for i in range(6):
        j = (i + 1) % 6
        turn[3 * j:3 * j + 3, 3 * i:3 * i + 3] = block
    return strains.T @ turn @ strains


def projectors(turn):
    """Onto the four irreducible parts under a sixth of a turn."""
    parts = []
    for k in range(4):
        total = sum(np.exp(-2j * np.pi * k * j / 6) * np.linalg.matrix_power(turn, j) for j in range(6)) / 6
        parts.append((1 if k in (0, 3) else 2) * total.real)
    return parts


def turned_mean(matrix, turn):
    powers = [np.linalg.matrix_power(turn, j) for j in range(6)]
    return sum(power.T @ matrix @ power for power in powers) / 6


def symmetric_units(size):
    for i in range(size):
        for j in range(i + 1):
            unit = np.zeros((size, size))
            unit[i, j] = unit[j, i] = 1.0
            yield unit


def loewner_bound(family, weight, sign):
    """The matrix X with sign * X <= sign * K for all K, of the largest sign * trace(weight X)."""
    size = len(weight)
    units = list(symmetric_units(size))
    cost = cvxopt.matrix([-sign * float(np.sum(weight * unit)) for unit in units])
    column = np.array([sign * unit.reshape(-1) for unit in units]).T
    blocks = [cvxopt.matrix(column) for _ in family]
    heights = [cvxopt.matrix(sign * own) for own in family]
    answer = cvxopt.solvers.sdp(cost, Gs=blocks, hs=heights)
    x = sum(float(value) * unit for value, unit in zip(answer["x"], units))
    # The solver stops a hair off: a small step back makes it a bound for certain.
    worst = min(np.linalg.eigvalsh(sign * (own - x)).min() for own in family)
    return x + sign * min(0.0, worst) * 1.0001 * np.eye(size)


def intervals(family, turn, count, random):
    """Pairs A <= K <= B for all K. In coordinates in which their mean is the unit matrix, the first pair has the largest
    and the least trace, the others are the tightest along random directions."""
    mean = sum(family) / len(family)
    values, vectors = np.linalg.eigh(mean)
    root = vectors * np.sqrt(values) @ vectors.T
    inverse = np.linalg.inv(root)
    own = [inverse @ k @ inverse for k in family]
    unit = np.eye(len(mean))
    pairs = []
    for i in range(count):
        weight = unit
        if i > 0:
            direction = random.standard_normal(len(mean))
            weight = turned_mean(np.outer(direction, direction), turn) + 0.02 * unit
        low, high = (turned_mean(loewner_bound(own, weight, sign), turn) for sign in (1, -1))
        # Wider by a hair, so that B - A can be inverted where all patterns agree.
        pairs.append((root @ (low - 1e-6 * unit) @ root, root @ (high + 1e-6 * unit) @ root))
    return pairs


class Bounds:
    """Lagrangian bounds of |C u - y|^2 over K_A u + sum B_t^T s_t = F with s_t . M^-1 s_t <= s_t . e_t, e_t = B_t u, for
    every interval, on every irreducible part of every tile. With x = x0 + N z for the equilibrium, all are quadratic in z."""

    def __init__(self, slopes, loads, pairs, parts):
        self.size = slopes[0].shape[1]
        strains = slopes[0].shape[0]
        base = pairs[0][0]
        stiffness = sum(b.T @ base @ b for b in slopes)
        equilibrium = np.hstack([stiffness] + [b.T for b in slopes])
        self.offset = np.linalg.lstsq(equilibrium, loads, rcond=None)[0]
        self.directions = np.linalg.svd(equilibrium)[2][self.size:].T
        self.limits = {}
        for t, b in enumerate(slopes):
            strain = np.zeros((strains, equilibrium.shape[1]))
            strain[:, :self.size] = b
            excess = np.zeros_like(strain)
            excess[:, self.size + strains * t:self.size + strains * (t + 1)] = np.eye(strains)
            for i, (low, high) in enumerate(pairs):
                inverse = np.linalg.inv(high - low)
                own = excess + (base - low) @ strain
                for k, part in enumerate(parts):
                    answer, cause = part @ own, part @ strain
                    product = cause.T @ answer
                    self.limits[t, i, k] = self.reduced(answer.T @ inverse @ answer - 0.5 * (product + product.T))

    def reduced(self, matrix, vector=None, constant=0.0):
        """x . matrix x + 2 vector . x + constant as one symmetric matrix of (z, 1)."""
        vector = np.zeros(len(matrix)) if vector is None else vector
        n, x = self.directions, self.offset
        gradient = n.T @ (matrix @ x + vector)
        top = np.hstack([n.T @ matrix @ n, gradient[:, None]])
        bottom = np.append(gradient, x @ matrix @ x + 2 * vector @ x + constant)
        return np.vstack([top, bottom])

    def bound(self, observe, wanted, groups):
        """The largest g with |C u - y|^2 - g + sum of multiplier * limit >= 0 everywhere; the limits of a group share a
        multiplier."""
        matrix = np.zeros((len(self.offset),) * 2)
        matrix[:self.size, :self.size] = observe.T @ observe
        vector = np.zeros(len(self.offset))
        vector[:self.size] = -observe.T @ wanted
        goal = self.reduced(matrix, vector, wanted @ wanted)
        scale = wanted @ wanted
        limits = [sum(self.limits[i] for i in group) for group in groups]
        sizes = [np.linalg.norm(limit) / scale for limit in limits]
        unit = np.zeros_like(goal)
        unit[-1, -1] = scale
        columns = np.array([unit.reshape(-1)] + [-l.reshape(-1) / s for l, s in zip(limits, sizes)]).T
        count = len(limits)
        balance = 1.0 / np.sqrt(np.maximum(np.abs(np.diag(goal)), 1e-6 * scale))
        squeeze = np.outer(balance, balance).reshape(-1)
        answer = cvxopt.solvers.sdp(
            cvxopt.matrix([-1.0] + [0.0] * count),
            Gl=cvxopt.matrix(np.hstack([np.zeros((count, 1)), -np.eye(count)])), hl=cvxopt.matrix(np.zeros(count)),
            Gs=[cvxopt.matrix(columns * squeeze[:, None])], hs=[cvxopt.matrix(goal * np.outer(balance, balance))])
        if answer["x"] is None:
            return float("nan"), answer["status"]
        x = np.array(answer["x"]).ravel()
        multipliers = np.maximum(x[1:], 0.0)
        total = goal + sum(m / s * l for m, s, l in zip(multipliers, sizes, limits))
        return max(0.0, self.certified(total)) / scale, answer["status"]

    @staticmethod
    def certified(total):
        """The least value over z for these multipliers, which is a bound whatever the solver's accuracy; -inf if the
        form is not convex."""
        form, gradient, constant = total[:-1, :-1], total[:-1, -1], total[-1, -1]
        values, vectors = np.linalg.eigh(form)
        if values.min() < -1e-9 * values.max():
            return -np.inf
        coordinates = vectors.T @ gradient
        kept = values > 1e-9 * values.max()
        return constant - np.sum(coordinates[kept] ** 2 / values[kept])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tiles", type=int, default=4)
    parser.add_argument("--targets", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    data = json.load(sys.stdin)
    places, side = np.array(data["nodes"]), data["length"]
    strains = strain_basis(places, side)
    family = [strains.T @ np.array(k).reshape(18, 18) @ strains for k in data["stiffness"]]
    strip = Strip(places, arguments.tiles, side)
    slopes = strip.slopes(strains)
    observe = np.eye(strip.free.sum())[0::3]
    shapes = {}
    for painting in itertools.product(range(len(family)), repeat=arguments.tiles):
        stiffness = sum(b.T @ family[p] @ b for b, p in zip(slopes, painting))
        shapes[painting] = observe @ np.linalg.solve(stiffness, strip.loads)
    turn = sixth_of_a_turn(strains)
    random = np.random.default_rng(arguments.seed)
    bounds = Bounds(slopes, strip.loads, intervals(family, turn, 6, np.random.default_rng(arguments.seed)), projectors(turn))
    keys = list(bounds.limits)
    first = [key for key in keys if key[1] == 0]
    one = [first]
    per_tile = [[key for key in first if key[0] == t] for t in range(arguments.tiles)]
    per_part = [[key] for key in first]
    per_interval = [[key for key in keys if key[:2] == (t, i)] for t in range(arguments.tiles) for i in range(6)]
    x = strip.at[strip.free.reshape(-1, 3)[:, 0]][:, 0] / (1.5 * side * arguments.tiles)
    middle = np.median([shape[-1] for shape in shapes.values()])
    for target in range(arguments.targets):
        a, b = random.uniform(-0.6, 0.6, 2)
        wanted = x ** 2 * (1 + a * x + b * x ** 2)
        wanted *= middle * random.uniform(0.7, 1.4) / np.abs(wanted).max()
        scale = wanted @ wanted
        best = min(np.sum((shape - wanted) ** 2) for shape in shapes.values()) / scale
        uniform = min(np.sum((shapes[(p,) * arguments.tiles] - wanted) ** 2) for p in range(len(family))) / scale
        row = [f"{value:.6g}" for value in (uniform, best)]
        for groups in (one, per_tile, per_part, per_interval):
            value, status = bounds.bound(observe, wanted, groups)
            row.append(f"{value:.6g}")
        print(",".join([str(arguments.tiles), str(len(family)), str(arguments.seed), str(target)] + row), flush=True)


main()
