// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/tiling/tessellation.hpp>

#include <functional>
#include <limits>

namespace fretwork::tiling {
namespace THIS_TEST {

using test::complaint_of;
using testing::HasSubstr;

/// Two unit squares side by side, with one interface node in the middle of each side.
Tessellation two_squares() {
    Tessellation two;
    two.layout = "paper7";
    two.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
    two.interface_nodes = {{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {1.5, 0}, {2, 0.5}, {1.5, 1}};
    const auto tile = [](std::vector<int> vertices, std::vector<int> nodes) {
        Tile made;
        for (const int v : vertices) made.vertices.emplace_back(v);
        for (const int n : nodes) made.interface_nodes.emplace_back(n);
        return made;
    };
    two.tiles = {tile({0, 1, 2, 3}, {0, 1, 2, 3}), tile({1, 4, 5, 2}, {4, 5, 6, 1})};
    return two;
}

std::string complaint_after(const std::function<void(Tessellation&)>& spoil) {
    Tessellation tessellation = two_squares();
    spoil(tessellation);
    return complaint_of([&] { validate(tessellation, pattern::find_node_layout("paper7")); });
}

TEST(TessellationCheck, ASoundTessellationPasses) {
    EXPECT_NO_THROW(validate(two_squares(), pattern::find_node_layout("paper7")));
}

TEST(TessellationCheck, EachFlawNamesItsTile) {
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.layout = "other"; }), HasSubstr("'other'"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[1].vertices[2] = VertexIndex(6); }),
                HasSubstr("tile 1 names the vertex 6, and there are 6"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[0].interface_nodes[0] = InterfaceIndex(-1); }),
                HasSubstr("tile 0 names the interface node -1"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[1].pattern = 0; }),
                HasSubstr("tile 1 names the pattern 0"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.patterns = {{"0-99"}}; }), HasSubstr("0-99"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[0].interface_nodes.pop_back(); }),
                HasSubstr("tile 0 has 3 interface nodes, where 4"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[0].vertices.resize(2); }),
                HasSubstr("tile 0 has 2 vertices"));
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.vertices[5] = {1.4, 0.4};
                }),
                HasSubstr("tile 1 is not convex"));
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.interface_nodes[6] = {1.5, 1.01};
                }),
                HasSubstr("tile 1 has the interface node 6 away from its place"));
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.interface_nodes.push_back({1, 0.5});
                    t.tiles[1].interface_nodes[3] = InterfaceIndex(7);
                }),
                HasSubstr("tile 1 and tile 0 share a side and do not agree"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles[1] = t.tiles[0]; }),
                HasSubstr("same direction as tile 0"));
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.interface_nodes.push_back({5, 5});
                }),
                HasSubstr("interface node 7 is on no tile"));
    EXPECT_THAT(
        complaint_after([](Tessellation& t) { t.vertices[3].x = std::numeric_limits<double>::infinity(); }),
        HasSubstr("vertex 3 is (inf, "));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.interface_nodes[2].y = -1e13; }),
                HasSubstr(", -1e+13), where each coordinate must be"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.tiles = {}; }),
                HasSubstr("the tessellation has no tiles"));
}

TEST(TessellationCheck, AStraightCornerMayBendInwardsByRounding) {
    const auto bent = [](double by) {
        return [by](Tessellation& t) {  // the first square gets a vertex on its lower side
            t.vertices.push_back({0.5, by});
            t.tiles[0].vertices.insert(t.tiles[0].vertices.begin() + 1, VertexIndex(6));
            t.interface_nodes[0] = {0.25, 0.5 * by};
            t.interface_nodes.push_back({0.75, 0.5 * by});
            t.tiles[0].interface_nodes.insert(t.tiles[0].interface_nodes.begin() + 1, InterfaceIndex(7));
        };
    };
    for (const double by : {0.0, 1e-17, 1e-6}) {
        Tessellation tessellation = two_squares();
        bent(by)(tessellation);
        EXPECT_NO_THROW(validate(tessellation, pattern::find_node_layout("paper7"))) << by;
    }
    EXPECT_THAT(
        complaint_after(bent(0.01)),
        HasSubstr("tile 0 is not convex and counterclockwise: it bends inwards at (0.5, 0.01) by 0.01 m"));
}

TEST(TessellationCheck, NothingIsThereTwiceOrForNothing) {
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.vertices.push_back({5, 5});
                }),
                HasSubstr("vertex 6 is on no tile"));
    EXPECT_THAT(complaint_after([](Tessellation& t) {
                    t.patterns = pattern::parse_named_patterns(
                        pattern::paper_layout(), std::vector<std::string>{"0-1+1-6", "0-5+5-6", "1-6+0-1"});
                }),
                HasSubstr("pattern 2 is pattern 0 again: '0-1+1-6'"));
    EXPECT_THAT(complaint_after([](Tessellation& t) { t.patterns = {{"0-1+1-6"}}; }),
                HasSubstr("pattern 0 is not the one that its id '0-1+1-6' names"));
}

TEST(TessellationCheck, AnInterfaceNodeIsOnOneSideOnly) {
    const std::string message = complaint_after([](Tessellation& t) {
        // The second square moves onto the first, with vertices of its own.
        t.vertices.insert(t.vertices.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        t.tiles[1].vertices = {VertexIndex(6), VertexIndex(7), VertexIndex(8), VertexIndex(9)};
        t.tiles[1].interface_nodes = t.tiles[0].interface_nodes;
    });
    EXPECT_THAT(message, HasSubstr("which is on another side"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
