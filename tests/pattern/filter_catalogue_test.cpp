// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace fretwork::pattern {
namespace {

using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

Verdict verdict_of(const char* filter_name, const char* id, std::optional<double> value = {}) {
    FilterSettings settings;
    settings.choices.push_back({filter_name, value});
    for (const Filter& filter : make_filters(paper7(), settings)) {
        if (filter.name == filter_name) return judge(paper7(), filter, parse_pattern_id(paper7(), id));
    }
    ADD_FAILURE() << filter_name;
    return {};
}

std::string guilty_of(const Verdict& verdict) {
    Pattern::Bits bits;
    for (const EdgeIndex edge : verdict.guilty) bits.set(static_cast<std::size_t>(edge));
    return pattern_id(paper7(), Pattern(bits));
}

TEST(Verdict, AcceptedPatternsHaveNoReason) {
    const std::vector<Filter> filters = make_filters(paper7());
    const Verdict verdict = judge(paper7(), filters, parse_pattern_id(paper7(), "1-3+1-6+3-6"));
    EXPECT_TRUE(verdict.accepted);
    EXPECT_TRUE(verdict.filter.empty() && verdict.reason.empty() && verdict.guilty.empty());
}

TEST(Verdict, CrossingEdgesAreNamed) {
    const Verdict verdict = verdict_of("intersecting", "0-6+1-3");
    EXPECT_EQ(verdict.filter, "intersecting");
    EXPECT_EQ(verdict.reason, "the edges 0-6 and 1-3 cross");
    EXPECT_EQ(guilty_of(verdict), "0-6+1-3");
    EXPECT_TRUE(verdict_of("intersecting", "0-6+0-1").accepted);
}

TEST(Verdict, AMissingInterfaceBeamIsSaid) {
    EXPECT_EQ(verdict_of("no_interface", "0-1").reason, "no beam ends at interface node n6");
}

TEST(Verdict, PartsThatAreLooseAreGuilty) {
    const Verdict verdict = verdict_of("multiple_components", "1-3+2-6+4-6");
    EXPECT_EQ(verdict.reason, "the fan falls into 2 components");
    EXPECT_EQ(guilty_of(verdict), "1-3");
}

// The paper, Fig. 7a and 7b: dangling edges and dangling components.
TEST(Verdict, PartsThatDangleAreGuilty) {
    const Verdict edge = verdict_of("articulation", "0-6+0-1");
    EXPECT_EQ(edge.reason, "a part hangs on node n0 alone");
    EXPECT_EQ(guilty_of(edge), "0-1");
    const Verdict component = verdict_of("articulation", "1-2+2-4+1-3+2-6+0-1");
    EXPECT_TRUE(component.accepted);
    EXPECT_EQ(guilty_of(verdict_of("articulation", "0-6+0-1+1-5+0-5")), "0-1+0-5+1-5");
}

TEST(Verdict, HighValenceNamesTheNode) {
    const Verdict verdict = verdict_of("high_valence", "0-1+0-6");
    EXPECT_EQ(verdict.reason, "node n0 has valence 12, above 6");
    EXPECT_EQ(guilty_of(verdict), "0-1+0-6");
    EXPECT_TRUE(verdict_of("high_valence", "0-1+0-6", 12.0).accepted);
}

// An interface node has the neighbour's beams too: three of ours are six.
TEST(HighValence, InterfaceNodesCountDouble) {
    EXPECT_TRUE(verdict_of("high_valence", "1-6+2-6+4-6").accepted);
    EXPECT_FALSE(verdict_of("high_valence", "1-6+2-6+3-6+4-6").accepted);
}

// A ring edge ends twice at each of its nodes.
TEST(HighValence, CountsBothEndsOfARing) {
    EXPECT_TRUE(verdict_of("high_valence", "1-3", 2.0).accepted);
    EXPECT_FALSE(verdict_of("high_valence", "1-3", 1.0).accepted);
}

// In the hexagon, 1-3 and the radius 0-1 enclose exactly 60 degrees, 1-3 and its own next copy 120 degrees.
TEST(SmallAngle, IsComparedExactlyWhereTheCosineIsRational) {
    EXPECT_TRUE(verdict_of("small_angle", "0-1+1-3", 60 * kDegree).accepted);
    EXPECT_FALSE(verdict_of("small_angle", "0-1+1-3", 60.0001 * kDegree).accepted);
    EXPECT_TRUE(verdict_of("small_angle", "1-3", 120 * kDegree).accepted);
    const Verdict own_copy = verdict_of("small_angle", "1-3", 121 * kDegree);
    EXPECT_FALSE(own_copy.accepted);
    EXPECT_THAT(own_copy.reason,
                HasSubstr("the edge 1-3 and its neighbour copies enclose less than 121 degrees"));
    // 0-1 and 0-6 lie 30 degrees apart, and 30 degrees from the next copy of 0-1.
    EXPECT_TRUE(verdict_of("small_angle", "0-1+0-6", 30 * kDegree).accepted);
    EXPECT_FALSE(verdict_of("small_angle", "0-1+0-6", 30.0001 * kDegree).accepted);
}

// By hand: tan of the angle between 2-6 and 4-6 at n6 .. their directions mirror each other about the radius;
// n2 is 1/3 of the side from its middle line and sqrt(3)/6 above the interface side, so each rises by
// atan(sqrt(3)/2).
TEST(SmallAngle, AgreesWithTrigonometry) {
    const double between = 180 - 2 * std::atan(std::sqrt(3.0) / 2) / kDegree;
    EXPECT_TRUE(verdict_of("small_angle", "2-6+4-6", (between - 1e-9) * kDegree).accepted);
    EXPECT_FALSE(verdict_of("small_angle", "2-6+4-6", (between + 1e-9) * kDegree).accepted);
}

TEST(SmallAngle, SeesBeamsOfTheNextSector) {
    // 1-5 leaves node 1 into its sector, 3-5 leaves the same node of the fan into the one before.
    EXPECT_TRUE(verdict_of("small_angle", "1-5+3-5", 40 * kDegree).accepted);
    EXPECT_FALSE(verdict_of("small_angle", "1-5+3-5", 178 * kDegree).accepted);
}

TEST(FilterCatalogue, ThePapersSixAreAlwaysOnAndInItsOrder) {
    std::vector<std::string> names;
    for (const Filter& filter : make_filters(paper7())) names.push_back(filter.name);
    EXPECT_EQ(names, (std::vector<std::string>{"intersecting", "no_interface", "multiple_components",
                                               "articulation", "small_angle", "high_valence"}));
}

TEST(FilterCatalogue, ChoicesAreReadInTheirUnits) {
    EXPECT_NEAR(*parse_filter_choice("small_angle=20deg").value, 20 * kDegree, 1e-15);
    EXPECT_EQ(*parse_filter_choice("high_valence=8").value, 8.0);
    EXPECT_FALSE(parse_filter_choice("small_angle").value.has_value());
}

TEST(FilterCatalogue, RefusesWrongChoices) {
    EXPECT_THROW(parse_filter_choice("small_angle=wide"), base::InputError);
    EXPECT_THROW(parse_filter_choice("intersecting=3"), base::InputError);
    EXPECT_THROW(parse_filter_choice("small_angle="), base::InputError);
    EXPECT_THROW(parse_filter_choice(""), base::InputError);
    try {
        parse_filter_choice("small_angel");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean 'small_angle'"));
    }
}

}  // namespace
}  // namespace fretwork::pattern
