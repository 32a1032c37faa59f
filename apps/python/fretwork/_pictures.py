# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures in notebooks, and tables for pandas. Nothing here is needed to compute."""

from __future__ import annotations

import html
import pathlib
from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    from ._core import LoadCase, NodeLayout, Outline, Pattern, Project, Result, Solution, Surface, SurfaceResult


class Picture:
    """An SVG that a notebook shows."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str) -> None:
        """Write the picture as a file."""
        pathlib.Path(path).write_text(self.svg)


class View:
    """A page that a notebook shows in a frame, without any extension: to turn and to zoom."""

    def __init__(self, page: str, height: int) -> None:
        self.page = page
        self.height = height

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.page)}" width="100%" height="{self.height}" '
                'style="border:0"></iframe>')

    def save(self, path: str) -> None:
        """Write the page as a file for any browser."""
        pathlib.Path(path).write_text(self.page)


def view(self: Surface, result: SurfaceResult | None = None, height: int = 500, **keywords: Any) -> View:
    """The surface in 3D, at rest or bent by a result, as a page in a frame.

    Keywords are those of export(): colour, scale, view, strength, models, progress.
    """
    return View(_core.export_content(self, ".html", result, **keywords).decode(), height)


def draw(self: NodeLayout, *patterns: Pattern | str) -> Picture:
    """A sheet of the layout and these patterns (or ids): fans in the hexagon.

    >>> import fretwork
    >>> layout = fretwork.paper_layout()
    >>> layout.draw("0-1+1-6").svg.startswith("<?xml")
    True
    """
    chosen = [_core.parse_pattern_id(self, one) if isinstance(one, str) else one for one in patterns]
    return Picture(_core.pattern_sheet_svg(self, chosen))


def draw_surface(self: Surface, load_case: LoadCase | None = None) -> Picture:
    """The surface from above, with supports and loads."""
    return Picture(_core.surface_svg(self, load_case))


def _layout_svg(self: NodeLayout) -> str:
    return _core.pattern_sheet_svg(self, [])


def _surface_svg(self: Surface) -> str:
    return _core.surface_svg(self)


def _project_svg(self: Project) -> str:
    return _core.surface_svg(_core.make_surface(self))


def _outline_svg(self: Outline) -> str:
    low, high = self.boundary.min(axis=0), self.boundary.max(axis=0)
    width, height = high - low
    path = "".join("M" + "L".join(f"{x:.9g},{-y:.9g}" for x, y in loop) + "Z" for loop in (self.boundary, *self.holes))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="480" height="{480 * height / width:.0f}" '
            f'viewBox="{low[0]:.9g} {-high[1]:.9g} {width:.9g} {height:.9g}">'
            f'<path d="{path}" fill="#d5dde5" fill-rule="evenodd" stroke="none"/></svg>')


def to_pandas(self: Result) -> Any:
    """The nodes as a pandas.DataFrame: index `node`, columns x y z (m), ux uy uz (m), rx ry rz (rad)."""
    import numpy
    import pandas

    rows = self.displacements
    names = ["x", "y", "z", "ux", "uy", "uz", "rx", "ry", "rz"]
    index = pandas.Index([node.id for node in self.nodes], name="node")
    return pandas.DataFrame(numpy.hstack([self.rest_positions, rows]), index=index, columns=names)


def plot_path(solutions: list[Solution], node: int, dof: str = "uz", ax: Any = None) -> Any:
    """Draw the load factor over a displacement of a node along a path, and return matplotlib's axes."""
    from matplotlib import pyplot

    ax = ax or pyplot.gca()
    column = list(_core.Dof).index(_core.Dof(dof))
    ax.plot([one.displacements[node, column] for one in solutions], [one.load_factor for one in solutions], ".-")
    ax.set_xlabel(f"{dof} of node {node} ({'m' if dof[0] == 'u' else 'rad'})")
    ax.set_ylabel("load factor")
    return ax


def install() -> None:
    """Give the classes of the extension module their pictures."""
    _core.NodeLayout._repr_svg_ = _layout_svg
    _core.NodeLayout.draw = draw
    _core.Outline._repr_svg_ = _outline_svg
    _core.Project._repr_svg_ = _project_svg
    _core.Surface._repr_svg_ = _surface_svg
    _core.Surface.draw = draw_surface
    _core.Surface.view = view
    _core.Result.to_pandas = to_pandas
