# SPDX-License-Identifier: GPL-3.0-or-later
"""The four loads of a plate, and the rows that are compared under them."""
LOADS = ("stretching", "shear", "bending", "twist")


def stiffnesses(tensors, prefix=""):
    """Of a strip that is free to contract: stretched and bent; of the plate: sheared and twisted."""
    value = {name: float(tensors[prefix + name]) for name in ("A11", "A12", "A66", "D11", "D12", "D66")}
    return [value["A11"] - value["A12"]**2 / value["A11"], value["A66"],
            value["D11"] - value["D12"]**2 / value["D11"], value["D66"]]


def ratios(row, tensors, prefix=""):
    """Solid over beams."""
    return [solid / beams for solid, beams in zip(stiffnesses(row, "solid_"), stiffnesses(tensors, prefix))]


def halves(rows):
    """Every second pattern, on which things are chosen, and the others, on which they are judged."""
    patterns = sorted({row["pattern"] for row in rows})
    return set(patterns[0::2]), set(patterns[1::2])


def main_rows(rows):
    """Those of the mesh that all patterns have, without fillets."""
    return [row for row in rows if (float(row["mesh"]), float(row["corner"]), int(row["layers"]), float(row["fillet_mm"])) == (0.5, 0.5, 1, 0)]
