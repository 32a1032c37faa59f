# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are solved, edited, compared; what lives how long; threads."""

import copy
import gc
import tempfile
import threading
import unittest

import numpy as np

import fretwork as fw
import support


class Selections(unittest.TestCase):
    def test_a_circle_selects_what_lies_in_it(self):
        tessellation = support.surface().tessellation
        nodes = np.asarray(tessellation.interface_nodes)
        center, radius = nodes.mean(axis=0), 0.6 * np.ptp(nodes, axis=0).min()
        inside = np.flatnonzero(((nodes - center) ** 2).sum(axis=1) <= radius ** 2)
        self.assertGreater(len(inside), 0)
        self.assertEqual(list(fw.select_nodes(fw.NodesInCircle(center, radius), tessellation)), list(inside))
        middles = np.asarray(tessellation.tile_centers)
        tiles = np.flatnonzero(((middles - center) ** 2).sum(axis=1) <= radius ** 2)
        self.assertEqual(list(fw.tiles_in(fw.Circle(center, radius), tessellation)), list(tiles))

    def test_a_circle_is_written_and_read(self):
        case = fw.LoadCase(name="push", supports=[fw.LoadCase.Support(fw.NodesInCircle([0.1, 0.2], 0.05), "uz")])
        self.assertEqual(fw.parse_load_case(fw.load_case_text(case)), case)
        self.assertEqual(case.supports[0].where.radius, 0.05)

    def test_a_radius_has_to_be_above_zero(self):
        for radius in (0, -1, float("nan"), float("inf")):
            with self.assertRaisesRegex(fw.InputError, "above 0 m"):
                fw.select_nodes(fw.NodesInCircle([0, 0], radius), support.surface().tessellation)


