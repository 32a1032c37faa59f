# SPDX-License-Identifier: GPL-3.0-or-later
"""The plate that is equivalent to an endless surface of one tile, from the tile's condensed stiffness: A, B and D."""
import numpy

from tile_geometry import area, interface_nodes, polygon


def macroscopic(places):
    """Displacements of the nodes (6n x 6) under unit strains e_xx, e_yy, 2 e_xy and unit curvatures w_xx, w_yy, 2 w_xy."""
    modes = numpy.zeros((len(places), 6, 6))
    x, y = places.T
    modes[:, 0, 0], modes[:, 1, 1] = x, y
    modes[:, 0, 2], modes[:, 1, 2] = y / 2.0, x / 2.0
    modes[:, 2, 3], modes[:, 2, 4], modes[:, 2, 5] = x * x / 2.0, y * y / 2.0, x * y / 2.0
    modes[:, 3, 4], modes[:, 3, 5] = y, x / 2.0  # rx = w_y
    modes[:, 4, 3], modes[:, 4, 5] = -x, -y / 2.0  # ry = -w_x
    return modes.reshape(-1, 6)


def partners(places, setting):
    """Pairs of nodes that are one node of an endless surface: the second lies where the tile beyond the opposite side has the first."""
    vertices = polygon(setting["sides"], setting["tile_side"])
    per_side = len(places) // len(vertices)
    pairs = []
    for node in range(len(places) // 2):
        side = node // per_side
        period = vertices[side] + vertices[(side + 1) % len(vertices)]  # twice the middle of the side
        pairs.append((node, int(numpy.linalg.norm(places - (places[node] - period), axis=1).argmin())))
    return pairs


def fluctuations(places, setting):
    """Displacements of the nodes that are equal at partners, one column each. The first pair keeps its place: translations cost nothing."""
    columns = []
    for number, pair in enumerate(partners(places, setting)):
        for component in range(3 if number == 0 else 0, 6):
            column = numpy.zeros((len(places), 6))
            column[list(pair), component] = 1.0
            columns.append(column.ravel())
    return numpy.array(columns).T


class Plate:
    """The least energy of a tile over periodic fluctuations, for the tiles of one layout and setting (squares and hexagons)."""

    def __init__(self, layout, setting):
        places = interface_nodes(layout, setting)
        self.modes, self.periodic, self.area = macroscopic(places), fluctuations(places, setting), area(setting)

    def tensors(self, stiffness):
        """A (N/m), B (N) and D (N m), 3 x 3 each, in Voigt's notation: forces A e + B k, moments B^T e + D k, per unit of length."""
        coupling = self.periodic.T @ stiffness @ self.modes
        moved = numpy.linalg.solve(self.periodic.T @ stiffness @ self.periodic, -coupling)
        energy = (self.modes.T @ stiffness @ self.modes + coupling.T @ moved) / self.area
        return energy[:3, :3], energy[:3, 3:], energy[3:, 3:]
