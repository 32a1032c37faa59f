#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the tables of `fretwork optimizers landscape` to landscape.html with its figures and landscape.csv.

Usage: landscape.py FOLDER
"""
import pathlib
import sys

import numpy as np

import analyse
import figures
from csv_tables import each_row, write_table
from figures import plt

KINDS = {"smoothed": "kinks smoothed by continuation", "sharp": "the last stage alone", "residuals": "Ceres on bare residuals"}
VARIABLES = ("ln A", "ln I2", "ln I3", "ln J", "theta", "R")
TOLD_APART = 1e-3  # ends whose values differ by less than this share are counted as one
COUNTS = 0.01      # a level counts if at least this share of the descents ends in it
AT_BOUND = 1e-6


def read_descents(path):
    """problem -> kind -> (values, points as shares of the box), best first."""
    table = {}
    for row in each_row(path):
        table.setdefault(row["problem"], {}).setdefault(row["kind"], []).append(
            (float(row["value"]), tuple(float(share) for share in row["shares"].split())))
    return {problem: {kind: (np.array([value for value, _ in sorted(rows)]), np.array([point for _, point in sorted(rows)]))
                      for kind, rows in kinds.items()} for problem, kinds in table.items()}


def levels(values):
    """Shares of the descents that end on each level of sorted values, lowest level first."""
    breaks = np.flatnonzero(np.diff(values) > TOLD_APART * values[:-1]) + 1
    return [len(part) / len(values) for part in np.split(values, breaks)]


def summary(descents):
    header = ["problem", "descents from", "kind", "best E", "levels that hold 1 % of the descents", "share within 0.1 % of the best",
              "share within 1 %", "share more than 10 % above", "variables at a bound in the best point"]
    rows = []
    for problem, kinds in descents.items():
        best = min(values[0] for values, _ in kinds.values())
        for kind, (values, points) in kinds.items():
            at_bound = [name for name, share in zip(VARIABLES, points[0]) if min(share, 1.0 - share) < AT_BOUND]
            rows.append([problem.split("/")[1], str(len(values)), kind, float(values[0]),
                         sum(share >= COUNTS for share in levels(values)), float(np.mean(values <= 1.001 * best)),
                         float(np.mean(values <= 1.01 * best)), float(np.mean(values > 1.1 * best)),
                         " ".join(at_bound) or "none"])
    return header, rows


def draw_ends(descents):
    """For each problem and kind: the sorted values at which descents end."""
    figure, grid = plt.subplots(2, 3, figsize=(figures.WIDTH, 4.6), sharex=True)
    for axes, (problem, kinds) in zip(grid.flat, descents.items()):
        best = min(values[0] for values, _ in kinds.values())
        for (kind, (values, _)), colour in zip(kinds.items(), ("#0072b2", "#d55e00", "#009e73")):
            axes.plot(np.linspace(0, 1, len(values)), np.maximum(values / best - 1.0, 1e-7), color=colour,
                      linewidth=1.5, label=KINDS[kind])
        axes.axhline(1e-3, color="black", linewidth=0.7, linestyle="--", label="0.1 % above the best")
        axes.set(yscale="log", xlim=(0, 1))
        axes.set_title(problem.split("/")[1], loc="left", fontsize=figures.SMALL)
    figure.legend(*grid.flat[0].get_legend_handles_labels(), fontsize=7, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, frameon=False)
    figure.supxlabel("share of the descents, best first", fontsize=9)
    figure.supylabel("(E at the end - best E) / best E", fontsize=9)
    figure.tight_layout()
    return figures.svg_of(figure)


def draw_sections(path, wanted):
    """E along each variable through the best point of some problems, a row for each."""
    sections = {}
    for row in each_row(path):
        sections.setdefault(row["problem"], {}).setdefault(int(row["variable"]), []).append(
            [float(row[name]) for name in ("share", "objective", "smoothed_0.1", "smoothed_0.01")])
    figure, grid = plt.subplots(len(wanted), 6, figsize=(figures.WIDTH, 1.4 * len(wanted)), sharex=True, squeeze=False)
    for row, problem in zip(grid, wanted):
        for variable, axes in enumerate(row):
            share, objective, rounder, sharper = np.array(sections[problem][variable]).T
            axes.plot(share, rounder, color="#56b4e9", linewidth=1.1, label="smoothing 0.1")
            axes.plot(share, sharper, color="#0072b2", linewidth=1.1, label="smoothing 0.01")
            axes.plot(share, objective, color="black", linewidth=0.9, label="E")
            if rounder.max() > 30.0 * objective.min():
                axes.set_yscale("log")
            if axes in grid[0]:
                axes.set_title(VARIABLES[variable], loc="left")
        row[0].set_ylabel(problem.split("/")[1][:24], fontsize=figures.SMALL)
    grid[0][0].legend(fontsize=figures.SMALL, framealpha=0.85, edgecolor="none")
    figure.supxlabel("variable, as a share of its range", fontsize=9)
    figure.tight_layout()
    return figures.svg_of(figure)


def draw_bounds(descents):
    """How often a variable is at a bound in the best point of a descent that ends within 1 % of the best."""
    shares = []
    for kinds in descents.values():
        best = min(values[0] for values, _ in kinds.values())
        values, points = kinds["smoothed"]
        good = points[values <= 1.01 * best]
        shares.append([np.mean(good < AT_BOUND, axis=0), np.mean(good > 1.0 - AT_BOUND, axis=0)])
    low, high = np.mean(shares, axis=0)
    figure, axes = plt.subplots(figsize=(5.2, 2.4))
    axes.bar(np.arange(6) - 0.2, low, 0.38, color="#0072b2", label="at the lower bound")
    axes.bar(np.arange(6) + 0.2, high, 0.38, color="#d55e00", label="at the upper bound")
    axes.set(xticks=range(6), xticklabels=VARIABLES, ylim=(0, 1), ylabel="share of good ends")
    axes.legend(fontsize=8, frameon=False)
    return figures.svg_of(figure)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    folder = pathlib.Path(sys.argv[1])
    descents = {problem: kinds for problem, kinds in read_descents(folder / "descents.csv").items()
                if problem.startswith("calibration/")}
    header, rows = summary(descents)
    write_table(folder / "landscape.csv", header, rows)
    wanted = list(descents)[:: max(1, len(descents) // 3)][:3]
    sections = [
        ("Where single descents end", "Descents from uniform random points, sorted by where they end. A plateau is a minimum, "
         "and its width the share of the box from which it is reached: its basin. A slope is a method that stops beside a minimum. "
         "Levels are told apart by value (0.1 %), since some minima are valleys.",
         analyse.figure("landscape_ends", draw_ends(descents), folder) + analyse.html_table(header, rows)),
        ("Sections through the best point", "One variable moves over its whole range, the others stay. Kinks of E, where a norm "
         "is zero, lie at or near the minimum; smoothing rounds them off.",
         analyse.figure("landscape_sections", draw_sections(folder / "sections.csv", wanted), folder)),
        ("Active bounds", "Of the descents with smoothing that end within 1 % of the best: how often a variable is at a bound. "
         "A method that creeps along bounds loses there.", analyse.figure("landscape_bounds", draw_bounds(descents), folder))]
    (folder / "landscape.html").write_text(analyse.report("The landscape of the calibration", sections))
    for row in rows:
        print(" | ".join(analyse.number(cell) for cell in row))


if __name__ == "__main__":
    main()
