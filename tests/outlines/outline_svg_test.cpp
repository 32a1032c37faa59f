// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

#include <numbers>

namespace fretwork::outlines {
namespace THIS_TEST {

using geometry::Point2;
using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr double kMillimetre = 1e-3;
/// Curves become polygons within 0.02 mm, so an area is off by less than that times the curve's length.
constexpr double kFlat = 2e-5;

/// A drawing of 200 x 100 mm in millimetres.
std::string drawing(const std::string& content) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">)" +
           content + "</svg>";
}

Outline read(const std::string& svg) {
    const TemporaryFolder folder;
    return read_outline(folder.file("o.svg", svg));
}
Outline read_path(const std::string& d) {
    return read(drawing(R"(<path d=")" + d + R"("/>)"));
}
std::string refuse(const std::string& svg) {
    return refuse_file("o.svg", svg);
}

TEST(OutlineSvg, YPointsUpSoThatThePictureIsNotMirrored) {
    const Outline outline = read_path("M 10 90 H 60 V 80 H 10 Z");  // near the lower edge of the picture
    const auto [low, high] = box_of(outline.boundary);
    EXPECT_NEAR(low.x, 0.010, 1e-15);
    EXPECT_NEAR(high.x, 0.060, 1e-15);
    EXPECT_NEAR(low.y, 0.010, 1e-15);
    EXPECT_NEAR(high.y, 0.020, 1e-15);
}

TEST(OutlineSvg, RelativeAndAbsoluteCommandsAreTheSameCurve) {
    const std::string absolute =
        "M 50 20 L 90 20 H 120 V 40 C 130 50 130 60 120 70 S 100 90 90 80 Q 80 70 70 80 T 50 80 A 10 20 30 0 "
        "1 40 60 Z";
    const std::string relative =
        "m 50 20 l 40 0 h 30 v 20 c 10 10 10 20 0 30 s -20 20 -30 10 q -10 -10 -20 0 t -20 0 a 10 20 30 0 1 "
        "-10 -20 z";
    const Outline a = read_path(absolute);
    const Outline b = read_path(relative);
    ASSERT_EQ(a.boundary.size(), b.boundary.size());
    for (std::size_t i = 0; i < a.boundary.size(); ++i) {
        EXPECT_NEAR(a.boundary[i].x, b.boundary[i].x, 1e-12);
        EXPECT_NEAR(a.boundary[i].y, b.boundary[i].y, 1e-12);
    }
}

TEST(OutlineSvg, NumbersNeedNoSpacesWhereTheGrammarNeedsNone) {
    EXPECT_EQ(read_path("M10,10L60.5.5.5,60z").boundary, read_path("M 10 10 L 60.5 0.5 L 0.5 60 Z").boundary);
    EXPECT_EQ(read_path("m10-0 50+60-50-0z").boundary, read_path("M 10 0 L 60 60 L 10 60 Z").boundary);
    EXPECT_NEAR(area_of(read_path("M40 50a20 20 0 1140 0a20 20 0 11-40 0z")),
                area_of(read_path("M40 50 a 20 20 0 1 1 40 0 a 20 20 0 1 1 -40 0 z")), 1e-15);
    EXPECT_EQ(read_path("M1e1 1E1 H6e+1 V600e-1z").boundary, read_path("M 10 10 H 60 V 60 Z").boundary);
}

TEST(OutlineSvg, SmoothCommandsReflectTheControlPointBefore) {
    EXPECT_EQ(read_path("M10 50 C10 20 40 20 40 50 S70 80 70 50 V90 H10 Z").boundary,
              read_path("M10 50 C10 20 40 20 40 50 C40 80 70 80 70 50 V90 H10 Z").boundary);
    EXPECT_EQ(read_path("M10 50 Q25 20 40 50 T70 50 V90 H10 Z").boundary,
              read_path("M10 50 Q25 20 40 50 Q55 80 70 50 V90 H10 Z").boundary);
    EXPECT_EQ(read_path("M10 50 L40 50 S60 20 70 50 V90 H10 Z").boundary,  // no curve before: no reflection
              read_path("M10 50 L40 50 C40 50 60 20 70 50 V90 H10 Z").boundary);
}

TEST(OutlineSvg, ArcsTakeTheSideAndTheLengthThatTheirFlagsSay) {
    // A chord of 20 in a circle of radius 10 sqrt(2): the segments have pi/2 and 3 pi/2 of angle.
    const double r2 = 200;
    const double small = 0.5 * r2 * (kPi / 2 - 1);
    const double large = kPi * r2 - small;
    const auto segment = [](const std::string& flags) {
        return read_path("M 50 50 A 14.142135623730951 14.142135623730951 0 " + flags + " 70 50 Z");
    };
    EXPECT_NEAR(area_of(segment("0 0")), small * 1e-6, kFlat * 0.1);
    EXPECT_NEAR(area_of(segment("1 0")), large * 1e-6, kFlat * 0.1);
    // Sweep 1 goes by growing angles, which is clockwise in a picture: above the chord from left to right.
    EXPECT_GT(box_of(segment("0 1").boundary)[1].y, 0.0501);
    EXPECT_LT(box_of(segment("0 0").boundary)[1].y, 0.0501);
}

TEST(OutlineSvg, AnArcTooSmallForItsChordGrows) {
    EXPECT_NEAR(area_of(read_path("M 50 50 A 1 1 0 0 1 70 50 Z")), 0.5 * kPi * 100e-6, kFlat * 0.1);
    EXPECT_NEAR(area_of(read_path("M 50 50 A 0 5 0 0 1 70 50 L 60 60 Z")), 100e-6,
                1e-15);  // radius 0: a line
}

TEST(OutlineSvg, ShapesHaveTheirAreas) {
    const auto area = [](const std::string& shape) {
        return area_of(read(drawing(shape))) / (kMillimetre * kMillimetre);
    };
    const double off = kFlat / kMillimetre * 300;  // tolerance times length, in square millimetres
    EXPECT_NEAR(area(R"(<rect x="10" y="10" width="50" height="20"/>)"), 1000, 1e-9);
    EXPECT_NEAR(area(R"(<rect x="10" y="10" width="50" height="20" rx="5"/>)"), 1000 - (4 - kPi) * 25, off);
    EXPECT_NEAR(area(R"(<rect width="50" height="20" rx="8" ry="4"/>)"), 1000 - (4 - kPi) * 32, off);
    EXPECT_NEAR(area(R"(<rect width="50" height="20" ry="100"/>)"), kPi / 4 * 1000, off);
    EXPECT_NEAR(area(R"(<circle cx="50" cy="50" r="40"/>)"), kPi * 1600, off);
    EXPECT_NEAR(area(R"(<ellipse cx="50" cy="50" rx="40" ry="10"/>)"), kPi * 400, off);
    EXPECT_NEAR(area(R"(<polygon points="0,0 40,0 40,30"/>)"), 600, 1e-9);
    EXPECT_NEAR(area(R"(<polyline points="0 0 40 0 40 30 0 0"/>)"), 600, 1e-9);
}

TEST(OutlineSvg, CurvesStayWithinTheToleranceOfTheFlattening) {
    const Outline outline = read(drawing(R"(<circle cx="50" cy="50" r="40"/>)"));
    for (std::size_t i = 0; i < outline.boundary.size(); ++i) {
        const Point2 a = outline.boundary[i];
        const Point2 b = outline.boundary[(i + 1) % outline.boundary.size()];
        EXPECT_NEAR(std::hypot(a.x - 0.05, a.y - 0.05), 0.04, 1e-7);
        EXPECT_NEAR(std::hypot((a.x + b.x) / 2 - 0.05, (a.y + b.y) / 2 - 0.05), 0.04, kFlat);
    }
}

TEST(OutlineSvg, LengthsComeFromWidthHeightAndViewBox) {
    const auto width_of = [](const std::string& attributes, const std::string& shape) {
        const auto [low, high] = box_of(read("<svg " + attributes + ">" + shape + "</svg>").boundary);
        return high.x - low.x;
    };
    const std::string ten = R"(<rect width="10" height="10"/>)";
    EXPECT_NEAR(width_of(R"(width="100" height="100")", ten), 10 * 0.0254 / 96, 1e-15);
    EXPECT_NEAR(width_of(R"(width="100px" height="100px")", ten), 10 * 0.0254 / 96, 1e-15);
    EXPECT_NEAR(width_of(R"(width="10cm" height="10cm" viewBox="0 0 100 100")", ten), 0.01, 1e-15);
    EXPECT_NEAR(width_of(R"(width="1in" height="1in" viewBox="0 0 100 100")", ten), 0.00254, 1e-15);
    EXPECT_NEAR(width_of(R"(width="72pt" height="6pc" viewBox="5 5 100 100")", ten), 0.00254, 1e-15);
    EXPECT_NEAR(width_of(R"(width="100mm" height="100mm")", R"(<rect width="2cm" height="5mm"/>)"), 0.02,
                1e-15);
    // "meet" takes the smaller scale, "none" each its own.
    EXPECT_NEAR(width_of(R"(width="200mm" height="100mm" viewBox="0 0 100 100")", ten), 0.01, 1e-15);
    EXPECT_NEAR(
        width_of(R"(width="200mm" height="100mm" viewBox="0 0 100 100" preserveAspectRatio="none")", ten),
        0.02, 1e-15);
}

TEST(OutlineSvg, TransformsNestAndComposeFromTheRight) {
    const auto corner = [](const std::string& content) { return box_of(read(drawing(content)).boundary)[0]; };
    const std::string square = "<rect width='10' height='10'";
    // Lower left corner in metres: the picture is 100 mm high.
    const auto near = [](Point2 there, double x, double y) {
        EXPECT_NEAR(there.x, x * kMillimetre, 1e-12);
        EXPECT_NEAR(there.y, (100 - y) * kMillimetre, 1e-12);
    };
    near(corner(square + " transform='translate(20,30)'/>"), 20, 40);
    near(corner(square + " transform='translate(20 30) scale(2)'/>"), 20, 50);
    near(corner(square + " transform='scale(2), translate(20 30)'/>"), 40, 80);
    near(corner(square + " transform='rotate(90 20 20)'/>"), 30, 10);
    near(corner(square + " transform='matrix(0 1 -1 0 40 0)'/>"), 30, 10);
    near(corner(square + " transform='skewX(45)'/>"), 0, 10);
    near(corner("<g transform='translate(20)'><g transform='scale(2 3)'>" + square + "/></g></g>"), 20, 30);
}

TEST(OutlineSvg, WhatIsNotDrawnDoesNotCount) {
    EXPECT_EQ(
        read(drawing(R"(<defs><circle id="c" r="5"/></defs><title>t</title><g display="none"><rect/></g>)"
                     R"(<path style="display : none" d="M"/><sodipodi:namedview xmlns:sodipodi="s"/>)"
                     R"(<rect width="10" height="10"/>)"))
            .boundary.size(),
        4U);
}

TEST(OutlineSvg, GroupsNestOnlySoDeep) {
    const auto nested = [](int depth) {
        std::string text;
        for (int i = 0; i < depth; ++i) text += "<g>";
        text += "<rect width='10' height='10'/>";
        for (int i = 0; i < depth; ++i) text += "</g>";
        return drawing(text);
    };
    EXPECT_THAT(refuse(nested(100000)), AllOf(HasSubstr("line 1, g"), HasSubstr("256")));
    EXPECT_NEAR(area_of(read(nested(200))), 100e-6, 1e-12);
}

TEST(OutlineSvg, ACurveBeyondAllMeasureIsRefused) {
    EXPECT_THAT(refuse(drawing("<circle r='1e200'/>")), HasSubstr("is the unit right?"));
}

TEST(OutlineSvg, ACurveFarOutsideTheDrawingIsRefused) {
    const std::string spike = R"(<path id="rim" d="M0 0 L200 0 C200 40 100000 50 200 100 L0 100 Z"/>)";
    EXPECT_THAT(refuse(drawing(spike)),
                AllOf(HasSubstr("path 'rim'"), HasSubstr("0.2 m wide and 0.1 m high")));
    EXPECT_NO_THROW(read_path("M-150 0 L200 0 L200 300 L0 100 Z"));
}

TEST(OutlineSvg, ComplaintsNameLineElementAndValue) {
    EXPECT_THAT(refuse("<svg width='1mm'"), HasSubstr("malformed XML"));
    EXPECT_THAT(refuse(""), HasSubstr("malformed XML"));
    EXPECT_THAT(refuse("<html/>"), HasSubstr("no SVG drawing"));
    EXPECT_THAT(refuse("<svg/>"), HasSubstr("nothing in it is filled"));
    EXPECT_THAT(refuse(R"(<svg width="-3mm" height="1mm"/>)"), HasSubstr("\"-3mm\""));
    EXPECT_THAT(refuse(R"(<svg width="1mm" height="1mm" viewBox="0 0 1"/>)"), HasSubstr("viewBox"));
    EXPECT_THAT(refuse(drawing("")), HasSubstr("nothing in it is filled"));
    EXPECT_THAT(
        refuse(drawing("\n\n<path id='rim' d='M 0 0 L 10 x'/>")),
        AllOf(HasSubstr("line 3"), HasSubstr("path 'rim'"), HasSubstr("character 12"), HasSubstr("'x'")));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 L 10'/>")), HasSubstr("the end"));
    EXPECT_THAT(refuse(drawing("<path d='L 0 0'/>")), HasSubstr("begins with M"));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 B 1 1'/>")), HasSubstr("not a command"));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 L nan 1'/>")), HasSubstr("a number is expected"));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 L 1e999 1'/>")), HasSubstr("a number is expected"));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 A 1 1 0 2 0 5 5 Z'/>")), HasSubstr("a flag"));
    EXPECT_THAT(refuse(drawing("<path d='M 0 0 h 1 z 5 5'/>")), HasSubstr("a command is expected"));
    EXPECT_THAT(refuse(drawing("<rect width='5' height='-1'/>")),
                AllOf(HasSubstr("height"), HasSubstr("\"-1\"")));
    EXPECT_THAT(refuse(drawing("<circle r='-2'/>")), HasSubstr("at least zero"));
    EXPECT_THAT(refuse(drawing("<rect width='5furlong' height='1'/>")), HasSubstr("furlong"));
    EXPECT_THAT(refuse(drawing("<polygon points='0 0 1 0 1'/>")), HasSubstr("a number is expected"));
    EXPECT_THAT(refuse(drawing("<g transform='turn(3)'><rect/></g>")), HasSubstr("'turn'"));
    EXPECT_THAT(refuse(drawing("<g transform='scale(1 2 3)'><rect/></g>")), HasSubstr("3 numbers"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
