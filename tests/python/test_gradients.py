# SPDX-License-Identifier: GPL-3.0-or-later
"""Gradients against central differences."""

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
    section = fw.rectangle_section(2e-3, 2e-3)
    nodes = len(surface.tessellation.interface_nodes)
    return {
        "forces": (random.normal(size=(nodes, 3)) * 2e-6, 1e-5),
        "prescribed": (np.array([0.02, -0.01]), 1e-4),
        "young_modulus": (np.array(1e9), 1e6),
        "section": (np.array([section.area, section.I2, section.I3, section.J]), None),
    }


class Gradients(unittest.TestCase):
    def check(self, model, part, value, step):
        """The derivative along a random direction, by differences of fourth order."""
        random = np.random.default_rng(5)
        surface = support.surface()
        function = fw.SurfaceFunction(surface, lifted(), model)
        cotangent = random.normal(size=(len(surface.tessellation.interface_nodes), 6))
        direction = random.normal(size=value.shape)
        if step is None:
            direction, step = direction * value, 1e-3
        slopes = function.vjp({part: value}, function.apply({part: value}), {"displacements": cotangent})[part]

        def along(t):
            return (function.apply({part: value + t * step * direction})["displacements"] * cotangent).sum()

        wanted = (8 * (along(1) - along(-1)) - (along(2) - along(-2))) / (12 * step)
        self.assertAlmostEqual((slopes * direction).sum() / wanted, 1.0, delta=1e-6)

    def test_at_large_deflection(self):
        for part, (value, step) in designs(np.random.default_rng(3), support.surface()).items():
            with self.subTest(part):
                self.check("corotational", part, value, step)

    def test_at_small_displacements(self):
        known = designs(np.random.default_rng(3), support.surface())
        for part in ("forces", "prescribed", "young_modulus"):
            with self.subTest(part):
                self.check("condensed", part, *known[part])

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
        """At random mixtures, against differences of fourth order in every direction of a few tiles."""
        random = np.random.default_rng(7)
        surface = support.surface()
        function = fw.SurfaceFunction(surface, lifted(), patterns=[support.PATTERN, support.OTHER])
        tiles = len(surface.tessellation)
        cotangent = random.normal(size=(len(surface.tessellation.interface_nodes), 6))
        for weights in (random.uniform(0.2, 1.0, size=(tiles, 2)) for _ in range(2)):
            design = {"weights": weights}
            slopes = function.vjp(design, function.apply(design), {"displacements": cotangent})["weights"]

            def along(tile, pattern, step):
                moved = weights.copy()
                moved[tile, pattern] += step
                return (function.apply({"weights": moved})["displacements"] * cotangent).sum()

            h, places = 2e-3, [(tile, pattern) for tile in (0, 7, 20) for pattern in (0, 1)]
            wanted = np.array([(8 * (along(*at, h) - along(*at, -h)) - (along(*at, 2 * h) - along(*at, -2 * h))) / (12 * h)
                               for at in places])
            found = np.array([slopes[at] for at in places])
            cosine = found @ wanted / np.linalg.norm(found) / np.linalg.norm(wanted)
            self.assertGreaterEqual(cosine, 0.999999)
            self.assertLess(np.linalg.norm(found - wanted), 1e-4 * np.linalg.norm(wanted))

    def test_a_row_with_a_single_one_is_a_painted_tile(self):
        surface = support.surface()
        function = fw.SurfaceFunction(surface, lifted(), patterns=[support.PATTERN, support.OTHER])
        painted = function.apply({})["displacements"]
        weights = np.tile([1.0, 0.0], (len(surface.tessellation), 1))
        np.testing.assert_allclose(function.apply({"weights": weights})["displacements"], painted, atol=1e-9)

    def test_wrong_designs_are_refused(self):
        function = fw.SurfaceFunction(support.surface(), lifted())
        for design in ({"force": 1}, {"forces": [[1, 2, 3]]}, {"prescribed": [1.0]}):
            with self.assertRaises(fw.InputError):
                function.apply(design)

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

        from torch_function import Positions

        function = fw.SurfaceFunction(support.surface(), lifted())
        x = torch.tensor([0.02, -0.01], dtype=torch.float64, requires_grad=True)
        nodes = [3, 40, 80]
        self.assertTrue(torch.autograd.gradcheck(lambda given: Positions.apply(function, "prescribed", given)[nodes],
                                                 (x,), eps=1e-4, atol=1e-5, rtol=1e-4))


if __name__ == "__main__":
    unittest.main()
