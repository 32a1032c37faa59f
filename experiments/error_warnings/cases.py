# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces and loads of many kinds, each at amounts from small to far beyond what reduced tiles can follow."""
import math

CLAMP = ["ux", "uy", "uz", "rx", "ry", "rz"]
PIN = ["ux", "uy", "uz"]
GRAVITY = 9.80665  # m/s2
SIDES = ("left", "right", "bottom", "top")


def rectangle(width, height):
    return [[0, 0], [width, 0], [width, height], [0, height]]


def circle(x, y, radius, count=24):
    return [[x + radius * math.cos(2 * math.pi * k / count), y + radius * math.sin(2 * math.pi * k / count)] for k in range(count)]


def on_sides(names, fixed):
    return [{"side": name, "fixed": fixed} for name in names]


def pinch(amount):
    """A strip, clamped on the left, whose long sides are pressed together in the middle."""
    pressed = [{"nearest": [[0.25, y]], "uy": sign * amount / 2} for y, sign in ((0, 1), (0.16, -1))]
    return {"supports": on_sides(["left", "right"], CLAMP), "prescribed": pressed,
            "loads": [{"nearest": [[0.25, 0.08]], "force": [0, 0, 0.002]}]}


def annulus_twist(amount):
    """The inner rim is turned in the plane, the outer one is clamped."""
    centre, inner = (0.2, 0.2), 0.07
    turned = []
    for x, y in circle(*centre, inner, 12):
        u, v = x - centre[0], y - centre[1]
        turned.append({"nearest": [[x, y]], "ux": math.cos(amount) * u - math.sin(amount) * v - u,
                       "uy": math.sin(amount) * u + math.cos(amount) * v - v, "rz": amount})
    return {"supports": [{"nearest": circle(*centre, 0.2, 40), "fixed": CLAMP}], "prescribed": turned,
            "loads": [{"nearest": [[0.32, 0.2]], "force": [0, 0, 0.002]}]}


def corner_load(amount):
    return {"supports": on_sides(["left"], CLAMP), "loads": [{"nearest": [[0.4, 0.3]], "force": [0, 0, -amount]}]}


def lifted_corner(amount):
    return {"supports": [{"nearest": [[0, 0], [0.4, 0], [0, 0.3]], "fixed": PIN}],
            "prescribed": [{"nearest": [[0.4, 0.3]], "uz": amount}]}


def arch(amount):
    """Two supports that are moved together under a small weight."""
    return {"supports": on_sides(["left"], PIN) + on_sides(["right"], ["uy", "uz"]),
            "prescribed": [{"side": "right", "ux": -amount}],
            "loads": [{"box": [-1, -1, 2, 2], "force": [0, 0, 0.05], "amount": "total"}]}


def rim_moment(amount):
    return {"supports": on_sides(["left"], CLAMP),
            "loads": [{"side": "right", "moment": [0, -amount, 0], "force": [0, 0, 0], "amount": "total"}]}


def cantilever(amount):
    return {"supports": on_sides(["left"], CLAMP), "loads": [{"side": "right", "force": [0, 0, -amount], "amount": "total"}]}


def corner_pins(amount):
    """Its own weight, many times over, between pinned corners."""
    return {"supports": [{"nearest": [[0, 0], [0.5, 0], [0.5, 0.4], [0, 0.4]], "fixed": PIN}], "gravity": [0, 0, -GRAVITY * amount]}


def cross(amount):
    return {"supports": on_sides(SIDES, PIN), "loads": [{"nearest": [[0.25, 0.25]], "force": [0, 0, -amount]}]}


def sway(amount):
    return {"supports": on_sides(["bottom"], CLAMP),
            "prescribed": [{"side": "top", "ux": amount * 0.01, "uz": amount * 0.3}]}


def torsion(amount):
    return {"supports": on_sides(["left"], CLAMP), "prescribed": [{"side": "right", "rx": amount}]}


