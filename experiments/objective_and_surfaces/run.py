#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does a lower calibration objective mean a smaller error on a surface? One sheet for each of some patterns, painted with it alone,
under five loads; the calibrated ring with links against the tiles that it stands for.

Usage: run.py OUT [--patterns N]     (with the Python module)
Rows go to OUT/rows.csv; those that are there already are kept and not computed again.
"""
import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import GrowingTable  # noqa: E402
from module import fw  # noqa: E402

WIDTH, HEIGHT = 0.42, 0.26  # m
EDGE_LENGTH = 26 * 1e-3  # m, to the last bit what the program reads from "26mm": a mirrored tiling is as good, and rounding chooses
# Small: linear tiles (condensed) are the truth. The deflected sheet is bent by a tenth of its length: the full model is.
FORCES = {"tension": ([1, 0, 0], None), "shear": ([0, 1, 0], None), "bending": ([0, 0, 1], None), "twist": (None, [1, 0, 0])}
DEFLECTION = 0.1
DIGITS = 5  # of the numbers in rows.csv
SMALL_FORCE = 1e-4  # N, or N m
# How calibrations differ: the model, and what the setting says other than the paper's.
VARIANTS = {"paper6": ("paper6", {}), "ring10": ("ring10", {}), "equal weights": ("paper6", {"weights": 1.0}),
            "small loads": ("paper6", {"loads": 0.02})}


def displacements(surface, load_case, model):
    """Translations of the interface nodes, one after another."""
    moved = fw.simulate(surface, load_case, model=model).displacements[: len(surface.tessellation.interface_nodes), :3]
    return moved.ravel()


def load_case(force=None, moment=None, amount=SMALL_FORCE):
    load = fw.LoadCase.Load(fw.NodesAtSide("right"), amount="total")
    load.force, load.moment = (amount * np.array(given or [0, 0, 0]) for given in (force, moment))
    return fw.LoadCase(name="case", supports=[fw.LoadCase.Support(fw.NodesAtSide("left"), "all")], loads=[load])


def changed_setting(changes):
    setting = fw.paper_setting()
    scenarios = setting.scenarios
    for scenario in scenarios:
        scenario.weight = changes.get("weights", scenario.weight)
        scenario.max_magnitude *= changes.get("loads", 1.0)
    setting.scenarios = scenarios
    return setting


def make_libraries(out, count):
    """A library for each variant, with the same patterns."""
    layout = fw.paper_layout()
    libraries = {}
    for name, (model, changes) in VARIANTS.items():
        path = out / f"{name.replace(' ', '_')}.db"
        libraries[name] = fw.Library.open_or_create(path, layout, changed_setting(changes), fw.enumerate_patterns(layout))
        libraries[name].fill([entry.id for entry in libraries[name].sample(count)], model=model)
    return libraries


def compared(exact, found):
    """Relative L2 error, and the stiffness as a multiple of the true one (least squares)."""
    return np.linalg.norm(found - exact) / np.linalg.norm(exact), exact @ found / (found @ found)


class Truth:
    """What a sheet does: under the small loads by its linear tiles, bent by the full model."""

    def __init__(self, surface):
        self.small = {load: displacements(surface, load_case(*given), "condensed") for load, given in FORCES.items()}
        self.bending = load_case(FORCES["bending"][0],
                                 amount=SMALL_FORCE * DEFLECTION * WIDTH / np.abs(self.small["bending"]).max())
        self.bent = displacements(surface, self.bending, "full")
        self.error_of_condensed = compared(self.bent, displacements(surface, self.bending, "condensed"))[0]


def row_of(surface, model, truth):
    row = {}
    for load, given in FORCES.items():
        row[f"{load}_error"], row[f"{load}_stiffness"] = compared(truth.small[load], displacements(surface, load_case(*given), model))
    row["bent_error"], row["bent_stiffness"] = compared(truth.bent, displacements(surface, truth.bending, model))
    row["bent_error_of_condensed"] = truth.error_of_condensed
    return row


def rows_of(libraries, outline, pattern):
    truth = None
    for name, (model, _) in VARIANTS.items():
        library = libraries[name]
        project, _ = fw.make_project(outline, pattern, library, edge_length=EDGE_LENGTH)
        surface = fw.make_surface(project, library)
        truth = truth or Truth(surface)  # sheet and material are the same in all
        yield {"pattern": pattern, "edges": pattern.count("-"), "variant": name,
               "objective": library.calibrations(pattern)[0].calibration.objective, **row_of(surface, model, truth)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--patterns", type=int, default=60)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    outline = fw.make_outline([[0, 0], [WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]])
    libraries = make_libraries(options.out, options.patterns)
    patterns = sorted(entry.id for entry in libraries["paper6"].fitted_patterns())
    table = GrowingTable(options.out / "rows.csv", DIGITS)
    done = {row["pattern"] for row in table.rows}
    for pattern in patterns:
        if pattern not in done:
            table.add(list(rows_of(libraries, outline, pattern)))


if __name__ == "__main__":
    main()
