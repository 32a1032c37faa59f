# SPDX-License-Identifier: GPL-3.0-or-later
"""The regular tile of a setting in the plane, and the bars of a pattern in it and in its neighbours, from layout.json and setting.json."""
import fractions
import math

import numpy


def number(text):
    return float(fractions.Fraction(text))


def layout_nodes(layout):
    """Barycentric coordinates (v0, v1, v2) of a layout's nodes in their order: center, radial left, radial right, face, interface."""
    radial = [number(text) for text in layout.get("radial", [])]
    places = [(1.0, 0.0, 0.0)] if layout.get("center", True) else []
    places += [(1.0 - share, share, 0.0) for share in radial]
    places += [(1.0 - share, 0.0, share) for share in radial]
    places += [tuple(number(text) for text in place) for place in layout.get("face", [])]
    places += [(0.0, 1.0 - number(text), number(text)) for text in layout["interface"]]
    return numpy.array(places)


def polygon(sides, side):
    """The vertices of the regular polygon around the origin; side t, from vertex t, looks to 270 + 360 t / sides degrees."""
    angles = math.radians(270.0) + (2.0 * numpy.arange(sides) - 1.0) * math.pi / sides
    return side / (2.0 * math.sin(math.pi / sides)) * numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=1)


def interface_nodes(layout, setting):
    """The places of the interface nodes (m), side by side."""
    vertices = polygon(setting["sides"], setting["tile_side"])
    shares = [number(text) for text in layout["interface"]]
    return numpy.array([(1.0 - share) * vertices[t] + share * vertices[(t + 1) % len(vertices)] for t in range(len(vertices)) for share in shares])


def area(setting):
    return setting["sides"] * setting["tile_side"] ** 2 / (4.0 * math.tan(math.pi / setting["sides"]))


class Bars:
    """The bars (n x 2 ends x 2, m) of patterns of one layout."""

    def __init__(self, layout, setting):
        self.places, self.sides = layout_nodes(layout), setting["sides"]
        self.vertices = polygon(self.sides, setting["tile_side"])
        self.inradius = setting["tile_side"] / (2.0 * math.tan(math.pi / self.sides))

    def of_sector(self, pattern_id, sector=0):
        """Of one sector."""
        corners = numpy.stack([numpy.zeros(2), self.vertices[sector], self.vertices[(sector + 1) % self.sides]])
        ends = [[int(node) for node in edge.split("-")] for edge in pattern_id.split("+")]
        return (self.places @ corners)[numpy.array(ends)]

    def of_tile(self, pattern_id):
        """Of a whole tile; those of sector 0 come first."""
        return numpy.concatenate([self.of_sector(pattern_id, sector) for sector in range(self.sides)])

    def of_neighbours(self, pattern_id):
        """Of the tiles beside it. Squares and hexagons alone have translated neighbours."""
        tile = self.of_tile(pattern_id)
        angles = math.radians(270.0) + 2.0 * math.pi * numpy.arange(self.sides) / self.sides
        steps = 2.0 * self.inradius * numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=1)
        return numpy.concatenate([tile + step for step in steps])
