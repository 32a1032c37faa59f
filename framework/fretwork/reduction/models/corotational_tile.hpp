// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// A tile that moves and turns at will with its corotating frame, and answers motions of its interface nodes
/// against that frame with its condensed stiffness (mechanics/corotational_element.hpp). Its mass is that of
/// the beams, condensed statically. Throws as condensed_frame.
///
/// @param tile  its first `interface_nodes` nodes are the interface nodes
std::shared_ptr<const TileStructure> corotational_tile(mechanics::Frame tile, int interface_nodes);

/// A tile that moves the same way, of a stiffness that is given: that of a tile model of one's own, say. Its
/// beams are not known, so it has no beam motion. Throws as CorotationalBody.
std::shared_ptr<const TileStructure> corotational_tile(mechanics::CorotationalBody::Parts parts);

/// The row of the catalogue: nothing is fitted, and congruent tiles are condensed once.
TileModel corotational_tile_model();

}  // namespace fretwork::reduction
