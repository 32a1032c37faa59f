// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/pattern/node_layout.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace fretwork::pattern {
namespace THIS_TEST {

using ::testing::AllOf;
using ::testing::HasSubstr;

NodeLayoutDescription paper7_description() {
    return find_node_layout("paper7").description();
}

/// The message that refuses a layout with one mistake.
std::string refusal(const std::function<void(NodeLayoutDescription&)>& spoil) {
    NodeLayoutDescription description = paper7_description();
    spoil(description);
    try {
        const NodeLayout layout(description);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// The message that refuses a layout file with this text.
std::string file_refusal(const std::string& text) {
    const test::TemporaryFolder folder;
    try {
        read_node_layout(folder.file("layout.json", text));
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "accepted";
}

// The paper, Section 4.2: all 21 pairs of the 7 nodes but 0-3, 0-4, 3-4 (right radial side) and 0-2 (through
// 1).
TEST(Paper7, HasTheSeventeenCandidateEdgesOfThePaper) {
    const NodeLayout layout = find_node_layout("paper7");
    ASSERT_EQ(layout.nodes().size(), 7u);
    std::vector<std::pair<int, int>> edges;
    for (const Edge& edge : layout.candidate_edges()) edges.emplace_back(edge.first, edge.second);
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 7; ++i) {
        for (int j = i + 1; j < 7; ++j) {
            const std::pair<int, int> edge{i, j};
            if (edge != std::pair{0, 3} && edge != std::pair{0, 4} && edge != std::pair{3, 4} &&
                edge != std::pair{0, 2})
                expected.push_back(edge);
        }
    }
    EXPECT_EQ(edges, expected);
}

TEST(Paper7, NumbersItsNodesAsThePaperDoes) {
    const NodeLayout layout = find_node_layout("paper7");
    const std::array regions = {Region::Center,      Region::LeftRadial,  Region::LeftRadial,
                                Region::RightRadial, Region::RightRadial, Region::Face,
                                Region::Interface};
    for (std::size_t i = 0; i < regions.size(); ++i) EXPECT_EQ(layout.nodes()[i].region, regions[i]) << i;
    EXPECT_EQ(layout.left_partner(LayoutNodeIndex(3)), LayoutNodeIndex(1));
    EXPECT_EQ(layout.left_partner(LayoutNodeIndex(4)), LayoutNodeIndex(2));
    EXPECT_EQ(layout.left_partner(LayoutNodeIndex(5)), LayoutNodeIndex(5));
    EXPECT_EQ(layout.nodes()[5].place[1], Rational(9, 20));
}

TEST(NodeLayout, CoordinatesOfEveryNodeSumToOne) {
    for (const std::string& name : layout_names()) {
        const NodeLayout layout = find_node_layout(name);
        EXPECT_EQ(layout.name(), name);
        for (const LayoutNode& node : layout.nodes())
            EXPECT_EQ(node.place[0] + node.place[1] + node.place[2], Rational(1));
    }
}

TEST(NodeLayout, WithoutCenterNumberingStartsAtTheRadialNodes) {
    NodeLayoutDescription description = paper7_description();
    description.center = false;
    const NodeLayout layout(description);
    EXPECT_EQ(layout.nodes().size(), 6u);
    EXPECT_EQ(layout.nodes()[0].region, Region::LeftRadial);
    EXPECT_EQ(layout.interface_nodes(), std::vector{LayoutNodeIndex(5)});
}

TEST(NodeLayout, EdgesAlongTheInterfaceSideAreNoCandidates) {
    NodeLayoutDescription description = paper7_description();
    description.interface = {Rational(1, 3), Rational(2, 3)};
    const NodeLayout layout(description);
    for (const Edge& edge : layout.candidate_edges())
        EXPECT_FALSE(edge.first == LayoutNodeIndex(6) && edge.second == LayoutNodeIndex(7));
}

// The middle of n1 n4 is on no other line of the layout: a node there takes exactly that edge away.
TEST(NodeLayout, AnEdgeThroughANodeIsNoCandidate) {
    NodeLayoutDescription description = paper7_description();
    description.face = {{Rational(1, 2), Rational(1, 6), Rational(1, 3)}};
    const NodeLayout layout(description);
    for (const Edge& edge : layout.candidate_edges())
        EXPECT_FALSE(edge.first == LayoutNodeIndex(1) && edge.second == LayoutNodeIndex(4));
}

TEST(BadLayout, RadialNodeAtAnEndIsRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.radial = {Rational(1, 3), Rational(1)};
                }),
                AllOf(HasSubstr("/radial/1"), HasSubstr("node n2"), HasSubstr("strictly between 0 and 1")));
}

TEST(BadLayout, RadialNodesOutOfOrderAreRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.radial = {Rational(2, 3), Rational(1, 3)};
                }),
                AllOf(HasSubstr("node n2 at 1/3"), HasSubstr("ascend")));
}

TEST(BadLayout, RadialNodesAtOnePlaceAreRefused) {
    EXPECT_THAT(refusal([](auto& d) { d.radial = {Rational(1, 3), Rational(1, 3)}; }), HasSubstr("coincide"));
}

TEST(BadLayout, FaceNodeOutsideTheTriangleIsRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.face = {{Rational(7, 10), Rational(-1, 10), Rational(4, 10)}};
                }),
                AllOf(HasSubstr("node n5"), HasSubstr("inside the base triangle"), HasSubstr("-1/10")));
}

