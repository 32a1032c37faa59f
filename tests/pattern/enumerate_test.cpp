// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/small_layouts.hpp"
#include "stops.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace fretwork::pattern {
namespace THIS_TEST {

constexpr double kDegree = std::numbers::pi / 180;

std::vector<std::string> ids(const NodeLayout& layout, const std::vector<Pattern>& patterns) {
    std::vector<std::string> texts;
    for (const Pattern& pattern : patterns) texts.push_back(pattern_id(layout, pattern));
    return texts;
}

/// Every graph of the layout that the judge accepts, whose verdicts rest on Boost.Graph and on no search.
std::vector<std::string> accepted_by_the_judge(const NodeLayout& layout, const EnumerationOptions& options) {
    const std::vector<Filter> filters = make_filters(layout, options.filters);
    std::vector<std::string> accepted;
    for (unsigned graph = 1; graph < 1u << layout.candidate_edges().size(); ++graph) {
        const Pattern pattern{Pattern::Bits(graph)};
        const bool in_range =
            pattern.edge_count() >= options.edges.least && pattern.edge_count() <= options.edges.most;
        if (in_range && judge(layout, filters, pattern).accepted)
            accepted.push_back(pattern_id(layout, pattern));
    }
    std::sort(accepted.begin(), accepted.end());
    return accepted;
}

std::vector<std::string> sorted(std::vector<std::string> texts) {
    std::sort(texts.begin(), texts.end());
    return texts;
}

// Reference: the paper, Section 7.1.
TEST(Enumerate, PapersLayoutHas1824ValidPatterns) {
    const NodeLayout layout = find_node_layout("paper7");
    EXPECT_EQ(count_patterns(layout).total(), 1824u);
    EXPECT_EQ(enumerate_patterns(layout).size(), 1824u);
}

// The star is the one pattern of a single edge, which the paper leaves out.
TEST(Enumerate, OneEdgeMakesTheStar) {
    const NodeLayout layout = find_node_layout("paper7");
    EnumerationOptions options;
    options.edges = {1, 1};
    EXPECT_EQ(ids(layout, enumerate_patterns(layout, options)), std::vector<std::string>{"0-6"});
}

TEST(Enumerate, FindsWhatAPlainFilterOverAllGraphsLeaves) {
    for (const NodeLayout& layout : small_layouts()) {
        for (const double angle : {15.0, 28.0}) {
            EnumerationOptions options;
            options.edges = {1, kMaxCandidateEdges};
            options.filters.choices = {{"small_angle", angle * kDegree},
                                       {"high_valence", angle == 15.0 ? 6.0 : 5.0}};
            EXPECT_EQ(sorted(ids(layout, enumerate_patterns(layout, options))),
                      accepted_by_the_judge(layout, options))
                << layout.name();
        }
    }
}

// The number is that of an independent program: plain backtracking over pairwise conflicts, then filtering.
TEST(Enumerate, FourRadialPairsAndTwoFaceNodesGive6540827Patterns) {
    const NodeLayout layout = find_node_layout("fifths12");
    ASSERT_EQ(layout.candidate_edges().size(), 49u);
    EXPECT_EQ(count_patterns(layout).total(), 6540827u);
}

TEST(Enumerate, OrderIsLexicographicAndDoesNotDependOnThreads) {
    const NodeLayout layout = find_node_layout("paper7");
    EnumerationOptions options;
    options.threads = 1;
    const std::vector<Pattern> alone = enumerate_patterns(layout, options);
    options.threads = 5;
    EXPECT_EQ(enumerate_patterns(layout, options), alone);
    EXPECT_TRUE(std::is_sorted(alone.begin(), alone.end(),
                               [](const Pattern& a, const Pattern& b) { return a.edges() < b.edges(); }));
}

TEST(Enumerate, AStreamIsTheSameHoweverFewPatternsAreKept) {
    const NodeLayout layout = find_node_layout("paper7");
    EnumerationOptions options;
    const std::vector<Pattern> all = enumerate_patterns(layout, options);
    for (const std::size_t most_kept : {1U, 7U, 300U}) {
        options.most_kept = most_kept;
        EXPECT_EQ(enumerate_patterns(layout, options), all) << most_kept;
    }
}

/// Remembers how far a search says it is, and asks it to stop once that is `stop_at` pieces.
class Watch final : public base::Progress {
  public:
    explicit Watch(std::size_t stop_at) : stop_at_(stop_at) {}
    void start(std::string_view, std::size_t total) override { total_ = total; }
    void update(std::size_t done) override {
        done_ = done;
        if (done >= stop_at_) source_.request_stop();
    }
    void finish() override { is_finished_ = true; }
    [[nodiscard]] base::Control control() { return {.stop = source_.get_token(), .progress = this}; }
    [[nodiscard]] bool is_finished() const { return is_finished_; }
    [[nodiscard]] std::size_t left() const { return total_ - done_; }

