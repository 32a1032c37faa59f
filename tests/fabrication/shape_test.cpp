// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <set>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Point2;

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kLength = 0.02;  // m
/// The area by which the grid of a nanometre may change some centimetres of contour, m2.
constexpr double kAreaTolerance = 1e-10;
constexpr double kLengthTolerance = 1e-7;  // m

/// The area of bars at equal angles (two or more) around a node. Of each bar, beyond the kites that
/// neighbours share at the node, a rectangle is left; its other end is round.
double star_area(int bars) {
    const double kite_length = 0.5 * kWidth / std::tan(kPi / bars);
    const double kite = kite_length * 0.5 * kWidth;  // half of the overlap of two neighbours
    return bars * (kLength * kWidth + 0.125 * kPi * kWidth * kWidth - kite);
}

TEST(Shape, OneBarIsAStadium) {
    const BarPlan plan = plan_of({{0.0, 0.0}, {kLength, 0.0}}, {{0, 1}});
    const Shape shape = make_shape(plan, {});
    ASSERT_EQ(shape.pieces.size(), 1U);
    EXPECT_NEAR(area(shape), kLength * kWidth + 0.25 * kPi * kWidth * kWidth, kAreaTolerance);
    EXPECT_NEAR(cut_length(shape), 2.0 * kLength + kPi * kWidth, kLengthTolerance);
    EXPECT_DOUBLE_EQ(shape.height, plan.height);
}

TEST(Shape, TwoCrossingBarsOverlapInASquare) {
    const Shape shape = make_shape(star(4, kLength), {});
    const double bar = 2.0 * kLength * kWidth + 0.25 * kPi * kWidth * kWidth;
    EXPECT_NEAR(area(shape), 2.0 * bar - kWidth * kWidth, kAreaTolerance);
    EXPECT_NEAR(area(shape), star_area(4), kAreaTolerance);
}

TEST(Shape, AJointOfEqualAnglesHasTheAreaOfItsBarsLessTheirOverlap) {
    for (const int bars : {3, 4, 5, 6, 8, 12}) {
        const Shape shape = make_shape(star(bars, kLength), {});
        ASSERT_EQ(shape.pieces.size(), 1U);
        EXPECT_TRUE(shape.pieces[0].openings.empty());
        EXPECT_NEAR(area(shape), star_area(bars), kAreaTolerance) << bars;
    }
}

TEST(Shape, FreeEndsAreTrueArcs) {
    for (const int bars : {1, 3, 5}) {
        const Shape shape = make_shape(star(bars, kLength), {});
        double swept = 0.0;
        const Contour& outer = shape.pieces.at(0).outer;
        for (std::size_t i = 0; i < outer.size(); ++i) {
            if (outer[i].bulge == 0.0) continue;
            const Arc arc = arc_between(outer[i], outer[(i + 1) % outer.size()].place);
            EXPECT_NEAR(arc.radius, 0.5 * kWidth, 2e-8);
            swept += arc.sweep;
        }
        EXPECT_NEAR(swept, kPi * (bars == 1 ? 2 : bars), 1e-3) << bars;
    }
}

TEST(Shape, KerfMovesContoursByHalfOfItself) {
    const double kerf = 2e-4;
    const BarPlan plan = plan_of({{0.0, 0.0}, {kLength, 0.0}}, {{0, 1}});
    const Shape drawn = make_shape(plan, {});
    const Shape cut = make_shape(plan, {.kerf = kerf});
    EXPECT_NEAR(cut_length(cut) - cut_length(drawn), kPi * kerf, kLengthTolerance);
    EXPECT_NEAR(area(cut) - area(drawn), cut_length(drawn) * 0.5 * kerf + 0.25 * kPi * kerf * kerf,
                kAreaTolerance);
}

