# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the periodic cell: the hexagon of a tile less the openings between bars, in triangles of second order (gmsh).

Sides that lie opposite each other have the same nodes, so that the cell can be continued endlessly.
"""
import math

import gmsh

import outline

CORNER_REACH = 1.0  # sizes of the mesh elsewhere
SNAP = 1e-5  # mm
NEAR = 1e-4  # mm: outlines come on a grid of a nanometre


def _arc_pieces(start, end):
    """A DXF arc as arcs of less than a half circle: (centre, end) of each."""
    (x, y, bulge), (u, v) = start, end
    sweep = 4.0 * math.atan(bulge)
    chord = math.hypot(u - x, v - y)
    radius = chord / (2.0 * math.sin(abs(sweep) / 2.0))
    # The centre lies to the left of the chord for a counterclockwise arc of less than a half circle.
    height = math.copysign(1.0, bulge) * radius * math.cos(sweep / 2.0)
    centre = ((x + u) / 2.0 - height * (v - y) / chord, (y + v) / 2.0 + height * (u - x) / chord)
    count = 1 + int(abs(sweep) > 0.9 * math.pi)
    first = math.atan2(y - centre[1], x - centre[0])
    ends = [(centre[0] + radius * math.cos(first + sweep * i / count), centre[1] + radius * math.sin(first + sweep * i / count))
            for i in range(1, count)]
    return centre, [*ends, (u, v)]


def _face(loop):
    occ = gmsh.model.occ
    # Where two fillets meet, a line without length is left between them.
    loop = [start for start, end in zip(loop, loop[1:] + loop[:1]) if math.dist(start[:2], end[:2]) > SNAP]
    places = [occ.addPoint(x, y, 0.0) for x, y, _ in loop]
    curves = []
    for i, start in enumerate(loop):
        j = (i + 1) % len(loop)
        if not start[2]:
            curves.append(occ.addLine(places[i], places[j]))
            continue
        centre, ends = _arc_pieces(start, loop[j][:2])
        middle = occ.addPoint(*centre, 0.0)
        tags = [places[i]] + [occ.addPoint(*end, 0.0) for end in ends[:-1]] + [places[j]]
        curves += [occ.addCircleArc(a, middle, b) for a, b in zip(tags, tags[1:])]
    return occ.addPlaneSurface([occ.addCurveLoop(curves)])


def _is_near(loop, corners):
    """Whether the box around an opening meets that of the cell."""
    xs, ys = [p[0] for p in loop], [p[1] for p in loop]
    us, vs = [p[0] for p in corners], [p[1] for p in corners]
    margin = max(max(xs) - min(xs), max(ys) - min(ys))  # arcs bulge out of the box of their ends
    return (min(xs) - margin < max(us) and max(xs) + margin > min(us) and min(ys) - margin < max(vs) and max(ys) + margin > min(vs))


def _snapped(loop, corners):
    """The loop with points that lie on a side but for the outline's grid put there exactly: else slivers are left."""
    points = []
    for x, y, bulge in loop:
        for (a, b), (c, d) in zip(corners, corners[1:] + corners[:1]):
            length = math.hypot(c - a, d - b)
            off = ((x - a) * (d - b) - (y - b) * (c - a)) / length
            if abs(off) < SNAP:
                x, y = x - off * (d - b) / length, y + off * (c - a) / length
        points.append((x, y, bulge))
    return points


def _side_curves(corners):
    """Of each side of the polygon the curves on it, with their middles."""
    sides = [[] for _ in corners]
    for dimension, tag in gmsh.model.getEntities(1):
        box = gmsh.model.getBoundingBox(dimension, tag)
        middle = ((box[0] + box[3]) / 2.0, (box[1] + box[4]) / 2.0)
        ends = [gmsh.model.getValue(0, abs(point), [])[:2] for _, point in gmsh.model.getBoundary([(1, tag)])]
        for side, ((x, y), (u, v)) in enumerate(zip(corners, corners[1:] + corners[:1])):
            length = math.hypot(u - x, v - y)
            off = [((p[0] - x) * (v - y) - (p[1] - y) * (u - x)) / length for p in [middle, *ends]]
            if max(map(abs, off)) < NEAR:
                sides[side].append((tag, middle))
    return sides


def _make_periodic(corners, pairs):
    """Give sides that belong together the same mesh. Returns the translation of the first side of each pair."""
    sides = _side_curves(corners)
    translations = {}
    for side, other in pairs:
        (x, y), (u, v) = corners[side], corners[(side + 1) % len(corners)]
        (r, s), (p, q) = corners[other], corners[(other + 1) % len(corners)]
        shift = ((r + p - x - u) / 2.0, (s + q - y - v) / 2.0)
        if len(sides[side]) != len(sides[other]):
            raise ValueError(f"sides {side} and {other} are cut {len(sides[side])} and {len(sides[other])} times")
        for tag, middle in sides[side]:
            wanted = (middle[0] + shift[0], middle[1] + shift[1])
            twin, place = min(sides[other], key=lambda curve: math.dist(curve[1], wanted))
            if math.dist(place, wanted) > 10 * NEAR:
                raise ValueError(f"side {side} is cut at {middle}, and side {other} is not")
            matrix = [1, 0, 0, shift[0], 0, 1, 0, shift[1], 0, 0, 1, 0, 0, 0, 0, 1]
            gmsh.model.mesh.setPeriodic(1, [twin], [tag], matrix)
        translations[side] = shift
    return translations


