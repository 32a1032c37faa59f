#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two patterns side by side, in stripes: how stiff are solids, and does it pay that joints on a side know the other tile?

Usage: pairs.py PROGRAM OUT [--count 20]
A cell is two hexagons, one of each pattern. Of the six sides of a tile four lie at tiles of the other pattern. Appends to OUT/pairs.csv, one
row a pair; rows that are there are kept. Prints how far beams are off: centrelines; stiff joints in which a tile takes itself for its
neighbour, as the program does; and stiff joints that know the neighbour.
"""
import argparse
import json
import math
import pathlib
import tempfile

import numpy as np

import cell
import frames
import geometry
import outline
import scan
import solid
import study
import unseen

WIDTH = 2.0  # mm
SHARE, LEAST = 0.35, 0.5  # of the program's stiff joints
KINDS = {"stretching": (solid.STRETCHING, 1), "shear": (solid.STRETCHING, 3), "bending": (solid.BENDING, 1), "twist": (solid.BENDING, 3)}
MODELS = ("centreline", "alone", "knowing")
SECOND = (1.5 * study.SIDE, math.sqrt(3) / 2 * study.SIDE)  # the middle of the other hexagon; the first lies around the origin
PERIODS = (3 * study.SIDE, math.sqrt(3) * study.SIDE)  # of the endless plate, along x and y
NEAR = 1e-6  # mm


def cell_sides():
    """The sides of both hexagons but the one between them, counterclockwise."""
    polygons = outline.hexagon(study.SIDE), outline.hexagon(study.SIDE, SECOND)
    sides = [side for polygon in polygons for side in zip(polygon, polygon[1:] + polygon[:1])]
    outer = [(p, q) for p, q in sides if not any(math.dist(p, b) < NEAR and math.dist(q, a) < NEAR for a, b in sides)]
    loop = [outer[0]]
    while len(loop) < len(outer):
        loop.append(next((p, q) for p, q in outer if math.dist(p, loop[-1][1]) < NEAR))
    return loop


def sides_that_meet(sides):
    """Pairs of sides that lie on each other when the cell is moved by its periods."""
    pairs = []
    for i, (p, q) in enumerate(sides):
        for j, (a, b) in enumerate(sides[:i]):
            apart = p[0] - b[0], p[1] - b[1]
            turns = [apart[k] / PERIODS[k] for k in (0, 1)]
            is_moved = math.dist((q[0] - a[0], q[1] - a[1]), apart) < NEAR
            if is_moved and all(abs(turn - round(turn)) < NEAR for turn in turns):
                pairs.append((j, i))
    return pairs


def wrapped(point, _side):
    """One name for a node and its copies."""
    return tuple(round(point[k] / PERIODS[k] % 1 * 1e5) % 100000 for k in (0, 1))


def middles(rings):
    """Of both hexagons and those around them. Openings reach across tiles, and only those that are closed can be cut out."""
    found = [(0.0, 0.0), SECOND]
    for _ in range(rings):
        for middle in [next_one for known in found for next_one in outline.neighbours(study.SIDE, known)]:
            if all(math.dist(middle, known) > NEAR for known in found):
                found.append(middle)
    return found


def second_stripes(fretwork):
    """The tiles of the project that have the second pattern."""
    tessellation = json.loads((fretwork.folder / "patch.json").read_text())["tessellation"]
    def middle(tile):
        return 1e3 * sum(tessellation["vertices"][vertex][0] for vertex in tile["vertices"]) / len(tile["vertices"])
    return [number for number, tile in enumerate(tessellation["tiles"]) if round(middle(tile) / SECOND[0]) % 2]


def paint(fretwork, pair):
    """The patch in stripes of the two patterns: openings of its outline, and the bars of both tiles."""
    centres = middles(2)
    (fretwork.folder / "patch.obj").write_text(outline.hexagons_obj(study.SIDE / 1e3, [(x / 1e3, y / 1e3) for x, y in centres]))
    (fretwork.folder / "patch.json").unlink(missing_ok=True)
    fretwork("tile", "patch.obj", "--keep-mesh", "--layout", study.LAYOUT, "--setting", "paper", "--patterns", pair[0], "--out", "patch.json")
    fretwork("paint", "patch.json", "--tiles", ",".join(map(str, second_stripes(fretwork))), "--patterns", pair[1])
    fretwork("export", "patch.json", "--to", "patch.dxf", "--to", "lines.obj")
    loops = outline.read_dxf((fretwork.folder / "patch.dxf").read_text())
    lines = (fretwork.folder / "lines.obj").read_text()
    return ([loop for loop in loops if outline.signed_area(loop) < 0],
            [geometry.bars_of(lines, study.SIDE, middle) for middle in centres[:2]])


def solid_stiffnesses(openings, ccx):
    """Of the endless plate, free to contract: stretched across the stripes, sheared, bent across them, twisted. SI."""
    sides = cell_sides()
    meshed = cell.mesh(openings, [p for p, _ in sides], (0.5 * WIDTH, 0.25 * WIDTH), sides_that_meet(sides))
    wedges = solid.Wedges(meshed, WIDTH / 2, 1)
    slaves = {slave for slave, _ in meshed.twins}
    node = next(node for node in range(len(meshed.places)) if node not in slaves)
    found = {}
    for name, (kind, dof) in KINDS.items():
        held = [(node, 1), (node, 2)] if kind == solid.STRETCHING else [(node, 3)]
        text = solid.deck(wedges, kind, (study.YOUNG / 1e6, study.POISSON), held, (dof, meshed.area / 2))
        with tempfile.TemporaryDirectory() as folder:
            found[name] = (1e3 if kind == solid.STRETCHING else 1e-3) / solid.macroscopic(folder, text, ccx)[dof - 1]
    return found


def beam_stiffnesses(bars, reaches):
    elastic = scan.elastic_shares(bars, reaches, WIDTH, SHARE, LEAST)
    tensor = frames.energies(bars, study.SIDE, WIDTH, elastic, wrapped) / (PERIODS[0] * PERIODS[1])
    compliances = np.linalg.inv(tensor[:3, :3]), np.linalg.inv(tensor[3:, 3:])
    return {name: (1e3 if kind == solid.STRETCHING else 1e-3) / compliances[kind == solid.BENDING][dof - 1, dof - 1]
            for name, (kind, dof) in KINDS.items()}


def row_of(fretwork, pair, ccx):
    openings, tiles = paint(fretwork, pair)
    bars = tiles[0] + tiles[1]
    local = [[((a[0] - x, a[1] - y), (b[0] - x, b[1] - y)) for a, b in tile] for tile, (x, y) in zip(tiles, ((0.0, 0.0), SECOND))]
    reaches = {"centreline": [0.0] * len(bars), "alone": frames.reaches(local[0], study.SIDE) + frames.reaches(local[1], study.SIDE),
               "knowing": frames.reaches(bars, study.SIDE, wrapped)}
    row = {"first": pair[0], "second": pair[1]} | {f"solid_{name}": value for name, value in solid_stiffnesses(openings, ccx).items()}
    for model in MODELS:
        row |= {f"{model}_{name}": value for name, value in beam_stiffnesses(bars, reaches[model]).items()}
    return row


def print_table(rows):
    print("| joints | |" + " | ".join(f" {name}" for name in KINDS) + " |\n|" + "---|" * (2 + len(KINDS)))
    for model in MODELS:
        found = np.array([[float(row[f"solid_{name}"]) / float(row[f"{model}_{name}"]) for name in KINDS] for row in rows])
        print(f"| {model} | solid / beams: median, all | " + " | ".join(f"{np.median(c):.3f} ({c.min():.3f} to {c.max():.3f})" for c in found.T) + " |")
        print(f"| {model} | mean error | " + " | ".join(f"{100 * np.abs(np.log(c)).mean():.1f} %" for c in found.T) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--ccx", default="ccx")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = study.Fretwork(options.program.resolve(), options.out.resolve())
    drawn = unseen.drawn(fretwork, "--sample", 2 * options.count, "--seed", unseen.SEED)
    table = study.GrowingTable(options.out / "pairs.csv", study.DIGITS)
    done = {(row["first"], row["second"]) for row in table.rows}
    for pair in zip(drawn[0::2], drawn[1::2]):
        if pair not in done:
            table.add([row_of(fretwork, pair, options.ccx)])
    print_table(study.read_rows(table.path))


if __name__ == "__main__":
    main()
