#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve patterns of a layout again by CalculiX: the stiffness, and nonlinear responses.

Usage: resolve.py PROGRAM OUT.csv [--layout paper7] [--patterns sample:4|IDS]      Needs ccx (Debian: calculix-ccx) and NumPy.
Example: resolve.py build/release/apps/fretwork/fretwork out/resolved.csv --patterns sample:4
Both programs get one setting (resolve_linear.json, resolve_nonlinear.json), in which the beams of CalculiX are ours. Prints the largest
difference as a share of the largest displacement; ends with 1 if one is above its tolerance, with 77 without ccx.
"""
import argparse
import json
import pathlib
import shutil
import sys
import tempfile

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
sys.path.insert(0, str(HERE))
import calculix  # noqa: E402
from csv_tables import read_rows, write_table  # noqa: E402
from program import Fretwork  # noqa: E402

# CalculiX prints seven digits. Its nonlinear beams are solids, whose elements leave a difference that falls with their number.
TOLERANCES = {"linear": 1e-5, "nonlinear": 1e-3}


def solve_ours(program, folder, options, setting):
    """A library of the patterns with the setting's responses, as tables, meshes and stiffness in the folder."""
    fretwork = Fretwork(program, folder)
    fretwork("enumerate", "--layout", options.layout, "--library", "library.db")
    fretwork("calibrate", "--library", "library.db", "--setting", HERE / setting, "--patterns", options.patterns, "--model", "condensed")
    fretwork("library", "export", "--library", "library.db", "--csv", "tables", "--meshes", "meshes", "--stiffness", "stiffness", "--patterns", "computed")
    return json.loads((folder / "tables" / "setting.json").read_text()), (folder / "stiffness" / "patterns.txt").read_text().split()


def solved_by_stiffness(stiffness, scenario):
    """The displacements (nodes x 6) of a condensed tile under a scenario of 1 N."""
    count = stiffness.shape[0] // 6
    held = {6 * row["interface_node"] + calculix.COMPONENTS.index(name) for row in scenario["held"] for name in row["fixed"]}
    free = [dof for dof in range(6 * count) if dof not in held]
    force = numpy.zeros(6 * count)
    for load in scenario["loads"]:
        begin = 6 * load["interface_node"]
        force[begin:begin + 6] += [*load["force"], *load["moment"]]
    found = numpy.zeros(6 * count)
    found[free] = numpy.linalg.solve(stiffness[numpy.ix_(free, free)], force[free])
    return found.reshape(count, 6)


def share(theirs, ours):
    """The largest difference of translations as a share of the largest translation."""
    return numpy.abs(theirs[:, :3] - ours[:, :3]).max() / numpy.linalg.norm(ours[:, :3], axis=1).max()


def linear_rows(folder, setting, patterns):
    arrays = numpy.load(folder / "stiffness" / "stiffness.npy")
    for name, stiffness in zip(patterns, arrays):
        nodes, bars = calculix.read_mesh(folder / "meshes" / f"{name}.obj")
        theirs = calculix.run(calculix.linear_deck(nodes, bars, setting), stiffness.shape[0] // 6)
        for scenario, found in zip(setting["scenarios"], theirs):
            yield "linear", name, scenario["name"], 1.0, share(found, solved_by_stiffness(stiffness, scenario))


def nonlinear_rows(folder, setting, patterns):
    states = {(row["pattern_id"], row["scenario"], row["step"]): row for row in read_rows(folder / "tables" / "response_state.csv")}
    ours = {}
    for row in read_rows(folder / "tables" / "response.csv"):
        ours.setdefault((row["pattern_id"], row["scenario"], row["step"]), []).append([float(row[name]) for name in calculix.COMPONENTS])
    for name in patterns:
        nodes, bars = calculix.read_mesh(folder / "meshes" / f"{name}.obj")
        for scenario in setting["scenarios"]:
            key = name, scenario["name"], str(setting["magnitudes"])
            if key not in ours or states[key]["stable"] != "1":
                continue
            magnitude = float(states[key]["magnitude"])
            theirs = calculix.run(calculix.nonlinear_deck(nodes, bars, setting, scenario, magnitude), len(ours[key]))[-1]
            yield "nonlinear", name, scenario["name"], magnitude, share(theirs, numpy.array(ours[key]))


def resolve(program, options):
    for kind, rows in (("linear", linear_rows), ("nonlinear", nonlinear_rows)):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            yield from rows(folder, *solve_ours(program, folder, options, f"resolve_{kind}.json"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--layout", default="paper7")
    parser.add_argument("--patterns", default="sample:4")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        print("resolve.py: no ccx here (Debian: calculix-ccx)", file=sys.stderr)
        raise SystemExit(77)
    rows = list(resolve(options.program.resolve(), options))
    options.out.parent.mkdir(parents=True, exist_ok=True)
    write_table(options.out, ["kind", "pattern_id", "scenario", "magnitude", "difference"], ([*row[:4], f"{row[4]:.3g}"] for row in rows))
    worst = {}
    for kind, tolerance in TOLERANCES.items():
        shares = [row[4] for row in rows if row[0] == kind]
        worst[kind] = max(shares)
        print(f"{kind}: {len(shares)} solutions, largest difference {worst[kind]:.2g} of the largest displacement (tolerance {tolerance:g})")
    raise SystemExit(0 if all(worst[kind] <= tolerance for kind, tolerance in TOLERANCES.items()) else 1)


if __name__ == "__main__":
    main()
