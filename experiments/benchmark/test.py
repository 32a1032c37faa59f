#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The objective in NumPy against the program's, the scores on counted cases, and all scripts on a small release. Usage: test.py PROGRAM"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "dataset"), str(HERE.parent / "common")]
try:
    import numpy
except ImportError:
    sys.exit(77)  # the test is skipped
import objective  # noqa: E402
import predict  # noqa: E402
import score  # noqa: E402
from csv_tables import read_rows, write_table  # noqa: E402

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())


def run(script, *words):
    return subprocess.run([sys.executable, "-B", str(script), *map(str, words)], capture_output=True, text=True, check=False)


class Counted(unittest.TestCase):
    def test_expected_evaluations_are_all_over_the_hits(self):
        self.assertEqual(score.expected_evaluations([(100, True), (50, False), (30, True)]), 90.0)
        self.assertEqual(score.expected_evaluations([(100, False)]), math.inf)

    def test_explained_is_one_for_the_truth_and_zero_for_the_mean(self):
        self.assertEqual(score.explained([(1.0, 1.0), (3.0, 3.0)]), 1.0)
        self.assertEqual(score.explained([(2.0, 1.0), (2.0, 3.0)]), 0.0)

    def test_angles_are_those_of_products_of_rotations(self):
        a, b = numpy.array([0.3, 0.0, 0.0]), numpy.array([-0.5, 0.0, 0.0])
        self.assertAlmostEqual(float(objective.angles_between(a, b)), 0.8, places=14)
        self.assertAlmostEqual(float(objective.angles_between(numpy.array([0.0, 3.0, 0.0]), numpy.array([0.0, -3.0, 0.0]))), 2.0 * math.pi - 6.0, places=13)
        quarter = math.pi / 2.0  # a quarter turn about x, then one about y: a third of a turn
        self.assertAlmostEqual(float(objective.angles_between(numpy.array([quarter, 0.0, 0.0]), numpy.array([0.0, -quarter, 0.0]))), 2.0 * math.pi / 3.0, places=13)

    def test_beam_bends_as_a_cantilever(self):
        material = {"young_modulus": 2e9, "poisson_ratio": 0.25}
        area, out, across, torsion, length = 3e-6, 5e-13, 7e-13, 9e-13, 0.02
        matrix = objective.beam_stiffness((0.0, 0.0), (0.6 * length, 0.8 * length), (area, out, across, torsion), material)
        free = numpy.linalg.inv(matrix[6:, 6:])
        along = numpy.array([0.6, 0.8, 0.0])
        beside = numpy.array([-0.8, 0.6, 0.0])
        self.assertAlmostEqual(along @ free[:3, :3] @ along, length / (2e9 * area), delta=1e-18)
        self.assertAlmostEqual(beside @ free[:3, :3] @ beside / (length**3 / (3.0 * 2e9 * across)), 1.0, places=12)
        self.assertAlmostEqual(free[2, 2] / (length**3 / (3.0 * 2e9 * out)), 1.0, places=12)
        self.assertAlmostEqual(along @ free[3:, 3:] @ along / (length / (0.8e9 * torsion)), 1.0, places=12)
        # A force along z turns the end about the axis to the right of the beam: the tip rises, so the slope is positive.
        self.assertAlmostEqual(-beside @ free[3:, 2] / (length**2 / (2.0 * 2e9 * out)), 1.0, places=12)

    def test_ridge_finds_a_linear_law_and_shrinks_with_its_penalty(self):
        generator = numpy.random.default_rng(1)
        table = generator.integers(0, 2, (60, 5)).astype(float)
        law = numpy.array([[1.0], [-2.0], [0.5], [0.0], [3.0]])
        weights, constant = predict.fit(table, table @ law + 4.0, 1e-9)
        self.assertLess(numpy.abs(weights - law).max(), 1e-7)
        self.assertAlmostEqual(float(constant[0]), 4.0, places=7)
        weights, constant = predict.fit(table, table @ law + 4.0, 1e9)
        self.assertLess(numpy.abs(weights).max(), 1e-5)
        self.assertAlmostEqual(float(constant[0]), float((table @ law + 4.0).mean()), places=5)


