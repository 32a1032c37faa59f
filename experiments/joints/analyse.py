#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables and figure of the page, from the rows of solids and beams.

Usage: analyse.py ROWS.csv FIGURE.svg
"""
import collections
import sys

import numpy as np
import scipy.stats

import figure
import loads
import study
from csv_tables import print_table

NAMES = {"centreline": "centrelines", "sheared": "with shear", "stiff": "stiff joints", "stiff_sheared": "both"}


def spread(values):
    low, middle, high = np.quantile(values, (0.1, 0.5, 0.9))
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"


def by_width(rows):
    found = collections.defaultdict(list)
    for row in rows:
        found[float(row["width_mm"])].append(row)
    return dict(sorted(found.items()))


def ratios(rows, model):
    return np.array([loads.ratios(row, row, f"{model}_") for row in rows])


def print_stiffer(widths):
    print("Solid over beams: median, and 10 to 90 % of the patterns\n")
    lines = []
    for model in ("centreline", "stiff"):
        for width, rows in widths.items():
            found = ratios(rows, model)
            lines.append([NAMES[model], f"{width:g}", str(len(rows)), *(spread(column) for column in found.T)])
    print_table(["beams", "bars, mm", "patterns", *loads.LOADS], lines)


def print_errors(widths):
    print("Mean of |log(solid / beams)|, about a relative error, over patterns that nothing was chosen on\n")
    lines = []
    for model in study.MODELS:
        for width, rows in widths.items():
            held_out = [row for row in rows if row["pattern"] in loads.halves(rows)[1]]
            found = np.abs(np.log(ratios(held_out, model))).mean(axis=0)
            lines.append([NAMES[model], f"{width:g}", *(f"{100 * value:.1f} %" for value in found)])
    print_table(["beams", "bars, mm", *loads.LOADS], lines)


def predictors(row):
    value = {name: float(row[name]) for name in row if name not in ("pattern",)}
    width, tile = value["width_mm"], value["tile_area_mm2"]
    density = value["true_area_mm2"] / tile
    stretch = loads.stiffnesses(row, "centreline_")[0]
    return {
        "area counted twice / tile": (value["bar_area_mm2"] - value["true_area_mm2"]) / tile,
        "area counted twice / bars": 1 - value["true_area_mm2"] / value["bar_area_mm2"],
        "true area / tile": density,
        "width / mean length": width / value["mean_length_mm"],
        "width / shortest bar": width / value["shortest_mm"],
        "mean valence": value["mean_valence"],
        "sharpest angle": value["sharpest_deg"],
        # Of an isotropic lattice in which all bars are stretched, and nothing bends: a third of the material's.
        "stiffness / most possible": stretch / (study.YOUNG * 1e-3 * width * density / 3),
    }


def print_correlations(widths):
    print("Spearman's rank correlation of solid / centrelines\n")
    lines = []
    for name in predictors(next(iter(widths.values()))[0]):
        cells = [name]
        for rows in (widths[2.0], [row for of_width in widths.values() for row in of_width]):
            found = ratios(rows, "centreline")
            known = [predictors(row)[name] for row in rows]
            cells += [f"{scipy.stats.spearmanr(known, column).statistic:+.2f}" for column in found.T]
        lines.append(cells)
    print_table(["of the pattern", *(f"{load}, 2 mm" for load in loads.LOADS), *(f"{load}, all" for load in loads.LOADS)], lines)


def print_regression(widths):
    """log(solid / beams) by area counted twice over that of the bars, and by how near the pattern is to the stiffest possible."""
    rows = [row for of_width in widths.values() for row in of_width]
    chosen_on = loads.halves(rows)[0]
    chosen = np.array([row["pattern"] in chosen_on for row in rows])
    known = [predictors(row) for row in rows]
    design = np.array([[1, p["area counted twice / bars"], p["width / mean length"], np.log(p["stiffness / most possible"])] for p in known])
    wanted = np.log(ratios(rows, "centreline"))
    coefficients = np.linalg.lstsq(design[chosen], wanted[chosen], rcond=None)[0]
    left = wanted - design @ coefficients
    print("log(solid / centrelines) = a + b (area counted twice / bars) + c (width / mean length) + d log(stiffness / most possible)\n")
    lines = []
    for i, load in enumerate(loads.LOADS):
        share = 1 - np.var(left[~chosen, i]) / np.var(wanted[~chosen, i])
        lines.append([load, *(f"{value:+.2f}" for value in coefficients[:, i]), f"{share:.2f}",
                      f"{100 * np.abs(left[~chosen, i]).mean():.1f} %"])
    print_table(["load", "a", "b", "c", "d", "explained, held out", "mean error left, held out"], lines)


def print_extremes(rows):
    print("Most and least stiffened, 2 mm\n")
    found = ratios(rows, "centreline")
    lines = []
    for i, load in enumerate(loads.LOADS):
        for place in (np.argmax(found[:, i]), np.argmin(found[:, i])):
            lines.append([load, f"`{rows[place]['pattern']}`", f"{found[place, i]:.2f}"])
    print_table(["load", "pattern", "solid / centrelines"], lines)


def other_meshes(rows):
    """Rows of other meshes or with fillets, each with its twin of the main mesh."""
    main = {(row["pattern"], row["width_mm"]): row for row in loads.main_rows(rows)}
    groups = collections.defaultdict(list)
    for row in rows:
        twin = main.get((row["pattern"], row["width_mm"]))
        if twin is not None and twin is not row:
            kind = tuple(float(row[name]) for name in ("mesh", "corner", "layers", "fillet_mm"))
            groups[kind].append((row, twin))
    return dict(sorted(groups.items()))


def print_meshes(rows):
    print("Other meshes and fillets over the main mesh, without fillets: median, smallest and largest of the patterns\n")
    lines = []
    for (mesh, corner, layers, fillet), pairs in other_meshes(rows).items():
        found = np.array([[a / b for a, b in zip(loads.stiffnesses(row, "solid_"), loads.stiffnesses(twin, "solid_"))]
                          for row, twin in pairs])
        cells = [f"{np.median(c):.4f} ({c.min():.4f} to {c.max():.4f})" for c in found.T]
        lines.append([f"{mesh:g} w", f"{mesh * corner:g} w", f"{layers:g}", f"{fillet:g}", str(len(pairs)), *cells])
    print_table(["triangles", "in corners", "layers", "fillet, mm", "rows", *loads.LOADS], lines)


def main():
    rows = study.read_rows(sys.argv[1])
    widths = by_width(loads.main_rows(rows))
    print_stiffer(widths)
    print_errors(widths)
    print_correlations(widths)
    print_regression(widths)
    print_extremes(widths[2.0])
    print_meshes(rows)
    with open(sys.argv[2], "w") as file:
        file.write(figure.draw({width: (ratios(of_width, "centreline"), ratios(of_width, "stiff")) for width, of_width in widths.items()}))


if __name__ == "__main__":
    main()
