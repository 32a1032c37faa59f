// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling::detail {

/// Turn a dual into a tessellation, numbered as tessellation.hpp defines: tiles from left to right, vertices
/// and interface nodes in the order in which the tiles first use them, and vertex 0 of each tile by the
/// direction of its first side. Throws base::Stopped.
Tessellation number(const Dual& dual, const pattern::NodeLayout& layout, const base::Control& control);

}  // namespace fretwork::tiling::detail
