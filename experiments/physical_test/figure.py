# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilevers from the side, at one scale: a line for each model, a cross for each measured point."""

# Lines that lie upon one another stay visible: the reference is a wide band beneath all, and the dashes of one model, above all, fill the gaps of
# another's.
STYLES = {"full": 'stroke="#b5b5b5" stroke-width="7"',
          "corotational": 'stroke="#d55e00" stroke-width="2" stroke-dasharray="8 8"',
          "condensed": 'stroke="#009e73" stroke-width="1.4"',
          "paper6": 'stroke="#0072b2" stroke-width="2" stroke-dasharray="8 8" stroke-dashoffset="8"',
          "full, stiff joints": 'stroke="#cc79a7" stroke-width="1.4"',
          "the same, true weight": 'stroke="#8a4b9e" stroke-width="1.4"'}
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
    crosses = "; crosses: measured points" if measured else ""
    parts = [text(LEFT, top - 12, f"{name}: from the side, the clamp at the left{crosses}")]
    for step in range(0, int(DEPTH) + 1, 30):
        y = top + SCALE * step
        parts += [f'<path d="M{LEFT} {y:.1f}h{width:.1f}" stroke="#e4e4e4"/>', text(LEFT - 6, y + 4, f"{step}", "end")]
    for step in range(0, int(LENGTH) + 1, 50):
        x = LEFT + SCALE * step
        parts += [f'<path d="M{x:.1f} {top}v{SCALE * DEPTH:.1f}" stroke="#e4e4e4"/>',
                  text(x, top + SCALE * DEPTH + 16, f"{step}", "middle")]
    for model in sorted(profiles, key=lambda name: "dash" in STYLES[name]):
        parts.append(f'<path d="{path([(0.0, 0.0), *profiles[model]], top)}" fill="none" {STYLES[model]}/>')
    for i, (model, points) in enumerate(profiles.items()):
        y = top + SCALE * DEPTH - 16 - 18 * (len(profiles) - 1 - i)
        parts += [f'<path d="M{LEFT + 12} {y - 4:.1f}h40" {STYLES[model]}/>',
                  text(LEFT + 60, y, f"{model}: {1e3 * points[-1][1]:.1f} mm")]
    for point in measured:
        x, y = place(point, top)
        parts.append(f'<path d="M{x - 4:.1f} {y:.1f}h8M{x:.1f} {y - 4:.1f}v8" stroke="#c00" stroke-width="1.5"/>')
    return parts


def profiles(specimens, measured):
    height = SCALE * DEPTH + GAP + 20
    total = TOP + height * len(specimens) - 28
    width = LEFT + SCALE * LENGTH + 20
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {total:.0f}" font-family="sans-serif" '
             'font-size="13">', f'<rect width="{width:.0f}" height="{total:.0f}" fill="#fff"/>']
    for i, (name, models) in enumerate(specimens.items()):
        parts += panel(name, models, measured.get(name, []), TOP + height * i)
    parts.append(text(LEFT + SCALE * LENGTH / 2, total - 4, "millimetres", "middle"))
    return "\n".join([*parts, "</svg>\n"])