class Whole(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        made = run(HERE.parent / "dataset" / "make.py", PROGRAM, cls.folder / "release", "--patterns", "sample:24")
        if made.returncode != 0:
            raise RuntimeError(made.stderr)
        cls.release = objective.Release(cls.folder / "release")
        made = run(HERE / "entry.py", PROGRAM, cls.folder / "release", cls.folder / "ours.csv")
        if made.returncode != 0:
            raise RuntimeError(made.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def test_objective_is_the_programs(self):
        tables = self.folder / "release" / "tables"
        parameters = {}
        for row in read_rows(tables / "calibration_parameter.csv"):
            if row["model"] == "paper6":
                parameters.setdefault(row["pattern_id"], {})[row["name"]] = float(row["value"])
        rows = [row for row in read_rows(tables / "calibration.csv") if row["model"] == "paper6"]
        self.assertEqual(len(rows), 24)
        for row in rows:
            values = [parameters[row["pattern_id"]][name] for name in objective.PARAMETERS]
            self.assertAlmostEqual(self.release.problem(row["pattern_id"])(values) / float(row["objective"]), 1.0, places=9)

    def test_bounds_hold_the_calibrations(self):
        for row in read_rows(self.folder / "ours.csv"):
            problem = self.release.problem(row["pattern_id"])
            values = numpy.array([float(row[name]) for name in objective.PARAMETERS])
            self.assertTrue((values >= problem.lower * (1.0 - 1e-12 * numpy.sign(problem.lower))).all(), row)
            self.assertTrue((values <= problem.upper * (1.0 + 1e-12)).all(), row)

    def test_score_counts_what_the_entry_has(self):
        told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "ours.csv", "--json")
        self.assertEqual(told.returncode, 0, told.stderr)
        found = json.loads(told.stdout)[0]
        rows = read_rows(self.folder / "ours.csv")
        self.assertEqual({row["pattern_id"] for row in rows}, self.release.held_out)
        self.assertEqual(found["patterns"], len(rows))
        total = sum(int(row["evaluations"]) for row in rows)
        self.assertAlmostEqual(found["evaluations_mean"], total / len(rows), places=9)
        self.assertGreater(found["hits"], 0)
        self.assertAlmostEqual(found["expected_evaluations"], total / found["hits"], places=9)
        self.assertEqual(found["below_best_known"], 0)
        self.assertIn("| `ours` |", run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "ours.csv").stdout)

    def test_a_worse_point_is_no_hit_whatever_it_claims(self):
        rows = read_rows(self.folder / "ours.csv")
        for row in rows:
            row["A"] = repr(max(0.99 * float(row["A"]), float(self.release.tile.lower[0])))
        self.write("moved.csv", rows)
        told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "moved.csv", "--json")
        self.assertLess(json.loads(told.stdout)[0]["hits"], len(rows))

    def test_refuses_what_breaks_a_rule(self):
        def spoiled(change):
            rows = read_rows(self.folder / "ours.csv")
            change(rows)
            self.write("spoiled.csv", rows)
            told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "spoiled.csv")
            self.assertEqual((told.returncode, len(told.stderr.splitlines())), (2, 1), told.stderr)
            return told.stderr

        inside = next(name for name in self.release.places if name not in self.release.held_out)
        self.assertIn("has no row for 1 held-out", spoiled(lambda rows: rows.pop()))
        self.assertIn(":2: 'x'", spoiled(lambda rows: rows[0].update(pattern_id="x")))
        self.assertIn("not a held-out pattern", spoiled(lambda rows: rows[0].update(pattern_id=inside)))
        self.assertIn("has a row already", spoiled(lambda rows: rows.append(dict(rows[0]))))
        self.assertIn("evaluations is 0", spoiled(lambda rows: rows[0].update(evaluations="0")))
        self.assertIn("theta is 1.0, expected", spoiled(lambda rows: rows[0].update(theta="1.0")))
        self.assertIn("A is 'much', expected a number", spoiled(lambda rows: rows[0].update(A="much")))
        self.assertIn("R is nan", spoiled(lambda rows: rows[0].update(R="nan")))
        (self.folder / "spoiled.csv").write_text("pattern_id,E\n")
        told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "spoiled.csv")
        self.assertIn("expected pattern_id,evaluations,A,I2,I3,J,theta,R", told.stderr)
        told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "none.csv")
        self.assertEqual((told.returncode, len(told.stderr.splitlines())), (2, 1), told.stderr)

    def write(self, name, rows):
        write_table(self.folder / name, list(rows[0]), (row.values() for row in rows))

    def test_example_and_baselines_can_be_scored(self):
        self.assertEqual(run(HERE / "example.py", self.folder / "release", self.folder / "compass.csv", "--budget", "40").returncode, 0)
        told = run(HERE / "score.py", "calibrate", self.folder / "release", self.folder / "compass.csv", "--json")
        self.assertLessEqual(json.loads(told.stdout)[0]["evaluations_mean"], 40)
        for kind in ("none", "edges", "pairs"):
            done = run(HERE / "predict.py", self.folder / "release", self.folder / f"{kind}.csv", "--features", kind)
            self.assertEqual(done.returncode, 0, done.stderr)
        told = run(HERE / "score.py", "predict", self.folder / "release", *(self.folder / f"{kind}.csv" for kind in ("none", "edges", "pairs")), "--json")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertLessEqual(json.loads(told.stdout)[0]["bending_stiffness"]["r2"], 0.0)  # the mean of other patterns


if __name__ == "__main__":
    unittest.main()