class Sessions(unittest.TestCase):
    def test_outlive_their_surface(self):
        surface = support.surface()
        session = fw.Session(surface, support.tip(), model="corotational")
        del surface
        gc.collect()
        self.assertTrue(session.solve().converged)

    def test_answer_as_a_simulation_from_nothing(self):
        session = fw.Session(support.surface(), support.tip(), model="condensed")
        session.solve()
        session.paint([0, 5], support.OTHER)
        again = fw.simulate(session.surface, support.tip(), model="condensed")
        scale = again.largest_displacement
        np.testing.assert_allclose(session.solve().displacements, again.displacements, rtol=0, atol=1e-9 * scale)

    def test_the_subject_of_a_mixed_result_has_its_full_tiles(self):
        session = fw.Session(support.surface(), support.tip(), model="mixed:0.25")
        result = session.solve(subject=True)
        self.assertGreater(len(result.subject.full_tiles), 0)
        self.assertEqual(list(result.subject.full_tiles), list(session.full_tiles))
        self.assertEqual(fw.beam_table(support.surface(), result).unknown, 0)

    def test_a_change_of_load_keeps_the_factors(self):
        session = fw.Session(support.surface(), support.tip(), model="condensed")
        one = session.solve().displacements
        session.set_load_case(support.tip(-0.002))
        two = session.solve().displacements
        self.assertEqual(session.last_report.factors, fw.FactorChange.KEPT)
        np.testing.assert_allclose(two, 2 * one, rtol=0, atol=1e-9 * np.abs(two).max())

    def test_an_edit_that_raises_changes_nothing(self):
        session = fw.Session(support.surface(), support.tip(), model="condensed")
        before = session.solve().displacements.copy()
        for tiles, pattern in (([10**6], support.PATTERN), ([-1], support.PATTERN), ([0], "0-1+9-9")):
            with self.assertRaises(fw.InputError):
                session.paint(tiles, pattern)
        np.testing.assert_array_equal(session.solve().displacements, before)

    def test_adjoint_is_the_inverse_of_the_stiffness(self):
        # Maxwell and Betti: the displacement at a under a unit force at b is that at b under one at a.
        session = fw.Session(support.surface(), support.tip(), model="condensed")
        displacements = session.solve().displacements
        a, b = (6 * node + 2 for node in np.argsort(displacements[:, 2])[[0, 20]])  # that move
        unit = np.zeros((displacements.size, 2))
        unit[a, 0] = unit[b, 1] = 1.0
        moved = session.solve_adjoint(unit)
        self.assertNotEqual(moved[b, 0], 0.0)
        self.assertAlmostEqual(moved[b, 0] / moved[a, 1], 1.0, delta=1e-9)

    def test_stress_is_refined_until_its_place_is_in_full(self):
        session = fw.Session(support.surface(), support.tip(-0.002), model="corotational")
        before = session.solve()
        refined = fw.refine_stress(session)
        self.assertTrue(refined.is_settled)
        worst = fw.most_stressed(refined.table, 1)[0]
        self.assertIn(worst.tile, refined.full_tiles)
        self.assertLess(np.abs(refined.result.displacements[: len(before.displacements)] - before.displacements).max(),
                        0.05 * before.largest_displacement)
        again = fw.refine_stress(session, refined.full_tiles)  # the session has kept these tiles
        self.assertEqual((again.solutions, again.full_tiles), (1, refined.full_tiles))
        session.tile_deformations(again.result)  # of the session's last solution

    def test_different_sessions_may_be_solved_at_once(self):
        sessions = [fw.Session(support.surface(), support.tip(), model="corotational") for _ in range(4)]
        results = [None] * 4

        def solve(place):
            results[place] = sessions[place].solve().displacements.copy()

        threads = [threading.Thread(target=solve, args=(place,)) for place in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for other in results[1:]:
            np.testing.assert_array_equal(other, results[0])

    def test_a_session_in_use_says_so(self):
        session = fw.Session(support.surface(), support.tip(), model="full")
        said = []

        def meddle(*_):
            try:
                session.solve()
            except fw.Error as error:
                said.append(str(error))

        session.solve(progress=meddle)
        self.assertTrue(said)
        self.assertIn("in use", said[0])

    def test_results_of_another_state_are_refused(self):
        session = fw.Session(support.surface(), support.tip(), model="corotational")
        other = fw.simulate(support.surface(), support.tip(), model="full")
        session.solve()
        with self.assertRaises(fw.InputError):
            session.tile_deformations(other)

    def test_results_of_before_an_edit_of_tiles_are_refused(self):
        other = copy.copy(support.surface().setting)
        other.material.young_modulus *= 2.0
        edits = (lambda of: of.paint([3], support.OTHER), lambda of: of.turn([3], 1),
                 lambda of: of.set_tile_model([3], "full"), lambda of: of.set_model("condensed"),
                 lambda of: of.set_setting(other), lambda of: of.set_calibrations([[] for _ in of.surface.calibrations]))
        uses = (fw.smooth_stress, lambda of, result: fw.smooth_stress_along(of, result, lambda t: other, 1e-3),
                fw.Session.energy_gradient, fw.Session.tile_deformations)
        for edit in edits:
            session = fw.Session(support.surface(), support.tip(), model="corotational")
            result = session.solve()
            edit(session)
            for use in uses:
                with self.assertRaises(fw.InputError):
                    use(session, result)
            result = session.solve()
            session.set_load_case(support.tip(-0.002))  # which leaves the tiles as they are
            self.assertEqual(len(session.tile_deformations(result)), len(session.surface.tessellation))

    def test_results_of_before_an_edit_of_tiles_are_refused_after_a_new_solve(self):
        session = fw.Session(support.surface(), support.tip(), model="corotational")
        result = session.solve()
        session.paint([3], support.OTHER)
        session.solve()
        for use in (fw.smooth_stress, fw.Session.energy_gradient, fw.Session.tile_deformations):
            with self.assertRaises(fw.InputError):
                use(session, result)


class Comparisons(unittest.TestCase):
    def test_corotational_tiles_are_near_the_full_model(self):
        full = fw.simulate(support.surface(), support.tip())
        reduced = fw.simulate(support.surface(), support.tip(), model="corotational")
        self.assertLess(fw.compare(full, reduced).relative_l2_error, 1e-2)

    def test_results_of_different_load_cases_are_refused(self):
        full = fw.simulate(support.surface(), support.tip())
        other = fw.simulate(support.surface(), support.tip(-0.002), model="corotational")
        with self.assertRaisesRegex(fw.InputError, "load case"):
            fw.compare(full, other)

    def test_a_result_goes_through_its_file(self):
        result = fw.simulate(support.surface(), support.tip(), model="corotational")
        with tempfile.TemporaryDirectory() as folder:
            fw.write_surface_result(result, folder + "/result.json")
            again = fw.read_surface_result(folder + "/result.json")
        np.testing.assert_array_equal(again.displacements, result.displacements)

    def test_beam_state_has_two_rows_a_beam(self):
        surface = support.surface()
        result = fw.simulate(surface, support.tip())
        state = fw.beam_state(surface, result)
        self.assertEqual(state.forces.shape, (2 * len(fw.surface_beams(surface).ends), 8))
        largest = fw.most_stressed(fw.beam_table(surface, result), 1)[0].largest_von_mises
        self.assertAlmostEqual(np.nanmax(state.forces[:, 7]) / largest, 1.0, delta=1e-12)


class Projects(unittest.TestCase):
    def test_go_through_their_files(self):
        project = support.project()
        self.assertEqual(fw.parse_project(fw.project_text(project)).tessellation, project.tessellation)

    def test_are_painted_as_the_command_line_paints(self):
        square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])
        palette = [support.PATTERN, support.OTHER]
        first, _ = fw.make_project(square, "random:7", palette=palette, edge_length=0.025)
        second, _ = fw.make_project(square, fw.PaintAtRandom(7, fw.PaletteChoice(palette)), edge_length=0.025)
        self.assertEqual(first.tessellation, second.tessellation)

    def test_a_wrong_painting_is_refused(self):
        project = fw.parse_project(fw.project_text(support.project()))
        with self.assertRaises(fw.InputError):
            project.paint("0-1")
        with self.assertRaises(IndexError):
            project.turn([10**6], 1)


