// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/fan.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fretwork::pattern {
namespace THIS_TEST {

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

Fan paper7_fan(const char* id, int sides = 6) {
    return make_fan(paper7(), parse_pattern_id(paper7(), id), sides);
}

TEST(Fan, StarHasOneBeamInEachSector) {
    const Fan fan = paper7_fan("0-6");
    EXPECT_EQ(fan.nodes.size(), 7u);
    EXPECT_EQ(fan.edges.size(), 6u);
    EXPECT_EQ(fan.interface_node_count, 6);
    for (int t = 0; t < 6; ++t) EXPECT_EQ(fan.edges[t], (std::array{FanNodeIndex(t), FanNodeIndex(6)}));
}

TEST(Fan, EveryEdgeIsRepeatedOncePerSectorInEveryPolygon) {
    for (const char* id : {"0-6", "0-1+1-6", "1-2+2-4+4-6+2-6", "0-1+1-3+3-5+5-6", "1-3+1-6+3-6"}) {
        const int edge_count = parse_pattern_id(paper7(), id).edge_count();
        for (int sides = 3; sides < 9; ++sides) {
            const Fan fan = paper7_fan(id, sides);
            EXPECT_EQ(fan.edges.size(), static_cast<std::size_t>(edge_count * sides)) << id;
            EXPECT_TRUE(std::is_sorted(fan.edges.begin(), fan.edges.end()));
            for (const auto& [first, second] : fan.edges) EXPECT_LT(first, second);
        }
    }
}

TEST(Fan, InterfaceNodesComeFirstUsedOrNot) {
    NodeLayoutDescription description = paper7().description();
    description.interface = {Rational(1, 4), Rational(1, 2), Rational(3, 4)};
    const NodeLayout layout(description);
    const Fan fan = make_fan(layout, parse_pattern_id(layout, "0-6"), 5);
    EXPECT_EQ(fan.interface_node_count, 15);
    for (int t = 0; t < 5; ++t) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(fan.nodes[static_cast<std::size_t>(3 * t + k)], (Fan::Node{LayoutNodeIndex(6 + k), t}));
        }
    }
    EXPECT_EQ(fan.nodes.size(), 16u);
}

TEST(Fan, InnerNodesAreOrderedByLayoutNodeThenSector) {
    const Fan fan = paper7_fan("0-1+1-5+5-6+2-6");
    const auto key = [](const Fan::Node& node) { return std::pair<int, int>(node.layout_node, node.sector); };
    EXPECT_TRUE(std::is_sorted(fan.nodes.begin() + fan.interface_node_count, fan.nodes.end(),
                               [&](const auto& a, const auto& b) { return key(a) < key(b); }));
}

// The paper, Fig. 4: radial nodes of neighbouring sectors are one node.
TEST(Fan, NeighbouringSectorsShareTheirRadialNodes) {
    const Fan fan = paper7_fan("1-3+1-6");
    EXPECT_EQ(fan.nodes.size(), 12u);  // 6 interface nodes and a ring of 6
    for (const Fan::Node& node : fan.nodes)
        EXPECT_NE(paper7().nodes()[node.layout_node].region, Region::RightRadial);
    // The ring's edge of sector t joins node 1 of sector t with node 1 of sector t + 1.
    for (int t = 0; t < 6; ++t) {
        const FanNodeIndex a(6 + t);
        const FanNodeIndex b(6 + (t + 1) % 6);
        const std::array edge{std::min(a, b), std::max(a, b)};
        EXPECT_TRUE(std::binary_search(fan.edges.begin(), fan.edges.end(), edge));
    }
}

// The paper, Fig. 5: node 3 of one sector is node 1 of the next, so a beam may be drawn from either side.
TEST(Fan, ABeamToTheRightRadialNodeEndsAtTheNextSectorsLeftOne) {
    const Fan fan = paper7_fan("3-6");
    for (const auto& [first, second] : fan.edges) {
        const Fan::Node& outer = fan.nodes[first];
        const Fan::Node& inner = fan.nodes[second];
        EXPECT_EQ(inner, (Fan::Node{LayoutNodeIndex(1), (outer.sector + 1) % 6}));
    }
}

TEST(Fan, HasFromThreeToTenThousandSectors) {
    for (const int sides : {-1, 2, geometry::kMostPolygonSides + 1, std::numeric_limits<int>::max()})
        EXPECT_THROW(paper7_fan("0-6", sides), base::InputError) << sides;
    EXPECT_EQ(paper7_fan("0-6", geometry::kMostPolygonSides).edges.size(), 10'000U);
}

TEST(PlaceFan, CommutesWithAffineMaps) {
    const Fan fan = paper7_fan("0-1+1-5+5-6+2-6+4-6");
    const geometry::Polygon hexagon = geometry::regular_polygon(6, 0.026);
    const auto affine = [](const geometry::Point2& p) {
        return geometry::Point2{1.7 * p.x - 0.4 * p.y + 0.3, 0.2 * p.x + 0.8 * p.y - 1.1};
    };
    geometry::Polygon image;
    for (const geometry::Point2& vertex : hexagon) image.push_back(affine(vertex));
    const std::vector<geometry::Point2> places = place_fan(paper7(), fan, hexagon);
    const std::vector<geometry::Point2> images = place_fan(paper7(), fan, image);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(images[i].x, affine(places[i]).x, 1e-15);
        EXPECT_NEAR(images[i].y, affine(places[i]).y, 1e-15);
    }
}

TEST(PlaceFan, RotationByOneSectorMapsTheRegularFanOntoItself) {
    const Fan fan = paper7_fan("0-1+1-5+5-6+2-6+4-6");
    const std::vector<geometry::Point2> places =
        place_fan(paper7(), fan, geometry::regular_polygon(6, 0.026));
    const double c = 0.5;
    const double s = std::sqrt(3.0) / 2;
    for (const geometry::Point2& p : places) {
        const geometry::Point2 rotated{c * p.x - s * p.y, s * p.x + c * p.y};
        const bool found = std::any_of(places.begin(), places.end(), [&](const geometry::Point2& q) {
            return std::hypot(q.x - rotated.x, q.y - rotated.y) < 1e-15;
        });
        EXPECT_TRUE(found);
    }
}

TEST(PlaceFan, InterfaceNodesLieOnTheSidesAsTheLayoutSays) {
    const geometry::Polygon quad = {{0, 0}, {3, 0}, {2, 2}, {0, 1}};
    const Fan fan = paper7_fan("0-6", 4);
    const std::vector<geometry::Point2> places = place_fan(paper7(), fan, quad);
    EXPECT_EQ(places[0], (geometry::Point2{1.5, 0}));
    EXPECT_EQ(places[1], (geometry::Point2{2.5, 1}));
    const geometry::Point2 center = centroid(quad);
    EXPECT_EQ(places[4], center);
}

TEST(PlaceFan, AStraightCornerMayBendInwardsByRounding) {
    const Fan fan = paper7_fan("0-6", 5);
    EXPECT_EQ(place_fan(paper7(), fan, {{0, 0}, {1, 1e-17}, {2, 0}, {2, 2}, {0, 2}}).size(),
              fan.nodes.size());
}

TEST(PlaceFan, RefusesPolygonsThatDoNotFit) {
    const Fan fan = paper7_fan("0-6", 4);
    EXPECT_THROW(place_fan(paper7(), fan, geometry::regular_polygon(5, 1.0)), base::InputError);
    EXPECT_THROW(place_fan(paper7(), fan, {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}), base::GeometryError);
    EXPECT_THROW(place_fan(paper7(), fan, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}), base::GeometryError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
