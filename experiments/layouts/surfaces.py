#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the files of surfaces.sh to a table, a row for each layout.

Usage: surfaces.py FOLDER OUT.csv
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import write_table  # noqa: E402

MODELS = ("paper6", "condensed", "corotational")


def row(folder, name):
    def load(what):
        path = folder / f"{name}-{what}.json"
        return json.loads(path.read_text()) if path.exists() else None

    calibrated = load("calibrations")
    compared = {model: load(f"{model}-compared") for model in MODELS}
    largest = compared["condensed"]["max_displacement_m"]
    cells = {"layout": name, "patterns": calibrated["calibrated"], "failed": calibrated["failed"],
             "objective_mean": f"{calibrated['objective_mean']:.2f}",
             "objective_median": f"{calibrated['objective_median']:.2f}", "tiles": load("tiles")["tiles"],
             "largest_displacement_mm": f"{1e3 * largest:.1f}"}
    for model in MODELS:
        told = compared[model]  # none where the model did not converge
        cells[f"{model}_mean_error_percent"] = f"{100 * told['mean_translation_error_m'] / largest:.2g}" if told else ""
    return cells


def main():
    folder, out = map(pathlib.Path, sys.argv[1:])
    suffix = "-calibrations.json"
    names = sorted(path.name.removesuffix(suffix) for path in folder.glob("*" + suffix))
    rows = [row(folder, name) for name in names]
    write_table(out, list(rows[0]), (line.values() for line in rows))


if __name__ == "__main__":
    main()
