#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Corotational cantilevers and bridges of further seeds: how many are beyond the aims, and do their results say so?

Usage: held_out.py PROGRAM PATTERNS OUT [--seeds 3,4,5,6] [--count 126]
Rows go to OUT/held_out.csv; those that are there are kept. Prints a table of both kinds. Exit code 1 if a surface beyond the aims is
not named: neither warned of, nor with an estimate that is beyond them.
"""
import json

import run
import surfaces
from csv_tables import GrowingTable, print_table, read_rows
from program import Failed
from surface import errors

AIMS = {"mean": 0.015, "largest": 0.035}
FIELDS = ["seed", "number", "kind", "shape", "tiles", "deflection", "mean", "largest", "tile_rotation", "estimate_mean",
          "estimate_largest", "estimate_stress", "warned", "note"]


def row_of(study, surface):
    tiles = run.make_surface(study.fretwork, surface, study.patterns)["tiles"]
    full = study.fretwork.simulate("full")
    told = study.fretwork.simulate("corotational")
    estimate = told["model_error_estimate"] or {}
    found = errors(study.fretwork.compare("full", "corotational"))
    return {"tiles": tiles, "deflection": full["largest_displacement"] / run.extent(surface["outline"]["boundary"])[0],
            "mean": found["mean"], "largest": found["largest"], "tile_rotation": told["model_doubt"]["tile_rotation"],
            "estimate_mean": estimate.get("mean"), "estimate_largest": estimate.get("largest"),
            "estimate_stress": estimate.get("largest_stress"), "warned": len(told["warnings"])}


def new_rows(study, done):
    for seed in map(int, study.options.seeds.split(",")):
        for surface in surfaces.surfaces(study.options.count, seed):
            if surface["kind"] not in ("cantilever", "bridge") or (str(seed), str(surface["number"])) in done:
                continue
            row = {"seed": seed, **{key: surface[key] for key in ("number", "kind", "shape")}}
            try:
                row |= row_of(study, surface)
            except Failed as failure:
                row["note"] = failure.told
            yield row


def is_beyond(row, prefix=""):
    return any(row[prefix + key] and float(row[prefix + key]) > aim for key, aim in AIMS.items())


def print_tables(rows):
    lines = []
    for kind in ("cantilever", "bridge"):
        own = [row for row in rows if row["kind"] == kind and not row["note"]]
        beyond = [row for row in own if is_beyond(row)]
        named = [row for row in beyond if row["warned"] == "1" or is_beyond(row, "estimate_")]
        wrongly = [row for row in own if row["warned"] == "1" and not is_beyond(row)]
        lines.append([kind, len(own), *(f"{100 * max((float(row[key]) for row in own), default=0):.2g} %" for key in AIMS), len(beyond),
                      len(named), len(wrongly)])
    header = ["kind", "surfaces", "largest mean error", "largest error of a node", "beyond 1.5 or 3.5 %", "of these named",
              "warned of, and not beyond"]
    print_table(header, lines)
    for row in rows:
        if row["note"]:
            print(f"without a result: {row['seed']} {row['number']} ({row['kind']}): {row['note']}")
        elif is_beyond(row):
            print(json.dumps({key: row[key] for key in FIELDS[:-1]}))
    return sum(line[4] - line[5] for line in lines)


def main():
    study = run.Study(__doc__, lambda parser: parser.add_argument("--seeds", default="3,4,5,6"))
    table = GrowingTable(study.out / "held_out.csv", run.DIGITS, FIELDS)
    for row in new_rows(study, {(row["seed"], row["number"]) for row in table.rows}):
        table.add([row])
    raise SystemExit(1 if print_tables(read_rows(table.path)) else 0)


if __name__ == "__main__":
    main()
