#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The six jobs of the paper's authors' public solver, on geometry of our own, beside the results that are published.

Usage: public_solver.py PROGRAM STAGED OUT
STAGED is verification_staged_frame of the build. Frames and results go to OUT; the tables are printed. The jobs are those of github.com/IasonManolas/DRMSimulationModel, which has no licence: none of its
files is copied. Sizes, sections, materials and moved points are taken from its job descriptions; public_solver.csv has the numbers of its stored results.
"""
import csv
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
from csv_tables import read_rows  # noqa: E402
from program import Fretwork  # noqa: E402

TRANSLATIONS = ("ux", "uy", "uz")
ROTATIONS = ("rx", "ry", "rz")
RISE = 0.5  # m, to which a structure is lifted, if it were linear, before its points are moved


class Net:
    """Bars between points in the plane; points that coincide are one."""

    def __init__(self):
        self.points, self.bars, self.places = [], [], {}

    def node(self, x, y):
        key = (round(x, 6), round(y, 6))
        if key not in self.places:
            self.places[key] = len(self.points)
            self.points.append((x, y))
        return self.places[key]

    def bar(self, a, b):
        if (b, a) not in self.bars and (a, b) not in self.bars:
            self.bars.append((a, b))

    def patch(self, corners, divisions):
        """A net over a quadrilateral, by bilinear interpolation. Returns its nodes, row by row from the first corner to the second."""
        def place(s, t):
            shares = ((1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t)
            return [sum(share * corner[k] for share, corner in zip(shares, corners)) for k in (0, 1)]
        across, along = divisions
        rows = [[self.node(*place(j / across, i / along)) for j in range(across + 1)] for i in range(along + 1)]
        for row in rows:
            for pair in zip(row, row[1:]):
                self.bar(*pair)
        for low, high in zip(rows, rows[1:]):
            for pair in zip(low, high):
                self.bar(*pair)
        return rows


def polar(radius, degrees):
    return radius * math.cos(math.radians(degrees)), radius * math.sin(math.radians(degrees))


def frame(net, section, young, moved, held=()):
    """The frame file of a net whose points `moved` go to given places in the plane; components `held` of their rotations are held, too. A unit force lifts each other node."""
    width, height = section
    return {"format": "fretwork/frame/1", "nodes": [[x, y, 0.0] for x, y in net.points],
            "materials": {"m": {"young_modulus": young, "poisson_ratio": 0.3}},
            "sections": {"s": {"type": "rectangle", "width": width, "height": height}},
            "beams": [{"nodes": list(bar), "section": "s", "material": "m", "normal": [0, 0, 1]} for bar in net.bars],
            "supports": [{"node": node, "fixed": list(held)} for node in moved if held],
            "prescribed": [{"node": node, "ux": x, "uy": y, "uz": 0.0} for node, (x, y) in moved.items()],
            "loads": [{"node": node, "force": [0, 0, 1.0]} for node in range(len(net.points)) if node not in moved]}


def inwards(net, nodes, distance):
    """The displacements of nodes towards the origin."""
    return {node: tuple(-distance * c / math.hypot(*net.points[node]) for c in net.points[node]) for node in nodes}


def cantilever():
    net = Net()
    nodes = [net.node(0.1 * i, 0.0) for i in range(11)]
    for pair in zip(nodes, nodes[1:]):
        net.bar(*pair)
    made = frame(net, (0.015, 0.015), 1e9, {})
    return {**made, "supports": [{"node": 0, "fixed": [*TRANSLATIONS, *ROTATIONS]}], "loads": [{"node": 10, "force": [0, 0, 5.0]}]}


RADII = (4.321, 6.391, 8.433, 10.455, 12.515, 14.579, 16.707, 18.708)  # m, of its rings
RAYS = 58


def torus():
    net = Net()
    rings = [[net.node(*polar(radius, 360 * ray / RAYS)) for ray in range(RAYS)] for radius in RADII]
    for ring in rings:
        for pair in zip(ring, ring[1:] + ring[:1]):
            net.bar(*pair)
    for low, high in zip(rings, rings[1:]):
        for pair in zip(low, high):
            net.bar(*pair)
    return frame(net, (0.1, 0.1), 1e10, {**inwards(net, rings[0], -0.9744), **inwards(net, rings[-1], 0.9744)})


def roof():
    net = Net()
    rows = net.patch([(-14, -17), (14, -17), (14, 17), (-14, 17)], (20, 20))
    left = [row[0] for row in rows]
    moved = left[4:17] + rows[0][:8] + rows[-1][:8]
    return frame(net, (0.2, 0.2), 2e11, inwards(net, moved, 0.844))


def tripod():
    net = Net()
    ends = [polar(17.6, 120 * foot + side) for foot in range(3) for side in (-20.5, 20.5)]  # of the feet
    moved = {}
    for foot in range(3):
        rows = net.patch([(0.0, 0.0)] + [ends[(2 * foot + k) % 6] for k in range(3)], (11, 11))
        moved.update({row[-1]: polar(-2.052, 120 * foot) for row in rows})  # a foot moves as a whole
    return frame(net, (0.25, 0.2), 5e10, moved)


def pentashell(held):
    net = Net()
    corners = [polar(17.5, 72 * k) for k in range(5)]
    middles = [polar(17.5 * math.cos(math.radians(36)), 72 * k + 36) for k in range(5)]
    for k in range(5):
        net.patch([(0.0, 0.0), middles[k - 1], corners[k], middles[k]], (10, 10))
    return frame(net, (0.1, 0.1), 1e10, inwards(net, [net.node(*corner) for corner in corners], 0.7155), held)


JOBS = {"torus": torus, "roof": roof, "tripod": tripod,
        "pentashell_pinned": lambda: pentashell(()), "pentashell_fixed": lambda: pentashell(ROTATIONS)}


def refined(made, divisions):
    return {**made, "beams": [{**beam, "divisions": divisions} for beam in made["beams"]]}


def write(fretwork, name, made):
    (fretwork.folder / name).write_text(json.dumps(made))


def bent_cantilever(fretwork, divisions):
    write(fretwork, "cantilever.json", refined(cantilever(), divisions))
    fretwork("solve", "cantilever.json", "--out", "cantilever_result.json")
    return json.loads((fretwork.folder / "cantilever_result.json").read_text())["displacements"]


def lifted(fretwork, made):
    """The frame with its lift scaled: it would rise by RISE if it were linear and its points were held."""
    held = {**made, "prescribed": [{"node": entry["node"], "ux": 0.0, "uy": 0.0, "uz": 0.0} for entry in made["prescribed"]]}
    write(fretwork, "lift.json", held)
    fretwork("solve", "lift.json", "--solver", "linear", "--out", "lift_result.json")
    rise = max(row[2] for row in json.loads((fretwork.folder / "lift_result.json").read_text())["displacements"])
    return {**made, "loads": [{**load, "force": [0, 0, RISE / rise]} for load in made["loads"]]}


class Erected:
    """A structure after its three stages: lifted, moved, released."""

    def __init__(self, staged, fretwork, name, made):
        write(fretwork, f"{name}.json", made)
        table = fretwork.folder / f"{name}_displacements.csv"
        done = subprocess.run([staged, fretwork.folder / f"{name}.json", table], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            raise SystemExit(f"public_solver.py: {name}: {done.stderr.strip()}")
        self.stages = list(csv.DictReader(done.stdout.splitlines()))
        self.displacements = [[float(value) for value in row.values()] for row in read_rows(table)]

    @property
    def ending(self):
        last = self.stages[-1]
        if last["converged"] != "1":
            return f"no equilibrium beyond {float(last['reached']):.2f} of {last['stage']}"
        return "stable" if last["stable"] == "1" else "unstable"

    @property
    def rise(self):
        return max(row[2] for row in self.displacements)


def elastica(load):
    """x / L and z / L of eleven points of a clamped rod under a force across its end, from P L^2 / E I: the pendulum's equation by shooting."""
    intervals = 4000

    def shot(curvature):
        angle, x, z, points = 0.0, 0.0, 0.0, [(0.0, 0.0)]
        step = 1.0 / intervals
        for i in range(intervals):
            def slope(a, c):
                return c, -load * math.cos(a), math.cos(a), math.sin(a)
            k1 = slope(angle, curvature)
            k2 = slope(angle + 0.5 * step * k1[0], curvature + 0.5 * step * k1[1])
            k3 = slope(angle + 0.5 * step * k2[0], curvature + 0.5 * step * k2[1])
            k4 = slope(angle + step * k3[0], curvature + step * k3[1])
            change = [step * (a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(k1, k2, k3, k4)]
            angle, curvature, x, z = angle + change[0], curvature + change[1], x + change[2], z + change[3]
            if (i + 1) % (intervals // 10) == 0:
                points.append((x, z))
        return curvature, points

    low, high = 0.0, load  # the end's curvature grows with the clamp's
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if shot(middle)[0] < 0.0 else (low, middle)
    return shot(0.5 * (low + high))[1]


def published(job):
    return [row for row in read_rows(HERE / "public_solver.csv") if row["job"] == job]


def cantilever_table(fretwork):
    yield "| cantilever, of its length | exact | theirs | off by, % | ours, 1 element a bar | off by, % | 4 elements | off by, % |\n" + "|---" * 8 + "|"
    exact = elastica(5.0 / (1e9 * 0.015 ** 4 / 12))
    ours = [bent_cantilever(fretwork, divisions) for divisions in (1, 4)]
    for row in published("cantilever"):
        node, k = int(row["place"]), {"along": 0, "across": 2}[row["quantity"]]
        true = exact[node][0 if k == 0 else 1]
        cells = [float(row["least"])] + [(0.1 * node if k == 0 else 0.0) + displacements[node][k] for displacements in ours]
        told = " | ".join(f"{value:.5f} | {100 * (value / true - 1):+.4f}" for value in cells)
        yield f"| {row['quantity']}, {'middle' if node == 5 else 'tip'} | {true:.5f} | {told} |"


def torus_table(erected):
    yield "| torus, height of a ring, m | theirs, least to most of its rays | ours |\n|---|---|---|"
    for row in published("torus"):
        ring = int(row["place"])
        heights = [entry[2] for entry in erected.displacements[RAYS * ring:RAYS * (ring + 1)]]
        told = f"{min(heights):.3f}" if max(heights) - min(heights) < 5e-4 else f"{min(heights):.3f} to {max(heights):.3f}"
        yield f"| {ring}, radius {RADII[ring]:.2f} m | {float(row['least']):.3f} to {float(row['largest']):.3f} | {told} |"


def jobs_table(staged, fretwork, erected):
    yield "| job | nodes, bars: theirs | ours | ends | rises by, m | with two elements a bar | energy, kJ |\n" + "|---" * 7 + "|"
    counts = {row["place"]: row for row in published("counts")}
    for name, make in JOBS.items():
        made = lifted(fretwork, make())
        erected[name] = Erected(staged, fretwork, name, made)
        finer = Erected(staged, fretwork, f"{name}_2", refined(made, 2))
        yield (f"| {name} | {counts[name]['least']}, {counts[name]['largest']} | {len(made['nodes'])}, {len(made['beams'])} | {erected[name].ending} | "
               f"{erected[name].rise:.3f} | {finer.rise:.3f} | {1e-3 * float(erected[name].stages[-1]['energy_J']):.4g} |")


def main():
    if len(sys.argv) != 4:
        print(__doc__.strip(), file=sys.stdout if "--help" in sys.argv else sys.stderr)
        raise SystemExit(0 if "--help" in sys.argv else 2)
    program, staged, out = map(pathlib.Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    fretwork = Fretwork(program.resolve(), out)
    erected = {}
    for line in cantilever_table(fretwork):
        print(line)
    print()
    for line in jobs_table(staged.resolve(), fretwork, erected):
        print(line, flush=True)
    print()
    for line in torus_table(erected["torus"]):
        print(line)


if __name__ == "__main__":
    main()
