# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the package share."""

import functools
import inspect
import os
import pathlib

import fretwork as fw

SOURCE = pathlib.Path(os.environ["FRETWORK_SOURCE_DIR"])
PATTERN = "0-1+1-6"
OTHER = "0-5+5-6"


def public_parts(also=()):
    """What the package shows, as (name, part); members follow their class, "Session.paint". `also`: of those with an underscore, these."""
    for name, part in sorted(vars(fw).items()):
        if name.startswith("_") or inspect.ismodule(part):
            continue
        yield name, part
        if inspect.isclass(part):
            yield from ((f"{name}.{key}", member) for key, member in vars(part).items() if not key.startswith("_") or key in also)


@functools.cache
def project():
    """A square of 33 tiles, painted with one pattern."""
    square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])
    return fw.make_project(square, patterns=PATTERN, edge_length=0.025)[0]


def tip(force=-0.001):
    """Held at the left, pushed down at the right."""
    return fw.LoadCase(
        name="tip",
        supports=[fw.LoadCase.Support(fw.NodesAtSide("left"), "all")],
        loads=[fw.LoadCase.Load(fw.NodesAtSide("right"), force=[0, 0, force])],
    )


def surface():
    return fw.make_surface(project())


def cantilever(divisions=1):
    """A steel bar of 1 m, 10 x 10 mm, held at one end and loaded with 1 N downwards at the other."""
    steel = fw.Material(young_modulus=2e11, poisson_ratio=0.3, density=7850)
    bar = fw.Beam((0, 1), fw.rectangle_section(0.01, 0.01), steel, divisions=divisions)
    return fw.Frame([[0, 0, 0], [1, 0, 0]], [bar], [fw.Support(0, "all")], loads=[fw.NodalLoad(1, [0, 0, -1])])
