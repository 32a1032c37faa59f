# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns as endless plates of straight bars, apart from the program: to try how bars and joints may be taken, and to check the program."""
import math

import numpy as np

import geometry
import study


def _bar_stiffness(length, width, elastic):
    """In its own axes, ux uy uz rx ry rz of both ends; Euler-Bernoulli. `elastic`: what is left of its length within the plane."""
    young = study.YOUNG / 1e6
    inertia, torsion = width**4 / 12, study.torsion_constant(width)
    matrix = np.zeros((12, 12))
    along = young * width**2 / length / elastic
    twist = young / (2 * (1 + study.POISSON)) * torsion / length / elastic
    for i, k in ((0, along), (3, twist)):
        matrix[i, i] += k
        matrix[i + 6, i + 6] += k
        matrix[i, i + 6] -= k
        matrix[i + 6, i] -= k
    for (across, turn, sign), share in (((1, 5, 1.0), elastic), ((2, 4, -1.0), 1.0)):
        k = young * inertia / (length * share) ** 3
        a, b = 6 * length * sign, length**2
        dofs = [across, turn, across + 6, turn + 6]
        matrix[np.ix_(dofs, dofs)] += k * np.array([[12, a, -12, a], [a, 4 * b, -a, 2 * b], [-12, -a, 12, -a], [a, 2 * b, -a, 4 * b]])
    return matrix


def reaches(bars, side, wrapped=geometry.wrapped):
    """Of each bar how far the joints reach along it, in its widths: both ends together. `wrapped` gives nodes that are one in the endless
    pattern one name."""
    ends = {}
    for i, (a, b) in enumerate(bars):
        for here, there in ((a, b), (b, a)):
            ends.setdefault(wrapped(here, side), []).append((math.atan2(there[1] - here[1], there[0] - here[0]), i))
    found = [0.0] * len(bars)
    for leaving in ends.values():
        leaving.sort()
        gaps = geometry.gaps([angle for angle, _ in leaving])
        parting = [0.5 / math.tan(gap / 2) if gap < math.pi else 0.0 for gap in gaps]
        for k, (_, bar) in enumerate(leaving):
            found[bar] += max(parting[k], parting[k - 1])
    return found


def _macroscopic(x, y):
    """The motion of a point under unit strains and curvatures; one column each."""
    return np.array([[x, 0, y / 2, 0, 0, 0], [0, y, x / 2, 0, 0, 0], [0, 0, 0, x * x / 2, y * y / 2, x * y / 2],
                     [0, 0, 0, 0, y, x / 2], [0, 0, 0, -x, 0, -y / 2], [0, 0, 0, 0, 0, 0]])


def plate(bars, side, width, elastic):
    """The tensors in SI of the endless pattern. `elastic`: of each bar the share of its length that deforms within the plane."""
    energy = energies(bars, side, width, elastic) / (1.5 * math.sqrt(3) * side**2)
    return {"A11": 1e3 * energy[0, 0], "A12": 1e3 * energy[0, 1], "A66": 1e3 * energy[2, 2],
            "D11": 1e-3 * energy[3, 3], "D12": 1e-3 * energy[3, 4], "D66": 1e-3 * energy[5, 5]}


def energies(bars, side, width, elastic, wrapped=geometry.wrapped):
    """Of one cell of the endless pattern twice the energy by unit strains and curvatures: N mm, 6 x 6."""
    numbers, places = {}, []
    for bar in bars:
        for point in bar:
            if geometry.key(point) not in numbers:
                numbers[geometry.key(point)] = len(places)
                places.append(point)
    size = 6 * len(places)
    stiffness = np.zeros((size, size))
    for (a, b), share in zip(bars, elastic):
        length = math.dist(a, b)
        c, s = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        turn = np.kron(np.eye(4), np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
        dofs = [6 * numbers[geometry.key(point)] + i for point in (a, b) for i in range(6)]
        stiffness[np.ix_(dofs, dofs)] += turn.T @ _bar_stiffness(length, width, share) @ turn
    own = {}
    columns = [own.setdefault(wrapped(place, side), len(own)) for place in places]
    periodic = np.zeros((size, 6 * len(own)))
    for i, column in enumerate(columns):
        periodic[6 * i:6 * i + 6, 6 * column:6 * column + 6] = np.eye(6)
    motions = np.vstack([_macroscopic(x, y) for x, y in places])
    coupling = periodic.T @ stiffness @ motions
    follow = np.linalg.lstsq(periodic.T @ stiffness @ periodic, -coupling, rcond=1e-12)[0]
    return motions.T @ stiffness @ motions + coupling.T @ follow
