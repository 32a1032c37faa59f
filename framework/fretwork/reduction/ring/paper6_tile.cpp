// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/ring/paper6_tile.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

namespace fretwork::reduction {

TileModel paper6_tile_model() {
    return ring_tile_model(paper6_parameters(),
                           "the paper's hexagon with links: six parameters, calibrated; linear");
}

}  // namespace fretwork::reduction
