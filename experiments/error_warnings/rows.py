#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve surfaces of many kinds with reduced models, and record how far each is from the full one and what it said by itself.

Usage: rows.py PROGRAM OUT [--paintings 8] [--kinds NAME,..] [--random 126] [--seed 2] [--staged 2]
The kinds of cases.py, and random surfaces of ../large_deflections with another seed than there. Needs OUT/library.db with calibrations of
paper6, and OUT/patterns.txt. Rows go to OUT/rows.csv; those that are there are kept, so it goes on when started again.
"""
import argparse
import json
import pathlib
import sys
import time

for name in ("common", "large_deflections"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / name))
import cases  # noqa: E402
import run as large_deflections  # noqa: E402
import surfaces  # noqa: E402
from csv_tables import GrowingTable  # noqa: E402
from program import Failed  # noqa: E402
from surface import Surface, errors  # noqa: E402

TURNING = ("corotational", "mixed:0.05", "mixed:0.1")
LINEAR = ("condensed", "paper6")
STAGES = "corotational in stages"
FIELDS = ["kind", "painting", "amount", "tiles", "deflection", "model", "full", "reached", "mean", "largest", "stress", "tile_rotation",
          "change", "doubtful", "estimate", "estimate_mean", "stress_estimate", "fit_error", "warned", "seconds", "command_seconds",
          "full_seconds"]


class TimedSurface(Surface):
    def simulate(self, model, out, *options):
        """What the program tells, and how long the command took. A path that does not reach its load is an answer, too."""
        started = time.perf_counter()
        told = super().simulate(model, out, *options, accepted=(0, 1))
        return told | {"command_seconds": time.perf_counter() - started}

    def errors(self, full, reduced):
        return errors(self.compare(full, reduced)) | {"stress": self.stress_error(full, reduced)}

    def stress_error(self, full, reduced):
        """Of the largest von Mises stress, as a share of it; none where the beams are not known."""
        largest = [json.loads(self("beams", "project.json", name, "--top", "1", "--json", accepted=(0, 1)))["beams"]
                   for name in (full, reduced)]
        if not all(largest):
            return None
        truth, found = (beams[0]["largest_von_mises"] for beams in largest)
        return abs(found - truth) / truth


def own_kinds(fretwork, options):
    """Of each surface its case, and what tiles and loads it: gives the number of tiles, and the models that it can be solved with."""
    for case in cases.cases(range(1, options.paintings + 1)):
        def prepare(case=case):
            fretwork.write("case.json", case["load_case"])
            fretwork.write("stages.json", cases.stages(case["load_case"]))
            tiled = fretwork.tile(case["outline"], case["painting"], "--library", "../library.db", "--edge-length", "26mm")
            return tiled["tiles"], TURNING + LINEAR + ((STAGES,) if case["painting"] <= options.staged else ())
        if not options.kinds or case["kind"] in options.kinds.split(","):
            yield case, prepare


def random_surfaces(fretwork, options):
    """The same of the random surfaces, whose patterns are not calibrated."""
    patterns = (options.out / "patterns.txt").read_text().split()
    loading = large_deflections.ModelledSurface(fretwork.program, fretwork.folder)
    for surface in surfaces.surfaces(options.random, options.seed):
        def prepare(surface=surface):
            try:
                return large_deflections.make_surface(loading, surface, patterns)["tiles"], TURNING + LINEAR[:1]
            except Failed:  # no load bends it as far
                return 0, ()
        yield {"kind": f"random {surface['kind']}", "painting": surface["number"], "amount": round(surface["target"], 5)}, prepare


def row_of(fretwork, case, full, model):
    if model == STAGES:
        full = fretwork.simulate("full", "full-stages.json", "--stages", "stages.json")
        told = fretwork.simulate("corotational", "reduced.json", "--stages", "stages.json")
    else:
        told = fretwork.simulate(model, "reduced.json")
    doubt, estimate = told["model_doubt"] or {}, told["model_error_estimate"] or {}
    row = {"kind": case["kind"], "painting": case["painting"], "amount": case["amount"], "model": model, "full": full["termination"],
           "reached": told["termination"], "deflection": full["largest_displacement"], "tile_rotation": doubt.get("tile_rotation"),
           "change": doubt.get("change"), "doubtful": doubt.get("is_large"), "estimate": estimate.get("largest"),
           "estimate_mean": estimate.get("mean"), "stress_estimate": estimate.get("largest_stress"), "fit_error": told["fit_error"],
           "warned": int(bool(told["warnings"])), "seconds": told["seconds"], "command_seconds": told["command_seconds"],
           "full_seconds": full["seconds"]}
    if full["converged"] and told["converged"]:
        row |= fretwork.errors("full-stages.json" if model == STAGES else "full.json", "reduced.json")
    return row


def new_rows(fretwork, options, done):
    """Of each surface that is not done yet a row for each model."""
    for case, prepare in [*own_kinds(fretwork, options), *random_surfaces(fretwork, options)]:
        if (case["kind"], str(case["painting"]), str(case["amount"])) in done:
            continue
        tiles, models = prepare()
        full = fretwork.simulate("full", "full.json") if models else None
        yield [row_of(fretwork, case, full, model) | {"tiles": tiles} for model in models]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--paintings", type=int, default=8, help="of each kind")
    parser.add_argument("--staged", type=int, default=2, help="as many of these also in stages")
    parser.add_argument("--kinds", default="", help="these alone")
    parser.add_argument("--random", type=int, default=126, help="random surfaces")
    parser.add_argument("--seed", type=int, default=2, help="of the random surfaces")
    options = parser.parse_args()
    (options.out / "surface").mkdir(parents=True, exist_ok=True)
    fretwork = TimedSurface(options.program.resolve(), options.out / "surface")
    table = GrowingTable(options.out / "rows.csv", large_deflections.DIGITS, FIELDS)
    for rows in new_rows(fretwork, options, {(row["kind"], row["painting"], row["amount"]) for row in table.rows}):
        table.add(rows)


if __name__ == "__main__":
    main()
