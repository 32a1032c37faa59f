# SPDX-License-Identifier: GPL-3.0-or-later
"""Gradients against central differences."""

import copy
import importlib.util
import sys
import unittest

import numpy as np

import fretwork as fw
import support

sys.path.insert(0, str(support.SOURCE / "apps/python/examples"))


def lifted():
    """Held at the left, lifted at the right, and loaded: all parts of a design matter."""
    case = support.tip(-0.0005)
    case.prescribed = [
        fw.LoadCase.PrescribedDisplacement(fw.NodesNearest([[0.2, 0.0]]), "uz", 0.02),
        fw.LoadCase.PrescribedDisplacement(fw.NodesNearest([[0.2, 0.2]]), "uz", -0.01),
    ]
    return case


def designs(random, surface):
    """A value and a step of each part."""
    section = fw.rectangle_section(2e-3, 2.5e-3)
    nodes = len(surface.tessellation.interface_nodes)
    return {
        "forces": (random.normal(size=(nodes, 3)) * 2e-6, 1e-5),
        "prescribed": (np.array([0.02, -0.01]), 1e-4),
        "young_modulus": (np.array(1e9), 1e6),
        "section": (np.array([section.area, section.I2, section.I3, section.J]), None),
        "width": (np.array(2.2e-3), 2e-6),
        "thickness": (np.array(1.8e-3), 2e-6),
    }


def cotangents(random, surface):
    """Each output alone. A stress, a high power, wants smaller steps: the share of the usual ones."""
    nodes = len(surface.tessellation.interface_nodes)
    return {"displacements": (random.normal(size=(nodes, 6)), 1.0), "positions": (random.normal(size=(nodes, 3)), 1.0),
            "energy": (np.array(1.0), 1.0), "stress": (np.array(1.0), 0.1)}


def difference(along):
    """The derivative of along(t) at 0, by central differences at steps of 1 and 2, extrapolated (Richardson)."""
    return (8 * (along(1) - along(-1)) - (along(2) - along(-2))) / 12


