#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the page, from the rows. Usage: analyse.py ROWS.csv   (exit code 1 if a result that is far off is silent)"""
import csv
import sys

FAR = 0.05  # of the largest displacement, at the worst node
GROUPS = {"corotational": ["corotational"], "mixed:0.05": ["mixed:0.05"], "mixed:0.1": ["mixed:0.1"], "condensed": ["condensed"],
          "paper6": ["paper6"]}


def number(row, name):
    return float(row[name]) if row[name] else None


def table(header, lines):
    print("| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for line in lines:
        print("| " + " | ".join(str(cell) for cell in line) + " |")
    print()


def is_far(row):
    return row["largest"] and float(row["largest"]) > FAR


def print_warnings(rows):
    print("Results that are compared with the full model: off by more than 5 % at the worst node, warned or silent; and those within\n")
    lines = []
    for name, models in GROUPS.items():
        known = [row for row in rows if row["model"] in models and row["largest"]]
        far, near = [r for r in known if is_far(r)], [r for r in known if not is_far(r)]
        told = [r for r in near if r["warned"] == "1"]
        lines.append([name, len(known), len(far), sum(r["warned"] == "1" for r in far), sum(r["warned"] == "0" for r in far), len(near),
                      len(told), f"{100 * min((float(r['largest']) for r in told), default=0):.2g} %"])
    table(["model", "compared", "more than 5 % off", "of these warned", "silent", "within 5 %", "of these warned", "the least error of these"], lines)


def print_unknown(rows):
    print("The full model reaches the load and the reduced one does not, or the other way round\n")
    lines = []
    for name, models in GROUPS.items():
        of = [row for row in rows if row["model"] in models]
        stuck = [r for r in of if r["full"] == "converged" and r["reached"] != "converged"]
        alone = [r for r in of if r["full"] != "converged" and r["reached"] == "converged"]
        lines.append([name, len(stuck), len(alone), sum(r["warned"] == "1" for r in alone)])
    table(["model", "the reduced one ends before, and says so", "the full one ends before", "of these warned"], lines)


def print_estimates(rows):
    print("Estimate over truth, of the largest error, where it was estimated and truth is above 1 %\n")
    lines = []
    for model in ("corotational", "mixed:0.05", "mixed:0.1"):
        ratios = sorted(float(r["estimate"]) / float(r["largest"]) for r in rows
                        if r["model"] == model and r["estimate"] and r["largest"] and float(r["largest"]) > 0.01)
        lines.append([model, len(ratios), f"{ratios[len(ratios) // 2]:.2f}", f"{ratios[0]:.2f} to {ratios[-1]:.2f}"])
    table(["model", "estimates", "median", "all"], lines)


def print_doubts(rows):
    print("How often the error is estimated without being asked for, by how large it is at the worst node\n")
    lines = []
    bounds = (0.0, 0.001, 0.01, 0.03, FAR, float("inf"))
    for model in ("corotational", "mixed:0.05", "mixed:0.1"):
        cells = [model]
        for low, high in zip(bounds, bounds[1:]):
            inside = [r for r in rows if r["model"] == model and r["largest"] and low < float(r["largest"]) <= high]
            cells.append(f"{sum(r['doubtful'] == 'True' for r in inside)} of {len(inside)}")
        lines.append(cells)
    table(["model", "to 0.1 %", "0.1 to 1 %", "1 to 3 %", "3 to 5 %", "above 5 %"], lines)
    far = [r for r in rows if r["model"] == "corotational" and is_far(r)]
    print(f"Least turn in a tile where corotational tiles are more than 5 % off: {min(float(r['tile_rotation']) for r in far):.3f} rad\n")


def main():
    rows = list(csv.DictReader(open(sys.argv[1])))
    print_warnings(rows)
    print_unknown(rows)
    print_estimates(rows)
    print_doubts(rows)
    silent = [row for row in rows if is_far(row) and row["warned"] == "0"]
    for row in silent:
        print(f"silent: {row['kind']} {row['painting']} {row['amount']} {row['model']}: {100 * float(row['largest']):.1f} %")
    raise SystemExit(1 if silent else 0)


if __name__ == "__main__":
    main()
