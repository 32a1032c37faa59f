// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/fan.hpp>

#include <vector>

namespace fretwork::pattern::detail {

// Connectivity of the fan itself, by Boost.Graph: the definition of the graph rules, and the reference for
// the faster test that the search uses.

/// The way in which neighbouring tiles connect a fan's interface nodes: in a ring around the polygon, or all
/// to one hub that is not a node of the fan. Both ways give the same articulation points among the fan's
/// nodes.
enum class Outside { Ring, Hub };

/// The component of each fan node; -1 for interface nodes that no beam uses.
struct FanComponents {
    int count = 0;
    base::IndexVector<FanNodeIndex, int> of_node;
};
FanComponents fan_components(const Fan& fan);

/// The articulation points of the fan with its outside, ascending.
std::vector<FanNodeIndex> articulation_nodes(const Fan& fan, Outside outside = Outside::Ring);

/// The beams (positions in Fan::edges) that share no block (biconnected component) with the outside. They
/// hang on one articulation point, or are not connected to the outside at all, and bear no load.
std::vector<std::size_t> dangling_beams(const Fan& fan);

}  // namespace fretwork::pattern::detail
