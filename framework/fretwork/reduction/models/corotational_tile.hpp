// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// A tile with corotating axes, which may move and turn by any amount. The tile resists motions of its
/// interface nodes relative to these axes with its condensed stiffness (mechanics/corotational_element.hpp).
/// Its mass is that of the beams, condensed statically. Throws as condensed_frame.
///
/// @param tile  its first `interface_nodes` nodes are the interface nodes
std::shared_ptr<const TileStructure> corotational_tile(mechanics::Frame tile, int interface_nodes);

/// A tile that moves the same way, with a given stiffness, such as that of a tile model of one's own. Its
/// beams are unknown, so it has no beam motion. Throws as CorotationalBody.
std::shared_ptr<const TileStructure> corotational_tile(mechanics::CorotationalBody::Parts parts);

/// The row `corotational` of the catalogue. It has no parameters, and congruent tiles are condensed once.
TileModel corotational_tile_model();

}  // namespace fretwork::reduction
