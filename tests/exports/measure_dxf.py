# SPDX-License-Identifier: GPL-3.0-or-later
"""Measure a DXF with ezdxf: unit, layers, and the area inside of the closed polylines of the layer `cut`."""
import sys

import ezdxf
import ezdxf.path
from ezdxf import recover

document, auditor = recover.readfile(sys.argv[1])
print("errors", len(auditor.errors) + len(auditor.fixes))
print("unit", document.header["$INSUNITS"])
space = document.modelspace()
print("inserts", len(space.query("INSERT")))
print("layers", ",".join(sorted({entity.dxf.layer for entity in space})))
area = 0.0
closed = True
for entity in space.query('LWPOLYLINE[layer=="cut"]'):
    closed = closed and entity.closed
    points = list(ezdxf.path.make_path(entity).flattening(0.0001))
    area += sum(a.x * b.y - b.x * a.y for a, b in zip(points, points[1:] + points[:1])) / 2
print("closed", closed)
print("area", area)