TEST(Shape, KerfMakesOpeningsSmallerAndLeavesTheirFilletsWithAnEqualCenter) {
    const BarPlan plan = plan_of({{0.0, 0.0}, {kLength, 0.0}, {kLength, kLength}, {0.0, kLength}},
                                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    const Shape drawn = make_shape(plan, {.fillet = 1e-3});
    const Shape cut = make_shape(plan, {.fillet = 1e-3, .kerf = 2e-4});
    const double side = kLength - kWidth;
    const auto rounded = [](double square_side, double radius) {
        return square_side * square_side - (4.0 - kPi) * radius * radius;
    };
    EXPECT_NEAR(-signed_area(drawn.pieces.at(0).openings.at(0)), rounded(side, 1e-3), kAreaTolerance);
    EXPECT_NEAR(-signed_area(cut.pieces.at(0).openings.at(0)), rounded(side - 2e-4, 0.9e-3), kAreaTolerance);
    EXPECT_NEAR(length(drawn.pieces[0].openings[0]) - length(cut.pieces[0].openings[0]), 2.0 * kPi * 1e-4,
                kLengthTolerance);
}

TEST(Shape, AFilletThatDoesNotFitIsAsLargeAsItCanBe) {
    const double side = 0.012;
    const BarPlan plan =
        plan_of({{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    const Shape shape = make_shape(plan, {.fillet = 0.1});
    const double radius = 0.5 * (side - kWidth);
    EXPECT_NEAR(-signed_area(shape.pieces.at(0).openings.at(0)), kPi * radius * radius, kAreaTolerance);
}

TEST(Shape, BarsInABarelyOpenTriangleLeaveNoOpening) {
    const double height = 1.5 * kWidth * 0.99;  // the circle inside has a radius of a third of it
    const double half = height / std::sqrt(3.0);
    const BarPlan plan = plan_of({{-half, 0.0}, {half, 0.0}, {0.0, height}}, {{0, 1}, {1, 2}, {2, 0}});
    EXPECT_EQ(opening_count(make_shape(plan, {})), 0U);
}

TEST(Shape, ABarInsideOfAnOpeningIsAPieceOfItsOwn) {
    BarPlan plan = plan_of({{0.0, 0.0}, {0.03, 0.0}, {0.03, 0.03}, {0.0, 0.03}, {0.01, 0.01}, {0.02, 0.015}},
                           {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
    const Shape shape = make_shape(plan, {});
    ASSERT_EQ(shape.pieces.size(), 2U);
    EXPECT_EQ(opening_count(shape), 1U);
}

TEST(Shape, ABoltHasAnEyeAroundItsHole) {
    const BarPlan plan = star(3, kLength);
    const ShapeOptions options{
        .bolt_diameter = 3e-3, .eye_diameter = 7e-3, .bolts = {TessellationNodeIndex(0)}};
    const Shape shape = make_shape(plan, options);
    ASSERT_EQ(shape.pieces.at(0).openings.size(), 1U);
    EXPECT_NEAR(-signed_area(shape.pieces[0].openings[0]), 0.25 * kPi * 9e-6, 1e-15);
    const double eye = 0.25 * kPi * 49e-6;
    // The part of each bar that the eye does not cover: the bar from the eye's circle on.
    const double radius = 3.5e-3, half = 0.5 * kWidth;
    const double covered =
        half * std::sqrt(radius * radius - half * half) + radius * radius * std::asin(half / radius);
    const double bar = kLength * kWidth + 0.125 * kPi * kWidth * kWidth - covered;
    EXPECT_NEAR(area(shape), eye + 3.0 * bar - 0.25 * kPi * 9e-6, 1e-9);  // chords where bars cut the circle
}

TEST(Shape, AHoleForABoltWhereNoBarEndsIsRefusedByNode) {
    BarPlan plan = star(3, kLength);
    plan.nodes.push_back({0.5 * kLength, 0.5 * kLength});
    for (const TessellationNodeIndex node :
         {TessellationNodeIndex(4), TessellationNodeIndex(5), TessellationNodeIndex()})
        EXPECT_THAT(complaint_of([&] { (void)make_shape(plan, {.bolt_diameter = 1e-3, .bolts = {node}}); }),
                    HasSubstr("a bolt at node " + std::to_string(node)));
}

TEST(Shape, HolesThatMeetAreRefusedByNode) {
    const BarPlan plan = plan_of({{0.0, 0.0}, {0.004, 0.0}, {0.05, 0.0}}, {{0, 1}, {1, 2}});
    const ShapeOptions options{.bolt_diameter = 5e-3,
                               .bolts = {TessellationNodeIndex(0), TessellationNodeIndex(1)}};
    EXPECT_THAT(complaint_of([&] { (void)make_shape(plan, options); }),
                AllOf(HasSubstr("nodes 0 and 1"), HasSubstr("mm")));
}

TEST(Shape, OptionsThatMakeNoSenseAreRefused) {
    const BarPlan plan = star(3, kLength);
    for (const ShapeOptions& wrong :
         {ShapeOptions{.fillet = -1.0}, ShapeOptions{.kerf = -1e-4}, ShapeOptions{.frame_width = NAN},
          ShapeOptions{.bolt_diameter = 3e-3, .eye_diameter = 2e-3},
          ShapeOptions{.kerf = 1e-3, .bolt_diameter = 5e-4}})
        EXPECT_THROW((void)make_shape(plan, wrong), base::InputError);
}

TEST(Shape, LengthsAboveTheSurfacesOwnAreRefusedWithBoth) {
    const BarPlan plan = star(3, kLength);
    for (const ShapeOptions& wrong :
         {ShapeOptions{.kerf = 5.0}, ShapeOptions{.frame_width = 5.0}, ShapeOptions{.bolt_diameter = 5.0},
          ShapeOptions{.bolt_diameter = 1e-3, .eye_diameter = 5.0}})
        EXPECT_THAT(complaint_of([&] { (void)make_shape(plan, wrong); }),
                    AllOf(HasSubstr(" is 5 m"), HasSubstr("whole surface")));
}

TEST(Shape, TilesInOnePieceStayInOnePieceAndCoverNoMoreThanTheirBars) {
    const std::vector<std::string> patterns = sample_patterns(60);
    for (const std::string& id : patterns) {
        const simulation::Surface surface = honeycomb(3, 2, {id});
        const BarPlan plan = bar_plan(surface);
        const Shape shape = make_shape(plan, {});
        EXPECT_EQ(shape.pieces.size(), 1U) << id;
        EXPECT_GT(area(shape), 0.0) << id;
        EXPECT_LT(area(shape), area_of_bars(plan)) << id;
    }
}

TEST(Shape, OpeningsAreThoseOfTheGraphWhereBarsAreThin) {
    const std::vector<std::string> patterns = sample_patterns(40);
    for (const std::string& id : patterns) {
        simulation::Surface surface = honeycomb(2, 2, {id});
        surface.setting.section = mechanics::rectangle_section(2e-5, 1e-3);
        const BarPlan plan = bar_plan(surface);
        std::set<int> nodes;
        for (const Bar& bar : plan.bars) nodes.insert({bar.nodes[0], bar.nodes[1]});
        EXPECT_EQ(opening_count(make_shape(plan, {})), plan.bars.size() - nodes.size() + 1) << id;  // Euler
    }
}

TEST(Shape, BarsTooNarrowForTheGridAreRefused) {
    simulation::Surface surface = honeycomb(4, 3, {"0-5+5-6", "1-2+1-4+4-6"});
    surface.setting.section = mechanics::rectangle_section(1e-6, 1e-3);
    EXPECT_THAT(complaint_of([&] { (void)make_shape(surface); }),
                AllOf(HasSubstr("bars are 0.001 mm wide"), HasSubstr("at least 0.003203 mm")));
    surface.setting.section = mechanics::rectangle_section(3.3e-6, 1e-3);
    const double bars = area_of_bars(bar_plan(surface));
    const double made = area(make_shape(surface));
    EXPECT_LT(made, bars);
    EXPECT_GT(made, 0.998 * bars) << "joints are small";
}

TEST(Shape, DoesNotDependOnWhereTheSurfaceLies) {
    simulation::Surface surface = honeycomb(3, 3, sample_patterns(9));
    const Shape here = make_shape(surface);
    const auto move = [](auto& points) {
        for (Point2& point : points) point = {point.x + 1.2345678, point.y - 2.3456789};
    };
    move(surface.tessellation.vertices);
    move(surface.tessellation.interface_nodes);
    const Shape there = make_shape(surface);
    EXPECT_NEAR(area(here), area(there), kAreaTolerance);
    EXPECT_EQ(opening_count(here), opening_count(there));
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
