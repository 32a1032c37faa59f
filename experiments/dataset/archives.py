# SPDX-License-Identifier: GPL-3.0-or-later
"""NumPy archives of a release: the tables of responses as arrays, and the condensed stiffness with the plate's tensors."""
import numpy

from csv_tables import each_row, read_rows
from plate import Plate


def state_arrays(states, shape, place_of):
    """Magnitudes, errors and flags of samples: patterns x scenarios x magnitudes."""
    arrays = {"magnitude": numpy.zeros(shape), "discretization_error": numpy.full(shape, numpy.nan)}
    arrays |= {name: numpy.zeros(shape, dtype=bool) for name in ("converged", "stable", "limit_load")}
    for row in states:
        for name, array in arrays.items():
            if row[name] != "":
                array[place_of(row)] = float(row[name])
    return arrays


def response_arrays(tables):
    """The responses as arrays: patterns x scenarios x magnitudes (x nodes x 6), and flags of samples."""
    scenarios = [row["name"] for row in sorted(read_rows(tables / "scenario.csv"), key=lambda row: int(row["position"]))]
    states = read_rows(tables / "response_state.csv")
    patterns = sorted({row["pattern_id"] for row in states})
    pattern_at = {name: place for place, name in enumerate(patterns)}
    scenario_at = {name: place for place, name in enumerate(scenarios)}

    def place_of(row):
        return pattern_at[row["pattern_id"]], scenario_at[row["scenario"]], int(row["step"]) - 1

    shape = (len(patterns), len(scenarios), max(int(row["step"]) for row in states))
    arrays = state_arrays(states, shape, place_of)
    nodes = 1 + max(int(row["node"]) for row in each_row(tables / "response.csv"))
    displacements = numpy.full((*shape, nodes, 6), numpy.nan)
    for row in each_row(tables / "response.csv"):
        displacements[(*place_of(row), int(row["node"]))] = [float(row[name]) for name in ("ux", "uy", "uz", "rx", "ry", "rz")]
    return {"patterns": numpy.array(patterns), "scenarios": numpy.array(scenarios), "displacements": displacements, **arrays}


def stiffness_arrays(folder, layout, setting):
    """The condensed stiffness (P x 6n x 6n) in the order of the ids, and A, B and D (P x 3 x 3). `folder` is that of `library export --stiffness`."""
    names = numpy.array((folder / "patterns.txt").read_text().split())
    order = numpy.argsort(names)
    stiffness = numpy.load(folder / "stiffness.npy")[order]
    plate = Plate(layout, setting)
    tensors = [numpy.array(tensor) for tensor in zip(*(plate.tensors(matrix) for matrix in stiffness))]
    return {"patterns": names[order], "stiffness": stiffness, **dict(zip("ABD", tensors))}
