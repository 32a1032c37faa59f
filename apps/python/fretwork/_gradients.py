# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of a surface with their gradients: displacements by loads, prescribed displacements, material and section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import numpy.typing as npt

    from ._core import LoadCase, Session, Surface, SurfaceResult

    Floats = npt.NDArray[np.float64]
    Design = Mapping[str, npt.ArrayLike]

_SECTION = ("area", "I2", "I3", "J")


class SurfaceFunction:
    """The displacements of a surface's interface nodes as a function of a design.

    A design is a dict; what is left out is as in surface and load case:

    forces: n x 3 floats, N, on the interface nodes, beside the loads of the load case
    prescribed: m floats (m or rad), the values of the load case's prescribed displacements, entry by entry
    young_modulus: a float, Pa
    section: 4 floats: area (m^2), I2, I3, J (m^4)
    weights: tiles x patterns floats: each tile's stiffness is this sum of those that the `patterns` give it

    `weights` want `patterns` (ids), the model "corotational", no gravity, and the surface's own material and section; a row
    with a single 1 is a painted tile.

    The outputs are a dict, too: displacements (n x 6), and positions (n x 3, m). With `model` "corotational" they are
    those of a nonlinear equilibrium, which continues from the one before; with "condensed" those of small
    displacements.
    """

    def __init__(self, surface: Surface, load_case: LoadCase, model: str = "corotational",
                 patterns: Sequence[str] = ()) -> None:
        if model not in ("corotational", "condensed"):
            raise _core.InputError(f"gradients are of the models corotational and condensed, and not of '{model}'")
        self._surface = surface
        self._case = load_case
        self._model = model
        self._session = _core.Session(surface, load_case, model=model)
        self._candidates = _core.CandidateTiles(surface, list(patterns)) if patterns else None
        if patterns and (model != "corotational" or any(load_case.gravity)):
            raise _core.InputError("weights of patterns are for the model corotational, and load cases without gravity")
        self._weights: Any = None  # those of the session
        self._applied: dict[str, Any] | None = None
        self._result: SurfaceResult | None = None

    def apply(self, design: Design) -> dict[str, Floats]:
        """The displacements (n x 6) and positions (n x 3) under a design. Raises NumericalError if there is none."""
        import numpy as np

        numbers = self._numbers(design)
        self._edit(numbers)
        result = self._session.solve()
        if not result.converged:
            raise _core.NumericalError(f"the surface has not converged: {result.solution.termination}")
        self._applied, self._result = numbers, result
        nodes = len(self._surface.tessellation.interface_nodes)
        displacements = np.array(result.displacements[:nodes])
        return {"displacements": displacements, "positions": result.rest_positions[:nodes] + displacements[:, :3]}

    def vjp(self, design: Design, outputs: Mapping[str, Any], cotangents: Mapping[str, Any]) -> dict[str, Floats]:
        """The gradient, by each part of the design, of the sum of outputs times cotangents.

        `outputs` are those of apply(design); where it was the last call, its equilibrium is used.
        """
        import numpy as np

        numbers = self._numbers(design)
        if self._applied is None or not _same(self._applied, numbers):
            self.apply(design)
        gradient = np.zeros((len(self._surface.tessellation.interface_nodes), 6))
        for name, cotangent in cotangents.items():
            if name not in ("displacements", "positions"):
                raise _core.InputError(f"there is no output '{name}'; there are displacements and positions")
            wide = 6 if name == "displacements" else 3
            gradient[:, :wide] += np.asarray(cotangent, dtype=float).reshape(-1, wide)
        backward = self._linear_vjp if self._model == "condensed" else self._nonlinear_vjp
        return {name: backward(gradient, name) for name in numbers}

    def _numbers(self, design: Design) -> dict[str, Any]:
        import numpy as np

        shapes = {"forces": (len(self._surface.tessellation.interface_nodes), 3),
                  "prescribed": (len(self._case.prescribed),), "young_modulus": (), "section": (4,)}
        if self._candidates is not None:
            shapes["weights"] = (len(self._surface.tessellation), len(self._candidates.patterns))
        numbers = {}
        for name, value in design.items():
            if name not in shapes:
                raise _core.InputError(f"a design has no part '{name}'; there is: {', '.join(shapes)}")
            numbers[name] = np.array(value, dtype=float)
            if numbers[name].shape != shapes[name]:
                raise _core.InputError(f"{name} has the shape {numbers[name].shape}, and not {shapes[name]}")
        if "weights" in numbers and numbers.keys() & {"young_modulus", "section"}:
            raise _core.InputError("weights are of the surface's own material and section")
        return numbers

    def _case_of(self, numbers: Mapping[str, Any]) -> LoadCase:
        import copy

        case = copy.copy(self._case)
        if "forces" in numbers:
            case.loads += tuple(_core.LoadCase.Load(_core.NodesById([node]), force=force)
                                for node, force in enumerate(numbers["forces"]) if force.any())
        if "prescribed" in numbers:
            case.prescribed = [_core.LoadCase.PrescribedDisplacement(entry.where, entry.dof, value)
                               for entry, value in zip(case.prescribed, numbers["prescribed"])]
        return case

    def _setting_of(self, numbers: Mapping[str, Any]) -> Any:
        import copy

        setting = copy.copy(self._surface.setting)
        if "young_modulus" in numbers:
            setting.material.young_modulus = float(numbers["young_modulus"])
        for name, value in zip(_SECTION, numbers.get("section", ())):
            setattr(setting.section, name, float(value))
        return setting

    def _edit(self, numbers: Mapping[str, Any]) -> None:
        before = self._applied or {}
        weights = numbers.get("weights")
        if not _same({"weights": self._weights}, {"weights": weights}):
            self._applied, before = None, {}
            self._session, self._weights = self._session_of(weights), weights
        kept = {name: before.get(name) for name in ("young_modulus", "section")}
        if not _same(kept, {name: numbers.get(name) for name in kept}):
            self._session.set_setting(self._setting_of(numbers))
        self._session.set_load_case(self._case_of(numbers))

    def _session_of(self, weights: Any) -> Session:
        """A session whose tiles are mixed, each by a tile model of its own; None: painted ones."""
        if weights is None:
            return _core.Session(self._surface, self._case, model=self._model)
        rows = list(enumerate(weights))
        models = [_core.TileModel(f"mixed {tile}", self._mixed(tile, row), displacements="large", sharing="congruent")
                  for tile, row in rows]
        session = _core.Session(self._surface, self._case, model=self._model, models=models)
        for tile, _ in rows:
            session.set_tile_model([tile], f"mixed {tile}")
        return session

    def _mixed(self, tile: int, weights: Any) -> Any:
        candidates = self._candidates
        assert candidates is not None
        stiffness = sum(weight * candidates.stiffness(tile, pattern) for pattern, weight in enumerate(weights))

        def build(given: Any) -> Any:
            return _core.corotational_tile(given.frame().nodes[: given.interface_nodes], stiffness)

        return build

    def _at_prescribed(self, rows: Floats) -> Floats:
        """For each prescribed entry, the sum of a component over its nodes."""
        import numpy as np

        components = list(_core.Dof)
        return np.array([rows[_core.select_nodes(entry.where, self._surface.tessellation),
                              components.index(entry.dof)].sum() for entry in self._case.prescribed])

    def _nonlinear_vjp(self, gradient: Floats, name: str) -> Floats:
        import numpy as np

        sensitivity = self._session.sensitivity(gradient)
        if name == "forces":
            return np.array(sensitivity.loads[: len(gradient), :3])
        if name == "prescribed":
            return self._at_prescribed(sensitivity.held_values)
        if name == "weights":
            assert self._candidates is not None
            instead = _core.pattern_derivatives(sensitivity, self._candidates)  # of K_p - K
            return np.array(instead + sensitivity.tile_stiffness[:, None])
        assert self._applied is not None
        setting = self._setting_of(self._applied)
        if name == "young_modulus":
            return np.array(sensitivity.stiffness / setting.material.young_modulus)
        return np.array([self._along_section(sensitivity, setting, part) for part in _SECTION])

    def _along_section(self, sensitivity: Any, setting: Any, part: str) -> float:
        """By one number of the section, whose share t is changed."""
        import copy

        def curve(t: float) -> Any:
            changed = copy.copy(setting)
            setattr(changed.section, part, (1 + t) * getattr(setting.section, part))
            return changed

        whole = _core.derivative_along(sensitivity, self._session.surface, curve, 1e-3)
        return float(whole / getattr(setting.section, part))

    def _linear_vjp(self, gradient: Floats, name: str) -> Floats:
        """Small displacements are u = u_f + sum of p_i u_i: those of the forces, and of each prescribed value."""
        import numpy as np

        assert self._applied is not None and self._result is not None
        if name == "forces":
            adjoint = self._session.solve_adjoint(gradient.reshape(-1, 1)).reshape(-1, 6)
            return np.array(adjoint[:, :3])
        if name == "prescribed":
            return self._linear_by_prescribed(gradient)
        if name == "young_modulus":
            adjoint = self._session.solve_adjoint(gradient.reshape(-1, 1)).reshape(-1, 6)
            forces = _core.load_rows(self._case_of(self._applied), self._session.surface)
            return np.array(-(adjoint * forces).sum() / self._setting_of(self._applied).material.young_modulus)
        raise _core.InputError("the derivative by the section is given for the model corotational")

    def _linear_by_prescribed(self, gradient: Floats) -> Floats:
        import copy

        import numpy as np

        slopes = []
        count = len(self._case.prescribed)
        for entry in range(count):
            alone = copy.copy(self._case)
            alone.loads, alone.area_loads, alone.combines, alone.gravity = (), (), (), [0, 0, 0]
            alone.prescribed = [_core.LoadCase.PrescribedDisplacement(one.where, one.dof, float(place == entry))
                                for place, one in enumerate(self._case.prescribed)]
            self._session.set_load_case(alone)
            slopes.append((gradient * self._session.solve().displacements).sum())
        self._session.set_load_case(self._case_of(self._applied or {}))
        return np.array(slopes)


def _same(left: Mapping[str, Any], right: Mapping[str, Any]) -> bool:
    import numpy as np

    return left.keys() == right.keys() and all(
        (left[name] is None) == (right[name] is None) and
        (left[name] is None or np.array_equal(left[name], right[name])) for name in left)


def apply(function: SurfaceFunction, design: Design) -> dict[str, Floats]:
    """The outputs of a function under a design: SurfaceFunction.apply."""
    return function.apply(design)


def vjp(function: SurfaceFunction, design: Design, outputs: Mapping[str, Any],
        cotangents: Mapping[str, Any]) -> dict[str, Floats]:
    """The gradient of outputs times cotangents by a design: SurfaceFunction.vjp."""
    return function.vjp(design, outputs, cotangents)
