# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the bars of a pattern come to each other, and at which widths they can be made."""
import math

import numpy

from tile_geometry import Bars

WIDTHS = (0.001, 0.002, 0.003)  # m
GAP = 0.0005  # m, between the flanks of bars: the clearance that `fretwork facts` takes for granted
SAME = 1e-6  # of the tile's side: ends that are one node
COLUMNS = ("pattern_id", "distance_in_tile", "distance", "smallest_angle", *(f"makeable_{1000 * width:.0f}mm" for width in WIDTHS))


def to_segments(points, segments):
    """Distances of points (n x 2) from segments (m x 2 x 2)."""
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    offset = points[:, None] - start
    share = numpy.clip((offset * along).sum(axis=2) / (along * along).sum(axis=1), 0.0, 1.0)
    return numpy.linalg.norm(offset - share[..., None] * along, axis=2)


class Pairs:
    """All pairs of a bar of `some` and another bar of `others`; no two bars cross. Tables have a row for each of `some`."""

    def __init__(self, some, others, tolerance):
        meets = numpy.linalg.norm(some[:, None, :, None] - others[None, :, None, :], axis=4) < tolerance  # of ends: some, others, 2, 2
        self.meet = meets.any(axis=(2, 3))
        self.same = meets.any(axis=3).all(axis=2)
        from_ends = numpy.stack([to_segments(some[:, end], others) for end in (0, 1)], axis=2)
        from_others = numpy.stack([to_segments(others[:, end], some).T for end in (0, 1)], axis=2)
        apart = numpy.minimum(from_ends.min(axis=2), from_others.min(axis=2))
        # Bars that meet are apart by the distance of the far end of one from the other.
        ours, theirs = meets.any(axis=3), meets.any(axis=2)
        far = numpy.minimum(numpy.where(ours, math.inf, from_ends).min(axis=2), numpy.where(theirs, math.inf, from_others).min(axis=2))
        self.distance = numpy.where(self.meet, far, apart)
        self.angles = self.angles_at(some, others, meets)

    @staticmethod
    def angles_at(some, others, meets):
        """Angles (rad) between bars where ends meet, infinite elsewhere."""
        angles = numpy.full(meets.shape, math.inf)
        for end in (0, 1):
            for other in (0, 1):
                ours, theirs = some[:, 1 - end] - some[:, end], others[:, 1 - other] - others[:, other]
                cosine = ours @ theirs.T / numpy.outer(numpy.linalg.norm(ours, axis=1), numpy.linalg.norm(theirs, axis=1))
                angles[:, :, end, other] = numpy.arccos(numpy.clip(cosine, -1.0, 1.0))
        return numpy.where(meets, angles, math.inf).min(axis=(2, 3))


def near(segments, others, reach):
    """Those of `others` that may come nearer than `reach` to one of the segments."""
    middle = segments.mean(axis=(0, 1))
    radius = numpy.linalg.norm(segments - middle, axis=2).max()
    return others[to_segments(middle[None], others)[0] < radius + reach]


def clearance(bars, pattern_id, tile_side):
    """Of a surface of this pattern: the distance (m) of bars of one tile that do not meet, that of all bars, and the smallest angle (rad)."""
    sector = bars.of_sector(pattern_id)
    inside = Pairs(sector, bars.of_tile(pattern_id), SAME * tile_side)
    others = ~inside.same
    distance = inside.distance[others].min()
    outside = Pairs(sector, near(sector, bars.of_neighbours(pattern_id), distance), SAME * tile_side)
    return (numpy.where(inside.meet, math.inf, inside.distance).min(), min(distance, outside.distance.min(initial=math.inf)),
            min(inside.angles[others].min(), outside.angles.min(initial=math.inf)))


def rows(layout, setting, patterns):
    """Rows of clearance.csv. A distance is empty where there are no such bars."""
    bars = Bars(layout, setting)
    for name in patterns:
        found = clearance(bars, name, setting["tile_side"])
        yield [name, *(repr(float(value)) if math.isfinite(value) else "" for value in found), *(int(found[1] >= width + GAP) for width in WIDTHS)]
