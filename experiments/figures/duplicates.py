#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figs. 5 and 6 of the paper: graphs on the base triangle that give one shape, and why the enumeration has only one of them.

Usage: duplicates.py LAYOUT.json OUT        Writes fig05.svg and fig06.svg. The layout is experiments/layouts/paper7.json.
The program never makes the second graph of a pair, so it cannot draw it. The shapes are compared in exact fractions before they are drawn.
"""
import json
import pathlib
import sys
from fractions import Fraction

# pairs of graphs: edges on the base triangle by numbers of nodes
RADIAL = ("fig05", "A radial edge of one side or of the other: one fan", ("0-1+1-2+2-5+4-5+5-6", "0-3+3-4+2-5+4-5+5-6"))
PASSED = ("fig06", "A beam in two pieces or in one: one shape", ("0-1+1-2+2-5+4-5+5-6", "0-2+2-5+4-5+5-6"))
HEXAGON = ((1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1))  # vertices in a basis whose second vector is the first, turned by 60 degrees


def layout_nodes(layout):
    """Barycentric places in the order of their numbers: the center, the pairs on the radial edges side by side, the face, the interface."""
    if layout.get("corners"):
        raise SystemExit("duplicates.py: layouts with corner nodes have no radial duplicates to draw")
    radial = [Fraction(share) for share in layout["radial"]]
    places = [(Fraction(1), Fraction(0), Fraction(0))] if layout["center"] else []
    places += [(1 - share, share, Fraction(0)) for share in radial] + [(1 - share, Fraction(0), share) for share in radial]
    places += [tuple(map(Fraction, place)) for place in layout["face"]]
    return places + [(Fraction(0), 1 - Fraction(share), Fraction(share)) for share in layout["interface"]]


def edges_of(pattern):
    return [tuple(map(int, edge.split("-"))) for edge in pattern.split("+")]


def fan(places, pattern):
    """The segments of the pattern in all six triangles."""
    segments = []
    for t in range(6):
        corners = (HEXAGON[t], HEXAGON[(t + 1) % 6])
        at = [tuple(place[1] * corners[0][k] + place[2] * corners[1][k] for k in (0, 1)) for place in places]
        segments += [(at[a], at[b]) for a, b in edges_of(pattern)]
    return segments


def pieces(segments, points):
    """The shape of segments: parted at all points that lie on them, each piece once, without direction."""
    found = set()
    for start, end in segments:
        along = (end[0] - start[0], end[1] - start[1])
        square = along[0] ** 2 + along[1] ** 2

        def share(point):
            return ((point[0] - start[0]) * along[0] + (point[1] - start[1]) * along[1]) / square

        inside = sorted({share(p) for p in points if (p[0] - start[0]) * along[1] == (p[1] - start[1]) * along[0] and 0 <= share(p) <= 1})
        ends = [(start[0] + s * along[0], start[1] + s * along[1]) for s in inside]
        found |= {frozenset(pair) for pair in zip(ends, ends[1:])}
    return found


def same_shape(places, first, second):
    fans = [fan(places, pattern) for pattern in (first, second)]
    points = {point for segments in fans for segment in segments for point in segment}
    return pieces(fans[0], points) == pieces(fans[1], points)


# ---- drawing, in millimetres in a column of 84 ----

PANEL, GAP, HEIGHT = 25.8, 3.3, 38.5
TEXT, LINE = 2.17, 2.8  # above 6 pt
BAR = 'stroke="#22303c" stroke-linecap="round"'


def in_triangle(place):
    corners = ((0.5 * PANEL, 3.0), (0.7, PANEL - 2.5), (PANEL - 0.7, PANEL - 2.5))
    return tuple(sum(float(share) * corner[k] for share, corner in zip(place, corners)) for k in (0, 1))


def in_hexagon(point):
    x, y = float(point[0]) + 0.5 * float(point[1]), 0.75 ** 0.5 * float(point[1])
    return 0.5 * PANEL + 0.48 * PANEL * x, 0.5 * PANEL - 0.48 * PANEL * y


def path(points):
    return "M" + " L".join(f"{x:.3f} {y:.3f}" for x, y in points)


def lines(segments, width):
    return "".join(f'<path d="{path(segment)}" {BAR} stroke-width="{width}"/>' for segment in segments)


def node_mark(place, number):
    x, y = in_triangle(place)
    colour = "#1b9e77" if place[0] == 0 else "#ffffff"
    side, anchor = (-1.3, "end") if place[1] > place[2] and place[2] == 0 else (1.3, "start")
    return (f'<circle cx="{x:.3f}" cy="{y:.3f}" r=".8" fill="{colour}" stroke="#22303c" stroke-width=".25"/>'
            f'<text x="{x + side:.3f}" y="{y - 0.95:.3f}" font-size="{TEXT}" text-anchor="{anchor}">{number}</text>')


def triangle_panel(places, pattern):
    """Bars pass over the nodes that they do not use."""
    used = {node for edge in edges_of(pattern) for node in edge}
    marks = [node_mark(place, number) for number, place in enumerate(places)]
    rim = path([in_triangle(corner) for corner in ((1, 0, 0), (0, 1, 0), (0, 0, 1))])
    return (f'<path d="{rim} Z" fill="#f4f6f8" stroke="#b8c0c8" stroke-width=".25"/>' + "".join(mark for node, mark in enumerate(marks) if node not in used)
            + lines([[in_triangle(places[end]) for end in edge] for edge in edges_of(pattern)], 1.1) + "".join(marks[node] for node in sorted(used)))


def fan_panel(places, pattern):
    rim = path([in_hexagon(corner) for corner in HEXAGON])
    return (f'<path d="{rim} Z" fill="#f4f6f8" stroke="#b8c0c8" stroke-width=".25"/>'
            + lines([[in_hexagon(end) for end in segment] for segment in fan(places, pattern)], 0.9))


def caption(letter, pattern):
    """A panel's letter and its edges, in lines as wide as the panel."""
    edges, half = pattern.split("+"), (pattern.count("+") + 2) // 2
    return [f"({letter}) " + "+".join(edges[:half]) + "+", "+".join(edges[half:])]


