// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/quotient.hpp>

namespace fretwork::pattern::detail {

Quotient::Quotient(const NodeLayout& layout) {
    for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
        const Region region = layout.nodes()[i].region;
        if (region == Region::RightRadial) {
            places_.push_back({place(layout.left_partner(LayoutNodeIndex(i))).orbit, 1});
            continue;
        }
        if (region == Region::Center) center_ = orbit_count_;
        if (region == Region::Interface) interface_orbits_ |= std::uint64_t{1} << orbit_count_;
        places_.push_back({orbit_count_++, 0});
    }
    for (const Edge& edge : layout.candidate_edges()) {
        const Place& first = place(edge.first);
        const Place& second = place(edge.second);
        links_.push_back({first.orbit, second.orbit, second.shift - first.shift});
    }
}

}  // namespace fretwork::pattern::detail
