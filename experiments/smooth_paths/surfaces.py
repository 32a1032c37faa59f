#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do painted surfaces that buckle end at once on the branch that many small steps end on?

A strip that is pushed together under a small force, and a sheet whose supports move together under a little weight,
each with two paintings, by four ways; against the primary path in many small steps. Corotational tiles.
Usage: surfaces.py [--reference-steps N]
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from module import fw  # noqa: E402
from ways import CLAMPED, Tally, reference_steps  # noqa: E402

PAINTINGS = {"one pattern": {"patterns": "0-5+5-6"}, "two patterns": {"patterns": "random:1", "palette": "0-5+5-6,0-1+1-6"}}


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


def surface_of(length, width, painting):
    outline = fw.make_outline([[0, 0], [length, 0], [length, width], [0, width]])
    return fw.make_surface(fw.make_project(outline, edge_length=0.025, setting=fw.paper_setting(), **painting)[0])


def main():
    tally = Tally({"load_steps": 10}, {"load_steps": reference_steps(__doc__.splitlines()[0], 100)})
    for name, size, case in cases():
        load_case = fw.parse_load_case(json.dumps({"format": "fretwork/load-case/1", "name": "c", **case}))
        for painting, patterns in PAINTINGS.items():
            surface = surface_of(*size, patterns)
            tally.add(f"{name}, {painting}",
                      lambda **options: fw.simulate(surface, load_case, model="corotational", **options).solution)
    tally.print()


if __name__ == "__main__":
    main()
