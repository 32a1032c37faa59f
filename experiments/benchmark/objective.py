# SPDX-License-Identifier: GPL-3.0-or-later
"""The calibration problem in NumPy alone: the paper's six-parameter tile, its error E, and a count of evaluations.

An optimizer enters by it:

    release = Release("out/dataset/paper7")
    problem = release.problem("0-1+1-6")
    e = problem(problem.lower)         # E at A I2 I3 J theta R; problem.evaluations is now 1

E is Eqs. (8) to (11) of the paper; framework/fretwork/reduction/calibration/objective.hpp is the same in C++, and test.py compares both.
"""
import json
import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "dataset"))
from load import load  # noqa: E402
from tile_geometry import interface_nodes  # noqa: E402

PARAMETERS = ("A", "I2", "I3", "J", "theta", "R")
COMPONENTS = ("ux", "uy", "uz", "rx", "ry", "rz")
TRANSLATION_WEIGHT, ROTATION_WEIGHT = 1.2, 0.8
LEAST_TRANSLATION, LEAST_ROTATION = 0.0003, math.radians(0.1)  # m, rad


def beam_stiffness(start, end, section, material):
    """The stiffness (12 x 12) of a straight beam in the plane z = 0 without shear; I2 bends it out of the plane. Global axes."""
    length = math.dist(start, end)
    young, shear = material["young_modulus"], material.get("shear_modulus", material["young_modulus"] / (2.0 * (1.0 + material["poisson_ratio"])))
    area, out_of_plane, in_plane, torsion = section
    matrix = numpy.zeros((12, 12))

    def add(dofs, values):
        matrix[numpy.ix_(dofs, dofs)] += values

    spring = numpy.array([[1.0, -1.0], [-1.0, 1.0]])
    add([0, 6], young * area / length * spring)
    add([3, 9], shear * torsion / length * spring)
    bending = numpy.array([[12.0, 6.0, -12.0, 6.0], [6.0, 4.0, -6.0, 2.0], [-12.0, -6.0, 12.0, -6.0], [6.0, 2.0, -6.0, 4.0]])
    for dofs, second_moment, arm in (([1, 5, 7, 11], in_plane, length), ([2, 4, 8, 10], out_of_plane, -length)):
        scale = numpy.array([1.0, arm, 1.0, arm])
        add(dofs, young * second_moment / length**3 * bending * numpy.outer(scale, scale))
    along = (numpy.asarray(end) - start) / length
    axes = numpy.array([[along[0], along[1], 0.0], [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]])
    turn = numpy.kron(numpy.eye(4), axes)
    return turn.T @ matrix @ turn


class Tile:
    """The paper's hexagon with links (Section 5.1): links from the interface nodes to a ring, which is turned by theta and scaled to R."""

    def __init__(self, layout, setting):
        self.setting, self.places = setting, interface_nodes(layout, setting)
        self.count = len(self.places)
        self.apothem = setting["tile_side"] / (2.0 * math.tan(math.pi / setting["sides"]))
        if len(layout["interface"]) != 1:
            raise ValueError("the benchmark has one interface node on each side")
        section = setting["section"]
        own = numpy.array([section[name] for name in ("area", "I2", "I3", "J")])
        self.lower = numpy.array([*(0.001 * own), -math.pi / 6.0, 0.001 * self.apothem])
        self.upper = numpy.array([*(1000.0 * own), math.pi / 6.0, 0.999 * self.apothem])

    def stiffness(self, parameters):
        """Of interface nodes and ring nodes."""
        *section, theta, radius = parameters
        turn = numpy.array([[math.cos(theta), -math.sin(theta)], [math.sin(theta), math.cos(theta)]])
        nodes = numpy.concatenate([self.places, radius / self.apothem * self.places @ turn.T])
        beams = [(i, self.count + i) for i in range(self.count)] + [(self.count + i, self.count + (i + 1) % self.count) for i in range(self.count)]
        matrix = numpy.zeros((12 * self.count, 12 * self.count))
        for a, b in beams:
            dofs = [*range(6 * a, 6 * a + 6), *range(6 * b, 6 * b + 6)]
            matrix[numpy.ix_(dofs, dofs)] += beam_stiffness(nodes[a], nodes[b], section, self.setting["material"])
        return matrix

    def displacements(self, parameters):
        """Of the interface nodes under each scenario of 1 N: scenarios x nodes x 6."""
        matrix = self.stiffness(parameters)
        found = []
        for scenario in self.setting["scenarios"]:
            held = [6 * row["interface_node"] + COMPONENTS.index(name) for row in scenario["held"] for name in row["fixed"]]
            free = numpy.setdiff1d(numpy.arange(len(matrix)), held)
            force = numpy.zeros(len(matrix))
            for load_row in scenario["loads"]:
                begin = 6 * load_row["interface_node"]
                force[begin:begin + 6] += [*load_row["force"], *load_row["moment"]]
            solution = numpy.zeros(len(matrix))
            solution[free] = numpy.linalg.solve(matrix[numpy.ix_(free, free)], force[free])
            found.append(solution[:6 * self.count].reshape(self.count, 6))
        return numpy.array(found)


