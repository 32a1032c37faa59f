# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of a release folder."""
import csv

import numpy

TOLERANCE = 1e-9  # of properties of mirror images: rounding alone


def properties_of(folder):
    found = {}
    with (folder / "tables" / "property.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["pattern_id"], {})[row["name"]] = float(row["value"])
    return found


def unequal_mirrors(folder, properties):
    """Mirror images have the same stiffness in their symmetric parts."""
    with (folder / "tables" / "pattern.csv").open(newline="") as file:
        pairs = [(row["id"], row["mirror"]) for row in csv.DictReader(file)]
    for name, mirror in pairs:
        if name not in properties or mirror not in properties:
            continue
        for key in ("A11", "A22", "A66", "D11", "D22", "D66", "mass_per_area"):
            ours, theirs = properties[name][key], properties[mirror][key]
            if abs(ours - theirs) > TOLERANCE * max(abs(ours), abs(theirs)):
                yield f"{name} and its mirror image {mirror}: {key} {ours!r} and {theirs!r}"


def indefinite(properties):
    """Stiffness of a plate stores energy in every strain."""
    for name, values in properties.items():
        for letter in "AD":
            rows = [[values[letter + index] for index in row] for row in (("11", "12", "16"), ("12", "22", "26"), ("16", "26", "66"))]
            least = numpy.linalg.eigvalsh(rows)[0]
            if least <= 0.0:
                yield f"{name}: {letter} has the eigenvalue {least!r}"


def silent_failures(folder, arrays):
    """A sample has converged with finite displacements, or it says that it has not; a pattern without results is in failure.csv."""
    finite = numpy.isfinite(arrays["displacements"]).all(axis=(3, 4))
    for name in arrays["patterns"][(arrays["converged"] & ~finite).any(axis=(1, 2))]:
        yield f"{name}: a converged sample has displacements that are not finite"
    with (folder / "tables" / "calibration.csv").open(newline="") as file:
        calibrated = {(row["pattern_id"], row["model"]) for row in csv.DictReader(file)}
    with (folder / "tables" / "failure.csv").open(newline="") as file:
        failed = {row["pattern_id"] for row in csv.DictReader(file)}
    models = {model for _, model in calibrated}
    for name in arrays["patterns"]:
        for model in sorted(models):
            if (name, model) not in calibrated and name not in failed:
                yield f"{name}: has neither a calibration of {model} nor a failure"


def check(folder, arrays):
    """What is wrong with the release; one line each."""
    properties = properties_of(folder)
    complaints = [f"{name}: has responses and no properties" for name in arrays["patterns"] if name not in properties]
    return complaints + [*unequal_mirrors(folder, properties), *indefinite(properties), *silent_failures(folder, arrays)]
