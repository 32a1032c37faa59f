#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A cantilever's points come back from every kind of measurement as they were."""
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import read_rows  # noqa: E402

PROGRAM = pathlib.Path(__file__).resolve().parent / "measure.py"
# Millimetres: along the cantilever, below the clamp.
POINTS = [(10.0 * i, 0.004 * (10.0 * i) ** 1.6) for i in range(1, 26)]
SCAN = ["--clamp", "100,50,97", "--ahead", "1,0,0", "--up", "0.1,1,0"]  # up is made square to ahead
PLY = "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nend_header\n"


def scanned():
    """Points of a scan whose axes are not those of the sheet; those far from its middle line do not count."""
    middle = [(100.0 + along, 50.0 - down, 97.0) for along, down in POINTS]
    return [*middle, *((x, y + 40.0, z + 60.0) for x, y, z in middle)]


class Measure(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_on(self, name, content, *options):
        path = pathlib.Path(self.folder.name) / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        self.out = path.with_name("out.csv")
        return subprocess.run([sys.executable, PROGRAM, path, self.out, *options], capture_output=True, text=True)

    def assert_points(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        found = [(float(row["along_mm"]), float(row["down_mm"])) for row in read_rows(self.out)]
        self.assertEqual(len(found), len(POINTS))
        for (along, down), (expected_along, expected_down) in zip(found, POINTS):
            self.assertAlmostEqual(along, expected_along, delta=2e-3)  # files have a thousandth of a millimetre
            self.assertAlmostEqual(down, expected_down, delta=2e-3)

    def test_a_table_comes_back(self):
        rows = "".join(f"{along},{down}\n" for along, down in POINTS)
        self.assert_points(self.run_on("p.csv", "along_mm,down_mm\n" + rows))

    def test_a_tilted_photograph(self):
        c, s = math.cos(0.05), math.sin(0.05)

        def pixel(along, down):
            return 300 + 4 * (c * along - s * down), 200 + 4 * (s * along + c * down)

        rows = "".join("{:.6f},{:.6f}\n".format(*pixel(*point)) for point in POINTS)
        marks = ["{:.6f},{:.6f}".format(*pixel(along, -30.0)) for along in (0.0, 250.0)]
        self.assert_points(self.run_on("photo.csv", "x,y\n" + rows, "--marks", *marks, "--distance", "250", "--clamp", "300,200"))

    def test_a_scan_as_xyz(self):
        text = "".join("{} {} {}\n".format(*point) for point in scanned())
        self.assert_points(self.run_on("scan.xyz", text, *SCAN))

    def test_a_scan_in_metres(self):
        text = "".join("{} {} {}\n".format(*(1e-3 * x for x in point)) for point in scanned())
        self.assert_points(self.run_on("scan.xyz", text, "--unit", "1000", "--clamp", "0.1,0.05,0.097", *SCAN[2:]))

    def test_a_scan_as_ply_in_text(self):
        points = scanned()
        text = PLY.format("ascii", len(points)) + "".join("{} {} {} 7\n".format(*point) for point in points)
        self.assert_points(self.run_on("scan.ply", text, *SCAN))

    def test_a_scan_as_binary_ply(self):
        points = scanned()
        data = b"".join(struct.pack(">3dB", *point, 7) for point in points)
        self.assert_points(self.run_on("scan.ply", PLY.format("binary_big_endian", len(points)).encode() + data, *SCAN))

    def test_a_scan_as_stl(self):
        points = scanned()
        data = b"".join(struct.pack("<12fH", 0, 0, 1, *point, *point, *point, 0) for point in points)
        done = self.run_on("scan.stl", b"\0" * 80 + struct.pack("<I", len(points)) + data, *SCAN)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_is_missing_is_said_in_one_line(self):
        for name, content, options, said in (
                ("p.csv", "x,y\n1,2\n", [], "along_mm, down_mm"),
                ("p.csv", "x,y\n1,two\n", ["--marks", "1,2", "3,4", "--distance", "4", "--clamp", "1,2"], "'two'"),
                ("scan.ply", "not a mesh", SCAN, "scan.ply"),
                ("scan.obj", "v 0 0 0\n", SCAN, "expected .csv, .ply, .stl or .xyz"),
                ("scan.xyz", "0 0 0\n", [], "--clamp, --ahead and --up"),
                ("scan.xyz", "-500 50 97\n", SCAN, "no point lies ahead")):
            done = self.run_on(name, content, *options)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
