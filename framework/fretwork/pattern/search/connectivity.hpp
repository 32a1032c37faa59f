// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/quotient.hpp>
#include <fretwork/pattern/search/word.hpp>

#include <array>
#include <cstdint>

namespace fretwork::pattern::detail {

/// Decides the graph rules on the quotient of the fan by its rotations, with bit sets of orbits.
/// detail/fan_graph.hpp defines the same rules by Boost.Graph on the fan itself. The tests compare the two on
/// every graph of three layouts.
///
/// The quotient is enough, for these reasons. A "root" is the center, or the node outside that connects all
/// interface nodes; a rotation of the fan leaves both in place.
/// - A connected part of the quotient lifts to one component if it has a root, else to gcd(gains of its
///   cycles, 6) components.
/// - Let v be a node other than the center. The piece that its removal cuts off holds no other copy of v.
/// First, if the component has a root: a path from one copy to the root through another copy could be rotated
/// without end. Second, if it has no root but several copies of v: rotations fix a block of its block tree,
/// and all copies are equally far from that block. So the piece is a lifted component of the quotient without
/// v's orbit. It has no root, and all its links to that orbit end at the single copy v.
/// - The center is an articulation point if its component without it falls into several lifted components.
class Connectivity {
  public:
    explicit Connectivity(const Quotient& quotient) : quotient_(&quotient) {}

    /// Set the graph, as a set of candidate edges, that the functions below decide on.
    template <class Word>
    void choose(Word edges) {
        used_ = 0;
        link_count_ = 0;
        for_each_bit(edges, [&](int edge) { add(quotient_->link(EdgeIndex(edge))); });
    }

    /// True if the fan without its unused nodes has one component, or no edge.
    [[nodiscard]] bool is_connected() const;
    /// True if the fan has an articulation point when a further node outside connects all interface nodes.
    [[nodiscard]] bool has_articulation() const;

  private:
    using Orbits = std::uint64_t;

    void add(const Quotient::Link& link) {
        for (const int orbit : {link.first, link.second}) {
            const Orbits bit = Orbits{1} << orbit;
            if ((used_ & bit) == 0) neighbours_[orbit] = 0;
            used_ |= bit;
        }
        neighbours_[link.first] |= Orbits{1} << link.second;
        neighbours_[link.second] |= Orbits{1} << link.first;
        links_[link_count_++] = link;
    }
    [[nodiscard]] Orbits center_bit() const {
        return quotient_->center() < 0 ? Orbits{0} : Orbits{1} << quotient_->center();
    }
    [[nodiscard]] Orbits roots() const { return center_bit() | quotient_->interface_orbits(); }

    [[nodiscard]] Orbits flood(Orbits seeds, Orbits within) const;
    [[nodiscard]] Orbits flood_with_outside(Orbits seeds, Orbits within) const;
    [[nodiscard]] int lifted_components(Orbits part) const;
    [[nodiscard]] bool center_is_articulation(Orbits component) const;
    [[nodiscard]] bool orbit_is_articulation(int orbit, Orbits component) const;
    [[nodiscard]] bool hangs_on_one_copy(Orbits part, int orbit) const;

    const Quotient* quotient_;
    Orbits used_ = 0;
    int link_count_ = 0;
    std::array<Orbits, 64> neighbours_{};
    std::array<Quotient::Link, kMaxCandidateEdges> links_{};
};

}  // namespace fretwork::pattern::detail
