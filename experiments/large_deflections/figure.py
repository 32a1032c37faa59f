# SPDX-License-Identifier: GPL-3.0-or-later
"""The mean error over the deflection, a dot for each surface and model, on logarithmic axes; times beside it."""
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from chart import decades, grid, percent, text  # noqa: E402

COLOURS = {"condensed": "#888888", "corotational": "#0072b2", "mixed:0.05": "#d55e00", "mixed:0.1": "#009e73", "mixed:0.3": "#cc79a7"}
WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 540, 360, 100, 20, 60
TITLES = (("largest displacement / span", percent), ("mean error / largest displacement", percent))
UNDER_WEIGHT = ("cantilever", "bridge")


def mark(x, y, row, colour):
    """Disks: cantilevers and bridges; rings: other loads."""
    fill = colour if row["kind"] in UNDER_WEIGHT else "none"
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{fill}" fill-opacity="0.8" stroke="{colour}"/>'


def legend(rows, models, x):
    parts = [text(x, TOP + 12, "model: median time / condensed", "start")]
    for i, model in enumerate(["full", *models]):
        y = TOP + 36 + 20 * i
        ratio = statistics.median(row[f"{model}_s"] / row["condensed_s"] for row in rows)
        if model in COLOURS:
            parts.append(f'<circle cx="{x + 5}" cy="{y - 4}" r="4" fill="{COLOURS[model]}"/>')
        parts.append(text(x + 16, y, f"{model}: {ratio:.1f}" if model in COLOURS else f"{model} (the reference): {ratio:.1f}", "start"))
    parts.append(text(x, TOP + 170, "disks: cantilevers, bridges", "start"))
    parts.append(text(x, TOP + 188, "rings: other loads", "start"))
    return parts


def errors_over_deflection(rows, models):
    across = decades([row["deflection"] for row in rows], LEFT, WIDTH)
    up = decades([max(row[f"{model}_mean"], 1e-6) for row in rows for model in models], HEIGHT - BOTTOM, TOP)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH + 230} {HEIGHT}" data-print-width="177mm" '
             'font-family="sans-serif" font-size="12">',
             '<rect width="100%" height="100%" fill="white"/>', *grid(across, up, TITLES, "#ddd")]
    for model in models:
        for row in rows:
            parts.append(mark(across(row["deflection"]), up(max(row[f"{model}_mean"], 1e-6)), row, COLOURS[model]))
    return "\n".join([*parts, *legend(rows, models, WIDTH + 20), "</svg>\n"])
