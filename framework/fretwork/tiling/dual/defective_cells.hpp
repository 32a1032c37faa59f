// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/dual/dual.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::tiling::detail {

/// The tilings without one cell: without its area where it is the end of a limb, so small that its place may
/// stay uncovered (at most `most_area`, m2); and united with each neighbour with which it makes a convex
/// cell. None of them is compared with the outline. Throws base::Stopped.
std::vector<Dual> without_cell(const Dual& dual, std::size_t cell, double most_area,
                               const base::Control& control);

}  // namespace fretwork::tiling::detail
