#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do painted surfaces that buckle end at once on the branch that many small steps end on?

A strip that is pushed together under a small force, and a sheet whose supports move together under a little weight,
each with two paintings, by four ways; against the primary path in many small steps. Corotational tiles.
Usage: surfaces.py PROGRAM FOLDER [--reference-steps N]
"""
import argparse
import json
import pathlib
import subprocess
from collections import Counter

from frames import WAYS, verdict

CLAMPED = ["ux", "uy", "uz", "rx", "ry", "rz"]
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


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode > 1:
        raise SystemExit(done.stderr)
    return done.stdout


def simulate(program, project, case, options):
    out = project.with_suffix(".result.json")
    text = run([program, "simulate", project, "--case", case, "--model", "corotational", "--out", out, "--json", *options])
    result = json.loads(out.read_text())
    summary = json.loads(text)
    return {"converged": result["converged"], "termination": result["termination"], "stable": result["stable"],
            "load_factor": result["load_factor"], "iterations": result["iterations"],
            "critical_load_factors": result.get("stability_losses", summary.get("critical_load_factors", []))}, result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--reference-steps", default="100")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    ways = dict(WAYS, **{"40 steps": ["--steps", "10"]})
    counts = {way: Counter() for way in ways}
    for name, (length, width), case in cases():
        for painting, patterns in PAINTINGS.items():
            outline = arguments.folder / "outline.json"
            outline.write_text(json.dumps({"format": "fretwork/outline/1", "boundary": [
                [0, 0], [length, 0], [length, width], [0, width]]}))
            project = arguments.folder / "project.json"
            project.unlink(missing_ok=True)
            run([arguments.program, "tile", outline, "--patterns", *patterns, "--edge-length", "25mm", "--out", project])
            path = arguments.folder / "case.json"
            path.write_text(json.dumps({"format": "fretwork/load-case/1", "name": "c", **case}))
            reference = simulate(arguments.program, project, path, ["--steps", arguments.reference_steps])
            row = []
            for way, options in ways.items():
                found = simulate(arguments.program, project, path, options)
                counts[way][verdict(found, reference)] += 1
                row.append(f"{verdict(found, reference)} ({found[0]['iterations']})")
            print(f"{name + ', ' + painting:36} {reference[0]['termination']:10} | " + " | ".join(row), flush=True)
    for way, count in counts.items():
        print(f"{way.replace('40', '10'):10}", ", ".join(f"{number} {what}" for what, number in count.most_common()))


if __name__ == "__main__":
    main()
