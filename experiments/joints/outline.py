# SPDX-License-Identifier: GPL-3.0-or-later
"""The true outline of a tile among its like: what `fretwork export` writes for a laser."""
import math


def hexagon(side, centre=(0.0, 0.0)):
    """Counterclockwise; its first side faces down, as the tiles' do."""
    angles = [math.radians(240 + 60 * i) for i in range(6)]
    return [(centre[0] + side * math.cos(a), centre[1] + side * math.sin(a)) for a in angles]


def neighbours(side, centre=(0.0, 0.0)):
    """The middles of the hexagons around one."""
    apart = math.sqrt(3.0) * side
    return [(centre[0] + apart * math.cos(math.radians(30 + 60 * i)), centre[1] + apart * math.sin(math.radians(30 + 60 * i)))
            for i in range(6)]


def patch_obj(side):
    """A hexagon and its six neighbours as the text of a mesh file; the first face is the one in the middle."""
    return hexagons_obj(side, [(0.0, 0.0), *neighbours(side)])


def hexagons_obj(side, centres):
    """Hexagons around these points as the text of a mesh file."""
    numbers, faces = {}, []
    places = []
    for centre in centres:
        face = []
        for x, y in hexagon(side, centre):
            key = (round(x / side * 1e6), round(y / side * 1e6))
            if key not in numbers:
                places.append((x, y))
                numbers[key] = len(places)
            face.append(numbers[key])
        faces.append(face)
    lines = [f"v {x!r} {y!r} 0" for x, y in places] + ["f " + " ".join(map(str, face)) for face in faces]
    return "\n".join(lines) + "\n"


def read_dxf(text):
    """The closed lines on the layer `cut`: lists of (x, y, bulge), millimetres."""
    lines = text.splitlines()
    pairs = [(int(code), value.strip()) for code, value in zip(lines[0::2], lines[1::2])]
    loops, kind, layer, points = [], "", "", []
    for code, value in [*pairs, (0, "EOF")]:
        if code == 0:
            if kind == "LWPOLYLINE" and layer == "cut":
                loops.append([tuple(point) for point in points])
            kind, layer, points = value, "", []
        elif kind == "LWPOLYLINE":
            if code == 8:
                layer = value
            elif code == 10:
                points.append([float(value), 0.0, 0.0])
            elif code == 20:
                points[-1][1] = float(value)
            elif code == 42:
                points[-1][2] = float(value)
    return loops


def signed_area(loop):
    """Of a closed line with arcs."""
    area = 0.0
    for (x, y, bulge), (u, v, _) in zip(loop, loop[1:] + loop[:1]):
        area += (x * v - u * y) / 2.0
        if bulge:
            sweep = 4.0 * math.atan(bulge)
            radius = math.hypot(u - x, v - y) / (2.0 * math.sin(sweep / 2.0))
            area += radius * radius * (sweep - math.sin(sweep)) / 2.0
    return area
