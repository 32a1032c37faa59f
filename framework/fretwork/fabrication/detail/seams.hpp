// SPDX-License-Identifier: GPL-3.0-or-later
// Seams between parts, moved to where their connectors have room.
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace fretwork::fabrication::detail {

/// An interface node between two tiles: a connector if they are in different parts.
struct Crossing {
    std::array<std::size_t, 2> tiles{};  ///< the two tiles
    geometry::Point2 place;              ///< m
    bool is_tight = false;               ///< true if an end of its side or a hole is too near for a connector
    std::vector<std::size_t> close;      ///< crossings that are too near for both to be connectors
};

/// The crossings of a surface, in the order of its shared sides.
/// @param room  free length around each connector, m: to its side's ends, and half way to the next connector
std::vector<Crossing> crossings_of(const tiling::Tessellation& tessellation,
                                   std::span<const tiling::SharedSide> sides, double room);

/// The rules that parts keep while seams move.
struct SeamRules {
    std::function<bool(const geometry::Box&)> fits;  ///< whether a part with this box of tiles fits the bed
    base::Control control{};
};

/// Move tiles along the seams from part to part until every connector has room. Parts stay connected and keep
/// fitting the bed. `parts` has the number of the part of each tile. The search is simulated annealing of the
/// number of connectors without room and, with less weight, of all connectors; its seed is fixed. Returns
/// false if some connector has no room in the end; `parts` is then not changed. Throws Stopped.
bool make_room(const std::vector<Crossing>& crossings, const std::vector<geometry::Box>& boxes,
               const SeamRules& rules, std::vector<std::size_t>& parts);

}  // namespace fretwork::fabrication::detail
