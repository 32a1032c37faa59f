#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Collect outlines that nobody of this project drew: glyphs of icon and text fonts that are one part.

Usage: collect.py FOLDER     Writes FOLDER/tune/*.json and FOLDER/held/*.json, half a metre across; the hash of the name
decides which. Needs Debian's python3-fonttools, python3-shapely, fonts-font-awesome, fonts-materialdesignicons-webfont,
fonts-elusive-icons, fonts-symbola and fonts-dejavu-core.
"""
import hashlib
import json
import math
import pathlib
import sys

from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont
from shapely import affinity
from shapely.geometry import Polygon
from shapely.ops import unary_union

FONTS = {  # short name: file, share of the glyphs that is taken, first and last code
    "fa": ("fonts-font-awesome/fonts/fontawesome-webfont.ttf", 0.2, (0, 0x10FFFF)),
    "mdi": ("fonts-materialdesignicons-webfont/fonts/materialdesignicons-webfont.ttf", 0.06, (0, 0x10FFFF)),
    "el": ("fonts-elusive-icons/fonts/elusiveicons-webfont.ttf", 0.3, (0, 0x10FFFF)),
    "sy": ("fonts/truetype/ancient-scripts/Symbola_hint.ttf", 0.12, (0x1F300, 0x1F6FF)),
    "sy2": ("fonts/truetype/ancient-scripts/Symbola_hint.ttf", 0.08, (0x2600, 0x27BF)),
    "dj": ("fonts/truetype/dejavu/DejaVuSerif-Bold.ttf", 0.4, (0x30, 0x7A)),
    "dj2": ("fonts/truetype/dejavu/DejaVuSans.ttf", 0.3, (0x30, 0x7A)),
}
SIZE = 0.5  # m, the longer side of the box
TOLERANCE = 2e-5  # m
LEAST_AREA = 0.005  # m2


def curve(points, steps):
    """Points of a Bezier curve, without the first."""
    result = []
    for k in range(1, steps + 1):
        row = list(points)
        while len(row) > 1:
            row = [tuple(a + (b - a) * k / steps for a, b in zip(p, q)) for p, q in zip(row, row[1:])]
        result.append(row[0])
    return result


def quadratic(start, args):
    """TrueType's run of quadratic curves: points on the curve lie between the control points."""
    controls, end = list(args[:-1]), args[-1]
    result = []
    for i, control in enumerate(controls):
        last = i + 1 == len(controls)
        to = end if last else tuple((a + b) / 2 for a, b in zip(control, controls[i + 1]))
        result += curve([start, control, to], 16)
        start = to
    return result or [end]


def contours(glyphs, name):
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    points = []
    for what, args in pen.value:
        if what == "moveTo":
            points = [args[0]]
        elif what == "lineTo":
            points.append(args[0])
        elif what == "qCurveTo":
            if args[-1] is None:  # a closed run of control points alone
                start = tuple((a + b) / 2 for a, b in zip(args[-2], args[0]))
                points, args = [start], args[:-1] + (start,)
            points += quadratic(points[-1], args)
        elif what == "curveTo":
            points += curve([points[-1], *args], 24)
        elif len(points) > 2:
            yield points


def signed_area(points):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(points, points[1:] + points[:1])) / 2


def shape(loops):
    """Contours that run like the largest one are filled, the others are holes."""
    loops = [loop for loop in loops if abs(signed_area(loop)) > 1e-9]
    if not loops:
        return Polygon()
    sign = math.copysign(1, signed_area(max(loops, key=lambda loop: abs(signed_area(loop)))))
    filled = unary_union([Polygon(loop).buffer(0) for loop in loops if sign * signed_area(loop) > 0])
    return filled.difference(unary_union([Polygon(loop).buffer(0) for loop in loops if sign * signed_area(loop) < 0]))


def write(geometry, name, folder):
    if geometry.geom_type != "Polygon" or geometry.is_empty:
        return
    left, low, right, high = geometry.bounds
    scale = SIZE / max(right - left, high - low)
    geometry = affinity.scale(affinity.translate(geometry, -left, -low), scale, scale, origin=(0, 0)).simplify(TOLERANCE)
    if geometry.geom_type != "Polygon" or not geometry.is_valid or geometry.area < LEAST_AREA:
        return
    half = "tune" if int(hashlib.md5(name.encode()).hexdigest(), 16) % 2 else "held"
    outline = {
        "format": "fretwork/outline/1",
        "boundary": [list(p) for p in geometry.exterior.coords[:-1]],
        "holes": [[list(p) for p in hole.coords[:-1]] for hole in geometry.interiors],
    }
    (folder / half / f"{name}.json").write_text(json.dumps(outline))


def is_taken(name, share):
    return int(hashlib.sha1(name.encode()).hexdigest(), 16) % 1000 < 1000 * share


def main():
    folder = pathlib.Path(sys.argv[1])
    for half in ("tune", "held"):
        (folder / half).mkdir(parents=True, exist_ok=True)
    for key, (file, share, (first, last)) in FONTS.items():
        font = TTFont(f"/usr/share/{file}")
        glyphs = font.getGlyphSet()
        for code, name in sorted(font.getBestCmap().items()):
            if first <= code <= last and is_taken(f"{key}{code}", share):
                write(shape(list(contours(glyphs, name))), f"{key}_{code:x}", folder)


if __name__ == "__main__":
    main()
