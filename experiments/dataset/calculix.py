# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames of patterns under scenarios in CalculiX (ccx): its decks, and the displacements that it prints."""
import os
import pathlib
import re
import subprocess
import tempfile

import numpy

COMPONENTS = ("ux", "uy", "uz", "rx", "ry", "rz")
ELEMENTS = 16  # quadratic elements of a bar in nonlinear decks: of resolve.py's four patterns with 4 the worst differs by 0.8 %, with 16 by 0.06 %


def read_mesh(path):
    """Nodes (n x 3, m) and bars (pairs of node numbers from 0) of an OBJ file of lines."""
    nodes, bars = [], []
    for line in pathlib.Path(path).read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            nodes.append([float(word) for word in words[1:]])
        elif words and words[0] == "l":
            bars.append([int(word) - 1 for word in words[1:]])
    return numpy.array(nodes), bars


def node_lines(nodes):
    return "*NODE, NSET=NALL\n" + "".join(f"{n},{x:.12g},{y:.12g},{z:.12g}\n" for n, (x, y, z) in enumerate(nodes, 1))


def step_lines(scenario, magnitude, procedure):
    """Supports and dead loads of one scenario, in place of those of the step before."""
    lines = ["*STEP, INC=1000, NLGEOM" if procedure != "" else "*STEP", "*STATIC"] + ([procedure] if procedure else [])
    lines.append("*BOUNDARY, OP=NEW")
    for held in scenario["held"]:
        lines += [f"{held['interface_node'] + 1},{COMPONENTS.index(name) + 1}" for name in held["fixed"]]
    lines.append("*CLOAD, OP=NEW")
    for load in scenario["loads"]:
        for place, value in enumerate([*load["force"], *load["moment"]], 1):
            if value != 0.0:
                lines.append(f"{load['interface_node'] + 1},{place},{value * magnitude:.12g}")
    return "\n".join([*lines, "*NODE PRINT, NSET=NALL", "U", "*END STEP"]) + "\n"


def linear_deck(nodes, bars, setting):
    """Bars as user elements U1, whose torsion constant is I2 + I3; a shear factor of a million makes them Euler-Bernoulli beams.

    For loads out of the plane alone: under loads in its plane U1 of CalculiX 2.20 turns the corner of an L the wrong way.
    """
    section, material = setting["section"], setting["material"]
    elements = "".join(f"{number},{a + 1},{b + 1}\n" for number, (a, b) in enumerate(bars, 1))
    return (f"{node_lines(nodes)}*USER ELEMENT, TYPE=U1, NODES=2, INTEGRATION POINTS=2, MAXDOF=6\n*ELEMENT, TYPE=U1, ELSET=EALL\n{elements}"
            f"*MATERIAL, NAME=M\n*ELASTIC\n{material['young_modulus']:.12g},{material['poisson_ratio']:.12g}\n"
            f"*BEAM SECTION, ELSET=EALL, MATERIAL=M, SECTION=GENERAL\n{section['area']:.12g},{section['I2']:.12g},0.,{section['I3']:.12g},1e6\n"
            "0.,0.,1.\n" + "".join(step_lines(scenario, 1.0, "") for scenario in setting["scenarios"]))


def nonlinear_deck(nodes, bars, setting, scenario, magnitude):
    """Bars as solids of a square section (B32R); these are Timoshenko beams of shear factor one and torsion constant I2 + I3."""
    side = setting["section"]["area"] ** 0.5
    nodes, elements = list(nodes), []
    for first, last in bars:
        along = [first, *range(len(nodes), len(nodes) + 2 * ELEMENTS - 1), last]
        nodes += [nodes[first] + (nodes[last] - nodes[first]) * k / (2 * ELEMENTS) for k in range(1, 2 * ELEMENTS)]
        elements += [along[k:k + 3] for k in range(0, 2 * ELEMENTS, 2)]
    rows = "".join(",".join(str(value) for value in (number, *(node + 1 for node in element))) + "\n" for number, element in enumerate(elements, 1))
    return (f"{node_lines(nodes)}*ELEMENT, TYPE=B32R, ELSET=EALL\n{rows}*MATERIAL, NAME=M\n*ELASTIC\n{setting['material']['young_modulus']:.12g},0.\n"
            f"*BEAM SECTION, ELSET=EALL, MATERIAL=M, SECTION=RECT\n{side:.12g},{side:.12g}\n0.,0.,1.\n"
            + step_lines(scenario, magnitude, "0.25,1."))


def run(deck, count):
    """The displacements of the first `count` nodes at the end of each step: steps x count x (3 or 6)."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "deck.inp").write_text(deck)
        done = subprocess.run(["ccx", "-i", "deck"], cwd=folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        printed = pathlib.Path(folder) / "deck.dat"
        if done.returncode != 0 or not printed.exists() or "*ERROR" in done.stdout:
            raise RuntimeError(f"ccx ended with {done.returncode}: {done.stdout.strip().splitlines()[-1:]}")
        return displacements_in(printed.read_text(), count)


def displacements_in(text, count):
    """Blocks of displacements, one for each increment that was printed."""
    blocks = []
    for line in text.splitlines():
        words = line.split()
        if line.startswith(" displacements"):
            blocks.append({})
        elif words and re.fullmatch(r"\d+", words[0]) and int(words[0]) <= count:
            blocks[-1][int(words[0])] = [float(word) for word in words[1:]]
    return numpy.array([[block[node] for node in range(1, count + 1)] for block in blocks])
