# SPDX-License-Identifier: GPL-3.0-or-later
"""The manners of values: constructors, comparison, text, pickling, views."""

import copy
import enum
import gc
import inspect
import pickle
import unittest

import numpy as np

import fretwork as fw
import support


def values():
    """A value of each class that can be made from nothing."""
    for name, kind in vars(fw).items():
        if inspect.isclass(kind) and hasattr(kind, "_setters") and kind.__init__.__name__ == "init":
            yield name, kind()


class Values(unittest.TestCase):
    def test_each_equals_its_pickle_and_its_copy(self):
        count = 0
        for name, value in values():
            with self.subTest(name):
                self.assertEqual(pickle.loads(pickle.dumps(value)), value)
                self.assertEqual(copy.deepcopy(value), value)
                self.assertIn(name, repr(value))
                count += 1
        self.assertGreater(count, 50)

    def test_each_field_is_a_keyword(self):
        for name, value in values():
            with self.subTest(name):
                fields = {field: getattr(value, field) for field in value._fields}
                self.assertEqual(type(value)(**fields), value)

    def test_a_change_makes_a_difference(self):
        self.assertNotEqual(fw.Material(young_modulus=1), fw.Material(young_modulus=2))
        self.assertNotEqual(fw.Material(), fw.Section())

    def test_members_are_references_and_lists_are_tuples(self):
        setting = fw.paper_setting()
        material = setting.material
        del setting
        material.young_modulus = 3.0
        self.assertEqual(material.young_modulus, 3.0)
        case = support.tip()
        self.assertIsInstance(case.loads, tuple)
        case.loads += (case.loads[0],)
        self.assertEqual(len(case.loads), 2)

    def test_vectors_write_through(self):
        case = support.tip()
        case.gravity[2] = -9.81
        self.assertEqual(list(case.gravity), [0, 0, -9.81])

    def test_tessellations_and_results_have_no_constructor(self):
        for kind in (fw.Tile, fw.Tessellation, fw.Result, fw.Project, fw.Outline):
            with self.assertRaises(TypeError):
                kind()

    def test_large_values_survive_pickling(self):
        project = support.project()
        self.assertEqual(pickle.loads(pickle.dumps(project)), project)
        result = fw.simulate(support.surface(), support.tip(), model="corotational")
        again = pickle.loads(pickle.dumps(result))
        np.testing.assert_array_equal(again.displacements, result.displacements)
        self.assertEqual(again.subject, result.subject)


class Views(unittest.TestCase):
    def test_a_view_outlives_its_result(self):
        result = fw.solve(support.cantilever(), solver="linear")
        before = result.displacements.copy()
        view = result.displacements
        del result
        filler = [np.ones((2, 6)) for _ in range(1000)]
        np.testing.assert_array_equal(view, before)
        del filler

    def test_views_of_results_are_read_only_and_no_copies(self):
        result = fw.solve(support.cantilever(), solver="linear")
        first, second = result.displacements, result.displacements
        self.assertEqual(first.__array_interface__["data"][0], second.__array_interface__["data"][0])
        with self.assertRaises(ValueError):
            first[0, 0] = 1.0

    def test_copies_of_rows_keep_their_texts(self):
        for row, name in [(fw.filter_catalogue()[0], "summary"), (fw.writer_catalogue()[0], "description")]:
            text = getattr(row, name)
            for again in (copy.copy(row), copy.deepcopy(row), pickle.loads(pickle.dumps(row))):
                gc.collect()
                _ = [str(number) * 9 for number in range(10000)]  # takes the place of what was given back
                self.assertEqual(getattr(again, name), text)


class Enums(unittest.TestCase):
    def test_members_are_words(self):
        self.assertEqual(fw.Branch.STABLE, "stable")
        self.assertEqual(fw.EquilibriumOptions(branch="stable").branch, fw.Branch.STABLE)

    def test_words_are_those_of_the_framework(self):
        self.assertEqual([str(word) for word in fw.Branch], fw.branch_names())
        self.assertEqual([str(word) for word in fw.Solver], fw.solver_names())

    def test_an_unknown_word_names_the_nearest(self):
        with self.assertRaisesRegex(fw.InputError, "did you mean 'stable'"):
            fw.EquilibriumOptions(branch="stabel")

    def test_all_survive_pickling(self):
        for kind in vars(fw).values():
            if inspect.isclass(kind) and issubclass(kind, enum.Enum):
                for member in kind:
                    self.assertIs(pickle.loads(pickle.dumps(member)), member)


if __name__ == "__main__":
    unittest.main()
