# SPDX-License-Identifier: GPL-3.0-or-later
"""How much stiffer solids are than beams: a dot for each pattern, in columns by load and width; beams without and with stiff joints."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from chart import Axis, text  # noqa: E402

import loads  # noqa: E402

LEFT, TOP, BOTTOM, WIDTH = 64, 44, 380, 940
SPREAD = 30.0  # pixels, of the dots of one height
COLOURS = ("#999999", "#d55e00")
NAMES = ("beams along centrelines", "with stiff joints")


def _column(values, x, up, colour):
    """Dots side by side where they would cover each other, and a line at the median."""
    parts, rows = [], {}
    for value in sorted(values):
        y = up(min(max(value, up.low), up.high))
        rows.setdefault(round(y / 4), []).append(y)
    for row in rows.values():
        apart = min(4.0, SPREAD / len(row))
        for i, y in enumerate(row):
            shift = (i + 1) // 2 * apart * (1 if i % 2 else -1)
            parts.append(f'<circle cx="{x + shift:.1f}" cy="{y:.1f}" r="2.1" fill="{colour}" fill-opacity=".75"/>')
    middle = sorted(values)[len(values) // 2]
    parts.append(f'<path d="M{x - 15} {up(middle):.1f}h30" stroke="#000" stroke-width="1.6"/>')
    return parts


def draw(widths):
    """`widths`: of each width (mm) the ratios of solid to beams, a row for each pattern, for both kinds of beams."""
    highest = max(ratios.max() for pair in widths.values() for ratios in pair)
    lowest = min(ratios.min() for pair in widths.values() for ratios in pair)
    up = Axis(math.floor(lowest * 10) / 10, math.ceil(highest * 2) / 2, BOTTOM, TOP, (1, 1.2, 1.5, 2, 3, 4, 6, 8))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {BOTTOM + 70}" data-print-width="177mm" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{BOTTOM + 70}" fill="#fff"/>']
    for tick in up.ticks():
        parts += [f'<path d="M{LEFT} {up(tick):.1f}H{WIDTH - 10}" stroke="{"#666" if tick == 1 else "#e0e0e0"}"/>',
                  text(LEFT - 6, up(tick) + 4, f"{tick:g}", "end")]
    group = (WIDTH - 10 - LEFT) / len(loads.LOADS)
    step = group / (2 * len(widths) + 0.6)
    for i, load in enumerate(loads.LOADS):
        start = LEFT + group * i
        parts.append(text(start + group / 2, BOTTOM + 44, load))
        for j, (width, pair) in enumerate(widths.items()):
            first = start + step * (0.8 + 2 * j)
            parts.append(text(first + step / 2, BOTTOM + 22, f"{width:g} mm"))
            for k, ratios in enumerate(pair):
                parts += _column(list(ratios[:, i]), first + step * k, up, COLOURS[k])
    for k, (name, colour) in enumerate(zip(NAMES, COLOURS)):
        parts += [f'<circle cx="{LEFT + 20 + 220 * k}" cy="20" r="5" fill="{colour}"/>', text(LEFT + 30 + 220 * k, 24, name, "start")]
    middle = (TOP + BOTTOM) / 2
    parts.append(text(18, middle, "stiffness, solid / beams", extra=f'transform="rotate(-90 18 {middle})"'))
    parts.append(text(WIDTH / 2, BOTTOM + 64, "bars of this width and height in hexagons with sides of 26 mm; lines: medians"))
    return "\n".join([*parts, "</svg>\n"])
