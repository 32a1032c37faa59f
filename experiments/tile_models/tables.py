#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of README.md from the CSV files of tile_models. Usage: tables.py FOLDER"""
import pathlib
import statistics
import sys
from collections import defaultdict

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import read_rows  # noqa: E402

# Columns of surfaces: heading, kinds of load, wanted deflection as a share of the span.
WEIGHT, COMPRESSION, IN_PLANE = ("cantilever", "bridge"), ("compression",), ("shear", "tension")
COLUMNS = [(f"weight, {name} %", WEIGHT, share) for name, share in ((5, 0.05), (15, 0.15), (40, 0.4), (60, 0.6))]
COLUMNS += [(f"compression, {name} %", COMPRESSION, share) for name, share in ((5, 0.05), (15, 0.15), (40, 0.4), (60, 0.6))]
COLUMNS += [(f"in plane, {name} %", IN_PLANE, share) for name, share in ((1, 0.01), (3, 0.03))]


def percent(values):
    if not values:
        return "-"
    return " / ".join(f"{100 * value:.2g}" for value in (statistics.median(values), max(values)))


def fit_cells(rows):
    if not rows:
        return ["", "", ""]
    E = [float(row["E"]) for row in rows]
    fit = "none"
    if int(rows[0]["parameters"]):
        evaluations = statistics.mean(float(row["evaluations"]) for row in rows)
        fit = f"{evaluations:.0f}; {1e3 * statistics.mean(float(row['cpu_seconds']) for row in rows):.0f} ms"
    return [rows[0]["parameters"], f"{statistics.mean(E):.2f} ({statistics.median(E):.2f})", fit]


def main():
    folder = pathlib.Path(sys.argv[1])
    fits, errors, ratios, seconds = (defaultdict(list) for _ in range(4))
    for row in read_rows(folder / "scenarios.csv"):
        fits[row["model"]].append(row)
    surfaces = read_rows(folder / "surfaces.csv")
    case = lambda row: (row["surface"], row["wanted"])
    condensed = {case(row): float(row["seconds"]) for row in surfaces if row["model"] == "condensed"}
    without = defaultdict(int)
    for row in surfaces:
        if not row["mean_error"]:
            without[row["model"]] += 1
            continue
        errors[row["model"], row["kind"], float(row["wanted"])].append(float(row["mean_error"]))
        seconds[row["model"]].append(float(row["seconds"]))
        ratios[row["model"]].append(float(row["seconds"]) / condensed[case(row)])
    headings = ["model", "parameters", "E: mean (median)", "calibration", *(name for name, _, _ in COLUMNS), "simulation"]
    print("| " + " | ".join(headings) + " |\n" + "|---" * len(headings) + "|")
    for model in dict.fromkeys(row["model"] for row in surfaces):
        cells = fit_cells(fits[model])
        for _, kinds, wanted in COLUMNS:
            cells.append(percent([error for kind in kinds for error in errors[model, kind, wanted]]))
        cells.append(f"{1e3 * statistics.median(seconds[model]):.0f} ms; {statistics.median(ratios[model]):.1f}")
        print(f"| `{model}` | " + " | ".join(cells) + " |")
    cases = {case(row): row for row in surfaces}
    tiles = [int(row["tiles"]) for row in cases.values()]
    print(f"\n{len(next(iter(fits.values())))} patterns; {len(cases)} loaded surfaces of {min(tiles)} to {max(tiles)} tiles. "
          "Without an equilibrium: " + (", ".join(f"`{m}` {n}" for m, n in without.items()) or "none") + ".")


if __name__ == "__main__":
    main()
