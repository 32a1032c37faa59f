# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames against closed forms."""

import math
import tempfile
import unittest

import numpy as np

import fretwork as fw
import support


class Frames(unittest.TestCase):
    def test_cantilever_tip_matches_pl3_over_3ei(self):
        section = fw.rectangle_section(0.01, 0.01)
        tip = fw.solve(support.cantilever(), solver="linear").displacements[1, 2]
        self.assertAlmostEqual(tip, -1 / (3 * 2e11 * section.I2), delta=1e-12)

    def test_euler_load_is_found(self):
        frame = support.cantilever(divisions=16)
        frame.loads = [fw.NodalLoad(1, [-1, 0, 0])]
        section = fw.rectangle_section(0.01, 0.01)
        euler = math.pi**2 * 2e11 * section.I2 / 4
        self.assertAlmostEqual(fw.buckling_modes(frame, 1)[0].value / euler, 1.0, delta=1e-4)

    def test_first_frequency_of_a_cantilever(self):
        # Blevins: f = 1.87510407^2 / (2 pi L^2) sqrt(E I / (rho A)).
        section = fw.rectangle_section(0.01, 0.01)
        wanted = 1.87510407**2 / (2 * math.pi) * math.sqrt(2e11 * section.I2 / (7850 * section.area))
        found = fw.vibration_modes(support.cantilever(divisions=16), 1)[0].value
        self.assertAlmostEqual(found / wanted, 1.0, delta=1e-3)

    def test_nonlinear_pure_bending_rolls_into_a_circle(self):
        # A moment 2 pi E I / L bends a bar into a full circle: its tip returns to its root.
        frame = support.cantilever(divisions=40)
        section = fw.rectangle_section(0.01, 0.01)
        frame.loads = [fw.NodalLoad(1, moment=[0, -2 * math.pi * 2e11 * section.I2, 0])]
        result = fw.solve(frame)
        self.assertTrue(result.converged)
        np.testing.assert_allclose(result.displacements[1, :3], [-1, 0, 0], atol=5e-3)

    def test_condensed_stiffness_is_symmetric_and_has_six_rigid_motions(self):
        stiffness = fw.condense(support.cantilever(), 2)
        np.testing.assert_allclose(stiffness, stiffness.T, rtol=0, atol=1e-6)
        self.assertEqual(np.linalg.matrix_rank(stiffness, tol=1e-6 * np.abs(stiffness).max()), 6)

    def test_files_give_back_an_equal_frame(self):
        frame = support.cantilever()
        with tempfile.TemporaryDirectory() as folder:
            fw.write_frame(frame, folder + "/frame.json")
            self.assertEqual(fw.read_frame(folder + "/frame.json"), frame)

    def test_a_result_goes_through_its_file(self):
        result = fw.solve(support.cantilever(), solver="linear")
        again = fw.parse_result(fw.result_text(result))
        np.testing.assert_array_equal(again.displacements, result.displacements)

    def test_paths_have_a_solution_for_each_factor(self):
        path = fw.follow_load_path(support.cantilever(), [0.5, 1.0])
        self.assertEqual([one.load_factor for one in path], [0.5, 1.0])


if __name__ == "__main__":
    unittest.main()
