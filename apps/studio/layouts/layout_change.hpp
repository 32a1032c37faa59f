// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace fretwork::studio {

/// The options of changes by hand: the grid on which nodes lie, and the nodes that move along.
struct LayoutHand {
    /// Nodes lie at multiples of 1 / steps: shares of a side, or barycentric coordinates.
    std::int64_t steps = 60;
    /// True: a face node takes its mirror image along, if that is a node, too. Radial and interface nodes
    /// always have their twins.
    bool keeps_mirror = true;
    /// The finest grid; layout files take no finer places.
    static constexpr std::int64_t kMostSteps = 1'000'000;
};

/// A change of a layout by hand. A place has barycentric coordinates for (v0, v1, v2); it need not lie in the
/// base triangle, nor on the grid.
struct LayoutChange {
    using Place = std::array<double, 3>;
    enum class Kind { Move, Add, Remove };
    Kind kind = Kind::Move;
    pattern::LayoutNodeIndex node{};                   ///< the node that is moved or removed
    pattern::Region region = pattern::Region::Center;  ///< of the node that is added
    std::optional<Place> to{};  ///< new place; none: an added node goes where there is most room
};

/// A layout after a change.
struct ChangedLayout {
    pattern::NodeLayout layout;
    std::optional<pattern::LayoutNodeIndex> node{};  ///< the one that was moved or added
};

/// The nodes at the mirror image of a node: its partner on the other radial side, the interface node across
/// the middle of the side, or the mirror image of a face node.
std::vector<pattern::LayoutNodeIndex> twins_of(const pattern::NodeLayout& layout,
                                               pattern::LayoutNodeIndex node);

/// Change a layout. A node stays in its region, and between its neighbours on a side; twins move with their
/// node, and are removed with it. Throws InputError that names node and rule if the result is no valid
/// layout.
ChangedLayout changed(const pattern::NodeLayout& layout, const LayoutChange& change, const LayoutHand& hand);

}  // namespace fretwork::studio
