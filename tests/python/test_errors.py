# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors are data, and classes that Python people expect."""

import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import fretwork as fw
import support


class Errors(unittest.TestCase):
    def test_an_input_error_says_source_and_place(self):
        with self.assertRaises(fw.InputError) as caught:
            fw.parse_load_case('{"format": "fretwork/load-case/3", "name": 3}', "my.json")
        error = caught.exception
        self.assertEqual((error.source, error.place), ("my.json", "/name"))
        self.assertEqual(error.kind, fw.ErrorKind.OTHER)
        self.assertIn(error.problem, str(error))
        self.assertIsInstance(error, ValueError)

    def test_a_floating_frame_says_so_by_its_kind(self):
        frame = support.cantilever()
        frame.supports = []
        with self.assertRaises(fw.Error) as caught:
            fw.solve(frame)
        self.assertEqual(caught.exception.kind, fw.ErrorKind.NOTHING_HELD)

    def test_a_mechanism_is_a_numerical_error(self):
        frame = support.cantilever()
        frame.supports = [fw.Support(0, "translations")]
        with self.assertRaises(fw.Error) as caught:
            fw.solve(frame, solver="linear")
        self.assertIsInstance(caught.exception, (ArithmeticError, ValueError))

    def test_a_missing_folder_is_an_io_error(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(fw.IoError) as caught:
                fw.write_frame(support.cantilever(), pathlib.Path(folder) / "no" / "frame.json")
            self.assertIsInstance(caught.exception, OSError)

    def test_a_bad_outline_is_a_geometry_error(self):
        with self.assertRaises(fw.GeometryError):
            fw.make_outline([[0, 0], [1, 1], [1, 0], [0, 1]])

    def test_errors_survive_pickling(self):
        try:
            fw.find_node_layout("papr7")
        except fw.InputError as error:
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((str(again), again.problem), (str(error), error.problem))

    def test_an_unknown_keyword_names_the_nearest(self):
        with self.assertRaisesRegex(TypeError, "did you mean 'threads'"):
            fw.enumerate_patterns(fw.paper_layout(), thread=1)

    def test_a_wrong_type_names_field_and_value(self):
        with self.assertRaisesRegex(TypeError, "threads takes int, and not 'many'"):
            fw.enumerate_patterns(fw.paper_layout(), threads="many")

    def test_a_keyword_of_another_type_is_a_type_error(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(TypeError, "another type than the docstring says"):
                fw.export(support.surface(), pathlib.Path(folder) / "x.svg", labels=3)

    def test_what_a_passed_function_answers_has_a_type(self):
        fickle = fw.Filter("fickle", lambda pattern: "perhaps")
        with self.assertRaisesRegex(TypeError, "another type than the docstring says"):
            fw.judge(fw.paper_layout(), [fickle], fw.Pattern([0]))

    def test_none_is_no_function(self):
        with self.assertRaisesRegex(TypeError, "a function is needed"):
            fw.judge(fw.paper_layout(), [fw.Filter("none", None)], fw.Pattern([0]))

    def test_bytes_that_are_no_text_are_shown_by_their_numbers(self):
        with tempfile.TemporaryDirectory() as folder:
            strange = pathlib.Path(folder) / "strange\n.json"
            strange.write_bytes(b'{"format": "fretwork/frame/1", "\xb0": 1}')
            with self.assertRaises(fw.InputError) as caught:
                fw.read_frame(strange)
        for text in (str(caught.exception), caught.exception.source):
            self.assertNotIn("\n", text)
            self.assertIn("strange\\x0a.json", text)

    def test_a_source_may_have_any_character(self):
        with self.assertRaises(fw.InputError) as caught:
            fw.parse_frame("{}", "\0")
        self.assertRegex(str(caught.exception), r"^\\x00: ")

    def test_displacements_of_too_few_interface_nodes_are_refused(self):
        setting = fw.paper_setting()
        fits = [np.zeros((6, 6))] * 5
        self.assertEqual(fw.linear_responses(fits, setting)[0].samples[0].displacements.shape, (6, 6))
        for model in ([np.zeros((1, 6))] * 5, fits[:4] + [np.zeros((12, 6))]):
            with self.assertRaisesRegex(fw.InputError, "the same multiple of 6 rows"):
                fw.linear_responses(model, setting)

    def test_places_that_are_no_numbers_are_refused(self):
        tessellation = support.surface().tessellation
        for bad in (float("nan"), float("inf")):
            with self.assertRaisesRegex(fw.InputError, "point 0 is"):
                fw.select_nodes(fw.NodesNearest([[bad, 0]]), tessellation)
            with self.assertRaisesRegex(fw.InputError, "the clearance is"):
                fw.close_bars(support.surface(), bad)
        with self.assertRaisesRegex(fw.GeometryError, "point 1 of the boundary"):
            fw.make_outline([[0, 0], [1e308, 0], [1e308, 1e308]])

    def test_a_line_load_between_places_that_are_no_numbers_is_refused(self):
        case = support.tip()
        for bad in (float("nan"), float("inf")):
            ends = fw.NodesNearest([[0, 0], [bad, 0]])
            case.loads = [fw.LoadCase.Load(ends, force=[0, 0, -1], amount="per-length")]
            with self.assertRaisesRegex(fw.InputError, "/loads/0: point 1 is"):
                fw.simulate(support.surface(), case)

    def test_too_many_modes_are_refused(self):
        for kind in ("vibration", "buckling"):
            with self.assertRaisesRegex(fw.InputError, "where 1 to 1000 are possible"):
                fw.surface_modes(support.surface(), support.tip(), kind, 10**9)

    def test_huge_counts_are_refused_at_once(self):
        layout, scenario, huge = fw.paper_layout(), fw.paper_scenarios()[0], 2**31 - 1
        star = fw.parse_pattern_id(layout, support.PATTERN)
        for make in (lambda: fw.make_fan(layout, star, huge), lambda: fw.regular_polygon(huge, 1.0),
                     lambda: fw.spread_over_sides(scenario, huge),
                     lambda: fw.random_painting(2**60, [fw.WeightedPattern()], 1)):
            with self.assertRaises(fw.InputError):
                make()

    def test_no_outlines_have_no_size(self):
        with self.assertRaisesRegex(fw.InputError, "no outline"):
            fw.size_text([])

    def test_a_pattern_of_another_layout_is_refused(self):
        other = fw.find_node_layout("fifths12")
        beyond = fw.Pattern([len(other.candidate_edges) - 1])
        with self.assertRaisesRegex(fw.InputError, "another layout"):
            fw.pattern_id(fw.paper_layout(), beyond)


if __name__ == "__main__":
    unittest.main()
