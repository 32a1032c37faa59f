// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/ring/ring10_tile.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

namespace fretwork::reduction {

TileModel ring10_tile_model() {
    return ring_tile_model(
        ring10_parameters(),
        "the same with sections of their own for ring and links: ten parameters, calibrated; linear");
}

}  // namespace fretwork::reduction
