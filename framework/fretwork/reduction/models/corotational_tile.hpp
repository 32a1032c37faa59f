// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// A tile that may move and turn by any amount, with axes that follow it. Its condensed stiffness resists
/// motions of the interface nodes relative to these axes (mechanics/corotational_element.hpp). The mass of
/// the tile is the mass of its beams, condensed statically. Throws as condensed_frame() and CorotationalBody,
/// and NumericalError if the bars are too thin for their length to be condensed.
///
/// @param tile  the tile's beams; the first `interface_nodes` nodes are the interface nodes
std::shared_ptr<const TileStructure> corotational_tile(mechanics::Frame tile, int interface_nodes);

/// A corotational tile with a given stiffness, for a tile model of the caller's own. Its beams are unknown,
/// so it has no beam motion. Throws as CorotationalBody.
std::shared_ptr<const TileStructure> corotational_tile(mechanics::CorotationalBody::Parts parts);

/// The row `corotational` of the catalogue. The model has no parameters, and congruent tiles are condensed
/// once.
TileModel corotational_tile_model();

}  // namespace fretwork::reduction
