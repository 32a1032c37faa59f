// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace fretwork::pattern::detail {

/// The reference fan divided by its rotations. It has one node for each orbit of fan nodes (a node and its
/// rotated copies), and one edge for each candidate edge. The gain of an edge is the number of sectors by
/// which the edge advances.
///
/// The fan is the covering graph of the quotient: node (orbit, sector) is connected to (orbit', sector +
/// gain). The center is the only node that is a whole orbit.
class Quotient {
  public:
    /// A node of the layout in sector 0, as an orbit and a shift by sectors.
    struct Place {
        int orbit = 0;
        int shift = 0;  ///< 1 on the right radial side, which is the next sector's left one
    };
    struct Link {
        int first = 0;
        int second = 0;
        int gain = 0;  ///< sectors from the first node to the second
    };

    explicit Quotient(const NodeLayout& layout);

    [[nodiscard]] int orbit_count() const { return orbit_count_; }
    /// The orbit of the center, or -1.
    [[nodiscard]] int center() const { return center_; }
    /// The orbits of the interface nodes, as a bit set.
    [[nodiscard]] std::uint64_t interface_orbits() const { return interface_orbits_; }
    [[nodiscard]] const Place& place(LayoutNodeIndex node) const { return places_[node]; }
    [[nodiscard]] const Link& link(EdgeIndex edge) const { return links_[edge]; }
    [[nodiscard]] std::span<const Link> links() const { return links_; }

  private:
    int orbit_count_ = 0;
    int center_ = -1;
    std::uint64_t interface_orbits_ = 0;
    base::IndexVector<LayoutNodeIndex, Place> places_;
    base::IndexVector<EdgeIndex, Link> links_;
};

}  // namespace fretwork::pattern::detail
