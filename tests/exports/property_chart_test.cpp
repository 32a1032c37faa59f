// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/exports/drawings/detail/chart_svg.hpp>
#include <fretwork/exports/drawings/property_chart.hpp>

#include <pugixml.hpp>

namespace fretwork::exports {
namespace THIS_TEST {

using test::complaint_of;
using testing::ElementsAre;
using testing::HasSubstr;

const pattern::NodeLayout& paper_layout() {
    static const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    return layout;
}

PatternProperties make(const char* id, double mass, double stiffness, double poisson) {
    return {pattern::parse_pattern_id(paper_layout(), id),
            {{"mass_per_area", mass},
             {"membrane_stiffness", stiffness},
             {"membrane_poisson", poisson},
             {"bending_stiffness", 1e-3 * mass}}};
}

std::vector<PatternProperties> sample() {
    return {make("0-1+1-6", 0.5, 1e3, -0.5), make("1-3+3-6", 0.7, 1e5, 0.1), make("2-4+2-6", 0.4, 1e4, 0.6)};
}

std::string chart(const std::vector<PatternProperties>& patterns) {
    const reduction::Setting setting = reduction::paper_setting();
    return property_chart_svg({paper_layout(), setting}, patterns);
}

/// The points of a panel, as pattern id and place; the first panel holds the first half of them.
struct Point {
    std::string id;
    double x;
    double y;
};
std::vector<Point> points_of(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    std::vector<Point> points;
    for (const pugi::xml_node& circle : document.child("svg").children("circle")) {
        const std::string title = circle.child("title").text().get();
        if (title.empty()) continue;
        points.push_back({title.substr(0, title.find('\n')), circle.attribute("cx").as_double(),
                          circle.attribute("cy").as_double()});
    }
    return points;
}

TEST(PropertyChart, HasANamedPointForEachPatternInEachPanel) {
    const auto points = points_of(chart(sample()));
    ASSERT_EQ(points.size(), 6U);
    EXPECT_EQ(points[0].id, "0-1+1-6");
    EXPECT_EQ(points[5].id, "2-4+2-6");
}

TEST(PropertyChart, PlacesPointsByTheLogarithmsOfTheirProperties) {
    const auto points = points_of(chart(sample()));
    ASSERT_EQ(points.size(), 6U);
    // In-plane stiffness upwards: 1e3, 1e5, 1e4 are evenly spaced; SVG counts down.
    EXPECT_NEAR(points[0].y - points[2].y, points[2].y - points[1].y, 0.02);
    EXPECT_GT(points[0].y, points[2].y);
    // In the second panel the same stiffness goes across.
    EXPECT_NEAR(points[5].x - points[3].x, points[4].x - points[5].x, 0.02);
    EXPECT_GT(points[5].x, points[3].x);
    // Mass across, the lightest leftmost.
    EXPECT_LT(points[2].x, points[0].x);
    EXPECT_LT(points[0].x, points[1].x);
}

TEST(PropertyChart, IsLegibleOnAPage) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(chart(sample()).c_str()));
    const auto root = document.child("svg");
    const double millimetres_a_pixel =
        root.attribute("data-print-width").as_double() / root.attribute("width").as_double();
    ASSERT_LE(root.attribute("data-print-width").as_double(), 177.0);
    for (const auto& text : root.children("text"))
        EXPECT_GE(text.attribute("font-size").as_double() * millimetres_a_pixel, 6.0 * 25.4 / 72.0)
            << text.child_value();
}

TEST(PropertyChart, RefusesPatternsWithoutPositiveProperties) {
    EXPECT_THAT(complaint_of([] { (void)chart({}); }), HasSubstr("no pattern"));
    auto patterns = sample();
    patterns[1].values.erase("membrane_poisson");
    EXPECT_THAT(complaint_of([&] { (void)chart(patterns); }), HasSubstr("no property membrane_poisson"));
    patterns = sample();
    patterns[1].values["mass_per_area"] = 0.0;
    EXPECT_THAT(complaint_of([&] { (void)chart(patterns); }), HasSubstr("mass per area"));
}

TEST(LogAxis, HasTicksAtRoundValuesAndContainsAllValues) {
    const std::array values = {3.0, 250.0};
    const detail::LogAxis axis = detail::axis_of("x", values);
    EXPECT_GT(axis.share(3.0), 0.0);
    EXPECT_LT(axis.share(250.0), 1.0);
    EXPECT_NEAR(axis.share(std::sqrt(3.0 * 250.0)), 0.5, 1e-12);
    EXPECT_THAT(axis.ticks(), ElementsAre(5.0, 10.0, 20.0, 50.0, 100.0, 200.0));
    EXPECT_THAT((detail::LogAxis{"x", 0.5, 2e3}.ticks()), ElementsAre(1.0, 10.0, 100.0, 1000.0));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
