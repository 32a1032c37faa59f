#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the page, from the rows. Usage: analyse.py ROWS.csv   (exit code 1 if a result that is far off is silent)"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import print_table, read_rows  # noqa: E402

FAR = 0.05  # of the largest displacement, at the worst node
GROUPS = {"corotational": ["corotational"], "mixed:0.05": ["mixed:0.05"], "mixed:0.1": ["mixed:0.1"], "condensed": ["condensed"],
          "paper6": ["paper6"], "corotational in stages": ["corotational in stages"]}


def number(row, name):
    return float(row[name]) if row[name] else None


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
    print_table(["model", "compared", "more than 5 % off", "of these warned", "silent", "within 5 %", "of these warned", "the least error of these"], lines)


def print_unknown(rows):
    print("The full model reaches the load and the reduced one does not, or the other way round\n")
    lines = []
    for name, models in GROUPS.items():
        of = [row for row in rows if row["model"] in models]
        stuck = [r for r in of if r["full"] == "converged" and r["reached"] != "converged"]
        alone = [r for r in of if r["full"] != "converged" and r["reached"] == "converged"]
        lines.append([name, len(stuck), len(alone), sum(r["warned"] == "1" for r in alone)])
    print_table(["model", "the reduced one ends before, and says so", "the full one ends before", "of these warned"], lines)


ESTIMATED = ("corotational", "mixed:0.05", "mixed:0.1", "corotational in stages")


def print_estimates(rows):
    for estimate, truth, name in (("estimate", "largest", "the largest error"), ("estimate_mean", "mean", "the mean error"),
                                  ("stress_estimate", "stress", "the error of the largest stress")):
        print(f"Estimate over truth, of {name}, where it was estimated and truth is above 1 %\n")
        lines = []
        for model in ESTIMATED:
            ratios = sorted(float(r[estimate]) / float(r[truth]) for r in rows
                            if r["model"] == model and r[estimate] and r[truth] and float(r[truth]) > 0.01)
            if ratios:
                lines.append([model, len(ratios), f"{ratios[len(ratios) // 2]:.2f}", f"{ratios[0]:.2f} to {ratios[-1]:.2f}",
                              sum(ratio < 0.7 for ratio in ratios), sum(ratio > 1.3 for ratio in ratios)])
        print_table(["model", "estimates", "median", "all", "below 0.7", "above 1.3"], lines)


AIMS = {"mean": 0.015, "largest": 0.035}


def is_named(row):
    """It is warned of, or its estimate says that it is beyond the aims."""
    estimates = {"mean": row["estimate_mean"], "largest": row["estimate"]}
    return row["warned"] == "1" or any(estimates[key] and float(estimates[key]) > aim for key, aim in AIMS.items())


def print_aims(rows):
    print("Corotational cantilevers and bridges, bent by up to 80 % of their span: beyond 1.5 % on average or 3.5 % at the worst node\n")
    lines = []
    for kind in ("random cantilever", "random bridge", "cantilever", "corner-load", "rim-moment"):
        own = [r for r in rows if r["model"] == "corotational" and r["kind"] == kind and r["largest"] and is_within_span(r)]
        beyond = [r for r in own if any(float(r[key]) > aim for key, aim in AIMS.items())]
        lines.append([kind, len(own), *(f"{100 * max((float(r[key]) for r in own), default=0):.2g} %" for key in AIMS), len(beyond),
                      sum(is_named(r) for r in beyond)])
    print_table(["kind", "compared", "largest mean error", "largest error of a node", "beyond", "of these named"], lines)


def is_within_span(row):
    """Amounts of random surfaces are shares of the span; the others are 0.4 m long."""
    return row["kind"].startswith("random") or float(row["deflection"]) <= 0.8 * 0.4


def print_doubts(rows):
    print("How often the error is estimated without being asked for, by how large it is at the worst node\n")
    lines = []
    bounds = (0.0, 0.001, 0.01, 0.03, FAR, float("inf"))
    for model in ESTIMATED:
        cells = [model]
        for low, high in zip(bounds, bounds[1:]):
            inside = [r for r in rows if r["model"] == model and r["largest"] and low < float(r["largest"]) <= high]
            cells.append(f"{sum(r['doubtful'] == 'True' for r in inside)} of {len(inside)}")
        lines.append(cells)
    print_table(["model", "to 0.1 %", "0.1 to 1 %", "1 to 3 %", "3 to 5 %", "above 5 %"], lines)
    far = [r for r in rows if r["model"] == "corotational" and is_far(r)]
    print(f"Least turn in a tile where corotational tiles are more than 5 % off: {min(float(r['tile_rotation']) for r in far):.3f} rad\n")


def print_cost(rows):
    print("Wall time of the command with an estimate over that of the solution alone\n")
    lines = []
    for model in ESTIMATED:
        ratios = sorted(float(r["command_seconds"]) / float(r["seconds"]) for r in rows if r["model"] == model and r["estimate"])
        if ratios:
            lines.append([model, len(ratios), f"{ratios[len(ratios) // 2]:.1f}", f"{ratios[int(0.9 * len(ratios))]:.1f}"])
    print_table(["model", "estimates", "median", "nine of ten below"], lines)


def main():
    rows = read_rows(sys.argv[1])
    print_warnings(rows)
    print_unknown(rows)
    print_estimates(rows)
    print_doubts(rows)
    print_aims(rows)
    print_cost(rows)
    silent = [row for row in rows if is_far(row) and row["warned"] == "0"]
    for row in silent:
        print(f"silent: {row['kind']} {row['painting']} {row['amount']} {row['model']}: {100 * float(row['largest']):.1f} %")
    raise SystemExit(1 if silent else 0)


if __name__ == "__main__":
    main()
