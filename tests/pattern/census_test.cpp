// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/small_layouts.hpp"
#include "stops.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/search/rule_counts.hpp>

#include <gtest/gtest.h>

namespace fretwork::pattern {
namespace THIS_TEST {

EnumerationOptions options_of(const NodeLayout& layout) {
    EnumerationOptions options;
    options.edges = default_edge_range(layout);
    return options;
}

// experiments/table1_enumeration/expected.csv is the paper's Table 1.
TEST(Census, IsThePapersTable1ByteForByte) {
    const NodeLayout layout = find_node_layout("paper7");
    const Census census = take_census(layout, options_of(layout));
    EXPECT_EQ(census_csv(census),
              base::read_text_file(FRETWORK_SOURCE_DIR "/experiments/table1_enumeration/expected.csv"));
    EXPECT_EQ(census.valid(), 1824u);
}

// Every count that a closed form gives must be the one that walking all graphs gives.
TEST(Census, ClosedFormsEqualWalkingEveryGraph) {
    for (const NodeLayout& layout : small_layouts()) {
        const int edge_count = static_cast<int>(layout.candidate_edges().size());
        EnumerationOptions options;
        options.edges = {1, edge_count};
        options.filters.choices = {{"short_edge", 0.008}, {"tight_clearance", 0.0005}};
        options.filters.required = {parse_edge_group(layout, "n1"), parse_edge_group(layout, "n2")};
        options.filters.forbidden = {parse_edge_group(layout, "n0")};
        const std::vector<Filter> filters = make_filters(layout, options.filters);
        const Census census = take_census(layout, options);
        int counted = 0;
        for (std::size_t i = 0; i < filters.size(); ++i) {
            const auto kept = detail::count_graphs_that_keep(filters[i].rule, edge_count);
            if (!kept) continue;
            ++counted;
            for (const CensusRow& row : census.rows) {
                const GraphCount rejected = row.patterns - (*kept)[static_cast<std::size_t>(row.edges)];
                EXPECT_EQ(count_text(rejected), count_text(*row.rejected[i]))
                    << layout.name() << " " << filters[i].name;
            }
        }
        EXPECT_EQ(counted, 8) << "all but the two graph rules";
    }
}

TEST(Census, ValidColumnIsThatOfTheSearch) {
    for (const NodeLayout& layout : small_layouts()) {
        EnumerationOptions options;
        options.edges = {1, kMaxCandidateEdges};
        const PatternCount count = count_patterns(layout, options);
        for (const CensusRow& row : take_census(layout, options).rows) {
            EXPECT_EQ(count_text(row.valid),
                      std::to_string(count.by_edges[static_cast<std::size_t>(row.edges)]));
        }
    }
}

TEST(Census, FiltersThatAreSwitchedOnGetAColumnBeforeValid) {
    EnumerationOptions options;
    options.edges = {2, 3};
    options.filters.choices = {{"asymmetric", {}}};
    options.filters.required = {parse_edge_group(find_node_layout("paper7"), "0-6")};
    const std::string csv = census_csv(take_census(find_node_layout("paper7"), options));
    EXPECT_EQ(
        csv.substr(0, csv.find('\n')),
        "edges,patterns,intersecting,no_interface,multiple_components,articulation,small_angle,high_valence,"
        "asymmetric,lacks_required,valid");
}

TEST(Census, QuotesTheNamesOfFiltersThatNeedIt) {
    Census census;
    census.filters = {"long, thin", "no \"star\""};
    EXPECT_EQ(census_csv(census), "edges,patterns,\"long, thin\",\"no \"\"star\"\"\",valid\n");
}

TEST(CensusOfALargeLayout, LeavesGraphColumnsEmpty) {
    NodeLayoutDescription description = find_node_layout("paper7").description();
    description.face.push_back({Rational(9, 20), Rational(1, 5), Rational(7, 20)});
    const NodeLayout layout(description);
    ASSERT_EQ(layout.candidate_edges().size(), 24u);
    EnumerationOptions options;
    options.edges = {2, 3};
    const Census census = take_census(layout, options);
    ASSERT_EQ(census.rows.size(), 2u);
    EXPECT_EQ(count_text(census.rows[0].patterns), "276");  // C(24, 2)
    for (const CensusRow& row : census.rows) {
        for (std::size_t i = 0; i < row.rejected.size(); ++i)
            EXPECT_EQ(row.rejected[i].has_value(), i != 2 && i != 3) << census.filters[i];
    }
}

TEST(CensusOfALargeLayout, CanBeStoppedInAColumn) {
    const fretwork::test::StopAtLook stop(0);
    const base::Control control = stop.control();
    const CoverRule cover{{{"edge", Pattern::Bits().set(0)}}, "the pattern lacks"};
    EXPECT_THROW(detail::count_graphs_that_keep(cover, 64, control), base::Stopped);
    const CapacityRule capacity{{{"node", std::vector<int>(64, 1)}}, 6, ""};
    EXPECT_THROW(detail::count_graphs_that_keep(capacity, 64, control), base::Stopped);
    const ConflictRule conflicts{std::vector<Pattern::Bits>(64), "", ""};
    EXPECT_THROW(detail::count_graphs_that_keep(conflicts, 64, control), base::Stopped);
}

TEST(CountText, WritesNumbersBeyond64Bits) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(GraphCount{1} << 100), "1267650600228229401496703205376");
    EXPECT_EQ(count_text(detail::binomial(128, 64)), "23951146041928082866135587776380551750");
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