class Gradients(unittest.TestCase):
    def assert_close(self, found, wanted):
        found, wanted = np.ravel(found), np.ravel(wanted)
        self.assertLessEqual(np.linalg.norm(found - wanted), 1e-6 * np.linalg.norm(wanted), (found, wanted))
        self.assertGreaterEqual(found @ wanted / np.linalg.norm(found) / np.linalg.norm(wanted), 0.999999)

    def test_a_design_without_equilibrium_leaves_nothing_behind(self):
        function = fw.SurfaceFunction(support.surface(), lifted(), "corotational")
        thick, thin = {"thickness": np.array(1.8e-3)}, {"thickness": np.array(1e-5)}
        first = function.apply(thick)
        with self.assertRaises(fw.NumericalError):
            function.apply(thin)
        np.testing.assert_allclose(function.apply(thick)["displacements"], first["displacements"], rtol=1e-9, atol=1e-12)
        with self.assertRaises(fw.NumericalError):
            function.apply(thin)
        slopes = function.vjp(thick, first, {"energy": 1.0})
        self.assertEqual(slopes["thickness"].shape, ())

    def check(self, model, part, value, step):
        """Derivatives along random directions."""
        random = np.random.default_rng(5)
        surface = support.surface()
        function = fw.SurfaceFunction(surface, lifted(), model, stress_exponent=32)
        if step is None:
            step = 1e-3 * value
        outputs = function.apply({part: value})
        for name, (cotangent, share) in cotangents(random, surface).items():
            slopes = function.vjp({part: value}, outputs, {name: cotangent})[part]
            self.assertEqual(slopes.shape, value.shape)
            directions = [share * step * random.normal(size=value.shape) for _ in range(3)]

            def along(direction):
                return difference(lambda t: (function.apply({part: value + t * direction})[name] * cotangent).sum())

            with self.subTest(model=model, part=part, output=name):
                self.assert_close([(slopes * one).sum() for one in directions], [along(one) for one in directions])

    def test_at_large_deflection(self):
        for part, (value, step) in designs(np.random.default_rng(3), support.surface()).items():
            self.check("corotational", part, value, step)

    def test_at_small_displacements(self):
        for part, (value, step) in designs(np.random.default_rng(3), support.surface()).items():
            self.check("condensed", part, value, step)

    def test_of_several_outputs_is_their_sum(self):
        surface = support.surface()
        function = fw.SurfaceFunction(surface, lifted(), stress_exponent=32)
        design = {"thickness": 2e-3, "forces": np.zeros((len(surface.tessellation.interface_nodes), 3))}
        outputs = function.apply(design)
        given = {name: one for name, (one, _) in cotangents(np.random.default_rng(2), surface).items()}
        whole = function.vjp(design, outputs, given)
        for part in design:
            np.testing.assert_allclose(whole[part], sum(function.vjp(design, outputs, {name: one})[part]
                                                        for name, one in given.items()), rtol=1e-9, atol=1e-12)

    def test_clapeyron(self):
        """At small displacements without prescribed ones, loads do twice the elastic energy: its slopes are displacements."""
        surface = support.surface()
        function = fw.SurfaceFunction(surface, support.tip(), "condensed")
        nodes = len(surface.tessellation.interface_nodes)
        forces = np.random.default_rng(1).normal(size=(nodes, 3)) * 1e-5
        outputs = function.apply({"forces": forces})
        slopes = function.vjp({"forces": forces}, outputs, {"energy": 1.0})["forces"]
        np.testing.assert_allclose(slopes, outputs["displacements"][:, :3], atol=1e-9)

    def test_stress_is_near_the_largest(self):
        surface = support.surface()
        near = [float(fw.SurfaceFunction(surface, lifted(), stress_exponent=p).apply({})["stress"]) for p in (8, 32, 512)]
        session = fw.Session(surface, lifted(), model="corotational")
        result = session.solve(subject=True)
        largest = max(row.largest_von_mises for row in fw.beam_table(surface, result).rows)
        self.assertGreaterEqual(min(near), largest * (1 - 1e-9))
        self.assertEqual(sorted(near, reverse=True), near)
        self.assertLess(near[-1], 1.05 * largest)

    def test_pattern_derivatives_vanish_for_the_pattern_that_is_there(self):
        surface = support.surface()
        session = fw.Session(surface, support.tip(), model="corotational")
        gradient = np.zeros_like(session.solve().displacements)
        gradient[:, 2] = 1.0
        slopes = fw.pattern_derivatives(session.sensitivity(gradient),
                                        fw.CandidateTiles(surface, [support.PATTERN, support.OTHER]))
        self.assertEqual(slopes.shape, (len(surface.tessellation), 2))
        self.assertLess(np.abs(slopes[:, 0]).max(), 1e-9 * np.abs(slopes[:, 1]).max())

    def test_weights_of_patterns(self):
        """At random mixtures, in the direction of single weights of a few tiles."""
        random = np.random.default_rng(7)
        surface = support.surface()
        tiles = len(surface.tessellation)
        places = [(tile, pattern) for tile in (0, 7, 20) for pattern in (0, 1)]
        for model in ("corotational", "condensed"):
            function = fw.SurfaceFunction(surface, lifted(), model, patterns=[support.PATTERN, support.OTHER])
            weights = random.uniform(0.2, 1.0, size=(tiles, 2))
            known = cotangents(random, surface)
            outputs = function.apply({"weights": weights})
            slopes = {name: function.vjp({"weights": weights}, outputs, {name: known[name][0]})["weights"]
                      for name in ("displacements", "energy")}
            found = {name: [] for name in slopes}
            h = 2e-3
            for at in places:
                there = {}
                for step in (-2, -1, 1, 2):
                    moved = weights.copy()
                    moved[at] += step * h
                    there[step] = function.apply({"weights": moved})
                for name in slopes:
                    found[name].append(difference(lambda step: (there[step][name] * known[name][0]).sum()) / h)
            for name in slopes:
                with self.subTest(model=model, output=name):
                    self.assert_close([slopes[name][at] for at in places], found[name])

    def test_a_row_with_a_single_one_is_a_painted_tile(self):
        surface = support.surface()
        for model in ("corotational", "condensed"):
            function = fw.SurfaceFunction(surface, lifted(), model, patterns=[support.PATTERN, support.OTHER])
            painted = function.apply({})["displacements"]
            weights = np.tile([1.0, 0.0], (len(surface.tessellation), 1))
            np.testing.assert_allclose(function.apply({"weights": weights})["displacements"], painted, atol=1e-9)

    def test_wrong_designs_are_refused(self):
        function = fw.SurfaceFunction(support.surface(), lifted(), stress_exponent=32)
        for design in ({"force": 1}, {"forces": [[1, 2, 3]]}, {"prescribed": [1.0]}, {"width": [1e-3]},
                       {"width": 1e-3, "section": [1, 1, 1, 1]}):
            with self.assertRaises(fw.InputError):
                function.apply(design)
        with self.assertRaises(fw.InputError):
            function.vjp({}, {}, {"position": 0})
        with self.assertRaises(fw.InputError):
            function.vjp({}, {}, {"positions": np.zeros(3)})
        mixed = fw.SurfaceFunction(support.surface(), lifted(), patterns=[support.PATTERN], stress_exponent=32)
        with self.assertRaisesRegex(fw.InputError, "no stress"):
            mixed.apply({"weights": np.ones((len(support.surface().tessellation), 1))})
        setting = fw.paper_setting()
        setting.section = fw.circle_section(2e-3)
        round_bars = copy.copy(support.project())
        round_bars.setting = setting
        with self.assertRaisesRegex(fw.InputError, "circle"):
            fw.SurfaceFunction(fw.make_surface(round_bars), lifted()).apply({"width": 2e-3})
        with self.assertRaises(fw.InputError):
            fw.SurfaceFunction(support.surface(), lifted(), "full")
        with self.assertRaises(fw.InputError):
            fw.SurfaceFunction(support.surface(), lifted(), stress_exponent=1)

    def test_a_shape_is_found_by_scipy(self):
        if importlib.util.find_spec("scipy") is None:
            self.skipTest("SciPy is not installed")
        from scipy.optimize import minimize

        from scipy_objective import objective

        function = fw.SurfaceFunction(support.surface(), lifted())
        target = function.apply({"prescribed": [0.015, -0.005]})["positions"]
        found = minimize(objective(function, target), [0.0, 0.0], jac=True, bounds=[(-0.03, 0.03)] * 2,
                         options={"ftol": 1e-14, "gtol": 1e-12})
        np.testing.assert_allclose(found.x, [0.015, -0.005], atol=1e-5)

    def test_torch_agrees(self):
        if importlib.util.find_spec("torch") is None:
            self.skipTest("torch is not installed")
        import torch

        from torch_function import Output

        function = fw.SurfaceFunction(support.surface(), lifted(), stress_exponent=32)
        nodes = [3, 40, 80]
        # x, by which numbers near 1 become parts of a design and outputs, so that gradcheck's tolerances mean something
        parts = {"prescribed": ([1.0, 1.0], torch.tensor([0.02, -0.01])), "thickness": (1.0, torch.tensor(2e-3)),
                 "young_modulus": (1.0, torch.tensor(1e9)), "section": ([1.0] * 4, torch.tensor([4e-6, 1.3e-12, 1.3e-12, 2.2e-12]))}
        sizes = {"positions": 0.01, "energy": 1e-4, "stress": 1e6}
        for part, (start, unit) in parts.items():
            for output, size in sizes.items():
                def called(x):
                    given = Output.apply(function, part, output, x * unit.double()) / size
                    return given[nodes] if output == "positions" else given

                x = torch.tensor(start, dtype=torch.float64, requires_grad=True)
                with self.subTest(part=part, output=output):  # plain central differences: shorter steps meet the solver's tolerance
                    self.assertTrue(torch.autograd.gradcheck(called, (x,), eps=1e-3, atol=1e-5, rtol=1e-5))


if __name__ == "__main__":
    unittest.main()
