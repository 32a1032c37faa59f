#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the release folder of one layout and one setting: patterns, responses, calibrations, stiffness, plate properties and clearances.

Usage: make.py PROGRAM OUT [--layout paper7] [--setting paper|made|FILE] [--policy paper|stable] [--patterns all|sample:N|IDS | --draw N --seed S]
Example: make.py build/release/apps/fretwork/fretwork out/dataset/paper7 --patterns sample:20
         make.py build/release/apps/fretwork/fretwork out/dataset/fifths12 --layout fifths12 --draw 2000 --seed 1
Killed at any moment, the same command goes on. All files but library.db are equal to the last byte for equal content (program, layout, setting, patterns).
"""
import argparse
import hashlib
import json
import pathlib
import resource
import shutil
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
sys.path.insert(0, str(HERE))
import clearance  # noqa: E402
from archives import response_arrays, stiffness_arrays  # noqa: E402
from checks import check  # noqa: E402
from csv_tables import read_rows, write_table  # noqa: E402
from package import write_package  # noqa: E402
from program import Fretwork  # noqa: E402

FITTED = ("paper6", "ring10")
HELD_OUT_OF_TEN = 2


def is_held_out(pattern_id, mirror=""):
    """Two in ten patterns, by the SHA-256 of the id, or of the mirror image's if that comes first: mirror images, which behave alike, stay together."""
    first = min(pattern_id, mirror or pattern_id)
    return int(hashlib.sha256(first.encode()).hexdigest(), 16) % 10 < HELD_OUT_OF_TEN


def children_seconds():
    """Processor time of the programs that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def enumerate_patterns(fretwork, options):
    drawn = () if options.draw is None else ("--sample", options.draw, "--seed", options.seed)
    fretwork("enumerate", "--layout", options.layout, "--library", "library.db", *drawn)


def calibrate(fretwork, options):
    """Calibrate what is lacking, one model after the other. Gives how many patterns were lacking, and the processor time."""
    begin, done = children_seconds(), 0
    policy = () if options.policy is None else ("--policy", options.policy)
    for model in FITTED:
        told = fretwork("calibrate", "--library", "library.db", "--setting", options.setting, "--patterns", options.patterns, "--model", model,
                        "--threads", options.threads, "--json", *policy, accepted=(0, 1))
        done = max(done, json.loads(told)["done"])
    return done, children_seconds() - begin


def export(fretwork, options):
    shutil.rmtree(fretwork.folder / "stiffness", ignore_errors=True)  # of a run that was killed
    fretwork("library", "export", "--library", "library.db", "--csv", "tables", "--stiffness", "stiffness", "--patterns", "computed")
    if options.draw is None:  # classes are those of all patterns of a layout
        fretwork("enumerate", "--layout", options.layout, "--classes", "tables/classes.csv")


def write_release(folder):
    tables = folder / "tables"
    layout, setting = (json.loads((tables / name).read_text()) for name in ("layout.json", "setting.json"))
    arrays = response_arrays(tables)
    matrices = stiffness_arrays(folder / "stiffness", layout, setting)
    shutil.rmtree(folder / "stiffness")
    numpy.savez_compressed(folder / "arrays.npz", **arrays)
    numpy.savez_compressed(folder / "stiffness.npz", **matrices)
    write_table(tables / "coupling.csv", ("pattern_id", *(f"B{i}{j}" for i in "126" for j in "126")),
                ([name, *map(float, tensor.ravel())] for name, tensor in zip(matrices["patterns"], matrices["B"])))
    write_table(tables / "clearance.csv", clearance.COLUMNS, clearance.rows(layout, setting, arrays["patterns"]))
    mirrors = {row["id"]: row["mirror"] for row in read_rows(tables / "pattern.csv")}
    (folder / "held_out.txt").write_text("".join(f"{name}\n" for name in arrays["patterns"] if is_held_out(name, mirrors[name])))
    write_package(folder, layout["name"])
    return arrays, matrices


def megabytes(path):
    return sum(file.stat().st_size for file in ([path] if path.is_file() else path.rglob("*"))) / 1e6


def print_summary(folder, arrays, done, seconds):
    both = arrays["converged"] & arrays["stable"]
    print(f"{len(arrays['patterns'])} patterns, {arrays['converged'].size} states, {int(arrays['converged'].sum())} converged, {int(both.sum())} of them stable")
    print("; ".join(f"{path.name} {megabytes(path):.2f} MB" for path in sorted(folder.iterdir())))
    if done:
        print(f"{done} of them now: {done / seconds:.1f} patterns a second and core; a million: {seconds / done * 1e6 / 3600:.0f} hours of one core")


def options_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--layout", default="paper7", help="a name or a file")
    parser.add_argument("--setting", default="paper", help="paper, made, or a file")
    parser.add_argument("--policy", choices=("paper", "stable"), help="which samples are fitted (default: as in the setting)")
    parser.add_argument("--patterns", default="all", help="all, sample:N, or ids joined by commas")
    parser.add_argument("--draw", type=int, metavar="N", help="enumerate N patterns drawn at random, each equally likely, instead of all; one may be drawn twice")
    parser.add_argument("--seed", default="1", help="of --draw")
    parser.add_argument("--threads", default="0")
    options = parser.parse_args()
    for name in ("layout", "setting"):  # the program runs in OUT
        if pathlib.Path(getattr(options, name)).is_file():
            setattr(options, name, str(pathlib.Path(getattr(options, name)).resolve()))
    return options


def main():
    options = options_of()
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = Fretwork(options.program.resolve(), options.out)
    enumerate_patterns(fretwork, options)
    done, seconds = calibrate(fretwork, options)
    export(fretwork, options)
    arrays, matrices = write_release(options.out)
    print_summary(options.out, arrays, done, seconds)
    complaints = check(options.out, arrays, matrices, is_whole=options.patterns == "all")
    for complaint in complaints:
        print(f"check failed: {complaint}", file=sys.stderr)
    raise SystemExit(1 if complaints else 0)


if __name__ == "__main__":
    main()