def quaternions(vectors):
    """(.., w x y z) of rotation vectors."""
    angles = numpy.linalg.norm(vectors, axis=-1, keepdims=True)
    shares = 0.5 * numpy.sinc(angles / (2.0 * math.pi))  # sin(angle / 2) / angle
    return numpy.concatenate([numpy.cos(angles / 2.0), shares * vectors], axis=-1)


def angles_between(some, others):
    """Angles (rad, at most pi) between rotations that rotation vectors give."""
    p, q = quaternions(some), quaternions(others)
    w = (p * q).sum(axis=-1)
    vector = p[..., :1] * q[..., 1:] - q[..., :1] * p[..., 1:] - numpy.cross(p[..., 1:], q[..., 1:])
    return 2.0 * numpy.arctan2(numpy.linalg.norm(vector, axis=-1), numpy.abs(w))


class Problem:
    """E of one pattern as a function of A, I2, I3, J, theta and R (SI)."""

    def __init__(self, tile, arrays, place):
        self.tile, self.lower, self.upper = tile, tile.lower, tile.upper
        self.target, self.magnitudes = arrays["displacements"][place], arrays["magnitude"][place]
        used = arrays["converged"][place].copy()
        if tile.setting["branch"] == "stable":  # samples up to the first that is not stable
            used &= numpy.logical_and.accumulate(arrays["stable"][place] | ~used, axis=1)
        self.weights = numpy.where(used, numpy.array([[row["weight"]] for row in tile.setting["scenarios"]]), 0.0)
        self.target = numpy.where(used[..., None, None], self.target, 0.0)
        self.translations = numpy.maximum(numpy.linalg.norm(self.target[..., :3], axis=-1).sum(axis=-1), LEAST_TRANSLATION)
        none = numpy.zeros_like(self.target[..., 3:])
        self.rotations = numpy.maximum(angles_between(self.target[..., 3:], none).sum(axis=-1), LEAST_ROTATION)
        self.evaluations = 0

    def __call__(self, parameters):
        self.evaluations += 1
        model = self.tile.displacements(parameters)[:, None] * self.magnitudes[..., None, None]
        missed = numpy.linalg.norm(model[..., :3] - self.target[..., :3], axis=-1).sum(axis=-1) / self.translations
        turned = angles_between(model[..., 3:], self.target[..., 3:]).sum(axis=-1) / self.rotations
        errors = TRANSLATION_WEIGHT * missed + ROTATION_WEIGHT * turned
        return float((self.weights * errors**2).sum())


class Release:
    """A release folder of experiments/dataset."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.arrays, self.properties, self.held_out = load(folder)
        layout, setting = (json.loads((folder / "tables" / name).read_text()) for name in ("layout.json", "setting.json"))
        self.layout, self.tile = layout["name"], Tile(layout, setting)
        names = [scenario["name"] for scenario in setting["scenarios"]]
        order = [list(self.arrays["scenarios"]).index(name) for name in names]
        for name in ("magnitude", "converged", "stable", "displacements"):
            self.arrays[name] = self.arrays[name][:, order]
        self.places = {str(name): place for place, name in enumerate(self.arrays["patterns"])}

    def problem(self, pattern_id):
        return Problem(self.tile, self.arrays, self.places[pattern_id])
