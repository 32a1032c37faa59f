# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of a surface with gradients: displacements, energy and stress, with respect to loads, material, section, patterns."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from . import _core

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence, Set

    import numpy as np
    import numpy.typing as npt

    from ._core import LoadCase, Session, Setting, SmoothStress, Surface, SurfaceResult

    _Floats = npt.NDArray[np.float64]
    _Design = Mapping[str, npt.ArrayLike]

_SECTION = ("area", "I2", "I3", "J")
_SIDES = ("width", "thickness")
_SHARE = 1e-3  # the step of a differenced share of a number


class SurfaceFunction:
    """Displacements, energy and largest stress of a surface as a function of a design.

    A design is a dict. A part that is left out is taken from surface and load case. The parts are:

    forces: n x 3 floats, N, on the n interface nodes, in addition to the loads of the load case
    prescribed: m floats (m or rad), the values of the load case's m prescribed displacements, entry by entry
    young_modulus: a float, Pa
    section: 4 floats: area (m^2), I2, I3, J (m^4)
    width, thickness: floats, m: of rectangular bars, in the plane of the surface and across it
    weights: tiles x patterns floats: each tile's stiffness is this sum of those that the `patterns` give it

    `weights` want `patterns` (ids), no gravity, and the surface's own material and section; a row with a single 1 is a
    painted tile. `section` excludes `width` and `thickness`.

    The outputs are a dict, too:

    displacements: n x 6 floats (m, rad: rotation vectors)
    positions: n x 3 floats, m
    energy: a float, J, elastic
    stress: a float, Pa; only with a `stress_exponent` p (32 is usual): the p-norm of the von Mises stresses over the
        points of all bars' end sections, a smooth stand-in for the largest (fretwork.smooth_stress). A mixture of
        patterns has no bars, so it has no stress.

    With `model` "corotational" outputs are those of a nonlinear equilibrium, which continues from the one before; with
    "condensed" those of small displacements. Gradients of other models are not offered.

    >>> import fretwork as fw
    >>> square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])
    >>> project, _ = fw.make_project(square, patterns="0-1+1-6", edge_length=0.025)
    >>> case = fw.LoadCase(name="tip", supports=[fw.LoadCase.Support(fw.NodesAtSide("left"), "all")],
    ...     loads=[fw.LoadCase.Load(fw.NodesAtSide("right"), force=[0, 0, -0.001])])
    >>> function = fw.SurfaceFunction(fw.make_surface(project), case, stress_exponent=32)
    >>> design = {"thickness": 0.002}
    >>> outputs = fw.apply(function, design)
    >>> slopes = fw.vjp(function, design, outputs, {"stress": 1.0})
    >>> bool(slopes["thickness"] < 0)  # thicker bars bear less stress
    True
    """

    def __init__(self, surface: Surface, load_case: LoadCase, model: str = "corotational",
                 patterns: Sequence[str] = (), stress_exponent: float | None = None) -> None:
        if model not in ("corotational", "condensed"):
            raise _core.InputError(f"gradients are of the models corotational and condensed, and not of {str(model)!r}")
        if patterns and any(load_case.gravity):
            raise _core.InputError("weights of patterns are for load cases without gravity")
        if stress_exponent is not None and not stress_exponent >= 2:
            raise _core.InputError(f"the exponent of a smooth stress is 2 or more, not {stress_exponent}")
        self._surface = surface
        self._case = load_case
        self._model = model
        self._exponent = stress_exponent
        self._session = _core.Session(surface, load_case, model=model)
        self._candidates = _core.CandidateTiles(surface, list(patterns)) if patterns else None
        self._weights: Any = None  # those of the session
        self._parts: dict[str, Any] = {}  # parts of a design that the session's setting has
        self._applied: dict[str, Any] | None = None
        self._result: SurfaceResult | None = None
        self._stress: SmoothStress | None = None

    def apply(self, design: _Design) -> dict[str, _Floats]:
        """The outputs under a design. Raises NumericalError if there is no equilibrium."""
        import numpy as np

        numbers = self._numbers(design)
        self._applied = None  # if there is no equilibrium, the session has another design than the last outputs
        self._edit(numbers)
        result = self._session.solve()
        if not result.converged:
            raise _core.NumericalError(f"the surface has not converged: {result.solution.termination}")
        self._applied, self._result = numbers, result
        displacements = np.array(result.displacements)
        outputs = {"displacements": displacements, "positions": result.rest_positions + displacements[:, :3],
                   "energy": np.array(result.solution.energy)}
        if self._exponent is not None:
            self._stress = _core.smooth_stress(self._session, result, exponent=self._exponent)
            outputs["stress"] = np.array(self._stress.value)
        return outputs

    def vjp(self, design: _Design, outputs: Mapping[str, Any], cotangents: Mapping[str, Any]) -> dict[str, _Floats]:
        """The gradient of the sum of outputs times cotangents, with respect to each part of the design.

        `outputs` are the outputs of apply(design). If that was the last call, its equilibrium is used; otherwise, the
        equilibrium is found again. A cotangent has the shape of its output, and is zero if it is left out.
        """
        numbers = self._numbers(design)
        if self._applied is None or not _same(self._applied, numbers):
            self.apply(design)
        gradient, energy, stress = self._gradient(cotangents)
        assert self._result is not None
        by = self._session.sensitivity(gradient)
        if energy:
            by = _core.with_energy(by, energy, self._result.solution.energy)
        return {name: self._backward(by, stress, name) for name in numbers}

    def _gradient(self, cotangents: Mapping[str, Any]) -> tuple[_Floats, float, float]:
        """The gradient of outputs times cotangents with respect to displacements, and the cotangents of energy and stress."""
        import numpy as np

        assert self._result is not None
        known = ["displacements", "positions", "energy"] + (["stress"] if self._stress is not None else [])
        for name in cotangents:
            if name not in known:
                raise _core.InputError(f"there is no output '{name}'; there is: {', '.join(known)}")
        gradient = np.zeros(self._result.displacements.shape)
        for name, wide in (("displacements", 6), ("positions", 3)):
            if name in cotangents:
                gradient[:, :wide] += _shaped(name, cotangents[name], (len(gradient), wide))
        energy, stress = (float(_shaped(name, cotangents.get(name, 0.0), ())) for name in ("energy", "stress"))
        if energy:
            gradient += energy * self._session.energy_gradient(self._result)
        if stress and self._stress is not None:
            gradient += stress * self._stress.gradient
        return gradient, energy, stress

    def _numbers(self, design: _Design) -> dict[str, Any]:
        import numpy as np

        shapes = {"forces": (len(self._surface.tessellation.interface_nodes), 3),
                  "prescribed": (len(self._case.prescribed),), "young_modulus": (), "section": (4,), "width": (),
                  "thickness": ()}
        if self._candidates is not None:
            shapes["weights"] = (len(self._surface.tessellation), len(self._candidates.patterns))
        numbers = {}
        for name, value in design.items():
            if name not in shapes:
                raise _core.InputError(f"a design has no part '{name}'; there is: {', '.join(shapes)}")
            numbers[name] = np.array(_shaped(name, value, shapes[name]))
        self._check_together(numbers.keys())
        return numbers

    def _check_together(self, parts: Set[str]) -> None:
        if "weights" in parts and parts & {"young_modulus", "section", *_SIDES}:
            raise _core.InputError("weights are of the surface's own material and section")
        if "weights" in parts and self._exponent is not None:
            raise _core.InputError("a mixture of patterns has no bars, and so no stress: leave stress_exponent out")
        if "section" in parts and parts & set(_SIDES):
            raise _core.InputError("a design has either a section, or its width and thickness")
        shape = _core.shape_name(_core.shape_of(self._surface.setting.section))
        if parts & set(_SIDES) and shape != "rectangle":
            raise _core.InputError(f"width and thickness are of rectangular bars; the surface has a {shape}")

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
        if numbers.keys() & set(_SIDES):
            section = setting.section
            setting.section = _core.rectangle_section(
                float(numbers.get("width", _core.rectangle_width(section))),
                float(numbers.get("thickness", _core.rectangle_height(section))))
        return setting

    def _edit(self, numbers: Mapping[str, Any]) -> None:
        weights = numbers.get("weights")
        if not _same({"weights": self._weights}, {"weights": weights}):
            self._session, self._weights, self._parts = self._session_of(weights), weights, {}
        parts = {name: numbers.get(name) for name in ("young_modulus", "section", *_SIDES)}
        if not _same({name: self._parts.get(name) for name in parts}, parts):
            self._session.set_setting(self._setting_of(numbers))
            self._parts = parts
        self._session.set_load_case(self._case_of(numbers))

    def _session_of(self, weights: Any) -> Session:
        """A session whose tiles mix patterns, each by a tile model of its own; None: tiles as painted."""
        if weights is None:
            return _core.Session(self._surface, self._case, model=self._model)
        rows = list(enumerate(weights))
        size: Literal["small", "large"] = "large" if self._model == "corotational" else "small"
        models = [_core.TileModel(f"mixed {tile}", self._mixed(tile, row), displacements=size, sharing="congruent")
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
            if self._model == "condensed":
                return stiffness
            return _core.corotational_tile(given.frame().nodes[: given.interface_nodes], stiffness)

        return build

    def _at_prescribed(self, rows: _Floats) -> _Floats:
        """For each prescribed entry, the sum of a component over its nodes."""
        import numpy as np

        components = list(_core.Dof)
        return np.array([rows[_core.select_nodes(entry.where, self._surface.tessellation),
                              components.index(entry.dof)].sum() for entry in self._case.prescribed])

    def _backward(self, by: Any, stress: float, name: str) -> _Floats:
        """The gradient with respect to one part of the design; `stress` is the cotangent of the stress."""
        import numpy as np

        if name == "forces":
            return np.array(by.loads[:, :3])
        if name == "prescribed":
            return self._at_prescribed(by.held_values)
        if name == "weights":
            assert self._candidates is not None
            instead = _core.pattern_derivatives(by, self._candidates)  # of K_p - K
            return np.array(instead + by.tile_stiffness[:, None])
        assert self._applied is not None
        setting = self._setting_of(self._applied)
        if name == "young_modulus":  # stresses of a surface that does not move are in proportion to it
            at_rest = stress * self._stress.value if self._stress is not None else 0.0
            return np.array((by.stiffness + at_rest) / setting.material.young_modulus)
        if name == "section":
            return np.array([self._along(by, stress, setting, part) for part in _SECTION])
        return np.array(self._along(by, stress, setting, name))

    def _along(self, by: Any, stress: float, setting: Setting, part: str) -> float:
        """The gradient with respect to one number of the section, or one side of the bars, by changing a share of it."""
        before = (getattr(setting.section, part) if part in _SECTION else
                  _core.rectangle_width(setting.section) if part == "width" else
                  _core.rectangle_height(setting.section))

        def curve(t: float) -> Setting:
            import copy

            changed = copy.copy(setting)
            if part in _SECTION:
                setattr(changed.section, part, (1 + t) * before)
            else:
                sides = [_core.rectangle_width(setting.section), _core.rectangle_height(setting.section)]
                sides[_SIDES.index(part)] = (1 + t) * before
                changed.section = _core.rectangle_section(*sides)
            return changed

        slope = _core.derivative_along(by, self._session.surface, curve, _SHARE)
        if stress and self._result is not None:
            slope += stress * _core.smooth_stress_along(self._session, self._result, curve, _SHARE,
                                                        exponent=self._exponent)
        return float(slope / before)


def _shaped(name: str, value: Any, shape: tuple[int, ...]) -> _Floats:
    """Numbers as an array of this shape."""
    import numpy as np

    array = np.asarray(value, dtype=float)
    if array.shape != shape:
        raise _core.InputError(f"{name} has the shape {array.shape}, and not {shape}")
    return array


def _same(left: Mapping[str, Any], right: Mapping[str, Any]) -> bool:
    import numpy as np

    return left.keys() == right.keys() and all(
        (left[name] is None) == (right[name] is None) and
        (left[name] is None or np.array_equal(left[name], right[name])) for name in left)


def apply(function: SurfaceFunction, design: _Design) -> dict[str, _Floats]:
    """The outputs of a function under a design: SurfaceFunction.apply."""
    return function.apply(design)


def vjp(function: SurfaceFunction, design: _Design, outputs: Mapping[str, Any],
        cotangents: Mapping[str, Any]) -> dict[str, _Floats]:
    """The gradient of outputs times cotangents with respect to a design: SurfaceFunction.vjp."""
    return function.vjp(design, outputs, cotangents)
