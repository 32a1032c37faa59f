# SPDX-License-Identifier: GPL-3.0-or-later
"""Fretwork: flat, tileable beam patterns that bend. Enumerate, calibrate, tile, simulate.

The names are those of the C++ framework. Lengths are metres, angles radians, all else SI.

>>> import fretwork
>>> layout = fretwork.find_node_layout("paper7")
>>> patterns = fretwork.enumerate_patterns(layout)
>>> len(patterns)
1824
>>> fretwork.pattern_id(layout, patterns[0])
'0-1+1-2+1-3+1-4+1-5+2-5+2-6'
"""

from . import _core, _record
from ._core import *  # noqa: F401,F403
from ._core import __version__  # noqa: F401
from ._gradients import SurfaceFunction, apply, vjp  # noqa: F401
from ._pictures import Picture, View, install as _install, plot_path  # noqa: F401

_record.guard(_core)
_install()
