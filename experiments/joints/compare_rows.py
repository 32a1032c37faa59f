#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether rows are those that are stored. Usage: compare_rows.py NEW.csv STORED.csv

Beams have to agree to 1e-6; solids to half a percent, since another gmsh makes another mesh.
"""
import sys

import study

TOLERANCES = {"solid": 5e-3} | {model: 1e-6 for model in study.MODELS}
KEY = ("pattern", "width_mm", "mesh", "corner", "layers", "fillet_mm")


def key(row):
    return row["pattern"], *(float(row[name]) for name in KEY[1:])


def main():
    stored = {key(row): row for row in study.read_rows(sys.argv[2])}
    rows = study.read_rows(sys.argv[1])
    off = []
    for row in rows:
        for kind, tolerance in TOLERANCES.items():
            for name in (f"{kind}_{tensor}" for tensor in study.TENSORS):
                new, old = float(row[name]), float(stored[key(row)][name])
                # Against the tensor's first component: others may be near zero.
                if abs(new - old) > tolerance * float(stored[key(row)][name[:-2] + "11"]):
                    off.append(f"{row['pattern']}: {name} is {new:g}, stored is {old:g}")
    print("\n".join(off) if off else f"{len(rows)} row(s) as stored")
    raise SystemExit(1 if off or not rows else 0)


if __name__ == "__main__":
    main()
