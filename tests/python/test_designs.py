# SPDX-License-Identifier: GPL-3.0-or-later
"""Paintings for a wanted shape: a planted one is approached, a stopped search keeps its best."""

import os
import signal
import unittest

import fretwork as fw
import support

PALETTE = [support.PATTERN, support.OTHER]


def strip():
    """A strip of a few tiles that has a load case."""
    outline = fw.make_outline([[0, 0], [0.15, 0], [0.15, 0.06], [0, 0.06]])
    project, _ = fw.make_project(outline, patterns=support.PATTERN, edge_length=0.02)
    project.load_cases = [support.tip(-0.002)]
    return project


def planted():
    """A project, and the target that a painting with both patterns reaches, full and nonlinear."""
    project = strip()
    tiles = len(project.tessellation)
    surface = fw.make_surface(project)
    session = fw.Session(surface, project.load_cases[0], model="full")
    session.paint(list(range(0, tiles, 2)), support.OTHER)
    rows = session.solve().displacements
    nodes = list(range(len(surface.tessellation.interface_nodes)))
    goal = fw.NodesGoal(nodes, [list(row[:3]) for row in rows[: len(nodes)]])
    return project, fw.Target("planted", goals=[fw.Goal(goal)])


class Targets(unittest.TestCase):
    def test_free_components_and_numbers(self):
        goal = fw.FormulaGoal(fw.NodesAtSide("right"), ["0.1*x", None, 0.02])
        self.assertEqual(goal.displacement, ("0.1*x", None, "0.02"))
        target = fw.Target("lifted", goals=[fw.Goal(goal, weight=2.0)])
        self.assertEqual(fw.parse_target(fw.target_text(target)), target)

    def test_what_is_wrong_is_named(self):
        with self.assertRaises(TypeError):
            fw.FormulaGoal(fw.NodesAtSide("right"), [1, 2])
        with self.assertRaisesRegex(fw.InputError, "is not a symmetry"):
            fw.DesignOptions(symmetry="diagonal")
        project, target = planted()
        with self.assertRaisesRegex(fw.InputError, "no tile"):
            fw.design(project, target, PALETTE, keep=[1000])
        with self.assertRaisesRegex(TypeError, "most_solutions"):
            fw.design(project, target, PALETTE, most_solution=3)


class Designs(unittest.TestCase):
    def test_a_planted_painting_is_approached(self):
        project, target = planted()
        told = []
        report = fw.design(project, target, PALETTE, most_solutions=30, on_better=told.append)
        self.assertTrue(report.is_better)
        self.assertLess(report.error.mean, 0.5 * report.best_uniform.mean)
        self.assertEqual(len(told), len(report.history))
        self.assertEqual(sorted(report.patterns), sorted(PALETTE))
        self.assertEqual(len(report.project.tessellation), len(project.tessellation))

    def test_kept_tiles_keep_their_patterns(self):
        project, target = planted()
        report = fw.design(project, target, PALETTE, most_solutions=6, keep=[0, 1])
        for tile in (0, 1):
            self.assertEqual(report.project.tessellation.pattern_of(tile), project.tessellation.pattern_of(tile))

    def test_ctrl_c_keeps_the_best_painting(self):
        project, target = planted()

        def interrupt(_):
            os.kill(os.getpid(), signal.SIGINT)

        report = fw.design(project, target, PALETTE, on_better=interrupt)
        self.assertEqual(report.end, "stopped")
        self.assertEqual(len(report.project.tessellation), len(project.tessellation))

    def test_an_exception_of_the_listener_is_raised(self):
        project, target = planted()

        def fail(_):
            raise ValueError("enough")

        with self.assertRaisesRegex(ValueError, "enough"):
            fw.design(project, target, PALETTE, on_better=fail)


if __name__ == "__main__":
    unittest.main()
