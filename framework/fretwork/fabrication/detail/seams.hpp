// SPDX-License-Identifier: GPL-3.0-or-later
// Seams between parts, moved to where their connectors have room.
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <functional>
#include <vector>

namespace fretwork::fabrication::detail {

/// The room that seams must leave.
struct SeamRules {
    double room = 0.0;  ///< m, around each connector: to the ends of its side, and half way to the next
    std::function<bool(const geometry::Box&)> fits;  ///< whether a part with this box of tiles fits the bed
    base::Control control{};
};

/// Move tiles along the seams from part to part until every connector has room. Parts stay connected and keep
/// fitting the bed. Each tile has a number of its part. The search is simulated annealing of the number of
/// connectors without room; its random numbers have one seed. Returns false if some connector has no room in
/// the end; `parts` then is not changed. Throws Stopped if `control` asks to stop.
bool make_room(const tiling::Tessellation& tessellation, const std::vector<geometry::Box>& boxes,
               const SeamRules& rules, std::vector<std::size_t>& parts);

}  // namespace fretwork::fabrication::detail
