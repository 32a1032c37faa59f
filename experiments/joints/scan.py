#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which share of the joints' reach is best taken as rigid: chosen on every second pattern, judged on the others.

Usage: scan.py PROGRAM OUT
Reads OUT/rows.csv. Prints the mean of |log(solid / beams)| over stretching, shear, bending and twist.
"""
import math
import pathlib
import sys
import tempfile

import numpy as np

import frames
import geometry
import loads
import outline
import study

SHARES = (0.0, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5)
LEAST = (0.3, 0.5)


def centrelines(program, pattern):
    with tempfile.TemporaryDirectory() as name:
        fretwork = study.Fretwork(program.resolve(), pathlib.Path(name))
        (fretwork.folder / "patch.obj").write_text(outline.patch_obj(study.SIDE / 1e3))
        fretwork("tile", "patch.obj", "--keep-mesh", "--layout", study.LAYOUT, "--setting", "paper", "--patterns", pattern, "--out", "patch.json")
        fretwork("export", "patch.json", "--to", "lines.obj")
        return geometry.bars_of((fretwork.folder / "lines.obj").read_text(), study.SIDE)


def elastic_shares(bars, reaches, width, share, least):
    return [max(1 - share * reach * width / math.dist(*bar), least) for bar, reach in zip(bars, reaches)]


def errors(rows, lines, share, least):
    """Of each row the mean of |log| over the loads."""
    found = []
    for row in rows:
        bars, reaches = lines[row["pattern"]]
        width = float(row["width_mm"])
        tensors = frames.plate(bars, study.SIDE, width, elastic_shares(bars, reaches, width, share, least))
        found.append(np.abs(np.log(loads.ratios(row, tensors))))
    return np.array(found)


def main():
    program, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    rows = loads.main_rows(study.read_rows(out / "rows.csv"))
    lines = {}
    for pattern in {row["pattern"] for row in rows}:
        bars = centrelines(program, pattern)
        lines[pattern] = bars, frames.reaches(bars, study.SIDE)
    check = max(abs(frames.plate(lines[row["pattern"]][0], study.SIDE, float(row["width_mm"]), [1.0] * 999)[name]
                    / float(row[f"centreline_{name}"]) - 1) for row in rows[:20] for name in ("A11", "A66", "D11", "D66"))
    print(f"these frames against the program's: {check:.1e}\n")
    print("| rigid share | least elastic share | chosen on: in the plane | out of it | held out: in the plane | out of it |\n|---|---|---|---|---|---|")
    for least in LEAST:
        for share in SHARES:
            cells = []
            for half in loads.halves(rows):
                found = errors([row for row in rows if row["pattern"] in half], lines, share, least)
                cells += [f"{found[:, :2].mean():.3f}", f"{found[:, 2:].mean():.3f}"]
            print("| " + " | ".join([f"{share:g}", f"{least:g}", *cells]) + " |", flush=True)


if __name__ == "__main__":
    main()
