# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilevers from the side, at one scale: a line for each model, a cross for each measured point."""

COLOURS = {"full": "#222222", "corotational": "#d55e00", "condensed": "#009e73", "paper6": "#0072b2", "full, stiff joints": "#cc79a7",
           "the same, true weight": "#8a4b9e"}
DASHES = {"corotational": "7 5"}
SCALE = 2.0  # pixels a millimetre
LEFT, TOP, GAP = 40, 40, 50
LENGTH, DEPTH = 290.0, 90.0  # mm, of a panel


def text(x, y, content, anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{content}</text>'


def place(point, top):
    return LEFT + SCALE * 1e3 * point[0], top + SCALE * 1e3 * point[1]


def path(points, top):
    return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in (place(point, top) for point in points))


def panel(name, profiles, measured, top):
    width = SCALE * LENGTH
    parts = [text(LEFT, top - 12, f"{name}: from the side, the clamp at the left")]
    for step in range(0, int(DEPTH) + 1, 30):
        y = top + SCALE * step
        parts += [f'<path d="M{LEFT} {y:.1f}h{width:.1f}" stroke="#e4e4e4"/>', text(LEFT - 6, y + 4, f"{step}", "end")]
    for step in range(0, int(LENGTH) + 1, 50):
        x = LEFT + SCALE * step
        parts += [f'<path d="M{x:.1f} {top}v{SCALE * DEPTH:.1f}" stroke="#e4e4e4"/>',
                  text(x, top + SCALE * DEPTH + 16, f"{step}", "middle")]
    for i, (model, points) in enumerate(profiles.items()):
        dash = f' stroke-dasharray="{DASHES[model]}"' if model in DASHES else ""
        style = f'fill="none" stroke="{COLOURS[model]}" stroke-width="2.2"{dash}'
        parts.append(f'<path d="{path([(0.0, 0.0), *points], top)}" {style}/>')
        y = top + SCALE * DEPTH - 16 - 18 * i
        parts += [f'<path d="M{LEFT + 12} {y - 4:.1f}h24" {style}/>',
                  text(LEFT + 44, y, f"{model}: {1e3 * points[-1][1]:.1f} mm")]
    for point in measured:
        x, y = place(point, top)
        parts.append(f'<path d="M{x - 4:.1f} {y:.1f}h8M{x:.1f} {y - 4:.1f}v8" stroke="#c00" stroke-width="1.5"/>')
    return parts


def profiles(specimens, measured):
    height = SCALE * DEPTH + GAP + 20
    total = TOP + height * len(specimens)
    width = LEFT + SCALE * LENGTH + 20
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {total:.0f}" font-family="sans-serif" '
             'font-size="13">', f'<rect width="{width:.0f}" height="{total:.0f}" fill="#fff"/>']
    for i, (name, models) in enumerate(specimens.items()):
        parts += panel(name, models, measured.get(name, []), TOP + height * i)
    parts.append(text(LEFT + SCALE * LENGTH / 2, total - 4, "millimetres; crosses: measured points", "middle"))
    return "\n".join([*parts, "</svg>\n"])
