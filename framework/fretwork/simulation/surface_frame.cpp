// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/surface_frame.hpp>

namespace fretwork::simulation {

std::optional<mechanics::Frame> tile_beams(const Surface& surface, const ModelChoice& choice,
                                           const base::Control& control) {
    detail::TileBuilder builder;
    reduction::StructureParts parts =
        detail::join_tiles(surface, builder.build_all(surface, choice, {.control = control}), control).parts;
    if (!parts.elements.empty()) return std::nullopt;
    return std::move(parts.beams);
}

mechanics::Frame surface_frame(const Surface& surface, const ModelChoice& choice,
                               const Conditions& conditions, const base::Control& control) {
    std::optional<mechanics::Frame> frame = tile_beams(surface, choice, control);
    if (!frame)
        throw base::InputError("the tile model " + choice.name +
                               " has tiles that do not consist of beams: it cannot be written as a frame");
    frame->supports = conditions.supports;
    frame->prescribed = conditions.prescribed;
    frame->loads = conditions.loads;
    return std::move(*frame);
}

}  // namespace fretwork::simulation
