# SPDX-License-Identifier: GPL-3.0-or-later
"""A cell of an endless plate as a solid: wedges of second order (C3D15), solved by CalculiX.

The plate's middle plane mirrors stretching and turns bending round, so the upper half is enough for each, with the middle plane held
accordingly. Opposite sides move alike but for the macroscopic strains (e_xx, e_yy, 2 e_xy) or curvatures (w_xx, w_yy, 2 w_xy),
which are the three displacements of one further node.
"""
import pathlib
import subprocess

STRETCHING, BENDING = "stretching", "bending"


class Wedges:
    """Triangles extruded from the middle plane to the surface."""

    def __init__(self, cell, half_height, layers):
        self.cell, self.levels = cell, 2 * layers + 1
        self.heights = [half_height * level / (2 * layers) for level in range(self.levels)]
        corners = {node for triangle in cell.triangles for node in triangle[:3]}
        self.number, self.nodes = {}, []
        for level in range(self.levels):
            for node, (x, y) in enumerate(cell.places):
                if level % 2 == 0 or node in corners:
                    self.nodes.append((x, y, self.heights[level]))
                    self.number[node, level] = len(self.nodes)
        self.elements = [self._wedge(triangle, 2 * layer) for layer in range(layers) for triangle in cell.triangles]

    def _wedge(self, triangle, level):
        at = self.number
        corners, middles = triangle[:3], triangle[3:]
        return ([at[n, level] for n in corners] + [at[n, level + 2] for n in corners] + [at[n, level] for n in middles]
                + [at[n, level + 2] for n in middles] + [at[n, level + 1] for n in corners])


def _jumps(kind, low, high, z):
    """How the displacements of two twins differ: for ux, uy, uz the factors of the three macroscopic quantities."""
    (x, y), (u, v) = low, high
    dx, dy = u - x, v - y
    plane = [[dx, 0.0, dy / 2.0], [0.0, dy, dx / 2.0]]
    if kind == STRETCHING:
        return [*plane, [0.0, 0.0, 0.0]]
    return [[-z * factor for factor in row] for row in plane] + [[(u * u - x * x) / 2.0, (v * v - y * y) / 2.0, (u * v - x * y) / 2.0]]


def _equations(wedges, kind, reference):
    held = (3,) if kind == STRETCHING else (1, 2)
    lines = []
    for slave, master in wedges.cell.twins:
        for level, z in enumerate(wedges.heights):
            if (slave, level) not in wedges.number:
                continue
            ids = wedges.number[slave, level], wedges.number[master, level]
            for dof, row in enumerate(_jumps(kind, wedges.cell.places[master], wedges.cell.places[slave], z), start=1):
                if level == 0 and dof in held:
                    continue
                terms = [(ids[0], dof, 1.0), (ids[1], dof, -1.0)]
                terms += [(reference, i, -factor) for i, factor in enumerate(row, start=1) if abs(factor) > 1e-9]
                lines += ["*EQUATION", str(len(terms))] + [f"{node},{d},{factor:.12e}" for node, d, factor in terms]
    return lines


def deck(wedges, kind, material, boundary, load):
    """The text of an input deck. `boundary`: (node of the cell, dof) that are held besides the middle plane, or (None, dof) of
    the macroscopic node; `load`: its (dof, force)."""
    reference = len(wedges.nodes) + 1
    slaves = {slave for slave, _ in wedges.cell.twins}
    lines = ["*NODE, NSET=ALL"] + [f"{i},{x:.12e},{y:.12e},{z:.12e}" for i, (x, y, z) in enumerate(wedges.nodes, start=1)]
    lines += [f"{reference},0,0,{10 * wedges.heights[-1]:.12e}", "*NSET, NSET=MACROSCOPIC", str(reference)]
    lines.append("*ELEMENT, TYPE=C3D15, ELSET=SOLID")
    for i, element in enumerate(wedges.elements, start=1):
        lines += [",".join(map(str, [i, *element[:9]])) + ",", ",".join(map(str, element[9:]))]
    lines += _equations(wedges, kind, reference)
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{material[0]!r},{material[1]!r}", "*SOLID SECTION, ELSET=SOLID, MATERIAL=M"]
    lines.append("*BOUNDARY")
    middle = [(node, number) for (node, level), number in wedges.number.items() if level == 0]
    for node, number in middle:
        lines += [f"{number},{dof},{dof}" for dof in ((3,) if kind == STRETCHING else (1, 2))]
    for node, dof in boundary:
        if node in slaves:
            raise ValueError("a node that follows another one cannot be held")
        lines.append(f"{reference if node is None else wedges.number[node, 0]},{dof},{dof}")
    lines += ["*STEP", "*STATIC", "*CLOAD", f"{reference},{load[0]},{load[1]!r}", "*NODE PRINT, NSET=MACROSCOPIC", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def macroscopic(folder, text, program="ccx"):
    """Solve, and read the displacements of the macroscopic node."""
    folder = pathlib.Path(folder)
    (folder / "cell.inp").write_text(text)
    done = subprocess.run([program, "-i", "cell"], cwd=folder, capture_output=True, text=True)
    table = folder / "cell.dat"
    if done.returncode != 0 or not table.exists():
        raise ValueError("ccx: " + " ".join((done.stdout + done.stderr).split())[-300:])
    rows = [line.split() for line in table.read_text().splitlines() if len(line.split()) == 4]
    if len(rows) != 1:
        raise ValueError("ccx printed no displacements")
    return [float(value) for value in rows[0][1:]]
