// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/small_layouts.hpp"

#include <fretwork/pattern/detail/fan_graph.hpp>
#include <fretwork/pattern/search/connectivity.hpp>

#include <gtest/gtest.h>

namespace fretwork::pattern {
namespace THIS_TEST {

using detail::Connectivity;
using detail::Outside;
using detail::Quotient;
using detail::Word64;

/// Call check(graph, fan, connectivity) for every graph of every small layout.
template <class Check>
void for_every_graph(const Check& check) {
    for (const NodeLayout& layout : small_layouts()) {
        const Quotient quotient(layout);
        Connectivity connectivity(quotient);
        ASSERT_LE(layout.candidate_edges().size(), 20u);
        for (Word64 graph = 1; graph < Word64{1} << layout.candidate_edges().size(); ++graph) {
            const Pattern pattern = detail::to_pattern(graph);
            connectivity.choose(graph);
            check(layout.name() + ":" + pattern_id(layout, pattern), make_fan(layout, pattern, 6),
                  connectivity);
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(Connectivity, EqualsBoostsComponentsOnEveryGraphOfSmallLayouts) {
    for_every_graph([](const std::string& id, const Fan& fan, const Connectivity& connectivity) {
        EXPECT_EQ(connectivity.is_connected(), detail::fan_components(fan).count == 1) << id;
    });
}

TEST(Connectivity, EqualsBoostsArticulationPointsOnEveryGraphOfSmallLayouts) {
    for_every_graph([](const std::string& id, const Fan& fan, const Connectivity& connectivity) {
        EXPECT_EQ(connectivity.has_articulation(), !detail::articulation_nodes(fan, Outside::Ring).empty())
            << id;
    });
}

TEST(FanGraph, RingAndHubHaveTheSameArticulationPoints) {
    for_every_graph([](const std::string& id, const Fan& fan, const Connectivity&) {
        EXPECT_EQ(detail::articulation_nodes(fan, Outside::Ring).empty(),
                  detail::articulation_nodes(fan, Outside::Hub).empty())
            << id;
    });
}

// By hand: two rungs that each join a radial node with the one two sectors on make two triangles in a
// hexagon.
TEST(FanGraph, CountsComponentsOfUsedNodesOnly) {
    const NodeLayout layout = find_node_layout("paper7");
    const auto components = [&](const char* id) {
        return detail::fan_components(make_fan(layout, parse_pattern_id(layout, id), 6)).count;
    };
    EXPECT_EQ(components("0-6"), 1);
    EXPECT_EQ(components("1-6"), 6);
    EXPECT_EQ(components("1-3"), 1);
    EXPECT_EQ(components("1-3+2-6"), 7);
    EXPECT_EQ(components("1-4+2-6"), 6);
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
