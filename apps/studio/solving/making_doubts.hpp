// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>
#include <vector>

namespace fretwork::studio {

/// Obstacles to making a surface.
struct MakingDoubts {
    struct Place {
        const char* kind = "";  ///< overlap, gap or opening
        geometry::Point2 at;
        double width = 0.0;  ///< m; negative for an overlap
    };
    /// How many there are, also beyond those that are listed.
    struct Counts {
        std::size_t overlaps = 0;
        std::size_t gaps = 0;
        std::size_t openings = 0;
    } counts;
    std::vector<std::string> words;  ///< a line for overlaps, one for all else; none: no obstacle
    std::vector<Place> places;       ///< overlaps first, the worst of each kind first; at most kMostPlaces
    static constexpr std::size_t kMostPlaces = 200;
};

/// Bars that overlap, and gaps and openings narrower than `clearance` (m), on a surface whose tiles are all
/// painted. Throws Stopped.
MakingDoubts making_doubts(const simulation::Surface& surface, const fabrication::ShapeOptions& shape,
                           double clearance);

/// The event `making`.
base::Json making_event(const MakingDoubts& doubts, std::int64_t revision);

}  // namespace fretwork::studio
