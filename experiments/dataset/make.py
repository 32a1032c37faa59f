#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the release folder of one layout and one setting: patterns, responses, calibrations and plate properties.

Usage: make.py PROGRAM OUT [--layout paper7] [--setting paper|made|FILE] [--patterns all|sample:N|IDS] [--threads N]
Example: make.py build/release/apps/fretwork/fretwork out/dataset/paper7 --patterns sample:20
Killed at any moment, the same command goes on. OUT then has library.db, tables/, arrays.npz, datapackage.json,
held_out.txt and SHA256SUMS; all but library.db are equal to the last byte for equal content (program, layout, setting, patterns).
"""
import argparse
import csv
import hashlib
import json
import pathlib
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
sys.path.insert(0, str(HERE))
from checks import check  # noqa: E402
from program import Fretwork  # noqa: E402

FITTED = ("paper6", "ring10")
HELD_OUT_OF_TEN = 2


def is_held_out(pattern_id):
    """Two in ten patterns, by the SHA-256 of the id: the split depends on nothing else."""
    return int(hashlib.sha256(pattern_id.encode()).hexdigest(), 16) % 10 < HELD_OUT_OF_TEN


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def fill(fretwork, options):
    """Enumerate and calibrate what is lacking; one model after the other."""
    fretwork("enumerate", "--layout", options.layout, "--library", "library.db")
    for model in FITTED:
        fretwork("calibrate", "--library", "library.db", "--setting", options.setting, "--patterns", options.patterns, "--model", model,
                 "--threads", options.threads)
    fretwork("library", "export", "--library", "library.db", "--csv", "tables")
    fretwork("enumerate", "--layout", options.layout, "--classes", "tables/classes.csv")


def arrays_of(folder):
    """The responses as arrays: patterns x scenarios x magnitudes (x nodes x 6), and flags of samples."""
    scenarios = [row["name"] for row in sorted(rows_of(folder / "scenario.csv"), key=lambda row: int(row["position"]))]
    states = rows_of(folder / "response_state.csv")
    patterns = sorted({row["pattern_id"] for row in states})
    at = {name: place for place, name in enumerate(patterns)}
    scenario_at = {name: place for place, name in enumerate(scenarios)}
    shape = (len(patterns), len(scenarios), max(int(row["step"]) for row in states))
    arrays = {"magnitude": numpy.zeros(shape), "discretization_error": numpy.full(shape, numpy.nan)}
    arrays |= {name: numpy.zeros(shape, dtype=bool) for name in ("converged", "stable", "limit_load")}
    for row in states:
        place = at[row["pattern_id"]], scenario_at[row["scenario"]], int(row["step"]) - 1
        for name, array in arrays.items():
            if row[name] != "":
                array[place] = float(row[name])
    with (folder / "response.csv").open(newline="") as file:
        nodes = 1 + max(int(row["node"]) for row in csv.DictReader(file))
    displacements = numpy.full((*shape, nodes, 6), numpy.nan)
    with (folder / "response.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            place = at[row["pattern_id"]], scenario_at[row["scenario"]], int(row["step"]) - 1, int(row["node"])
            displacements[place] = [float(row[name]) for name in ("ux", "uy", "uz", "rx", "ry", "rz")]
    return {"patterns": numpy.array(patterns), "scenarios": numpy.array(scenarios), "displacements": displacements, **arrays}


def data_package(folder, options):
    """Frictionless: one resource a table, one field a column, its meaning from dictionary.csv."""
    meaning = {(row["table"], row["column"]): row for row in rows_of(HERE / "dictionary.csv")}
    resources = []
    for path in sorted((folder / "tables").glob("*.csv")):
        with path.open(newline="") as file:
            columns = next(csv.reader(file))
        fields = []
        for column in columns:
            row = meaning.get((path.stem, column)) or meaning.get(("*", column))
            if row is None:
                raise SystemExit(f"dictionary.csv: has no row for column {column} of {path.name}")
            fields.append({"name": column, "type": row["type"], "description": row["meaning"], "unit": row["unit"]})
        resources.append({"name": path.stem.replace("_", "-"), "path": f"tables/{path.name}", "format": "csv", "profile": "tabular-data-resource",
                          "schema": {"fields": fields}, "hash": f"sha256:{digest(path)}", "bytes": path.stat().st_size})
    return {"profile": "tabular-data-package", "name": f"fretwork-{options.layout}", "resources": resources}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def write_release(folder, options):
    tables = folder / "tables"
    arrays = arrays_of(tables)
    numpy.savez_compressed(folder / "arrays.npz", **arrays)
    (folder / "held_out.txt").write_text("".join(f"{name}\n" for name in arrays["patterns"] if is_held_out(name)))
    (folder / "datapackage.json").write_text(json.dumps(data_package(folder, options), indent=1) + "\n")
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name not in ("SHA256SUMS", "library.db"))
    (folder / "SHA256SUMS").write_text("".join(f"{digest(path)}  {path.relative_to(folder)}\n" for path in files))
    return arrays


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--layout", default="paper7")
    parser.add_argument("--setting", default="paper")
    parser.add_argument("--patterns", default="all")
    parser.add_argument("--threads", default="0")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    fill(Fretwork(options.program.resolve(), options.out), options)
    arrays = write_release(options.out, options)
    complaints = check(options.out, arrays)
    size = sum(path.stat().st_size for path in options.out.rglob("*") if path.is_file())
    print(f"{len(arrays['patterns'])} patterns, {arrays['converged'].size} states, {int(arrays['converged'].sum())} converged, "
          f"{int((arrays['converged'] & arrays['stable']).sum())} of them stable; {size / 1e6:.1f} MB")
    for complaint in complaints:
        print(f"check failed: {complaint}", file=sys.stderr)
    raise SystemExit(1 if complaints else 0)


if __name__ == "__main__":
    main()