def _refine_corners(corners, sizes):
    """Stresses have peaks where bars meet in sharp corners."""
    size, at_corners = sizes
    inner = [tag for _, tag in gmsh.model.getEntities(0)
             if min(math.dist(gmsh.model.getValue(0, tag, [])[:2], corner) for corner in corners) > NEAR]
    field = gmsh.model.mesh.field
    field.add("Distance", 1)
    field.setNumbers(1, "PointsList", inner)
    field.add("Threshold", 2)
    for name, value in (("InField", 1), ("SizeMin", at_corners), ("SizeMax", size), ("DistMin", 0.0), ("DistMax", size * CORNER_REACH)):
        field.setNumber(2, name, value)
    field.setAsBackgroundMesh(2)


class Cell:
    """Triangles with six nodes, and which nodes are one in the endless pattern."""

    def __init__(self, places, triangles, twins, areas):
        self.places = places  # of each node, mm
        self.triangles = triangles  # three corners, then the middles of the sides 1-2, 2-3, 3-1
        self.twins = twins  # (node, node that moves with it)
        self.area, self.material = areas  # of the whole cell with its openings, and of what is left, mm2


def _collect():
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    places = {int(tag): (coordinates[3 * i], coordinates[3 * i + 1]) for i, tag in enumerate(tags)}
    kinds, _, nodes = gmsh.model.mesh.getElements(2)
    if list(kinds) != [9]:
        raise ValueError(f"expected triangles with six nodes, got elements of kind {list(kinds)}")
    rows = [int(node) for node in nodes[0]]
    triangles = [rows[i:i + 6] for i in range(0, len(rows), 6)]
    used = sorted({node for triangle in triangles for node in triangle})
    number = {tag: i for i, tag in enumerate(used)}
    return [places[tag] for tag in used], [[number[tag] for tag in triangle] for triangle in triangles]


def _twins(places, corners, translations):
    """Pairs of nodes on opposite sides."""
    grid = {}
    for node, (x, y) in enumerate(places):
        grid.setdefault((round(x / NEAR / 100), round(y / NEAR / 100)), []).append(node)

    def find(x, y):
        i, j = round(x / NEAR / 100), round(y / NEAR / 100)
        near = [node for a in (i - 1, i, i + 1) for b in (j - 1, j, j + 1) for node in grid.get((a, b), [])]
        return [node for node in near if math.dist(places[node], (x, y)) < 10 * NEAR]

    pairs = []
    for side, shift in translations.items():
        (x, y), (u, v) = corners[side], corners[(side + 1) % len(corners)]
        length = math.hypot(u - x, v - y)
        for node, (a, b) in enumerate(places):
            along = ((a - x) * (u - x) + (b - y) * (v - y)) / length
            if abs((a - x) * (v - y) - (b - y) * (u - x)) / length > NEAR or not 0 <= along <= length:
                continue
            if min(along, length - along) < 10 * NEAR:
                raise ValueError("there is material in a corner of the tile")
            found = find(a + shift[0], b + shift[1])
            if len(found) != 1:
                raise ValueError(f"the node at {a}, {b} has no twin on the opposite side")
            pairs.append((found[0], node))
    return pairs


def _cut_out(openings, corners):
    """Leave the material of the cell as the only face. Returns its area."""
    polygon = _face([(x, y, 0.0) for x, y in corners])
    holes = [(2, _face(_snapped(loop, corners))) for loop in openings if _is_near(loop, corners)]
    if holes:
        left, _ = gmsh.model.occ.cut([(2, polygon)], holes)
        if len(left) != 1:
            raise ValueError(f"the cell falls into {len(left)} parts")
    gmsh.model.occ.synchronize()
    return sum(gmsh.model.occ.getMass(2, tag) for _, tag in gmsh.model.getEntities(2))


def _mesh(openings, corners, sizes, pairs):
    for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.MeshSizeMin", 0.0), ("Mesh.MeshSizeMax", sizes[0]),
                        ("Mesh.MeshSizeFromPoints", 0), ("Mesh.MeshSizeFromCurvature", 0), ("Mesh.Algorithm", 6),
                        ("Mesh.ElementOrder", 2), ("Mesh.SecondOrderLinear", 0), ("Mesh.HighOrderOptimize", 1)):
        gmsh.option.setNumber(name, value)
    gmsh.model.add("cell")
    material = _cut_out(openings, corners)
    translations = _make_periodic(corners, pairs)
    _refine_corners(corners, sizes)
    gmsh.model.mesh.generate(2)
    places, triangles = _collect()
    whole = outline.signed_area([(x, y, 0.0) for x, y in corners])
    return Cell(places, triangles, _twins(places, corners, translations), (whole, material))


def mesh(openings, corners, sizes, pairs=None):
    """Mesh what is left of a polygon; `sizes`: of the triangles, and of those in the corners between bars, mm; `pairs`: the sides that
    meet in the endless plate, opposite ones if left out.

    Throws ValueError that says what cannot be meshed.
    """
    gmsh.initialize()
    try:
        half = len(corners) // 2
        return _mesh(openings, corners, sizes, pairs or [(side, side + half) for side in range(half)])
    except ValueError:
        raise
    except Exception as problem:  # gmsh's own have no other type
        raise ValueError(f"gmsh: {problem}") from problem
    finally:
        gmsh.finalize()
