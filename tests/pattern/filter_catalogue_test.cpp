// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fretwork::pattern {
namespace THIS_TEST {

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

TEST(Verdict, NamesTheInterfaceNodeWithoutABeam) {
    EXPECT_EQ(verdict_of("no_interface", "0-1").reason, "no beam ends at interface node n6");
}

TEST(Verdict, LooseComponentsAreGuilty) {
    const Verdict verdict = verdict_of("multiple_components", "1-3+2-6+4-6");
    EXPECT_EQ(verdict.reason, "the fan falls into 2 components");
    EXPECT_EQ(guilty_of(verdict), "1-3");
}

// The paper, Fig. 7a and 7b: dangling edges and dangling components.
TEST(Verdict, DanglingPartsAreGuilty) {
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

// By hand, in the unit hexagon: 0-1 and 1-2 are 1/3 long, 1-3 too (an equilateral triangle), 0-6 sqrt(3)/2.
TEST(EdgeLength, IsThatInTheHexagon) {
    constexpr double kSide = 0.025980762113533160;
    EXPECT_TRUE(verdict_of("short_edge", "0-1+1-2+1-3", kSide / 3 * (1 - 1e-9)).accepted);
    EXPECT_FALSE(verdict_of("short_edge", "1-3", kSide / 3 * (1 + 1e-9)).accepted);
    EXPECT_TRUE(verdict_of("long_edge", "0-6", kSide * std::sqrt(3.0) / 2 * (1 + 1e-9)).accepted);
    const Verdict verdict = verdict_of("long_edge", "0-6", 0.02);
    EXPECT_EQ(verdict.reason, "the edge 0-6 is longer than 20 mm");
    EXPECT_EQ(guilty_of(verdict), "0-6");
}

// By hand: the rings 1-3 and 2-4 are parallel, sqrt(3)/6 of the side apart; beams of 2 mm leave 5.5 mm
// between them.
TEST(TightClearance, IsBetweenTheFlanksOfBeamsThatDoNotMeet) {
    const double gap = 0.025980762113533160 * std::sqrt(3.0) / 6 - 0.002;
    EXPECT_TRUE(verdict_of("tight_clearance", "1-3+2-4", gap - 1e-9).accepted);
    EXPECT_FALSE(verdict_of("tight_clearance", "1-3+2-4", gap + 1e-9).accepted);
    EXPECT_TRUE(verdict_of("tight_clearance", "0-1+1-2", gap).accepted)
        << "beams that meet are left to small_angle";
}

// By hand: copies of 1-2 lie on neighbouring radii, nearest at their inner ends, which are side / 3 apart.
TEST(TightClearance, SeesCopiesInOtherSectors) {
    const double gap = 0.025980762113533160 / 3 - 0.002;
    EXPECT_TRUE(verdict_of("tight_clearance", "1-2", gap - 1e-9).accepted);
    EXPECT_FALSE(verdict_of("tight_clearance", "1-2", gap + 1e-9).accepted);
    EXPECT_EQ(verdict_of("tight_clearance", "1-2", 0.007).reason,
              "the edge 1-2 and its copies leave less than 7 mm between them");
}

TEST(TightClearance, OfZeroDistanceCountsCrossings) {
    EXPECT_FALSE(verdict_of("tight_clearance", "0-6+1-3", 0.0).accepted);
}

TEST(Asymmetric, RejectsWhatIsNotItsOwnMirrorImage) {
    EXPECT_TRUE(verdict_of("asymmetric", "1-6+3-6").accepted);
    EXPECT_FALSE(verdict_of("asymmetric", "1-6").accepted);
    EXPECT_FALSE(verdict_of("asymmetric", "5-6").accepted);
}

TEST(EdgeGroups, AreEdgesOrAllEdgesAtANodeOfTheFan) {
    EXPECT_EQ(parse_edge_group(paper7(), "1-6").edges.count(), 1u);
    EXPECT_EQ(parse_edge_group(paper7(), "n5").edges, parse_edge_group(paper7(), "5").edges);
    EXPECT_EQ(parse_edge_group(paper7(), "n5").edges.count(), 6u);
    EXPECT_EQ(parse_edge_group(paper7(), "n3").edges, parse_edge_group(paper7(), "n1").edges)
        << "one node of the fan";
    for (const char* text : {"", "n", "n7", "x", "0-2", "-1", "n-1", "1.5"})
        EXPECT_THROW(parse_edge_group(paper7(), text), base::InputError) << text;
}

TEST(EdgeGroups, RequiredAndForbiddenOnesAreKept) {
    FilterSettings settings;
    settings.required = {parse_edge_group(paper7(), "n5")};
    settings.forbidden = {parse_edge_group(paper7(), "0-6")};
    const std::vector<Filter> filters = make_filters(paper7(), settings);
    EXPECT_EQ(judge(paper7(), filters, parse_pattern_id(paper7(), "1-3+1-6+3-6")).reason,
              "the pattern lacks node n5");
    EXPECT_EQ(judge(paper7(), filters.back(), parse_pattern_id(paper7(), "0-6")).reason,
              "the edge 0-6 is forbidden");
}

// 210 of the 1,824 patterns do not use node 5.
TEST(EdgeGroups, RequiredAndForbiddenOnesTogetherGiveAllPatterns) {
    EnumerationOptions with;
    with.filters.required = {parse_edge_group(paper7(), "n5")};
    EnumerationOptions without;
    without.filters.forbidden = with.filters.required;
    EXPECT_EQ(count_patterns(paper7(), with).total(), 1824u - 210u);
    EXPECT_EQ(count_patterns(paper7(), without).total(), 210u);
}

TEST(FilterCatalogue, EveryFilterTakesItsDefaultAndRejectsNonsense) {
    for (const FilterKind& kind : filter_catalogue()) {
        FilterSettings settings;
        settings.choices = {{std::string(kind.name), std::nullopt}};
        EXPECT_NO_THROW(make_filters(paper7(), settings)) << kind.name;
        if (kind.parameter == FilterParameter::None) continue;
        settings.choices.front().value = -1.0;
        EXPECT_THROW(make_filters(paper7(), settings), base::InputError) << kind.name;
        settings.choices.front().value = std::nan("");
        EXPECT_THROW(make_filters(paper7(), settings), base::InputError) << kind.name;
    }
}

// Rules prune by conflicts and loads: both must stay broken when edges are added.
TEST(FilterCatalogue, RulesThatPruneAreMonotone) {
    FilterSettings settings;
    settings.choices = {{"short_edge", {}}, {"long_edge", {}}, {"tight_clearance", {}}};
    const std::vector<Filter> filters = make_filters(paper7(), settings);
    for (unsigned graph = 1; graph < 1u << 17; graph += 97) {
        const Pattern pattern{Pattern::Bits(graph)};
        const Pattern larger{Pattern::Bits(graph | (graph * 2654435761u) % (1u << 17))};
        for (const Filter& filter : filters) {
            const bool prunes = std::holds_alternative<ConflictRule>(filter.rule) ||
                                std::holds_alternative<CapacityRule>(filter.rule);
            if (!prunes || judge(paper7(), filter, pattern).accepted) continue;
            EXPECT_FALSE(judge(paper7(), filter, larger).accepted) << filter.name;
        }
    }
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

TEST(FilterCatalogue, FiltersOfTheCallersOwnTakePart) {
    const PredicateRule few{[](const Pattern& pattern) { return pattern.edge_count() <= 3; },
                            "has many beams"};
    EnumerationOptions options;
    options.filters.own.push_back({"many", 0.0, few});
    std::vector<Pattern> wanted = enumerate_patterns(paper7());
    std::erase_if(wanted, [](const Pattern& pattern) { return pattern.edge_count() > 3; });
    EXPECT_EQ(enumerate_patterns(paper7(), options), wanted);
    options.filters.own.push_back({"intersecting", 0.0, few});
    EXPECT_THROW(enumerate_patterns(paper7(), options), base::InputError);
}

TEST(FilterCatalogue, SixtyFourFiltersAreTheMost) {
    const PredicateRule any{[](const Pattern&) { return true; }, ""};
    FilterSettings settings;
    while (make_filters(paper7(), settings).size() < 64)
        settings.own.push_back({"own" + std::to_string(settings.own.size()), 0.0, any});
    settings.own.push_back({"one more", 0.0, any});
    EXPECT_THROW(make_filters(paper7(), settings), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
