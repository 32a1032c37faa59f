# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilevers from the side, at one scale: a line for each model, a cross for each measured point."""

# Lines that lie upon one another stay visible: the reference is a wide band beneath all, and the dashes of one model, above all, fill the gaps of
# another's.
STYLES = {"full": 'stroke="#b5b5b5" stroke-width="7"',
          "corotational": 'stroke="#d55e00" stroke-width="2" stroke-dasharray="8 8"',
          "condensed": 'stroke="#009e73" stroke-width="1.4"',
          "paper6": 'stroke="#0072b2" stroke-width="2" stroke-dasharray="8 8" stroke-dashoffset="8"',
          "full, stiff joints": 'stroke="#cc79a7" stroke-width="1.4"',
          "full, stiff joints, true weight": 'stroke="#8a4b9e" stroke-width="1.4"'}
SCALE = 2.0  # pixels a millimetre
LEFT, RIGHT, TOP, BOTTOM, GAP = 64, 16, 40, 50, 74
LENGTH, DEPTH = 290.0, 110.0  # mm, of a panel
WIDTH = LEFT + SCALE * LENGTH + RIGHT
PRINT_WIDTH = 84  # mm, a column
TEXT, LINE = 17, 21  # pixels: above 6 pt in print


def text(x, y, content, anchor="start", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{content}</text>'


def place(point, top):
    return LEFT + SCALE * 1e3 * point[0], top + SCALE * 1e3 * point[1]


def path(points, top):
    return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in (place(point, top) for point in points))


def axes(top):
    parts = []
    for step in range(0, int(DEPTH) + 1, 25):
        y = top + SCALE * step
        parts += [f'<path d="M{LEFT} {y:.1f}h{SCALE * LENGTH:.1f}" stroke="#e4e4e4"/>', text(LEFT - 6, y + 6, f"{step}", "end")]
    for step in range(0, int(LENGTH) + 1, 50):
        x = LEFT + SCALE * step
        parts += [f'<path d="M{x:.1f} {top}v{SCALE * DEPTH:.1f}" stroke="#e4e4e4"/>',
                  text(x, top + SCALE * DEPTH + 19, f"{step}", "middle")]
    middle = top + SCALE * DEPTH / 2
    parts.append(text(18, middle, "below the clamp, mm", "middle", f' transform="rotate(-90 18 {middle:.1f})"'))
    return parts


def cross(x, y):
    return f'<path d="M{x - 4:.1f} {y:.1f}h8M{x:.1f} {y - 4:.1f}v8" stroke="#c00" stroke-width="1.5"/>'


def legend(profiles, measured, top):
    """At the lower left, where no cantilever hangs."""
    words = [f"{model}: {1e3 * points[-1][1]:.1f} mm" for model, points in profiles.items()] + ["measured points"] * bool(measured)
    first = top + SCALE * DEPTH - 10 - LINE * (len(words) - 1)
    parts = [text(LEFT + 12, first - LINE, "model: how far the tip sinks")]
    for i, row in enumerate(words):
        y = first + LINE * i
        parts.append(text(LEFT + 60, y, row))
    for i, model in enumerate(profiles):
        parts.append(f'<path d="M{LEFT + 12} {first + LINE * i - 6:.1f}h40" {STYLES[model]}/>')
    return parts + [cross(LEFT + 32, first + LINE * len(profiles) - 6)] * bool(measured)


def panel(name, profiles, measured, top):
    parts = [text(LEFT, top - 12, f"{name}: from the side, the clamp at the left"), *axes(top)]
    for model in sorted(profiles, key=lambda name: "dash" in STYLES[name]):
        parts.append(f'<path d="{path([(0.0, 0.0), *profiles[model]], top)}" fill="none" {STYLES[model]}/>')
    parts += legend(profiles, measured, top)
    return parts + [cross(*place(point, top)) for point in measured]


def profiles(specimens, measured):
    height = SCALE * DEPTH + GAP
    total = TOP + height * (len(specimens) - 1) + SCALE * DEPTH + BOTTOM
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH:.0f} {total:.0f}" data-print-width="{PRINT_WIDTH}mm" '
             f'font-family="DejaVu Sans, sans-serif" font-size="{TEXT}">', f'<rect width="{WIDTH:.0f}" height="{total:.0f}" fill="#fff"/>']
    for i, (name, models) in enumerate(specimens.items()):
        parts += panel(name, models, measured.get(name, []), TOP + height * i)
    parts.append(text(LEFT + SCALE * LENGTH / 2, total - 8, "distance from the clamp, mm", "middle"))
    return "\n".join([*parts, "</svg>\n"])
