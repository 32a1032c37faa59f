// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/quotient.hpp>
#include <fretwork/pattern/search/word.hpp>

#include <array>
#include <cstdint>

namespace fretwork::pattern::detail {

/// A test of the graph rules on the quotient of the fan by its rotations, with bit sets of orbits.
/// detail/fan_graph.hpp defines the graph rules by Boost.Graph on the fan itself. The tests compare both
/// implementations on every graph of five layouts.
///
/// The quotient suffices for the following reasons. A "root" is the center, or the outside node that connects
/// all interface nodes. Rotations of the fan leave roots in place.
/// - A connected part of the quotient lifts to one component if it has a root. A connected part without a
///   root lifts to gcd(gains of its cycles, 6) components.
/// - Let v be a node other than the center. The piece that the removal of v cuts off contains no other copy
///   of v. Proof for a component with a root: a path from one copy to the root through another copy could be
///   rotated again and again, and would never end. Proof for a component with several copies of v but no
///   root: rotations fix a block of the component's block tree, and all copies are equally far from that
///   block. So the piece is a lifted component of the quotient without v's orbit. The piece has no root, and
///   all its links to that orbit end at the single copy v.
/// - The center is an articulation point if its component falls into several lifted components when the
///   center is removed.
class Connectivity {
  public:
    explicit Connectivity(const Quotient& quotient) : quotient_(&quotient) {}

    /// Set the graph, as a set of candidate edges, for the two functions below.
    template <class Word>
    void choose(Word edges) {
        used_ = 0;
        link_count_ = 0;
        for_each_bit(edges, [&](int edge) { add(quotient_->link(EdgeIndex(edge))); });
    }

    /// True if the fan without its unused nodes has one component, or if the fan has no edge.
    [[nodiscard]] bool is_connected() const;
    /// True if a node of the fan is an articulation point when a further node outside is connected to all
    /// interface nodes.
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
