# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user brings along: filters, layouts, tile models, optimizers. All of it works as what is built in."""

import tempfile
import unittest

import numpy as np

import fretwork as fw
import support


def condensed(tile):
    return fw.condensed_frame(tile.frame(), tile.interface_nodes)


def dice(evaluator, options):
    random = np.random.default_rng(options.seed)
    bounds = evaluator.bounds
    while evaluator.value(random.uniform(bounds.lower, bounds.upper)) is not None:
        pass
    return fw.RunOutcome("budget-spent")


class OwnFilters(unittest.TestCase):
    def test_keeps_what_it_is_written_to_keep(self):
        layout = fw.paper_layout()
        even = fw.Filter("odd", lambda pattern: len(pattern) % 2 == 0, "has an odd number of beams")
        found = fw.enumerate_patterns(layout, filters=fw.FilterSettings(own=[even]))
        self.assertEqual(found, [one for one in fw.enumerate_patterns(layout) if len(one) % 2 == 0])

    def test_its_exception_comes_out_as_it_is(self):
        def broken(pattern):
            raise KeyError("mine")

        settings = fw.FilterSettings(own=[fw.Filter("broken", broken)])
        with self.assertRaisesRegex(KeyError, "mine"):
            fw.enumerate_patterns(fw.paper_layout(), filters=settings)

    def test_two_of_one_name_are_refused(self):
        twice = [fw.Filter("same", lambda pattern: True)] * 2
        with self.assertRaisesRegex(fw.InputError, "same"):
            fw.count_patterns(fw.paper_layout(), filters=fw.FilterSettings(own=twice))


class OwnLayouts(unittest.TestCase):
    def test_is_enumerated_and_survives_its_file(self):
        own = fw.NodeLayout("own", radial=["1/3", "2/3"], interface=["1/2"])
        self.assertGreater(len(fw.enumerate_patterns(own)), 0)
        self.assertEqual(fw.parse_node_layout(fw.node_layout_text(own)), own)

    def test_is_tiled_and_simulated(self):
        own = fw.NodeLayout("own", radial=["1/2"], face=[["1/3", "1/3", "1/3"]], interface=["1/2"])
        pattern = fw.pattern_id(own, fw.enumerate_patterns(own)[0])
        square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])
        project, _ = fw.make_project(square, patterns=pattern, own_layout=own, edge_length=0.03)
        self.assertEqual(project.layout, own)
        self.assertTrue(fw.simulate(fw.make_surface(project), support.tip(-1e-4), model="corotational").converged)


class OwnTileModels(unittest.TestCase):
    def test_the_condensed_tile_in_python_is_that_of_the_framework(self):
        own = fw.TileModel("mine", condensed)
        mine = fw.simulate(support.surface(), support.tip(), model="mine", models=[own])
        theirs = fw.simulate(support.surface(), support.tip(), model="condensed")
        scale = np.abs(theirs.displacements).max()
        np.testing.assert_allclose(mine.displacements, theirs.displacements, rtol=0, atol=1e-9 * scale)

    def test_is_compared_and_exported(self):
        own = fw.TileModel("mine", condensed)
        surface = support.surface()
        full = fw.simulate(surface, support.tip(), analysis="linear")
        mine = fw.simulate(surface, support.tip(), model="mine", models=[own])
        self.assertLess(fw.compare(full, mine).relative_l2_error, 1e-6)
        self.assertIn(b"VTKFile", fw.export_content(surface, ".vtu", mine, models=[own]))

    def test_its_beams_are_written_as_a_frame(self):
        own = fw.TileModel("mine", lambda tile: fw.beam_tile(tile.frame(), tile.interface_nodes, "of-the-pattern"))
        surface = support.surface()
        for _ in range(5):  # its tiles are built by several threads, which wait for one another
            mine = fw.surface_frame(surface, support.tip(), model="mine", models=[own])
        self.assertEqual(len(mine.beams), len(fw.surface_frame(surface, support.tip()).beams))

    def test_a_stiffness_of_the_wrong_size_is_refused(self):
        wrong = fw.TileModel("wrong", lambda tile: np.eye(3))
        with self.assertRaisesRegex(fw.InputError, "not 3 x 3"):
            fw.simulate(support.surface(), support.tip(), model="wrong", models=[wrong])

    def test_a_stiffness_that_resists_rigid_motions_is_refused(self):
        wrong = fw.TileModel("wrong", lambda tile: np.eye(6 * tile.interface_nodes))
        with self.assertRaises(fw.InputError):
            fw.simulate(support.surface(), support.tip(), model="wrong", models=[wrong])

    def test_a_parameter_is_calibrated(self):
        def scaled(tile):
            return tile.parameters[0] * condensed(tile)

        factor = fw.TileParameter("factor", (0.1, 10.0), "logarithmic")
        own = fw.TileModel("scaled", scaled, parameters=[factor], sharing="congruent")
        layout, setting = fw.paper_layout(), fw.paper_setting()
        setting.magnitudes = 2
        pattern = fw.parse_pattern_id(layout, support.PATTERN)
        responses = fw.linear_responses(fw.model_displacements("condensed", layout, pattern, setting), setting)
        found = fw.calibrate(own, layout, pattern, setting, responses, starts=2)
        self.assertAlmostEqual(found.parameters["factor"], 1.0, delta=1e-3)

    def test_an_input_may_be_kept(self):
        kept = []

        def keep(tile):
            kept.append(tile)
            return condensed(tile)

        fw.simulate(support.surface(), support.tip(), model="keep", models=[fw.TileModel("keep", keep)])
        self.assertEqual(kept[0].layout, fw.paper_layout())
        self.assertEqual(kept[-1].polygon.shape[1], 2)


