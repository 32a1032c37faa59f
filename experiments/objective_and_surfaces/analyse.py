#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the rows of run.py to the tables of README.md (on standard output) and figure.svg.

Usage: analyse.py ROWS.csv FIGURE.svg
"""
import pathlib
import random
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from chart import Axis, grid, percent, text  # noqa: E402
from csv_tables import read_rows, with_numbers  # noqa: E402

LOADS = ("tension", "shear", "bending", "twist", "bent")
WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 620, 420, 96, 20, 64
COLOURS = {"bending": "#0072b2", "shear": "#d55e00"}


def ranks(values):
    """Equal values share the mean of their ranks."""
    order = sorted(range(len(values)), key=values.__getitem__)
    result = [0.0] * len(values)
    first = 0
    while first < len(order):
        last = first
        while last + 1 < len(order) and values[order[last + 1]] == values[order[first]]:
            last += 1
        for place in range(first, last + 1):
            result[order[place]] = (first + last) / 2
        first = last + 1
    return result


def spearman(a, b):
    return statistics.correlation(ranks(a), ranks(b))


def interval(a, b, draws=2000):
    """95 % of bootstrap samples of the patterns."""
    rng = random.Random(1)
    found = []
    for _ in range(draws):
        picks = [rng.randrange(len(a)) for _ in a]
        found.append(spearman([a[i] for i in picks], [b[i] for i in picks]))
    found.sort()
    return found[int(0.025 * draws)], found[int(0.975 * draws) - 1]


def quartiles(values, scale=1.0):
    low, middle, high = statistics.quantiles(values, n=4)
    return f"{scale * middle:.2g} ({scale * low:.2g} to {scale * high:.2g})"


def correlation_table(rows):
    own = [row for row in rows if row["variant"] == "paper6"]
    print("| load | rank correlation of E with the error (95 %) | error, %: median (quartiles) | stiffness / true: median (quartiles) |")
    print("|---|---|---|---|")
    for load in LOADS:
        E, errors = [row["objective"] for row in own], [row[f"{load}_error"] for row in own]
        low, high = interval(E, errors)
        print(f"| {load} | {spearman(E, errors):.2f} ({low:.2f} to {high:.2f}) | {quartiles(errors, 100)} | "
              f"{quartiles([row[f'{load}_stiffness'] for row in own])} |")
    print()


def variant_table(rows):
    print(f"| variant | {' | '.join(f'{load}: error, %' for load in LOADS)} | {' | '.join(f'{load}: stiffness' for load in LOADS)} |")
    print("|---|" + "---|" * (2 * len(LOADS)))
    for variant in dict.fromkeys(row["variant"] for row in rows):
        own = [row for row in rows if row["variant"] == variant]
        errors = [f"{100 * statistics.median(row[f'{load}_error'] for row in own):.2g}" for load in LOADS]
        stiffness = [f"{statistics.median(row[f'{load}_stiffness'] for row in own):.2f}" for load in LOADS]
        print(f"| {variant} ({len(own)}) | {' | '.join(errors)} | {' | '.join(stiffness)} |")
    linear = [row["bent_error_of_condensed"] for row in rows if row["variant"] == "paper6"]
    print(f"\nThe linear tiles themselves (condensed) are {quartiles(linear, 100)} % off on the bent sheet.")


def fitting_axis(values, first, last):
    """A tenth of a decade wider than the values, at both ends."""
    return Axis(min(values) / 10**0.1, max(values) * 10**0.1, first, last, multiples=(1, 2, 5))


def figure(rows):
    own = [row for row in rows if row["variant"] == "paper6"]
    across = fitting_axis([row["objective"] for row in own], LEFT, WIDTH - 20)
    up = fitting_axis([row[f"{load}_error"] for row in own for load in COLOURS], HEIGHT - BOTTOM, TOP)
    titles = (("objective E of the calibration", "{:g}".format), ("error of the sheet, relative L2", percent))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" data-print-width="84mm" font-family="sans-serif" font-size="16">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>', *grid(across, up, titles, "#eee")]
    for i, (load, colour) in enumerate(COLOURS.items()):
        for row in own:
            parts.append(f'<circle cx="{across(row["objective"]):.1f}" cy="{up(row[f"{load}_error"]):.1f}" r="4" '
                         f'fill="{colour}" fill-opacity="0.7"/>')
        parts.append(f'<circle cx="{LEFT + 15}" cy="{TOP + 14 + 20 * i}" r="4" fill="{colour}"/>')
        parts.append(text(LEFT + 25, TOP + 19 + 20 * i, load, "start"))
    return "\n".join([*parts, "</svg>\n"])


def main():
    rows = with_numbers(read_rows(sys.argv[1]), "pattern", "variant")
    print(f"{len({row['pattern'] for row in rows})} patterns.\n")
    correlation_table(rows)
    variant_table(rows)
    open(sys.argv[2], "w").write(figure(rows))


if __name__ == "__main__":
    main()
