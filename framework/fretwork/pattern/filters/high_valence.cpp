// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/quotient.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <cmath>

namespace fretwork::pattern::filters {
namespace {

using detail::Quotient;

/// The number of beams that one candidate edge, repeated over the fan, adds at a node of an orbit. At the
/// center, all copies of the edge meet. An interface node counts double, because the neighbouring tile adds
/// the same number.
int ends_at(const Quotient& quotient, const Quotient::Link& link, int orbit) {
    const int ends = (link.first == orbit ? 1 : 0) + (link.second == orbit ? 1 : 0);
    if (orbit == quotient.center()) return ends * kReferenceSides;
    const bool is_interface = (quotient.interface_orbits() >> orbit & 1) != 0;
    return is_interface ? 2 * ends : ends;
}

}  // namespace

// Paper, Section 4.2, "Fabrication constraints".
Rule make_high_valence(const NodeLayout& layout, double value, const FabricationScale&) {
    constexpr double kMost = 1000.0;
    if (!(value >= 1.0 && value <= kMost) || value != std::floor(value)) {
        throw base::InputError("the largest valence is a whole number from 1 to 1000, and " +
                               base::format_number(value) + " was given");
    }
    const Quotient quotient(layout);
    CapacityRule rule{{}, static_cast<int>(value), "valence"};
    for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
        if (layout.nodes()[i].region == Region::RightRadial) continue;
        CapacityRule::Resource node{"node n" + std::to_string(i), {}};
        const int orbit = quotient.place(LayoutNodeIndex(i)).orbit;
        for (const Quotient::Link& link : quotient.links())
            node.loads.push_back(ends_at(quotient, link, orbit));
        rule.resources.push_back(std::move(node));
    }
    return rule;
}

}  // namespace fretwork::pattern::filters
