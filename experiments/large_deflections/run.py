#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve random painted surfaces with every model and compare each with the full one.

Usage: run.py PROGRAM PATTERNS OUT [--count N] [--seed N]   (PATTERNS: ids, one a line)
Rows go to OUT/rows.csv; those that are there already are kept and not computed again.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
import surfaces  # noqa: E402
from csv_tables import GrowingTable  # noqa: E402
from program import Failed  # noqa: E402
from surface import Surface, errors, palette  # noqa: E402

MODELS = ("condensed", "corotational", "mixed:0.05", "mixed:0.1", "mixed:0.3")
SEARCH_STEPS = 6
DIGITS = 5  # of the numbers in tables
FIELDS = ["number", "kind", "shape", "tiles", "span", "deflection", "rotation", "full_s", "full_linear_s"]
for name in MODELS:
    FIELDS += [f"{name}_{what}" for what in ("mean", "largest", "l2", "s")]
# Estimates of a mean error: the difference from mixed:0.05 and 0.1 for corotational, and from mixed:0.3 for the other models.
DIFFERENCES = {"by_5": ("mixed:0.05", "corotational"), "by_10": ("mixed:0.1", "corotational"),
               "condensed_by_30": ("mixed:0.3", "condensed"), "mixed_by_30": ("mixed:0.3", "mixed:0.05")}
FIELDS += ["estimate_mean", "estimate_largest", "estimate_l2", *DIFFERENCES, "buckled", "note"]


class ModelledSurface(Surface):
    """Its results are named after their models."""

    def simulate(self, model, *options):
        return super().simulate(model, result_file(model, options), *options)

    def compare(self, better, model):
        return super().compare(result_file(better), result_file(model))


def result_file(model, options=()):
    return model.replace(":", "-") + ("-linear" if "--linear" in options else "") + ".json"


def extent(boundary):
    return max(p[0] for p in boundary), max(p[1] for p in boundary)


def find_load(fretwork, surface):
    """Scale the load until the corotational model is deflected as wanted, to a fifth."""
    width, height = extent(surface["outline"]["boundary"])
    wanted = surface["target"] * width

    def deflection(amount, model):
        fretwork.write("case.json", surfaces.load_case(surface["kind"], amount, width, height))
        return fretwork.simulate(model)["largest_displacement"]

    if surface["kind"] == "prescribed":
        return deflection(wanted, "corotational")
    amount = 0.01
    amount *= wanted / deflection(amount, "condensed")  # what a linear surface would take
    for _ in range(SEARCH_STEPS):
        try:
            found = deflection(amount, "corotational")
        except Failed:  # beyond a limit load
            amount *= 0.5
            continue
        if abs(found / wanted - 1) < 0.2:
            return found
        amount *= min(3.0, max(0.3, (wanted / found) ** 1.3))
    return deflection(amount, "corotational")


def make_surface(fretwork, surface, patterns):
    """Tile, paint and load it. Returns what `tile` tells."""
    tiled = fretwork.tile(surface["outline"], surface["painting"] % 10000, "--palette", palette(patterns, surface["painting"]), "--setting", "paper")
    find_load(fretwork, surface)
    return tiled


def row_of(fretwork, surface, patterns):
    tiled = make_surface(fretwork, surface, patterns)
    full = fretwork.simulate("full")
    span = extent(surface["outline"]["boundary"])[0]
    row = {"number": surface["number"], "kind": surface["kind"], "shape": surface["shape"], "tiles": tiled["tiles"], "span": span,
           "deflection": full["largest_displacement"] / span, "rotation": full["largest_rotation"], "full_s": full["seconds"],
           "full_linear_s": fretwork.simulate("full", "--linear")["seconds"]}
    for model in MODELS:
        row[f"{model}_s"] = fretwork.simulate(model)["seconds"]
        compared = fretwork.compare("full", model)
        found = errors(compared) | {"l2": compared["relative_l2_error"]}
        row.update({f"{model}_{what}": value for what, value in found.items()})
    for name, pair in DIFFERENCES.items():
        row[name] = errors(fretwork.compare(*pair))["mean"]
    estimate = fretwork.simulate("corotational", "--estimate-model-error")
    row.update({f"estimate_{short}": estimate["model_error_estimate"][key]
                for short, key in (("mean", "mean"), ("largest", "largest"), ("l2", "relative_l2"))})
    row["buckled"] = len(estimate["buckled_tiles"])
    return row


class Study:
    """What the command line of a study says, and the program to run it with."""

    def __init__(self, description, add_options=lambda parser: None):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("program", type=pathlib.Path)
        parser.add_argument("patterns", type=pathlib.Path)
        parser.add_argument("out", type=pathlib.Path)
        parser.add_argument("--count", type=int, default=126)
        parser.add_argument("--seed", type=int, default=1)
        add_options(parser)
        self.options = options = parser.parse_args()
        self.out, self.folder = options.out, options.out / "surface"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.patterns = options.patterns.read_text().split()
        self.fretwork = ModelledSurface(options.program.resolve(), self.folder)
        self.surfaces = surfaces.surfaces(options.count, options.seed)


def main():
    study = Study(__doc__)
    table = GrowingTable(study.out / "rows.csv", DIGITS, FIELDS)
    done = {int(row["number"]) for row in table.rows}
    for surface in study.surfaces:
        if surface["number"] in done:
            continue
        try:
            row = row_of(study.fretwork, surface, study.patterns)
        except Failed as failure:
            row = {"number": surface["number"], "kind": surface["kind"], "shape": surface["shape"], "note": failure.told}
        table.add([row])


if __name__ == "__main__":
    main()
