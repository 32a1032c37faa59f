#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a submission to the calibration task with a method of `fretwork calibrate`.

Usage: entry.py PROGRAM RELEASE OUT.csv [--optimizer ceres-multistart] [--starts 8] [--budget 20000] [--seed 1]
Example: entry.py build/release/apps/fretwork/fretwork out/dataset/paper7 out/benchmark/slsqp-16.csv --optimizer slsqp --starts 16
The release stays as it is: the work is done in a copy of its library.
"""
import argparse
import pathlib
import shutil
import sqlite3
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
sys.path.insert(0, str(HERE))
from csv_tables import write_table  # noqa: E402
from objective import PARAMETERS  # noqa: E402
from program import Fretwork  # noqa: E402


def calibrations(library, options):
    """Evaluations and parameters by pattern."""
    key = ("paper6", options.optimizer, options.seed, options.starts, options.budget)
    where = "model = ? AND optimizer = ? AND seed = ? AND starts = ? AND budget = ?"
    with sqlite3.connect(library) as database:
        evaluations = dict(database.execute(f"SELECT pattern_id, evaluations FROM calibration WHERE {where}", key))
        found = {}
        for name, parameter, value in database.execute(f"SELECT pattern_id, name, value FROM calibration_parameter WHERE {where}", key):
            found.setdefault(name, {})[parameter] = value
    return {name: (evaluations[name], [found[name][parameter] for parameter in PARAMETERS]) for name in found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("release", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--optimizer", default="ceres-multistart")
    for name, value in (("starts", 8), ("budget", 20000), ("seed", 1)):
        parser.add_argument(f"--{name}", type=int, default=value)
    options = parser.parse_args()
    held_out = (options.release / "held_out.txt").read_text().split()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(options.release / "library.db", folder)
        Fretwork(options.program.resolve(), folder)("calibrate", "--library", "library.db", "--patterns", ",".join(held_out), "--optimizer", options.optimizer,
                                                    "--starts", options.starts, "--budget", options.budget, "--seed", options.seed, accepted=(0, 1))
        rows = calibrations(pathlib.Path(folder) / "library.db", options)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    write_table(options.out, ["pattern_id", "evaluations", *PARAMETERS], ([name, rows[name][0], *rows[name][1]] for name in held_out if name in rows))
    lacking = [name for name in held_out if name not in rows]
    if lacking:
        print(f"entry.py: {len(lacking)} patterns failed, such as {lacking[0]}", file=sys.stderr)
    raise SystemExit(1 if lacking else 0)


if __name__ == "__main__":
    main()
