// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/ring/ring10_tile.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

namespace fretwork::reduction {

TileModel ring10_tile_model() {
    return ring_tile_model(ring10_parameters(),
                           "the paper's hexagon with links, with one section for the ring and one for the "
                           "links: ten parameters, calibrated; linear");
}

}  // namespace fretwork::reduction
