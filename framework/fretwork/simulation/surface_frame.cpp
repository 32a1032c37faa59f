// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/surface_frame.hpp>

namespace fretwork::simulation {

mechanics::Frame surface_frame(const Surface& surface, const ModelChoice& choice,
                               const Conditions& conditions, const base::Control& control) {
    detail::TileBuilder builder;
    reduction::StructureParts parts =
        detail::join_tiles(surface, builder.build_all(surface, choice, {.control = control}), control).parts;
    if (!parts.elements.empty())
        throw base::InputError("the tile model " + choice.name +
                               " has tiles that do not consist of beams: it cannot be written as a frame");
    parts.beams.supports = conditions.supports;
    parts.beams.prescribed = conditions.prescribed;
    parts.beams.loads = conditions.loads;
    return std::move(parts.beams);
}

}  // namespace fretwork::simulation