TEST(BadLayout, FaceNodeOnASideIsRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.face = {{Rational(1, 2), Rational(1, 2), Rational(0)}};
                }),
                AllOf(HasSubstr("node n5"), HasSubstr("'radial' and 'interface'")));
}

TEST(BadLayout, FaceCoordinatesThatDoNotSumToOneAreRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.face = {{Rational(3, 10), Rational(9, 20), Rational(3, 10)}};
                }),
                AllOf(HasSubstr("node n5"), HasSubstr("sum 21/20 instead of 1")));
}

TEST(BadLayout, TwoFaceNodesAtOnePlaceAreRefused) {
    EXPECT_THAT(refusal([](auto& d) { d.face.push_back(d.face.front()); }),
                AllOf(HasSubstr("node n6"), HasSubstr("node n5 already is")));
}

TEST(BadLayout, UnsymmetricInterfaceNodesAreRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.interface = {Rational(1, 3), Rational(1, 2)};
                }),
                AllOf(HasSubstr("/interface/0"), HasSubstr("node n6 at 1/3 has no twin at 2/3")));
}

TEST(BadLayout, NoInterfaceNodeIsRefused) {
    EXPECT_THAT(refusal([](auto& d) { d.interface.clear(); }), HasSubstr("no interface node"));
}

TEST(BadLayout, CornersAreRefusedAsNotSupportedYet) {
    EXPECT_THAT(refusal([](auto& d) { d.corners = true; }),
                AllOf(HasSubstr("/corners"), HasSubstr("not supported yet")));
}

TEST(BadLayout, TooManyCandidateEdgesAreRefused) {
    EXPECT_THAT(refusal([](auto& d) {
                    d.radial.clear();
                    for (int i = 1; i < 13; ++i) d.radial.emplace_back(i, 13);
                }),
                HasSubstr("1 to 128 are possible"));
}

TEST(BadLayout, NamesThatCouldNotStandBeforeAPatternIdAreRefused) {
    EXPECT_THAT(refusal([](auto& d) { d.name = "a:b"; }), HasSubstr("/name"));
    EXPECT_THAT(refusal([](auto& d) { d.name = ""; }), HasSubstr("/name"));
}

TEST(BadLayout, DenominatorsBeyondAMillionAreRefused) {
    EXPECT_THAT(refusal([](auto& d) { d.radial[0] = Rational(1, 1'000'001); }),
                AllOf(HasSubstr("node n1"), HasSubstr("1000000")));
}

TEST(BadLayoutFile, MissingFileIsRefused) {
    EXPECT_THROW(read_node_layout("no/such/layout.json"), base::InputError);
}

TEST(BadLayoutFile, EveryFaultNamesFileAndPlace) {
    const std::string head = R"({"format": "fretwork/layout/1", "name": "x", )";
    EXPECT_THAT(file_refusal(head + R"("interface": ["1/2"], "radia": [] })"),
                AllOf(HasSubstr(".json: /radia"), HasSubstr("did you mean 'radial'")));
    EXPECT_THAT(file_refusal(head + R"("interface": ["1/2", )"), HasSubstr("malformed JSON"));
    EXPECT_THAT(file_refusal(head + R"("interface": [NaN] })"), HasSubstr("malformed JSON"));
    EXPECT_THAT(file_refusal(head + R"("interface": [0.5] })"), HasSubstr("/interface/0"));
    EXPECT_THAT(file_refusal(head + R"("interface": ["1/0"] })"),
                AllOf(HasSubstr("/interface/0"), HasSubstr("1/0")));
    EXPECT_THAT(file_refusal(head + R"("interface": ["1/2"], "face": [["1/3", "2/3"]] })"),
                HasSubstr("/face/0"));
    EXPECT_THAT(file_refusal(head + R"("radial": [] })"), HasSubstr("interface"));
    EXPECT_THAT(file_refusal(R"({"format": "fretwork/frame/1", "name": "x", "interface": ["1/2"]})"),
                HasSubstr("/format"));
    EXPECT_THAT(file_refusal(head + R"("interface": ["1/2"], "face": [["1/3", "1/3", "1/2"]] })"),
                AllOf(HasSubstr(".json: /face/0: node n1"), HasSubstr("7/6")));
    EXPECT_THAT(file_refusal(""), HasSubstr("malformed JSON"));
    EXPECT_THAT(file_refusal(head + R"("center": false, "interface": ["1/2"]})"),
                AllOf(HasSubstr(".json: /: layout 'x': "), HasSubstr("0 candidate edges")));
}

TEST(NodeLayout, IsEqualIfItsTextIs) {
    const NodeLayout& paper = paper_layout();
    EXPECT_EQ(parse_node_layout(node_layout_text(paper), "copy"), paper);
    NodeLayoutDescription other = paper.description();
    other.name = "other";
    EXPECT_NE(NodeLayout(other), paper) << "libraries and results name their layout";
    other = paper.description();
    other.interface = {Rational(1, 3), Rational(2, 3)};
    EXPECT_NE(NodeLayout(other), paper);
}

TEST(BadLayoutFile, AnUnknownNameListsTheKnownOnes) {
    try {
        find_node_layout("papr7");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean 'paper7'"));
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
