# SPDX-License-Identifier: GPL-3.0-or-later
"""Random outlines, and load cases of every kind with a wanted deflection."""
import math
import random

CLAMP = ["ux", "uy", "uz", "rx", "ry", "rz"]

# Of each kind, the range of the largest displacement as a share of the span (the width of the outline). Cantilevers and bridges
# are under weight; the others, moderate loads of other kinds.
KINDS = {
    "cantilever": (0.15, 0.8),
    "bridge": (0.15, 0.8),
    "gravity": (0.15, 0.6),
    "shear": (0.01, 0.1),
    "tension": (0.005, 0.05),
    "compression": (0.02, 0.2),
    "pinned": (0.03, 0.2),
    "twist": (0.05, 0.3),
    "prescribed": (0.05, 0.4),
}
UNDER_WEIGHT = ("cantilever", "bridge", "gravity")


def rectangle(w, h, rng):
    return [[0, 0], [w, 0], [w, h], [0, h]]


def trapezoid(w, h, rng):
    inset = rng.uniform(0.1, 0.35) * h
    return [[0, 0], [w, inset], [w, h - inset * rng.uniform(0, 1)], [0, h]]


def waisted(w, h, rng):
    """Two wide ends and a neck between them."""
    neck = rng.uniform(0.15, 0.3) * h
    half = w / 2
    return [[0, 0], [half, neck], [w, 0], [w, h], [half, h - neck], [0, h]]


def angle(w, h, rng):
    a, b = rng.uniform(0.4, 0.6) * w, rng.uniform(0.45, 0.6) * h
    return [[0, 0], [w, 0], [w, b], [a, b], [a, h], [0, h]]


def blob(w, h, rng):
    points = []
    phases = [rng.uniform(0, 2 * math.pi) for _ in range(3)]
    for k in range(48):
        t = 2 * math.pi * k / 48
        r = 1 + sum(0.09 * math.cos((n + 2) * t + phases[n]) for n in range(3))
        points.append([w / 2 * (1 + r * math.cos(t)), h / 2 * (1 + r * math.sin(t))])
    left, low = min(p[0] for p in points), min(p[1] for p in points)
    return [[x - left, y - low] for x, y in points]


def band(w, h, rng):
    """A part of a ring."""
    inner, outer, reach = 0.55 * w, w, rng.uniform(0.9, 1.5)
    arc = [k / 16 * reach for k in range(17)]
    points = [[outer * math.sin(t), outer * (1 - math.cos(t))] for t in arc]
    points += [[inner * math.sin(t), outer - inner * math.cos(t)] for t in reversed(arc)]
    left, low = min(p[0] for p in points), min(p[1] for p in points)
    return [[x - left, y - low] for x, y in points]


SHAPES = (rectangle, trapezoid, waisted, angle, blob, band)


def outline(shape, rng):
    """Of about 45 to 240 tiles of the paper's size."""
    width = rng.uniform(0.4, 0.8)
    boundary = shape(width, width * rng.uniform(0.35, 0.7), rng)
    holes = []
    if shape is rectangle and rng.random() < 0.4:
        x, y = boundary[2][0] / 2, boundary[2][1] / 2
        r = 0.18 * boundary[2][1]
        holes.append([[x + r * math.cos(0.5 * k), y + r * math.sin(0.5 * k)] for k in range(12)])
    return {"format": "fretwork/outline/1", "boundary": boundary, "holes": holes}


def load_case(kind, amount, width, height):
    """`amount` is in newtons or, where other units are meant, scales them."""
    left = {"side": "left", "fixed": CLAMP}
    case = {"format": "fretwork/load-case/1", "name": kind, "supports": [left]}
    middle = [0.35 * width, -1, 0.65 * width, height + 1]

    def total(where, **what):
        case["loads"] = [{**where, **what, "amount": "total"}]

    if kind == "cantilever":
        total({"side": "right"}, force=[0, 0, -amount])
    elif kind == "bridge":
        case["supports"].append({"side": "right", "fixed": ["uy", "uz"]})
        total({"box": middle}, force=[0, 0, -amount])
    elif kind == "gravity":
        case["gravity"] = [0, 0, -9.81 * amount]
    elif kind == "shear":
        total({"side": "right"}, force=[0, amount, 0.02 * amount])
    elif kind == "tension":
        total({"side": "right"}, force=[amount, 0, 0.02 * amount])
    elif kind == "compression":  # it is pushed a little to one side, so that there is one branch to follow
        total({"side": "right"}, force=[-0.3 * amount, 0, 0.3 * amount])
    elif kind == "pinned":
        pins = ["ux", "uy", "uz"]
        case["supports"] = [{"side": "left", "fixed": pins}, {"side": "right", "fixed": pins}]
        total({"box": middle}, force=[0, 0, -amount])
    elif kind == "twist":
        total({"side": "right"}, force=[0, 0, 0], moment=[0.1 * amount, 0, 0])
    elif kind == "prescribed":
        case["prescribed"] = [{"side": "right", "uz": amount}]
    return case


def surfaces(count, seed=1):
    """Numbered descriptions: kind, outline, wanted deflection as a share of the span, seed of the painting."""
    kinds = list(KINDS)
    # Cantilevers and bridges, which the claims are about, are every second surface.
    order = [kinds[i // 2 % 2] if i % 2 == 0 else kinds[2 + i // 2 % (len(kinds) - 2)] for i in range(count)]
    for number, kind in enumerate(order):
        rng = random.Random(1000 * seed + number)
        shape = SHAPES[number // 4 % len(SHAPES)]
        low, high = KINDS[kind]
        yield {"number": number, "kind": kind, "shape": shape.__name__, "outline": outline(shape, rng),
               "target": low * (high / low) ** rng.random(), "painting": rng.randrange(1 << 30)}
