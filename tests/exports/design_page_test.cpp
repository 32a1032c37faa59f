// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/designs/design_page.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace fretwork::exports {
namespace THIS_TEST {

using testing::HasSubstr;
using testing::Not;

/// A report made by hand: two tiles, one node that shall rise by a millimetre and has risen by a half.
design::DesignReport sample() {
    design::DesignReport report;
    report.project.tessellation = test::honeycomb(2, 1, {"0-1+1-6", "0-6"});
    const auto nodes = std::ssize(report.project.tessellation.interface_nodes);
    design::CaseShape shape{"tip", mechanics::NodeValues::Zero(nodes, 6), {}};
    shape.displacements(4, 2) = 0.0005;
    const auto& place = report.project.tessellation.interface_nodes[tiling::InterfaceIndex(4)];
    shape.goals = {{4, {place.x, place.y, 0.001}, 0.0005}};
    report.shapes = report.uniform_shapes = {shape};
    report.error = design::TargetError{0.5, 0.5};
    report.best_uniform = design::TargetError{0.8, 0.8};
    report.best_uniform_pattern = "0-6";
    report.uniform_tried = 2;
    report.load_cases = {"tip"};
    report.factors = {2.0};
    report.history = {{1, 40, 0.1, 0.8}, {5, 40, 0.2, 0.5}};
    report.gamut.reached = {{1.0, 0.0}};
    report.gamut.wanted = {{3.0, 0.0}};
    report.start_misfits = {0.5, 0.6};
    return report;
}

std::string data_of(const std::string& page) {
    std::smatch match;
    const std::regex mark("<script type=\"application/json\" id=\"data\">(.*)</script>");
    for (const std::string& line : base::split(page, '\n')) {
        if (std::regex_search(line, match, mark)) return match[1];
    }
    return "";
}

TEST(DesignPage, HasTheDesignAsData) {
    const std::string page = design_html(sample(), {"arc", "", {}});
    const auto json = base::JsonReader::from_text(data_of(page), "page");
    EXPECT_EQ(json.at("title").string(), "arc");
    EXPECT_EQ(json.at("tiles").elements().size(), 2U);
    EXPECT_EQ(json.at("patterns").elements().size(), 2U);
    EXPECT_EQ(json.at("error").at("mean").number(), 0.5);
    EXPECT_EQ(json.at("uniform").at("mean").number(), 0.8);
    const auto goal = json.at("shapes").elements(1).front().at("goals").elements(1).front().numbers(5);
    EXPECT_EQ(goal[0], 4.0);
    EXPECT_EQ(goal[3], 0.001);
    EXPECT_EQ(json.at("history").elements().size(), 2U);
}

/// Whatever a target is called, it stays data; and nothing is loaded.
TEST(DesignPage, NeedsNothingBesidesAndRunsNoText) {
    const std::string page = design_html(sample(), {"</script><b>\"&", "", {}});
    EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
    const auto json = base::JsonReader::from_text(data_of(page), "page");
    EXPECT_EQ(json.at("title").string(), "</script><b>\"&");
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, Not(testing::ContainsRegex("(src|href)=")));
    EXPECT_THAT(page, HasSubstr("made by fretwork"));
}

TEST(DesignPage, SaysWhatLimitsTheResult) {
    design::DesignReport report = sample();
    report.bound = 0.3;
    report.wanted_of_softest = 12.0;
    report.reach_of_ten_loads = 0.9;
    report.error->is_stable_from_flat = false;
    report.warnings = {{"/goals/0 wants the moon"}};
    const std::string all = base::join(design_limits(report), "\n");
    for (const char* part : {"no proof", "100 % shall take curvatures", "30 % (root mean square)", "12 times",
                             "Ten times the load", "snaps", "2 starts", "wants the moon."})
        EXPECT_THAT(all, HasSubstr(part));
}

/// A design that was stopped before its check has no shapes.
TEST(DesignPage, IsMadeWithoutACheck) {
    design::DesignReport report = sample();
    report.shapes.clear();
    report.error.reset();
    const auto json = base::JsonReader::from_text(data_of(design_html(report, {})), "page");
    EXPECT_TRUE(json.at("shapes").elements().empty());
    EXPECT_EQ(json.at("title").string(), "Design");
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
