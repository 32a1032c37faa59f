# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a pattern may tell how much its joints matter."""
import math


def bars_of(obj_text, side, centre=(0.0, 0.0)):
    """The centrelines in the tile around a point: pairs of points, mm. Interface nodes are those on its sides."""
    points, bars = [], []
    for line in obj_text.splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append((1e3 * float(words[1]), 1e3 * float(words[2])))
        elif words[:1] == ["l"]:
            bars.append(tuple(points[int(word) - 1] for word in words[1:3]))
    apothem = side * math.sqrt(3) / 2

    def is_inside(x, y):
        return max((x - centre[0]) * math.cos(a) + (y - centre[1]) * math.sin(a) for a in (math.radians(30 + 60 * i) for i in range(6))) < apothem + 1e-6

    return [bar for bar in bars if is_inside(*((p + q) / 2 for p, q in zip(*bar)))]


def key(point):
    return round(point[0], 4), round(point[1], 4)


def wrapped(point, side):
    """One name for a node on a side and its twin on the opposite one."""
    apart = side * math.sqrt(3)
    for i in range(3, 6):
        angle = math.radians(30 + 60 * i)
        if point[0] * math.cos(angle) + point[1] * math.sin(angle) > apart / 2 - 1e-3:
            return key((point[0] - apart * math.cos(angle), point[1] - apart * math.sin(angle)))
    return key(point)


def directions(bars, side):
    """Of each node of the endless pattern the angles of its bars, counterclockwise from x."""
    found = {}
    for a, b in bars:
        for here, there in ((a, b), (b, a)):
            found.setdefault(wrapped(here, side), []).append(math.atan2(there[1] - here[1], there[0] - here[0]))
    return {node: sorted(angles) for node, angles in found.items()}


def gaps(angles):
    """Between neighbouring bars of a node."""
    return [(second - first) % (2 * math.pi) or 2 * math.pi for first, second in zip(angles, angles[1:] + angles[:1])]


def measures(obj_text, side, width, meshed):
    """The numbers that rows have of a pattern's shape."""
    bars = bars_of(obj_text, side)
    nodes = directions(bars, side)
    lengths = [math.dist(*bar) for bar in bars]
    all_gaps = [gap for angles in nodes.values() for gap in gaps(angles)]
    return {"bars": len(bars), "nodes": len(nodes), "mean_length_mm": sum(lengths) / len(bars), "shortest_mm": min(lengths),
            "mean_valence": 2 * len(bars) / len(nodes), "largest_valence": max(map(len, nodes.values())),
            "sharpest_deg": math.degrees(min(all_gaps)), "bar_area_mm2": width * sum(lengths), "true_area_mm2": meshed.material,
            "tile_area_mm2": meshed.area}