def figure(places, title, patterns):
    panels = [triangle_panel(places, pattern) for pattern in patterns] + [fan_panel(places, patterns[0])]
    captions = [caption(letter, pattern) for letter, pattern in zip("ab", patterns)] + [["(c) the fan of both"]]

    def text(x, y, words):
        return f'<text x="{x:g}" y="{y:g}" font-size="{TEXT}" text-anchor="middle">{words}</text>'

    body = "".join(f'<g transform="translate({k * (PANEL + GAP):g} 0)">{panel}'
                   + "".join(text(PANEL / 2, PANEL + 3 + LINE * row, words) for row, words in enumerate(lines)) + "</g>"
                   for k, (panel, lines) in enumerate(zip(panels, captions)))
    width = 3 * PANEL + 2 * GAP
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{HEIGHT:g}mm" viewBox="0 0 {width:g} {HEIGHT:g}" '
            f'data-print-width="{width:g}mm" font-family="DejaVu Sans, sans-serif" fill="#333333"><title>{title}</title>'
            f'<rect width="100%" height="100%" fill="#ffffff"/>{body}{text(width / 2, HEIGHT - 1.2, title)}</svg>\n')


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stdout if "--help" in sys.argv else sys.stderr)
        raise SystemExit(0 if "--help" in sys.argv else 2)
    places = layout_nodes(json.loads(pathlib.Path(sys.argv[1]).read_text()))
    out = pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for name, title, patterns in (RADIAL, PASSED):
        if not same_shape(places, *patterns):
            raise SystemExit(f"duplicates.py: {' and '.join(patterns)} have different shapes")
        (out / f"{name}.svg").write_text(figure(places, title, patterns))


if __name__ == "__main__":
    main()
