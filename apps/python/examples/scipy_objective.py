# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as an objective for SciPy: `minimize(objective(function, target), x0, jac=True)`."""

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

import fretwork as fw


def objective(function: fw.SurfaceFunction, target: npt.NDArray[np.float64], part: str = "prescribed"
              ) -> Callable[[npt.NDArray[np.float64]], tuple[float, Any]]:
    """The squared distance (m^2) of the interface nodes from a target (n x 3), and its gradient by one part."""

    def value_and_gradient(x: npt.NDArray[np.float64]) -> tuple[float, Any]:
        outputs = fw.apply(function, {part: x})
        distance = outputs["positions"] - target
        return float((distance**2).sum()), fw.vjp(function, {part: x}, outputs, {"positions": 2 * distance})[part]

    return value_and_gradient
