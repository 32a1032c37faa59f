#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do painted surfaces that buckle end at once on the branch that many small steps end on?

A strip that is pushed together under a small force, and a sheet whose supports move together under a little weight,
each with two paintings, by four ways; against the primary path in many small steps. Corotational tiles.
Usage: surfaces.py PROGRAM FOLDER [--reference-steps N]
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from program import Fretwork  # noqa: E402
from ways import CLAMPED, Tally, arguments_of  # noqa: E402

PAINTINGS = {"one pattern": ["0-5+5-6"], "two patterns": ["random:1", "--palette", "0-5+5-6,0-1+1-6"]}


def cases():
    """Name, size of the outline (m), load case."""
    for force in (0.001, 0.004, 0.02):
        for shortening in (0.003, 0.03, 0.1):
            yield (f"strip {1e3 * force:g} mN {1e3 * shortening:g} mm", (0.5, 0.06),
                   {"supports": [{"side": "left", "fixed": CLAMPED}, {"side": "right", "fixed": ["uy", "uz"]}],
                    "prescribed": [{"side": "right", "ux": -shortening}],
                    "loads": [{"box": [0.23, -1, 0.27, 1], "force": [0, 0, force], "amount": "total"}]})
    for shortening in (0.0005, 0.02, 0.06):
        yield (f"sheet {1e3 * shortening:g} mm", (0.55, 0.1),
               {"supports": [{"side": "left", "fixed": ["ux", "uy", "uz"]}, {"side": "right", "fixed": ["uy", "uz"]}],
                "prescribed": [{"side": "right", "ux": -shortening}],
                "loads": [{"box": [-1, -1, 1, 1], "force": [0, 0, 0.05], "amount": "total"}]})


def tile(fretwork, length, width, patterns):
    (fretwork.folder / "outline.json").write_text(json.dumps({"format": "fretwork/outline/1", "boundary": [
        [0, 0], [length, 0], [length, width], [0, width]]}))
    (fretwork.folder / "project.json").unlink(missing_ok=True)
    fretwork("tile", "outline.json", "--patterns", *patterns, "--edge-length", "25mm", "--setting", "paper", "--out", "project.json")


def simulate(fretwork, options):
    """The losses of stability, and the result."""
    summary = fretwork("simulate", "project.json", "--case", "./case.json", "--model", "corotational", "--out",
                       "result.json", "--json", *options, accepted=(0, 1))
    return json.loads(summary)["stability_losses"], json.loads((fretwork.folder / "result.json").read_text())


def main():
    arguments = arguments_of(__doc__.splitlines()[0], 100)
    fretwork = Fretwork(arguments.program, arguments.folder)
    tally = Tally(10, arguments.reference_steps)
    for name, (length, width), case in cases():
        (fretwork.folder / "case.json").write_text(json.dumps({"format": "fretwork/load-case/1", "name": "c", **case}))
        for painting, patterns in PAINTINGS.items():
            tile(fretwork, length, width, patterns)
            tally.add(f"{name}, {painting}", lambda options: simulate(fretwork, options))
    tally.print()


if __name__ == "__main__":
    main()
