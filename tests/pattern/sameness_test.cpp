// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/small_layouts.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/pattern/detail/canonical_form.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/pattern/sameness.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fretwork::pattern {
namespace THIS_TEST {

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

Pattern pattern_of(const char* id) {
    return parse_pattern_id(paper7(), id);
}

TEST(Mirror, ExchangesTheRadialSides) {
    const Mirror mirror(paper7());
    EXPECT_EQ(mirror.image(pattern_of("1-4")), pattern_of("2-3"));
    EXPECT_EQ(mirror.image(pattern_of("2-6")), pattern_of("4-6"));
    EXPECT_EQ(mirror.image(pattern_of("0-1+1-2")), pattern_of("0-1+1-2"));
    EXPECT_FALSE(mirror.image(pattern_of("0-5")).has_value());
}

TEST(Mirror, IsItsOwnInverse) {
    for (const NodeLayout& layout : small_layouts()) {
        const Mirror mirror(layout);
        for (const Pattern& pattern : enumerate_patterns(layout)) {
            const auto image = mirror.image(pattern);
            EXPECT_TRUE(!image || mirror.image(*image) == pattern);
        }
    }
}

// The reflection x -> -x, at the axis of sector 0, maps the placed fan of a pattern onto that of its image,
// up to a few roundings of coordinates of magnitude 1.
TEST(Mirror, ImageIsTheReflectedFan) {
    const geometry::Polygon hexagon = geometry::regular_polygon(6, 1.0);
    const Mirror mirror(paper7());
    for (const char* id : {"1-4+4-6+1-2", "0-1+1-6+3-6", "2-3+3-6+0-6"}) {
        const auto places = place_fan(paper7(), make_fan(paper7(), pattern_of(id), 6), hexagon);
        const auto images =
            place_fan(paper7(), make_fan(paper7(), *mirror.image(pattern_of(id)), 6), hexagon);
        ASSERT_EQ(places.size(), images.size());
        for (const geometry::Point2& p : places) {
            EXPECT_TRUE(std::any_of(images.begin(), images.end(), [&](const geometry::Point2& q) {
                return std::hypot(q.x + p.x, q.y - p.y) < 1e-14;
            }));
        }
    }
}

// Facts about the paper's patterns: 210 do not use node 5; 14 of these are symmetric, 196 form 98 pairs.
TEST(Sameness, Paper7HasFourteenSymmetricPatternsAnd98MirrorPairs) {
    const std::vector<Pattern> patterns = enumerate_patterns(paper7());
    const SamenessReport report = find_sameness(paper7(), patterns);
    const auto symmetric =
        std::count_if(report.of_pattern.begin(), report.of_pattern.end(),
                      [](const PatternSameness& s) { return s.symmetry == Symmetry::Mirror; });
    const auto paired = std::count_if(report.of_pattern.begin(), report.of_pattern.end(),
                                      [](const PatternSameness& s) { return s.mirror_partner.has_value(); });
    EXPECT_EQ(symmetric, 14);
    EXPECT_EQ(paired, 196);
    EXPECT_EQ(report.up_to_mirror, 1726u);
}

// 337 classes are separated by colour refinement alone, so there are at least as many.
TEST(Sameness, Paper7HasAtLeastTheClassesThatColourRefinementTellsApart) {
    const std::vector<Pattern> patterns = enumerate_patterns(paper7());
    EXPECT_GE(find_sameness(paper7(), patterns).up_to_isomorphism, 337u);
}

TEST(Sameness, MirrorPartnersAreIsomorphicAndMutual) {
    const std::vector<Pattern> patterns = enumerate_patterns(paper7());
    const SamenessReport report = find_sameness(paper7(), patterns);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const auto& same = report.of_pattern[i];
        if (!same.mirror_partner) continue;
        EXPECT_EQ(report.of_pattern[*same.mirror_partner].mirror_partner, i);
        EXPECT_EQ(report.of_pattern[*same.mirror_partner].isomorphism_class, same.isomorphism_class);
    }
}

TEST(Sameness, ClassesDoNotDependOnThreadsAndAreNumberedByTheirFirstPattern) {
    const std::vector<Pattern> patterns = enumerate_patterns(paper7());
    const SamenessReport alone = find_sameness(paper7(), patterns, {.threads = 1});
    const SamenessReport together = find_sameness(paper7(), patterns, {.threads = 4});
    std::size_t next = 0;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        EXPECT_EQ(alone.of_pattern[i].isomorphism_class, together.of_pattern[i].isomorphism_class);
        EXPECT_LE(alone.of_pattern[i].isomorphism_class, next);
        next = std::max(next, alone.of_pattern[i].isomorphism_class + 1);
    }
    EXPECT_EQ(next, alone.up_to_isomorphism);
}

/// Counts the tasks that begin.
class TaskCount final : public base::Progress {
  public:
    void start(std::string_view, std::size_t) override { ++begun; }
    void update(std::size_t) override {}
    void finish() override {}
    int begun = 0;
};

TEST(Sameness, StopsBeforeTheCanonicalForms) {
    std::stop_source source;
    source.request_stop();
    TaskCount tasks;
    const base::Control control{.stop = source.get_token(), .progress = &tasks};
    const std::vector<Pattern> patterns{pattern_of("0-6")};
    EXPECT_THROW(find_sameness(paper7(), patterns, {.control = control}), base::Stopped);
    EXPECT_EQ(tasks.begun, 0);
}

/// The same fan with its nodes numbered in another order, interface nodes still first.
Fan shuffled(Fan fan) {
    const int inner = static_cast<int>(fan.nodes.size()) - fan.interface_node_count;
    const auto moved = [&](FanNodeIndex node) {
        if (node < fan.interface_node_count) return FanNodeIndex((node * 5 + 2) % fan.interface_node_count);
        return FanNodeIndex(fan.interface_node_count + (node - fan.interface_node_count + 3) % inner);
    };
    for (auto& [first, second] : fan.edges) {
        const FanNodeIndex a = moved(first);
        const FanNodeIndex b = moved(second);
        first = std::min(a, b);
        second = std::max(a, b);
    }
    return fan;
}

TEST(CanonicalForm, DoesNotDependOnNumbering) {
    for (const Pattern& pattern : enumerate_patterns(paper7())) {
        const Fan fan = make_fan(paper7(), pattern, 6);
        EXPECT_EQ(detail::canonical_form(fan), detail::canonical_form(shuffled(fan)));
    }
}

// A star of six beams and a ring of six, each with the interface nodes at the far ends or not.
TEST(CanonicalForm, TellsInterfaceNodesFromOthers) {
    const Fan outside{6, 6, std::vector<Fan::Node>(12), {{FanNodeIndex(0), FanNodeIndex(6)}}};
    const Fan inside{6, 6, std::vector<Fan::Node>(12), {{FanNodeIndex(6), FanNodeIndex(7)}}};
    EXPECT_NE(detail::canonical_form(outside), detail::canonical_form(inside));
}

TEST(SamenessCsv, HasARowForEachPattern) {
    const std::vector<Pattern> patterns{pattern_of("1-4+4-6+1-2"), pattern_of("0-6")};
    const std::string csv = sameness_csv(paper7(), patterns, find_sameness(paper7(), patterns));
    EXPECT_EQ(csv, "id,edges,symmetry,mirror,class\n1-2+1-4+4-6,3,none,,0\n0-6,1,mirror,,1\n");
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
