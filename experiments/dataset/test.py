#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A release of twenty patterns. Usage: test.py PROGRAM"""
import csv
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
try:
    import numpy
except ImportError:
    sys.exit(77)  # the test is skipped
import checks  # noqa: E402
from load import load  # noqa: E402
from make import is_held_out  # noqa: E402

PROGRAM = sys.argv.pop(1)


def make(folder, patterns):
    return subprocess.run([sys.executable, str(HERE / "make.py"), PROGRAM, str(folder), "--patterns", patterns],
                          capture_output=True, text=True, check=False)


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name) / "whole"
        cls.told = make(cls.folder, "sample:20")

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def test_has_what_it_says(self):
        self.assertEqual(self.told.returncode, 0, self.told.stderr)
        self.assertTrue(self.told.stdout.startswith("20 patterns, 1000 states, "), self.told.stdout)

    def test_package_names_the_columns_of_each_table(self):
        package = json.loads((self.folder / "datapackage.json").read_text())
        self.assertEqual(len(package["resources"]), len(list((self.folder / "tables").glob("*.csv"))))
        for resource in package["resources"]:
            with (self.folder / resource["path"]).open(newline="") as file:
                self.assertEqual([field["name"] for field in resource["schema"]["fields"]], next(csv.reader(file)))

    def test_checksums_are_those_of_the_files(self):
        for line in (self.folder / "SHA256SUMS").read_text().splitlines():
            digest, path = line.split("  ")
            self.assertEqual(hashlib.sha256((self.folder / path).read_bytes()).hexdigest(), digest)

    def test_arrays_hold_the_rows_of_the_tables(self):
        arrays, properties, held_out = load(self.folder)
        self.assertEqual(set(arrays["patterns"]), set(properties))
        self.assertEqual(held_out, {name for name in properties if is_held_out(name)})
        scenarios, patterns = list(arrays["scenarios"]), list(arrays["patterns"])
        with (self.folder / "tables" / "response.csv").open(newline="") as file:
            for row in csv.DictReader(file):
                values = arrays["displacements"][patterns.index(row["pattern_id"]), scenarios.index(row["scenario"]), int(row["step"]) - 1,
                                                 int(row["node"])]
                self.assertEqual(list(values), [float(row[name]) for name in ("ux", "uy", "uz", "rx", "ry", "rz")])

    def test_work_in_two_parts_gives_the_same_bytes(self):
        parts = self.folder.parent / "parts"
        make(parts, "sample:20").check_returncode()  # a second run goes on where the first ended
        (parts / "library.db").unlink()
        ids = [str(name) for name in load(self.folder)[0]["patterns"]]
        make(parts, ",".join(ids[7:])).check_returncode()
        make(parts, ",".join(ids)).check_returncode()
        self.assertEqual((parts / "SHA256SUMS").read_text(), (self.folder / "SHA256SUMS").read_text())

    def test_checks_find_what_is_wrong(self):
        arrays, _, _ = load(self.folder)
        self.assertEqual(checks.check(self.folder, arrays), [])
        properties = checks.properties_of(self.folder)
        name = next(iter(properties))
        self.assertEqual(len(list(checks.indefinite({name: {**properties[name], "D66": -1.0}}))), 1)
        arrays["displacements"][0, 0, 0] = numpy.nan
        self.assertIn("not finite", checks.check(self.folder, arrays)[0])
        with (self.folder / "tables" / "pattern.csv").open(newline="") as file:
            pairs = [(row["id"], row["mirror"]) for row in csv.DictReader(file) if row["mirror"] not in ("", row["id"])]
        first, mirror = pairs[0]
        sound = properties[name]
        self.assertEqual(list(checks.unequal_mirrors(self.folder, {first: sound, mirror: sound})), [])
        self.assertIn("D11", next(checks.unequal_mirrors(self.folder, {first: sound, mirror: {**sound, "D11": 2.0 * sound["D11"]}})))


if __name__ == "__main__":
    unittest.main()
