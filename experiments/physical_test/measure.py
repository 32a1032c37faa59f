#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured points of a cantilever as a table that run.py --measured reads: along_mm from the clamp, down_mm below it.

Usage, one of
  measure.py points.csv OUT.csv
      a table along_mm,down_mm that was measured by hand: checked and copied
  measure.py photo.csv OUT.csv --marks AX,AY BX,BY --distance MM --clamp X,Y
      pixels x,y of points on the edge, read off a photograph taken square to the side; two marks that lie level, the first nearer to the
      clamp, their distance, and the clamp's upper edge
  measure.py scan.(ply|stl|xyz) OUT.csv --clamp X,Y,Z --ahead X,Y,Z --up X,Y,Z [--unit MM] [--width MM]
      points of a scan: the middle of the clamped edge, the directions from there along the flat sheet and upwards, the length of the scan's
      unit, and how near to the middle line points are taken (18 mm)
"""
import argparse
import csv
import math
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import write_table  # noqa: E402

CLASSES = 40  # a scan's points are means over so many stretches


def fail(text):
    raise SystemExit(f"measure.py: {text}")


def vector(text, size):
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != size or not all(map(math.isfinite, numbers)):
        fail(f"'{text}': expected {size} numbers with commas between")
    return numbers


def read_table(path, names):
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        if not set(names) <= set(reader.fieldnames or []):
            fail(f"{path}: expected a first line with the columns {', '.join(names)}")
        rows = [tuple(vector(row[name] or "", 1)[0] for name in names) for row in reader]
    if not rows:
        fail(f"{path}: has no points")
    return rows


def from_photograph(path, options):
    if not (options.marks and options.distance and options.clamp):
        fail("a photograph needs --marks, --distance and --clamp")
    first, second = (vector(mark, 2) for mark in options.marks)
    clamp = vector(options.clamp, 2)
    pixels = math.dist(first, second)
    if pixels == 0.0 or options.distance <= 0.0:
        fail("the marks need a distance")
    scale = options.distance / pixels
    ahead = [(b - a) / pixels for a, b in zip(first, second)]
    down = [-ahead[1], ahead[0]] if ahead[0] > 0 else [ahead[1], -ahead[0]]  # pixels count downwards
    return [(scale * dot(ahead, minus(point, clamp)), scale * dot(down, minus(point, clamp)))
            for point in read_table(path, ("x", "y"))]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def unit(a):
    length = math.hypot(*a)
    if length == 0.0:
        fail("a direction needs a length")
    return [x / length for x in a]


def from_scan(path, options):
    if not (options.clamp and options.ahead and options.up):
        fail("a scan needs --clamp, --ahead and --up")
    origin, ahead = vector(options.clamp, 3), unit(vector(options.ahead, 3))
    up = vector(options.up, 3)
    up = unit(minus(up, [dot(up, ahead) * x for x in ahead]))  # square to the sheet's direction
    aside = [ahead[1] * up[2] - ahead[2] * up[1], ahead[2] * up[0] - ahead[0] * up[2], ahead[0] * up[1] - ahead[1] * up[0]]
    placed = []
    for point in scan_points(path):
        offset = [options.unit * x for x in minus(point, origin)]
        if abs(dot(aside, offset)) <= options.width:
            placed.append((dot(ahead, offset), -dot(up, offset)))
    placed = sorted(point for point in placed if point[0] >= 0.0)
    if not placed:
        fail(f"{path}: no point lies ahead of the clamp and within {options.width:g} mm of the middle line; are unit and directions right?")
    size = math.ceil(len(placed) / CLASSES)
    groups = [placed[i:i + size] for i in range(0, len(placed), size)]
    return [tuple(sum(axis) / len(group) for axis in zip(*group)) for group in groups]


def scan_points(path):
    readers = {".ply": ply_points, ".stl": stl_points, ".xyz": xyz_points}
    if path.suffix.lower() not in readers:
        fail(f"{path}: expected .csv, .ply, .stl or .xyz")
    try:
        points = readers[path.suffix.lower()](path.read_bytes())
    except (ValueError, IndexError, KeyError, struct.error) as error:
        fail(f"{path}: not a {path.suffix[1:].upper()} file that can be read: {error}")
    return points


def xyz_points(data):
    lines = (line.split() for line in data.decode().splitlines())
    return [tuple(map(float, line[:3])) for line in lines if line and not line[0].startswith("#")]


def stl_points(data):
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else 0
    if len(data) == 84 + 50 * count and count:
        return [struct.unpack_from("<3f", data, 84 + 50 * i + 12 * k) for i in range(count) for k in (1, 2, 3)]
    lines = (line.split() for line in data.decode().splitlines())
    return [tuple(map(float, line[1:4])) for line in lines if line[:1] == ["vertex"]]


PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
             "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def ply_points(data):
    """Vertices come first in the file, as scanners write it."""
    head, _, body = data.partition(b"end_header\n")
    lines = [line.split() for line in head.decode().splitlines()]
    form = next((line[1] for line in lines if line[:1] == ["format"]), None)
    if form is None:
        raise ValueError("it has no header")
    elements = [line for line in lines if line[:1] == ["element"]]
    if elements[0][1] != "vertex":
        raise ValueError("its first element is not the vertices")
    first = lines.index(elements[0])
    last = lines.index(elements[1]) if len(elements) > 1 else len(lines)
    properties = [line for line in lines[first:last] if line[:1] == ["property"]]
    names = [line[-1] for line in properties]
    places = [names.index(axis) for axis in "xyz"]
    count = int(elements[0][2])
    if form == "ascii":
        rows = [line.split() for line in body.decode().splitlines()[:count]]
        return [tuple(float(row[place]) for place in places) for row in rows]
    layout = struct.Struct((">" if form == "binary_big_endian" else "<") + "".join(PLY_TYPES[line[1]] for line in properties))
    rows = (layout.unpack_from(body, i * layout.size) for i in range(count))
    return [tuple(row[place] for place in places) for row in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("input", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--marks", nargs=2)
    parser.add_argument("--distance", type=float)
    parser.add_argument("--clamp")
    parser.add_argument("--ahead")
    parser.add_argument("--up")
    parser.add_argument("--unit", type=float, default=1.0)
    parser.add_argument("--width", type=float, default=18.0)
    options = parser.parse_args()
    if not options.input.exists():
        fail(f"{options.input}: no such file")
    if options.input.suffix.lower() != ".csv":
        points = from_scan(options.input, options)
    elif options.marks:
        points = from_photograph(options.input, options)
    else:
        points = read_table(options.input, ("along_mm", "down_mm"))
    write_table(options.output, ["along_mm", "down_mm"], ([f"{along:.3f}", f"{down:.3f}"] for along, down in sorted(points)))
    print(f"{len(points)} points, {max(p[0] for p in points):.0f} mm along, down to {max(p[1] for p in points):.1f} mm: {options.output}")


if __name__ == "__main__":
    main()
