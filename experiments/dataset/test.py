#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A release of twenty patterns. Usage: test.py PROGRAM"""
import copy
import hashlib
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]
try:
    import jsonschema
    import numpy
except ImportError:
    sys.exit(77)  # the test is skipped
import checks  # noqa: E402
import clearance  # noqa: E402
import tile_geometry  # noqa: E402
from csv_tables import columns_of, read_rows  # noqa: E402
from load import load  # noqa: E402
from make import is_held_out  # noqa: E402

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())


def make(folder, *options):
    return subprocess.run([sys.executable, "-B", str(HERE / "make.py"), PROGRAM, str(folder), *options], capture_output=True, text=True, check=False)


def run(folder, *words):
    return subprocess.run([PROGRAM, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name) / "whole"
        cls.told = make(cls.folder, "--patterns", "sample:20")

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def content(self):
        with numpy.load(self.folder / "stiffness.npz") as file:
            return load(self.folder)[0], dict(file)

    def test_has_what_it_says(self):
        self.assertEqual(self.told.returncode, 0, self.told.stderr)
        self.assertTrue(self.told.stdout.startswith("20 patterns, 1000 states, "), self.told.stdout)
        self.assertIn("stiffness.npz", self.told.stdout)
        self.assertIn("patterns a second and core", self.told.stdout)

    def test_package_keeps_the_specification(self):
        package = json.loads((self.folder / "datapackage.json").read_text())
        validator = jsonschema.Draft202012Validator(json.loads((HERE / "datapackage.schema.json").read_text()))
        validator.validate(package)
        for spoil in (lambda p: p.pop("resources"), lambda p: p.update(name="Paper 7"), lambda p: p["resources"][0].update(path="../x.csv"),
                      lambda p: p["resources"][0].pop("schema"), lambda p: p["resources"][0]["schema"]["fields"][0].update(type="float")):
            spoiled = copy.deepcopy(package)
            spoil(spoiled)
            self.assertFalse(validator.is_valid(spoiled))

    def test_package_names_the_columns_of_each_table(self):
        package = json.loads((self.folder / "datapackage.json").read_text())
        tables = [resource for resource in package["resources"] if resource["profile"] == "tabular-data-resource"]
        self.assertEqual(len(tables), len(list((self.folder / "tables").glob("*.csv"))))
        for resource in tables:
            self.assertEqual([field["name"] for field in resource["schema"]["fields"]], columns_of(self.folder / resource["path"]))
        self.assertEqual(len({resource["name"] for resource in package["resources"]}), len(package["resources"]))

    def test_checksums_are_those_of_the_files(self):
        for line in (self.folder / "SHA256SUMS").read_text().splitlines():
            digest, path = line.split("  ")
            self.assertEqual(hashlib.sha256((self.folder / path).read_bytes()).hexdigest(), digest)

    def test_arrays_hold_the_rows_of_the_tables(self):
        arrays, properties, held_out = load(self.folder)
        self.assertEqual(set(arrays["patterns"]), set(properties))
        mirrors = dict(checks.mirror_pairs(self.folder))
        self.assertEqual(held_out, {name for name in properties if is_held_out(name, mirrors[name])})
        scenarios, patterns = list(arrays["scenarios"]), list(arrays["patterns"])
        for row in read_rows(self.folder / "tables" / "response.csv"):
            values = arrays["displacements"][patterns.index(row["pattern_id"]), scenarios.index(row["scenario"]), int(row["step"]) - 1, int(row["node"])]
            self.assertEqual(list(values), [float(row[name]) for name in ("ux", "uy", "uz", "rx", "ry", "rz")])

    def test_mirror_images_are_held_out_together(self):
        pairs = [pair for pair in checks.mirror_pairs(self.folder) if pair[1]]
        self.assertGreater(sum(is_held_out(*pair) for pair in pairs), len(pairs) // 10)
        for name, mirror in pairs:
            self.assertEqual(is_held_out(name, mirror), is_held_out(mirror, name))

    def test_stiffness_answers_small_loads_as_the_responses_do(self):
        """The first sample of `bending`, a tenth of its magnitude, is small: its work is that of the condensed stiffness to 5 %."""
        arrays, matrices = self.content()
        scenario = next(s for s in json.loads((self.folder / "tables" / "setting.json").read_text())["scenarios"] if s["name"] == "bending")
        at, force = list(arrays["scenarios"]).index("bending"), numpy.zeros((6, 6))
        for row in scenario["loads"]:
            force[row["interface_node"], :3] = row["force"]
        held = [6 * row["interface_node"] + component for row in scenario["held"] for component in range(6)]
        free = numpy.setdiff1d(numpy.arange(36), held)
        for place, matrix in enumerate(matrices["stiffness"]):
            flexibility = force.ravel()[free] @ numpy.linalg.solve(matrix[numpy.ix_(free, free)], force.ravel()[free])
            work = (arrays["displacements"][place, at, 0] * force).sum() / arrays["magnitude"][place, at, 0]
            self.assertAlmostEqual(work / flexibility, 1.0, delta=0.05)

    def test_distances_are_those_of_the_filter(self):
        rows = read_rows(self.folder / "tables" / "clearance.csv")
        for width in clearance.WIDTHS:
            run(self.folder, "enumerate", "--filter", f"tight_clearance={clearance.GAP}", "--beam-width", width, "--list", "../list.txt")
            allowed = set((self.folder.parent / "list.txt").read_text().split())
            for row in rows:
                self.assertEqual(float(row["distance_in_tile"] or "inf") >= width + clearance.GAP, row["pattern_id"] in allowed, row)

    def test_distances_in_a_surface_are_those_that_painting_warns_of(self):
        """Nine hexagons, the middle one with all of its neighbours."""
        side = json.loads((self.folder / "tables" / "setting.json").read_text())["tile_side"]
        self.write_hexagons(self.folder.parent / "hexagons.obj", side)
        bars = 0.002
        rows = [row for row in read_rows(self.folder / "tables" / "clearance.csv") if float(row["distance"]) > bars]
        self.assertGreater(len(rows), 5)
        for row in rows[:6]:
            gap = float(row["distance"]) - bars
            for factor, count in ((0.999, 0), (1.001, 1)):
                told = run(self.folder.parent, "tile", "hexagons.obj", "--keep-mesh", "--setting", "paper", "--patterns", row["pattern_id"], "--clearance",
                           repr(factor * gap), "--out", f"p{factor}.json")
                self.assertEqual(told.returncode, 0, told.stderr)
                self.assertEqual("come as near" in told.stderr + told.stdout, count == 1, (row, factor, told.stderr))

    @staticmethod
    def write_hexagons(path, side):
        corners, faces = [], []
        polygon = tile_geometry.polygon(6, side)
        steps = [polygon[t] + polygon[(t + 1) % 6] for t in range(6)]
        for centre in [numpy.zeros(2), *steps, steps[0] + steps[1], steps[1] + steps[2]]:
            face = []
            for corner in polygon + centre:
                known = [place for place, other in enumerate(corners) if math.dist(corner, other) < 1e-6]
                if not known:
                    corners.append(corner)
                face.append((known[0] if known else len(corners) - 1) + 1)
            faces.append(face)
        path.write_text("".join(f"v {x!r} {y!r} 0\n" for x, y in ((float(x), float(y)) for x, y in corners)) +
                        "".join("f " + " ".join(map(str, face)) + "\n" for face in faces))

    def test_work_in_two_parts_gives_the_same_bytes(self):
        parts = self.folder.parent / "parts"
        ids = [str(name) for name in load(self.folder)[0]["patterns"]]
        make(parts, "--patterns", ",".join(ids[7:])).check_returncode()
        (parts / "stiffness").mkdir()  # as if it had been killed while it wrote
        (parts / "stiffness" / "stiffness.npy").write_bytes(b"half")
        make(parts, "--patterns", ",".join(ids)).check_returncode()  # goes on where the first ended
        self.assertEqual((parts / "SHA256SUMS").read_text(), (self.folder / "SHA256SUMS").read_text())

    def test_checks_find_what_is_wrong(self):
        arrays, matrices = self.content()
        self.assertEqual(checks.check(self.folder, arrays, matrices), [])
        properties = checks.properties_of(self.folder)
        name = next(iter(properties))
        self.assertEqual(len(list(checks.indefinite({name: {**properties[name], "D66": -1.0}}))), 1)
        spoiled = copy.deepcopy(arrays)
        spoiled["displacements"][0, 0, 0] = numpy.nan
        self.assertIn("not finite", checks.check(self.folder, spoiled, matrices)[0])
        self.assertIn("neither responses nor a failure", checks.check(self.folder, arrays, matrices, is_whole=True)[0])

    def test_checks_find_wrong_mirror_images(self):
        properties, (_, matrices) = checks.properties_of(self.folder), self.content()
        first, mirror = next(pair for pair in checks.mirror_pairs(self.folder) if pair[1] not in ("", pair[0]) and pair[0] < pair[1])
        sound = next(iter(properties.values()))
        self.assertEqual(list(checks.unequal_mirrors([(first, mirror)], {first: sound, mirror: sound})), [])
        self.assertIn("D11", next(checks.unequal_mirrors([(first, mirror)], {first: sound, mirror: {**sound, "D11": 2.0 * sound["D11"]}})))
        matrix = matrices["stiffness"][0]
        for factor, count in ((1.0, 0), (1.001, 1)):
            pair = {"patterns": [first, mirror], "stiffness": numpy.array([matrix, factor * matrix])}
            self.assertEqual(len(list(checks.unequal_mirror_stiffness([(first, mirror)], pair))), count)

    def test_checks_find_wrong_stiffness(self):
        _, matrices = self.content()
        properties = checks.properties_of(self.folder)
        for key, at, word in (("stiffness", (0, 3, 4), "not symmetric"), ("stiffness", (0, 3, 3), "eigenvalue"), ("A", (0, 0, 0), "A from"),
                              ("B", (0, 1, 0), "B has"), ("D", (0, 2, 2), "D from")):
            spoiled = copy.deepcopy(matrices)
            spoiled[key][at] -= 2.0 * numpy.abs(spoiled["stiffness" if key == "stiffness" else "A"]).max()
            complaints = [*checks.unsound_stiffness(spoiled), *checks.unequal_tensors(properties, spoiled)]
            self.assertTrue(any(word in complaint for complaint in complaints), (key, complaints))

    def test_other_layouts_are_drawn_by_count_and_seed(self):
        """Twelve patterns of a layout of two nodes a side, which is too large to list in a test."""
        layout = self.folder.parent / "own.json"
        layout.write_text('{ "format": "fretwork/layout/1", "name": "Own_2", "radial": ["1/2"], "face": [["1/2", "1/4", "1/4"]], "interface": ["1/4", "3/4"] }')
        setting = self.folder.parent / "short.json"
        setting.write_text('{ "format": "fretwork/setting/2", "material": { "young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1240 }, '
                           '"section": { "type": "rectangle", "width": 0.001, "height": 0.001 }, "magnitudes": 2, '
                           '"scenarios": [{ "use": "bending", "max_magnitude": 0.01 }] }')
        found = []
        for seed in (3, 3, 4):
            told = make(self.folder.parent / f"drawn{len(found)}", "--layout", layout, "--setting", setting, "--draw", "6", "--seed", str(seed))
            self.assertEqual(told.returncode, 0, told.stderr)
            found.append((self.folder.parent / f"drawn{len(found)}" / "SHA256SUMS").read_text())
        self.assertEqual(found[0], found[1])
        self.assertNotEqual(found[0], found[2])
        with numpy.load(self.folder.parent / "drawn0" / "stiffness.npz") as file:
            self.assertEqual(file["stiffness"].shape[1:], (72, 72))
        self.assertEqual(json.loads((self.folder.parent / "drawn0" / "datapackage.json").read_text())["name"], "fretwork-own_2")


if __name__ == "__main__":
    unittest.main()