class OwnOptimizers(unittest.TestCase):
    def setUp(self):
        self.bowl = fw.Problem("bowl", [-1, -1], [2, 2], value=lambda x: float(x @ x))

    def test_spends_its_budget_and_no_more(self):
        report = fw.minimize(self.bowl, fw.OptimizerRow("dice", dice), cost=300)
        self.assertEqual((report.cost, report.ending), (300, "budget-spent"))

    def test_the_same_seed_gives_the_same_trace(self):
        method = fw.OptimizerRow("dice", dice)
        first, second = (fw.minimize(self.bowl, method, cost=100, seed=4).trace for _ in range(2))
        self.assertEqual(first, second)

    def test_calibrates_a_library(self):
        layout = fw.paper_layout()
        pattern = fw.parse_pattern_id(layout, support.PATTERN)
        with tempfile.TemporaryDirectory() as folder:
            library = fw.Library.create(folder + "/own.db", layout, fw.paper_setting())
            library.add_patterns([pattern])
            options = fw.CalibrationOptions(optimizer="dice", budget=200)
            report = library.fill(calibration=options, optimizers=[fw.OptimizerRow("dice", dice)])
            self.assertEqual((report.done, report.failed), (1, 0))
            self.assertEqual(library.calibrations(support.PATTERN)[0].key.optimizer, "dice")
            library.close()

    def test_a_study_does_not_mix_two_commands(self):
        program = "head -n 5 >/dev/null; echo value 0 0; read answer; echo done"
        method, other = (fw.outside_command_row("mine", command) for command in (program, "true; " + program))
        self.assertEqual((method.name, method.command), ("mine", program))
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(fw.run_study(folder, ["analytic/beale"], [(method, 1)], repetitions=1).runs_done, 1)
            self.assertEqual(fw.run_study(folder, ["analytic/beale"], [(method, 1)], repetitions=1).runs_before, 1)
            with self.assertRaisesRegex(fw.InputError, "another command"):
                fw.run_study(folder, ["analytic/beale"], [(other, 1)], repetitions=1)

    def test_an_evaluator_that_is_kept_says_that_the_run_is_over(self):
        kept = []
        fw.minimize(self.bowl, fw.OptimizerRow("keep", lambda evaluator, options: kept.append(evaluator)), cost=5)
        with self.assertRaisesRegex(fw.Error, "over"):
            kept[0].value([0, 0])

    def test_a_point_of_the_wrong_size_is_refused(self):
        def wrong(evaluator, options):
            evaluator.value([1.0])

        with self.assertRaisesRegex(fw.InputError, "2 are wanted"):
            fw.minimize(self.bowl, fw.OptimizerRow("wrong", wrong), cost=5)

    def test_a_library_method_sees_derivatives_of_a_python_problem(self):
        def residuals(x):
            return np.array([10 * (x[1] - x[0] ** 2), 1 - x[0]]), np.array([[-20 * x[0], 10], [-1, 0]])

        rosenbrock = fw.Problem("rosenbrock", [-2, -2], [2, 2], residuals=residuals,
                                value=lambda x: float(np.sum(residuals(x)[0] ** 2)))
        self.assertLess(fw.minimize(rosenbrock, "ceres-residuals").value, 1e-8)

    def test_a_calibration_is_a_problem_for_others(self):
        layout, setting = fw.paper_layout(), fw.paper_setting()
        pattern = fw.parse_pattern_id(layout, support.PATTERN)
        responses = fw.compute_responses(layout, pattern, setting)
        problem, parameters = fw.calibration_problem("paper6", layout, pattern, setting, responses)
        found = fw.calibrate("paper6", layout, pattern, setting, responses)
        report = fw.minimize(problem, "ceres-multistart", starts=8)
        self.assertAlmostEqual(report.value, found.objective, delta=1e-9 * found.objective)
        self.assertEqual(sorted(parameters(report.point)), sorted(found.parameters))


if __name__ == "__main__":
    unittest.main()
