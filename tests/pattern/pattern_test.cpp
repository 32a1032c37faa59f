// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace fretwork::pattern {
namespace THIS_TEST {

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

TEST(PatternId, RoundTripsForEveryGraphOfThePaper) {
    for (unsigned graph = 1; graph < (1u << 17); ++graph) {
        const Pattern pattern{Pattern::Bits(graph)};
        ASSERT_EQ(parse_pattern_id(paper7(), pattern_id(paper7(), pattern)), pattern);
    }
}

TEST(PatternId, ListsEdgesSortedAsNumbers) {
    EXPECT_EQ(pattern_id(paper7(), parse_pattern_id(paper7(), "6-1+1-0")), "0-1+1-6");
    NodeLayoutDescription description = paper7().description();
    description.face.push_back({Rational(1, 2), Rational(1, 4), Rational(1, 4)});
    description.interface = {Rational(1, 5), Rational(2, 5), Rational(3, 5), Rational(4, 5)};
    const NodeLayout layout(description);
    EXPECT_EQ(pattern_id(layout, parse_pattern_id(layout, "1-10+1-7+0-9")), "0-9+1-7+1-10");
}

TEST(PatternId, MayCarryItsLayoutsName) {
    EXPECT_EQ(parse_pattern_id(paper7(), "paper7:0-6"), parse_pattern_id(paper7(), "0-6"));
}

TEST(PatternId, RefusesOtherText) {
    for (const char* text : {"", "0", "0-", "-6", "0-6+", "+0-6", "0-3", "0-2", "0-0", "0-7", "0-6+0-6",
                             "0-6+6-0", "other:0-6", "a-b", "0 -6", "0-+6", "0--6", "0-99999999999"}) {
        EXPECT_THROW(parse_pattern_id(paper7(), text), base::InputError) << text;
    }
}

TEST(PatternId, ARefusalNamesTheEdge) {
    try {
        parse_pattern_id(paper7(), "0-1+0-2");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(),
                    ::testing::HasSubstr("'0-2' is not a candidate edge of the layout 'paper7'"));
    }
}

TEST(Pattern, KnowsItsEdges) {
    const Pattern pattern = parse_pattern_id(paper7(), "0-1+1-6");
    EXPECT_EQ(pattern.edge_count(), 2);
    ASSERT_EQ(pattern.edges().size(), 2u);
    EXPECT_TRUE(pattern.has(pattern.edges()[0]));
    EXPECT_EQ(pattern.edges()[0], find_edge(paper7(), "0-1"));
    EXPECT_FALSE(pattern.has(find_edge(paper7(), "0-6")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
