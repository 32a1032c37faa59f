#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does a lower calibration objective mean a smaller error on a surface? One sheet for each of some patterns, painted with it alone,
under five loads; the calibrated ring with links against the tiles that it stands for.

Usage: run.py PROGRAM OUT [--patterns N]
Rows go to OUT/rows.csv; those that are there already are kept and not computed again.
"""
import argparse
import csv
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from program import Fretwork  # noqa: E402

WIDTH, HEIGHT = 0.42, 0.26  # m
# Small: linear tiles (condensed) are the truth. The deflected sheet is bent by a tenth of its length: the full model is.
FORCES = {"tension": ([1, 0, 0], None), "shear": ([0, 1, 0], None), "bending": ([0, 0, 1], None), "twist": (None, [1, 0, 0])}
DEFLECTION = 0.1
SMALL_FORCE = 1e-4  # N, or N m
# How calibrations differ: the model, and what the setting says other than the paper's.
VARIANTS = {"paper6": ("paper6", {}), "ring10": ("ring10", {}), "equal weights": ("paper6", {"weights": 1.0}),
            "small loads": ("paper6", {"loads": 0.02})}


def displacements(fretwork, project, model):
    """Translations of the interface nodes, one after another."""
    fretwork("simulate", project, "--case", "./case.json", "--model", model, "--out", "result.json")
    result = json.loads((fretwork.folder / "result.json").read_text())
    pairs = zip(result["nodes"], result["displacements"])
    return [component for node, moved in pairs if node.get("interface") for component in moved[:3]]


def write(path, content):
    path.write_text(json.dumps(content))


def write_case(folder, force=None, moment=None, amount=SMALL_FORCE):
    load = {"side": "right", "amount": "total"}
    if force is not None:
        load["force"] = [amount * x for x in force]
    if moment is not None:
        load["moment"] = [amount * x for x in moment]
    held = {"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}
    write(folder / "case.json", {"format": "fretwork/load-case/1", "name": "case", "supports": [held], "loads": [load]})


def make_libraries(fretwork, count):
    """A library for each variant, with the same patterns. Returns their ids."""
    for name, (model, changes) in VARIANTS.items():
        library = f"{name.replace(' ', '_')}.db"
        if not (fretwork.folder / library).exists():
            fretwork("enumerate", "--layout", "paper7", "--library", library)
        options = []
        if changes:
            write(fretwork.folder / "setting.json", changed_setting(fretwork, changes))
            options = ["--setting", "setting.json"]
        fretwork("calibrate", "--library", library, "--patterns", f"sample:{count}", "--model", model, *options)
    fretwork("library", "export", "--library", "paper6.db", "--csv", "tables")
    with (fretwork.folder / "tables" / "calibration.csv").open() as file:
        return sorted(row["pattern_id"] for row in csv.DictReader(file))


def changed_setting(fretwork, changes):
    fretwork("library", "export", "--library", "paper6.db", "--csv", "tables")
    setting = json.loads((fretwork.folder / "tables" / "setting.json").read_text())
    for scenario in setting["scenarios"]:
        scenario["weight"] = changes.get("weights", scenario["weight"])
        scenario["max_magnitude"] *= changes.get("loads", 1.0)
    return setting


def objective(fretwork, library, pattern):
    shown = json.loads(fretwork("library", "show", pattern, "--library", library, "--json"))
    return shown["calibrations"][0]["objective"]


def product(a, b):
    return sum(x * y for x, y in zip(a, b))


def compared(exact, found):
    """Relative L2 error, and the stiffness as a multiple of the true one (least squares)."""
    return math.dist(found, exact) / math.hypot(*exact), product(exact, found) / product(found, found)


class Truth:
    """What a sheet does: under the small loads by its linear tiles, bent by the full model."""

    def __init__(self, fretwork, project):
        self.small = {}
        for load, (force, moment) in FORCES.items():
            write_case(fretwork.folder, force, moment)
            self.small[load] = displacements(fretwork, project, "condensed")
        self.bending_force = SMALL_FORCE * DEFLECTION * WIDTH / max(map(abs, self.small["bending"]))
        self.write_bending_case(fretwork.folder)
        self.bent = displacements(fretwork, project, "full")
        self.error_of_condensed = compared(self.bent, displacements(fretwork, project, "condensed"))[0]

    def write_bending_case(self, folder):
        write_case(folder, FORCES["bending"][0], amount=self.bending_force)


def row_of(fretwork, project, model, truth):
    row = {}
    for load, (force, moment) in FORCES.items():
        write_case(fretwork.folder, force, moment)
        row[f"{load}_error"], row[f"{load}_stiffness"] = compared(truth.small[load], displacements(fretwork, project, model))
    truth.write_bending_case(fretwork.folder)
    row["bent_error"], row["bent_stiffness"] = compared(truth.bent, displacements(fretwork, project, model))
    row["bent_error_of_condensed"] = truth.error_of_condensed
    return row


def rows_of(fretwork, pattern):
    truth = None
    for name, (model, _) in VARIANTS.items():
        library = f"{name.replace(' ', '_')}.db"
        project = f"sheet_{name.replace(' ', '_')}.json"
        fretwork("tile", "outline.json", "--edge-length", "26mm", "--patterns", pattern, "--library", library, "--out", project)
        truth = truth or Truth(fretwork, project)  # sheet and material are the same in all
        yield {"pattern": pattern, "edges": pattern.count("-"), "variant": name, "objective": objective(fretwork, library, pattern),
               **row_of(fretwork, project, model, truth)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--patterns", type=int, default=60)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = Fretwork(options.program.resolve(), options.out)
    corners = [[0, 0], [WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]]
    write(options.out / "outline.json", {"format": "fretwork/outline/1", "boundary": corners, "holes": []})
    patterns = make_libraries(fretwork, options.patterns)
    table = options.out / "rows.csv"
    done = set()
    if table.exists():
        done = {row["pattern"] for row in csv.DictReader(table.open())}
    with table.open("a", newline="") as file:
        writer = None
        for pattern in patterns:
            if pattern in done:
                continue
            for row in list(rows_of(fretwork, pattern)):
                if writer is None:
                    writer = csv.DictWriter(file, row, lineterminator="\n")
                    if not done:
                        writer.writeheader()
                writer.writerow({k: f"{v:.5g}" if isinstance(v, float) else v for k, v in row.items()})
            file.flush()


if __name__ == "__main__":
    main()
