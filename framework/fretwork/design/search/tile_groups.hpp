// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/symmetry.hpp>
#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <set>
#include <span>
#include <vector>

namespace fretwork::design::detail {

/// A group of tiles that are painted together. Each gets the pattern of the group or its mirror image.
struct TileGroup {
    struct Member {
        tiling::TileIndex tile;
        bool is_mirrored = false;
    };
    std::vector<Member> members;
};

/// The groups of the tiles that are not kept: each tile by itself or, with a symmetry, together with its
/// images. Throws InputError that names a tile without an image, or a kept tile with an image that is not
/// kept.
std::vector<TileGroup> tile_groups(const tiling::Tessellation& tessellation,
                                   std::span<const tiling::TileIndex> kept, const Symmetry& symmetry);

/// The indices of the kept tiles' patterns among the candidates.
std::set<std::size_t> kept_candidates(const simulation::CandidateTiles& candidates,
                                      const tiling::Tessellation& tessellation,
                                      const std::vector<tiling::TileIndex>& keep);

}  // namespace fretwork::design::detail
