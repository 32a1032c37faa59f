#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns as endless plates, as solids of their true outline.

Usage: solids.py PROGRAM OUT [--sample 64] [--widths 2,1,3] [--only ID,..] [--mesh 0.5] [--corner 0.5] [--layers 1] [--fillet MM] [--ccx PROGRAM]
Appends to OUT/solids.csv, one row a pattern, width and mesh, as each is done; rows that are there are kept, so it goes on when it is
started again. What cannot be meshed or solved goes to OUT/failures.csv. OUT/provenance.json tells what it was made with.
"""
import argparse
import json
import pathlib
import platform
import subprocess
import tempfile
import time

import cell
import geometry
import outline
import solid
import study


def true_outline(fretwork, library, pattern, fillet):
    """The openings between the bars of a tile among its like, and the bars' centrelines as an OBJ: millimetres and metres."""
    (fretwork.folder / "patch.obj").write_text(outline.patch_obj(study.SIDE / 1e3))
    fretwork("tile", "patch.obj", "--keep-mesh", "--library", library, "--patterns", pattern, "--out", "patch.json")
    options = ["--fillet", f"{fillet}mm"] if fillet else []
    fretwork("export", "patch.json", "--to", "patch.dxf", "--to", "lines.obj", *options)
    loops = outline.read_dxf((fretwork.folder / "patch.dxf").read_text())
    return [loop for loop in loops if outline.signed_area(loop) < 0], (fretwork.folder / "lines.obj").read_text()


def plate_of(stretched, bent):
    """The tensors of a plate that is the same in all directions, from its answers to one force and one moment."""
    values = {}
    for name, (along, across, _) in (("A", stretched), ("D", bent)):
        determinant = along**2 - across**2
        values |= {f"{name}11": along / determinant, f"{name}12": -across / determinant, f"{name}66": 1 / (2 * (along - across))}
    return values


def solid_properties(meshed, height, layers, ccx):
    """The tensors in SI, and by how much the answer to a pull is sheared. One load is enough for each: six sides make it isotropic."""
    wedges = solid.Wedges(meshed, height / 2, layers)
    slaves = {slave for slave, _ in meshed.twins}
    node = next(node for node in range(len(meshed.places)) if node not in slaves)
    answers = []
    for kind, held in ((solid.STRETCHING, [(node, 1), (node, 2)]), (solid.BENDING, [(node, 3)])):
        text = solid.deck(wedges, kind, (study.YOUNG / 1e6, study.POISSON), held, (1, meshed.area / 2))
        with tempfile.TemporaryDirectory() as folder:
            answers.append(solid.macroscopic(folder, text, ccx))
    plate = plate_of(*answers)
    uneven = max(abs(answer[2] / answer[0]) for answer in answers)
    return {name: plate[name] * (1e3 if name[0] == "A" else 1e-3) for name in study.TENSORS}, uneven


def row_of(fretwork, library, pattern, width, options):
    started = time.perf_counter()
    openings, lines = true_outline(fretwork, library, pattern, options.fillet)
    meshed = cell.mesh(openings, outline.hexagon(study.SIDE), (options.mesh * width, options.mesh * options.corner * width))
    plate, uneven = solid_properties(meshed, width, options.layers, options.ccx)
    row = {"pattern": pattern, "width_mm": width, "mesh": options.mesh, "corner": options.corner, "layers": options.layers, "fillet_mm": options.fillet}
    row |= geometry.measures(lines, study.SIDE, width, meshed)
    row |= {f"solid_{name}": plate[name] for name in study.TENSORS}
    return row | {"uneven": uneven, "triangles": len(meshed.triangles), "seconds": time.perf_counter() - started}


def key(row):
    return row["pattern"], *(float(row[name]) for name in ("width_mm", "mesh", "corner", "layers", "fillet_mm"))


def version(*command, line=-1):
    done = subprocess.run(command, capture_output=True, text=True)
    return (done.stdout + done.stderr).strip().splitlines()[line].strip()


def write_provenance(fretwork, options):
    told = {"fretwork": version(fretwork.program, "--version", line=0).split()[-1], "gmsh": version("gmsh", "--version"),
            "calculix": version(options.ccx, "-v").split()[-1], "python": platform.python_version(), "machine": platform.machine(),
            "layout": study.LAYOUT, "tile_side_mm": study.SIDE, "young_modulus": study.YOUNG, "poisson_ratio": study.POISSON,
            "options": {name: str(value) for name, value in vars(options).items() if name not in ("program", "out", "ccx")},
            "element": "C3D15", "solver": "SPOOLES"}
    (fretwork.folder / "provenance.json").write_text(json.dumps(told, indent=2) + "\n")


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--sample", type=int, default=64, help="so many patterns, spread over the numbers of edges")
    parser.add_argument("--widths", default="2,1,3", help="of the square bars, mm")
    parser.add_argument("--only", default="", help="these patterns instead of a sample")
    parser.add_argument("--mesh", type=float, default=0.5, help="size of the triangles, in widths of a bar")
    parser.add_argument("--corner", type=float, default=0.5, help="size of those in the corners between bars, as a share of it")
    parser.add_argument("--layers", type=int, default=1, help="of wedges in half of the height")
    parser.add_argument("--fillet", type=float, default=0.0, help="radius of the inner corners, mm")
    parser.add_argument("--ccx", default="ccx")
    return parser.parse_args()


def main():
    options = read_options()
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = study.Fretwork(options.program.resolve(), options.out.resolve())
    write_provenance(fretwork, options)
    table, failures, failed = *(study.GrowingTable(options.out / f"{name}.csv", study.DIGITS) for name in ("solids", "failures")), 0
    done = {key(row) for row in table.rows}
    patterns = options.only.split(",") if options.only else study.sample(fretwork, options.sample)
    for width in map(float, options.widths.split(",")):
        library = study.library(fretwork, width, "centreline", ",".join(patterns))
        for pattern in patterns:
            if (pattern, width, options.mesh, options.corner, options.layers, options.fillet) in done:
                continue
            try:
                row = row_of(fretwork, library, pattern, width, options)
            except ValueError as problem:
                failures.add([{"pattern": pattern, "width_mm": width, "why": str(problem)}])
                failed += 1
                continue
            table.add([row])
            print(f"{width:g} mm {pattern}: {row['triangles']} triangles, {row['seconds']:.0f} s", flush=True)
    raise SystemExit(1 if failed else 0)


if __name__ == "__main__":
    main()
