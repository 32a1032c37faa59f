// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/rejections.hpp>

#include <gtest/gtest.h>

#include <set>

namespace fretwork::pattern {
namespace THIS_TEST {

TEST(Rejections, BreakOneRuleEachAndSayWhich) {
    const NodeLayout layout = find_node_layout("paper7");
    const EnumerationOptions options;
    const std::vector<Filter> filters = make_filters(layout, options.filters);
    std::set<std::string> seen;
    for (const Rejection& rejection : find_rejections(layout, options, 4)) {
        seen.insert(rejection.verdict.filter);
        EXPECT_FALSE(rejection.verdict.reason.empty());
        for (const Filter& filter : filters)
            EXPECT_EQ(judge(layout, filter, rejection.pattern).accepted,
                      filter.name != rejection.verdict.filter);
        for (const EdgeIndex edge : rejection.verdict.guilty) EXPECT_TRUE(rejection.pattern.has(edge));
    }
    EXPECT_EQ(seen.size(), 6u);
}

TEST(Rejections, AreAsManyAsWantedAndDifferent) {
    const NodeLayout layout = find_node_layout("paper7");
    std::set<std::string> ids;
    const auto rejections = find_rejections(layout, {}, 5);
    for (const Rejection& rejection : rejections) ids.insert(pattern_id(layout, rejection.pattern));
    EXPECT_EQ(rejections.size(), 30u);
    EXPECT_EQ(ids.size(), 30u);
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
