# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of a release folder."""
import numpy

from csv_tables import read_rows

TOLERANCE = 1e-9  # of what is equal but for rounding


def properties_of(folder):
    found = {}
    for row in read_rows(folder / "tables" / "property.csv"):
        found.setdefault(row["pattern_id"], {})[row["name"]] = float(row["value"])
    return found


def mirror_pairs(folder):
    return [(row["id"], row["mirror"]) for row in read_rows(folder / "tables" / "pattern.csv")]


def unequal_mirrors(pairs, properties):
    """Mirror images have the same stiffness in their symmetric parts."""
    for name, mirror in pairs:
        if name not in properties or mirror not in properties:
            continue
        for key in ("A11", "A22", "A66", "D11", "D22", "D66", "mass_per_area"):
            ours, theirs = properties[name][key], properties[mirror][key]
            if abs(ours - theirs) > TOLERANCE * max(abs(ours), abs(theirs)):
                yield f"{name} and its mirror image {mirror}: {key} {ours!r} and {theirs!r}"


def unequal_mirror_stiffness(pairs, matrices):
    """The stiffness of mirror images has the same eigenvalues."""
    at = {name: place for place, name in enumerate(matrices["patterns"])}
    values = numpy.linalg.eigvalsh(matrices["stiffness"])
    for name, mirror in pairs:
        if name in at and mirror in at and name < mirror:
            difference = numpy.abs(values[at[name]] - values[at[mirror]]).max()
            if difference > TOLERANCE * values[at[name]].max():
                yield f"{name} and its mirror image {mirror}: eigenvalues of the stiffness differ by {difference!r}"


def unsound_stiffness(matrices):
    """Condensed stiffness is symmetric, has no negative energy, and six motions of the rigid tile cost nothing."""
    for name, matrix in zip(matrices["patterns"], matrices["stiffness"]):
        values = numpy.linalg.eigvalsh(matrix)
        if numpy.abs(matrix - matrix.T).max() > TOLERANCE * values[-1]:
            yield f"{name}: the stiffness is not symmetric"
        if values[0] < -TOLERANCE * values[-1]:
            yield f"{name}: the stiffness has the eigenvalue {values[0]!r}"
        if numpy.count_nonzero(values < TOLERANCE * values[-1]) < 6:
            yield f"{name}: a motion of the rigid tile costs energy"


def unequal_tensors(properties, matrices):
    """A and D from the released stiffness are those that the program computed; a plane frame has no coupling B."""
    for name, *tensors in zip(*(matrices[key] for key in ("patterns", "A", "B", "D"))):
        scale = dict(zip("ABD", (abs(tensors[0]).max(), (abs(tensors[0]).max() * abs(tensors[2]).max()) ** 0.5, abs(tensors[2]).max())))
        if abs(tensors[1]).max() > TOLERANCE * scale["B"]:
            yield f"{name}: B has the entry {abs(tensors[1]).max()!r}"
        for letter, tensor in zip("AD", tensors[::2]):
            theirs = [[properties[name][letter + index] for index in row] for row in (("11", "12", "16"), ("12", "22", "26"), ("16", "26", "66"))]
            if numpy.abs(tensor - theirs).max() > TOLERANCE * scale[letter]:
                yield f"{name}: {letter} from the stiffness differs by {numpy.abs(tensor - theirs).max()!r} from that of property.csv"


def indefinite(properties):
    """Stiffness of a plate stores energy in every strain."""
    for name, values in properties.items():
        for letter in "AD":
            rows = [[values[letter + index] for index in row] for row in (("11", "12", "16"), ("12", "22", "26"), ("16", "26", "66"))]
            least = numpy.linalg.eigvalsh(rows)[0]
            if least <= 0.0:
                yield f"{name}: {letter} has the eigenvalue {least!r}"


def silent_failures(folder, arrays, is_whole):
    """A sample has converged with finite displacements, or it says that it has not; a pattern without results is in failure.csv."""
    finite = numpy.isfinite(arrays["displacements"]).all(axis=(3, 4))
    for name in arrays["patterns"][(arrays["converged"] & ~finite).any(axis=(1, 2))]:
        yield f"{name}: a converged sample has displacements that are not finite"
    failed = {row["pattern_id"] for row in read_rows(folder / "tables" / "failure.csv")}
    calibrated = {(row["pattern_id"], row["model"]) for row in read_rows(folder / "tables" / "calibration.csv")}
    models = sorted({model for _, model in calibrated})
    for name in arrays["patterns"]:
        for model in models:
            if (name, model) not in calibrated and name not in failed:
                yield f"{name}: has neither a calibration of {model} nor a failure"
    wanted = {row["id"] for row in read_rows(folder / "tables" / "pattern.csv")} if is_whole else set()
    for name in sorted(wanted - set(arrays["patterns"]) - failed):
        yield f"{name}: has neither responses nor a failure"


def check(folder, arrays, matrices, is_whole=False):
    """What is wrong with the release; one line each. `is_whole`: every pattern of pattern.csv should have results."""
    properties, pairs = properties_of(folder), mirror_pairs(folder)
    complaints = [f"{name}: has responses and no properties" for name in arrays["patterns"] if name not in properties]
    if list(matrices["patterns"]) != list(arrays["patterns"]):
        complaints.append("stiffness.npz and arrays.npz have other patterns")
    return complaints + [*unequal_mirrors(pairs, properties), *unequal_mirror_stiffness(pairs, matrices), *indefinite(properties),
                         *unsound_stiffness(matrices), *unequal_tensors(properties, matrices), *silent_failures(folder, arrays, is_whole)]