def tripod(amount):
    feet = [[0.25 + 0.25 * math.cos(a), 0.25 + 0.25 * math.sin(a)] for a in (0.5, 2.6, 4.7)]
    return {"supports": [{"nearest": feet, "fixed": PIN}], "gravity": [0, 0, -GRAVITY * amount]}


def membrane(amount):
    """Air pressure on a sheet that is pinned all around."""
    return {"supports": on_sides(SIDES, PIN), "loads": [{"box": [-1, -1, 2, 2], "per_area": [0, 0, amount]}]}


def tension(amount):
    return {"supports": on_sides(["left"], CLAMP),
            "loads": [{"side": "right", "force": [amount, 0, 0.02 * amount], "amount": "total"}]}


def shear(amount):
    return {"supports": on_sides(["left"], CLAMP),
            "loads": [{"side": "right", "force": [0, amount, 0.02 * amount], "amount": "total"}]}


CROSS = [[0.17, 0], [0.33, 0], [0.33, 0.17], [0.5, 0.17], [0.5, 0.33], [0.33, 0.33], [0.33, 0.5], [0.17, 0.5],
         [0.17, 0.33], [0, 0.33], [0, 0.17], [0.17, 0.17]]
FOUR_HOLES = [circle(x, y, 0.04, 12) for x in (0.15, 0.35) for y in (0.12, 0.28)]

# Name, boundary, holes, load case, amounts.
KINDS = [
    ("pinch", rectangle(0.5, 0.16), [], pinch, (0.01, 0.05, 0.1)),
    ("annulus-twist", circle(0.2, 0.2, 0.2, 40), [circle(0.2, 0.2, 0.07)], annulus_twist, (0.05, 0.2, 0.6)),
    ("corner-load", rectangle(0.4, 0.3), [], corner_load, (0.02, 0.1, 0.5)),
    ("lifted-corner", rectangle(0.4, 0.3), [], lifted_corner, (0.03, 0.12, 0.3)),
    ("arch", rectangle(0.55, 0.1), [], arch, (0.0005, 0.02, 0.06)),
    ("rim-moment", rectangle(0.4, 0.16), [], rim_moment, (0.02, 0.1, 0.3)),
    ("cantilever", rectangle(0.4, 0.2), [], cantilever, (0.02, 0.1, 0.5)),
    ("holes-gravity", rectangle(0.5, 0.4), FOUR_HOLES, corner_pins, (0.1, 3, 40)),
    ("cross-pinned", CROSS, [], cross, (0.05, 2, 40)),
    ("sway", rectangle(0.4, 0.2), [], sway, (0.1, 0.3, 0.6)),
    ("torsion-strip", rectangle(0.4, 0.1), [], torsion, (0.3, 1.5, 2.8)),
    ("tripod-ring", circle(0.25, 0.25, 0.25, 40), [circle(0.25, 0.25, 0.12)], tripod, (0.3, 3, 10)),
    ("membrane", rectangle(0.4, 0.3), [], membrane, (1, 50, 2000)),
    ("tension", rectangle(0.5, 0.16), [], tension, (0.5, 10, 40)),
    ("shear", rectangle(0.5, 0.2), [], shear, (0.02, 0.2, 1)),
]


def stages(load_case):
    """The same loads and displacements in one stage, whose supports are those of the load case."""
    stage = {"name": "all", "loads": [{"load_case": load_case["name"], "factor": 1}]}
    if "prescribed" in load_case:
        stage["prescribed"] = load_case["prescribed"]
    return {"format": "fretwork/stages/1", "stages": [stage]}


def cases(paintings):
    """Of each kind, amount and seed of a painting: name, outline and load case."""
    for name, boundary, holes, load_case, amounts in KINDS:
        for seed in paintings:
            for amount in amounts:
                yield {"kind": name, "amount": amount, "painting": seed,
                       "outline": {"format": "fretwork/outline/1", "boundary": boundary, "holes": holes},
                       "load_case": {"format": "fretwork/load-case/2", "name": name, **load_case(amount)}}
