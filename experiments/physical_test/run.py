#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's physical test, computed: two cantilevers of PLA under their own weight, with all models.

Usage: run.py PROGRAM OUT [--measured SPECIMEN=FILE.csv ..]
Writes OUT/profiles.csv (specimen, model, along, down: millimetres), OUT/figure.svg, and prints a table. Measured points, as measure.py
writes them, go into the figure and the table.
"""
import argparse
import json
import math
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
import figure  # noqa: E402
from csv_tables import read_rows, write_table  # noqa: E402
from program import Fretwork  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
SPECIMENS = {"light": "2-4+4-6", "dense": "1-2+2-3+3-5+3-6+4-6+5-6"}
MODELS = ("full", "corotational", "condensed", "paper6")
STIFF = "full, stiff joints"
TRUE_WEIGHT = "full, stiff joints, true weight"
WIDTH = 0.18  # m, of the clamped side
MIDDLE_BAND = 0.2  # of the width: nodes this near to the middle line make the profile
STATIONS = 14  # along the cantilever


def middle_line(result):
    """Deflected nodes near the middle line: (distance from the clamp, depth below it), m, means over stations."""
    points = []
    for node, moved in zip(result["nodes"], result["displacements"]):
        x, y, _ = node["rest_position"]
        if node.get("interface") and abs(x - WIDTH / 2) <= MIDDLE_BAND * WIDTH:
            points.append((y + moved[1], -moved[2]))
    points.sort()
    size = math.ceil(len(points) / STATIONS)
    groups = [points[i:i + size] for i in range(0, len(points), size)]
    return [tuple(statistics.fmean(axis) for axis in zip(*group)) for group in groups]


def fill_library(fretwork, name, setting, *options):
    """A library of a setting, with calibrations of the specimens' patterns."""
    (fretwork.folder / f"{name}-setting.json").write_text(json.dumps(setting))
    if not (fretwork.folder / f"{name}.db").exists():
        fretwork("enumerate", "--library", f"{name}.db")
    fretwork("calibrate", "--library", f"{name}.db", "--setting", f"{name}-setting.json", "--patterns", ",".join(SPECIMENS.values()), *options)


def fill_libraries(fretwork):
    setting = json.loads((HERE.parent / "settings" / "pla.json").read_text())
    fill_library(fretwork, "pla", setting)
    fill_library(fretwork, "pla-stiff", setting | {"format": "fretwork/setting/2", "joints": "stiff"}, "--model", "condensed")


def result_of(fretwork, project, model, case="own-weight"):
    path = f"{project}-{model}-{case}.json"
    fretwork("simulate", f"{project}.json", "--case", case, "--model", model, "--out", path)
    return json.loads((fretwork.folder / path).read_text())


def add_true_weight(fretwork, project):
    """A load case whose gravity is less by what the beams' mass counts joints more than once."""
    fretwork("export", f"{project}.json", "--content", "facts", "--to", f"{project}-facts.json")
    facts = json.loads((fretwork.folder / f"{project}-facts.json").read_text())
    case = json.loads((HERE / "own_weight.json").read_text())
    case |= {"name": "true-weight", "gravity": [facts["mass"] / facts["beam_mass"] * g for g in case["gravity"]]}
    (fretwork.folder / "true_weight.json").write_text(json.dumps(case))
    fretwork("case", "add", f"{project}.json", "true_weight.json", "--replace")


def make_project(fretwork, project, pattern, library):
    fretwork("tile", HERE.parent / "outlines" / "specimen.svg", "--edge-length", "26mm", "--library", library, "--patterns", pattern,
             "--out", f"{project}.json")
    fretwork("case", "add", f"{project}.json", HERE / "own_weight.json", "--replace")


def results_of(fretwork, name, pattern):
    make_project(fretwork, name, pattern, "pla.db")
    stiff = f"{name}-stiff"
    make_project(fretwork, stiff, pattern, "pla-stiff.db")
    add_true_weight(fretwork, stiff)
    results = {model: result_of(fretwork, name, model) for model in MODELS}
    return results | {STIFF: result_of(fretwork, stiff, "full"), TRUE_WEIGHT: result_of(fretwork, stiff, "full", "true-weight")}


def read_measured(options):
    measured = {}
    for choice in options:
        name, _, path = choice.partition("=")
        if name not in SPECIMENS or not path:
            raise SystemExit(f"--measured {choice}: expected one of {', '.join(SPECIMENS)}, then = and a file")
        measured[name] = [(float(row["along_mm"]) / 1e3, float(row["down_mm"]) / 1e3) for row in read_rows(path)]
    return measured


def depth_at(profile, along):
    """Between two stations of a profile; beyond them none."""
    for (a, u), (b, v) in zip(profile, profile[1:]):
        if a <= along <= b and b > a:
            return u + (v - u) * (along - a) / (b - a)
    return None


def print_table(name, profiles, measured):
    tip = profiles["full"][-1][1]
    for model in profiles:
        down = profiles[model][-1][1]
        cells = [name, model, f"{1e3 * down:.1f}", f"{100 * (down / tip - 1):+.1f} %"]
        if measured:
            misses = [depth_at(profiles[model], along) for along, _ in measured]
            known = [abs(miss - down) for miss, (_, down) in zip(misses, measured) if miss is not None]
            cells.append(f"{1e3 * statistics.fmean(known):.1f}" if known else "no measured point lies along it")
        print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--measured", action="append", default=[])
    options = parser.parse_args()
    measured = read_measured(options.measured)
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = Fretwork(options.program.resolve(), options.out)
    fill_libraries(fretwork)
    print("| specimen | model | tip hangs down, mm | against full |" + (" mean distance of the measured points, mm |" if measured else ""))
    print("|---|---|---|---|" + ("---|" if measured else ""))
    all_profiles = {}
    for name, pattern in SPECIMENS.items():
        profiles = {model: middle_line(result) for model, result in results_of(fretwork, name, pattern).items()}
        print_table(name, profiles, measured.get(name))
        all_profiles[name] = profiles
    write_table(options.out / "profiles.csv", ["specimen", "model", "along_mm", "down_mm"],
                ([name, model, f"{1e3 * a:.3f}", f"{1e3 * d:.3f}"] for name, profiles in all_profiles.items()
                 for model, profile in profiles.items() for a, d in profile))
    (options.out / "figure.svg").write_text(figure.profiles(all_profiles, measured))


if __name__ == "__main__":
    main()
