// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in tile models. A new tile model is a file and a row.
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>
#include <fretwork/reduction/models/full_tile.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/ring/paper6_tile.hpp>
#include <fretwork/reduction/ring/ring10_tile.hpp>

namespace fretwork::reduction {

const std::vector<TileModel>& tile_models() {
    static const std::vector<TileModel> rows = {full_tile_model(), paper6_tile_model(), ring10_tile_model(),
                                                condensed_tile_model(), corotational_tile_model()};
    return rows;
}

}  // namespace fretwork::reduction