class Retiling(unittest.TestCase):
    def loaded(self):
        """Held by side, and at two nodes by number."""
        project = fw.parse_project(fw.project_text(support.project()))
        case = support.tip()
        case.supports += (fw.LoadCase.Support(fw.NodesById([0, 1]), "all"),)
        project.load_cases = [case]
        return project

    def test_keeps_what_has_a_place_and_counts_what_has_none(self):
        before = self.loaded()
        made = fw.retile(before, edge_length=0.015)
        tiles = made.project.tessellation
        self.assertGreater(len(tiles), 2 * len(before.tessellation))
        self.assertEqual(made.report.tiles, len(tiles))
        self.assertEqual({tile.pattern for tile in tiles.tiles}, {0})
        self.assertEqual((made.dropped.supports, made.dropped.loads, made.dropped.prescribed), (1, 0, 0))
        self.assertEqual(made.project.load_cases, (support.tip(),))
        old, new = before.tessellation.tile_centers, tiles.tile_centers
        nearest = np.argmin(np.linalg.norm(new[:, None] - old[None], axis=2), axis=1)
        self.assertEqual(list(made.from_tiles), list(nearest), "of two that are equally near, the smaller number")
        self.assertEqual(len(before.load_cases[0].supports), 2, "the project is not changed")
        self.assertTrue(fw.simulate(fw.make_surface(made.project), support.tip(), model="condensed").converged)

    def test_paints_as_projects_are_painted(self):
        def ids(project):
            return [project.tessellation.patterns[tile.pattern].id for tile in project.tessellation.tiles]

        palette = [support.PATTERN, support.OTHER]
        made = fw.retile(self.loaded(), "random:7", palette=palette, edge_length=0.02).project
        painted = fw.retile(self.loaded(), edge_length=0.02).project
        painted.paint("random:7", palette=palette)
        self.assertEqual(ids(made), ids(painted))

    def test_a_field_paints_again_what_it_has_painted(self):
        palette = [support.PATTERN, support.OTHER]
        project = self.loaded()
        self.assertEqual(project.recipes, ())
        project.paint("field:u", palette=palette)
        (recipe,) = project.recipes
        self.assertEqual(recipe.choice, fw.PaintByField(fw.FieldExpression("u"), fw.PaletteChoice(ids=palette)))
        self.assertEqual(list(recipe.tiles), list(range(len(project.tessellation))))
        again = fw.retile(fw.parse_project(fw.project_text(project)), edge_length=0.015).project
        said = fw.retile(project, "field:u", palette=palette, edge_length=0.015).project
        self.assertEqual(fw.project_text(again), fw.project_text(said))
        self.assertEqual({tile.pattern for tile in again.tessellation.tiles}, {0, 1})

    def test_tiles_that_are_painted_in_another_way_leave_their_recipe(self):
        project = self.loaded()
        project.paint("random:1", palette=[support.PATTERN, "0-1+3-6"])  # which have mirror images
        project.paint(support.PATTERN, tiles=[0, 2])
        self.assertEqual(list(project.recipes[0].tiles[:2]), [1, 3])
        project.mirror([1])
        self.assertEqual(project.recipes[0].tiles[0], 3)
        project.end_recipes()
        self.assertEqual(project.recipes, ())

    def test_an_image_is_kept_as_bytes(self):
        image = fw.FieldImage("a.png", b"\x89PNG\x00\xff")
        self.assertEqual(image.content, b"\x89PNG\x00\xff")
        self.assertIsNone(fw.FieldImage("a.png").content)

    def test_with_another_layout_tiles_are_bare(self):
        made = fw.retile(support.project(), layout=fw.find_node_layout("paper8"))
        self.assertEqual(made.project.layout.name, "paper8")
        self.assertEqual({tile.pattern for tile in made.project.tessellation.tiles}, {-1})

    def test_wrong_input_is_refused(self):
        for wrong in ({"edge_length": -1.0}, {"edge_length": 0.015, "patterns": "0-99"}):
            with self.subTest(wrong), self.assertRaises(fw.InputError):
                fw.retile(support.project(), **wrong)
        with self.assertRaises(TypeError):
            fw.retile(support.project(), side=0.01)


class Libraries(unittest.TestCase):
    def test_hold_what_is_filled_in(self):
        layout = fw.paper_layout()
        patterns = fw.enumerate_patterns(layout)[:3]
        with tempfile.TemporaryDirectory() as folder:
            with fw.Library.create(folder + "/own.db", layout, fw.paper_setting()) as library:
                library.add_patterns(patterns)
                self.assertEqual(library.fill().done, 3)
                arrays = library.response_arrays()
                self.assertEqual(arrays.displacements.shape, (3, 5, 10, 6, 6))
                single = library.responses(arrays.patterns[1])
                np.testing.assert_array_equal(arrays.displacements[1, 2, 3], single[2].samples[3].displacements)
                self.assertIn("bending_stiffness", library.properties(arrays.patterns[0]))
            with self.assertRaisesRegex(fw.Error, "closed"):
                library.patterns()


if __name__ == "__main__":
    unittest.main()
