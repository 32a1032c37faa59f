#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same patterns as the program's beams have them, beside the solids.

Usage: beams.py PROGRAM OUT
Reads OUT/solids.csv and writes OUT/rows.csv: the same rows, with the tensors of each kind of beams.
"""
import pathlib
import sys

import study


def main():
    program, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    fretwork = study.Fretwork(program.resolve(), out.resolve())
    rows = study.read_rows(out / "solids.csv")
    for width in sorted({float(row["width_mm"]) for row in rows}):
        of_width = [row for row in rows if float(row["width_mm"]) == width]
        for model in study.MODELS:
            library = study.library(fretwork, width, model, ",".join(sorted({row["pattern"] for row in of_width})))
            found = study.properties(out / library)
            for row in of_width:
                row |= {f"{model}_{name}": found[row["pattern"]][name] for name in study.TENSORS}
    study.write_rows(out / "rows.csv", rows, 7)


if __name__ == "__main__":
    main()