  private:
    std::size_t stop_at_;
    std::size_t total_ = 0;
    std::size_t done_ = 0;
    bool is_finished_ = false;
    std::stop_source source_;
};

TEST(Enumerate, TellsOfEveryPieceUntilAllAreDone) {
    Watch watch(1'000'000);
    EnumerationOptions options;
    options.control = watch.control();
    EXPECT_EQ(count_patterns(find_node_layout("paper7"), options).total(), 1824u);
    EXPECT_TRUE(watch.is_finished());
    EXPECT_EQ(watch.left(), 0U);
}

TEST(Enumerate, StopsInTheMiddleOfASearch) {
    const NodeLayout layout = find_node_layout("fifths12");
    for (const int threads : {1, 4}) {
        Watch watch(100);
        EnumerationOptions options;
        options.threads = threads;
        options.control = watch.control();
        EXPECT_THROW(count_patterns(layout, options), base::Stopped);
        EXPECT_GT(watch.left(), 0U);
        std::size_t visited = 0;
        EXPECT_THROW(for_each_pattern(layout, options, [&](const Pattern&) { ++visited; }), base::Stopped);
        EXPECT_EQ(visited, 0U) << "it was asked to stop before it began";
    }
}

// So few edges make so few nodes that no piece reaches the first look of the search itself.
TEST(Enumerate, OfSmallPiecesStopsAtAnyLook) {
    const NodeLayout layout = find_node_layout("paper7");
    EnumerationOptions options;
    options.edges = {1, 2};
    options.threads = 1;
    options.most_kept = 1;
    fretwork::test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            options.control = control;
            count_patterns(layout, options);
        },
        [] {});
    fretwork::test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            options.control = control;
            enumerate_patterns(layout, options);
        },
        [] {});
}

TEST(Enumerate, CountsAreThoseOfTheStream) {
    for (const NodeLayout& layout : small_layouts()) {
        std::vector<std::uint64_t> seen(layout.candidate_edges().size() + 1);
        const PatternCount count = for_each_pattern(layout, {}, [&](const Pattern& pattern) {
            ++seen[static_cast<std::size_t>(pattern.edge_count())];
        });
        EXPECT_EQ(count.by_edges, seen);
        EXPECT_EQ(count_patterns(layout).by_edges, seen);
    }
}

TEST(Enumerate, AnUpperEndBeyondTheCandidateEdgesIsClipped) {
    const NodeLayout layout = find_node_layout("paper7");
    EnumerationOptions options;
    options.edges = {2, 1000};
    EXPECT_EQ(count_patterns(layout, options).total(), 1824u);
}

TEST(Enumerate, RefusesOptionsThatMakeNoSense) {
    const NodeLayout layout = find_node_layout("paper7");
    const auto refuses = [&](const auto& spoil) {
        EnumerationOptions options;
        spoil(options);
        EXPECT_THROW(count_patterns(layout, options), base::InputError);
    };
    refuses([](auto& options) { options.edges = {0, 3}; });
    refuses([](auto& options) { options.edges = {4, 3}; });
    refuses([](auto& options) { options.filters.choices = {{"small_angel", 0.1}}; });
    refuses([](auto& options) { options.filters.choices = {{"small_angle", 0.1}, {"small_angle", 0.2}}; });
    refuses([](auto& options) { options.filters.choices = {{"small_angle", -0.1}}; });
    refuses([](auto& options) { options.filters.choices = {{"small_angle", 3.2}}; });
    refuses([](auto& options) { options.filters.choices = {{"high_valence", 2.5}}; });
    refuses([](auto& options) { options.filters.choices = {{"high_valence", 0.0}}; });
    refuses([](auto& options) { options.filters.scale.tile_side = 0.0; });
    refuses([](auto& options) { options.threads = -1; });
    refuses([](auto& options) { options.most_kept = 0; });
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
