// SPDX-License-Identifier: GPL-3.0-or-later
// The areas that a browser would fill: fill rules, unions, clips, copies, switches, sizes.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

#include <numbers>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A drawing of 200 x 100 mm in millimetres.
OutlineFile read(const std::string& content) {
    const TemporaryFolder folder;
    return read_outline_file(folder.file(
        "o.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">)" +
            content + "</svg>"));
}
/// Square millimetres of all parts; nothing filled is 0.
double filled(const std::string& content) {
    try {
        double area = 0;
        for (const Outline& part : read(content).parts) area += area_of(part);
        return 1e6 * area;
    } catch (const base::GeometryError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nothing in it is filled"));
        return 0;
    }
}
std::size_t holes(const std::string& content) {
    return read(content).parts.front().holes.size();
}
constexpr double kExact = 1e-6;  // square millimetres: straight sides

TEST(SvgFill, NonzeroCountsTurnsAndEvenoddCountsCrossings) {
    const std::string same_turn = "d='M 0 0 H 100 V 100 H 0 Z M 20 20 H 40 V 40 H 20 Z'";
    const std::string other_turn = "d='M 0 0 H 100 V 100 H 0 Z M 20 20 V 40 H 40 V 20 Z'";
    EXPECT_NEAR(filled("<path " + same_turn + "/>"), 10000, kExact);
    EXPECT_NEAR(filled("<path " + other_turn + "/>"), 9600, kExact);
    EXPECT_NEAR(filled("<path fill-rule='evenodd' " + same_turn + "/>"), 9600, kExact);
    EXPECT_EQ(holes("<path " + same_turn + "/>"), 0U);
    EXPECT_EQ(holes("<path " + other_turn + "/>"), 1U);
}

TEST(SvgFill, AnIslandInAHoleIsAPartOfItsOwn) {
    const OutlineFile file = read(
        "<path fill-rule='evenodd' d='M0 0H90V90H0Z M10 10H80V80H10Z M20 20H70V70H20Z M30 30H60V60H30Z'/>");
    ASSERT_EQ(file.parts.size(), 2U);
    EXPECT_NEAR(1e6 * area_of(file.parts[0]), 8100 - 4900, kExact);
    EXPECT_NEAR(1e6 * area_of(file.parts[1]), 2500 - 900, kExact);
}

TEST(SvgFill, OverlappingShapesAreTheirUnion) {
    EXPECT_NEAR(filled("<rect width='20' height='20'/><rect x='10' y='10' width='20' height='20'/>"), 700,
                kExact);
    EXPECT_NEAR(filled("<rect width='20' height='20'/><rect x='20' width='20' height='20'/>"), 800, kExact);
    EXPECT_EQ(read("<rect width='20' height='20'/><rect x='20' width='20' height='20'/>").parts.size(), 1U);
    EXPECT_EQ(read("<rect width='20' height='20'/><rect x='21' width='20' height='20'/>").parts.size(), 2U);
    // Four bars around a window.
    EXPECT_EQ(holes("<rect width='50' height='10'/><rect y='40' width='50' height='10'/><rect width='10' "
                    "height='50'/>"
                    "<rect x='40' width='10' height='50'/>"),
              1U);
}

TEST(SvgFill, ABarAcrossAHoleMakesTwoHoles) {
    EXPECT_EQ(holes("<path fill-rule='evenodd' d='M0 0H90V90H0Z M10 10H80V80H10Z'/><rect y='40' width='90' "
                    "height='5'/>"),
              2U);
}

TEST(SvgFill, ACurveThatCrossesItselfIsFilledAsBrowsersDo) {
    EXPECT_NEAR(filled("<path d='M 0 0 L 10 10 L 10 0 L 0 10 Z'/>"), 50, kExact);
    EXPECT_EQ(read("<path d='M 0 0 L 10 10 L 10 0 L 0 10 Z'/>").parts.size(), 2U);
    const std::string star = "d='M 50 0 L 79.4 90.5 L 2.4 34.5 L 97.6 34.5 L 20.6 90.5 Z'";
    EXPECT_EQ(holes("<path " + star + "/>"), 0U);
    EXPECT_EQ(read("<path fill-rule='evenodd' " + star + "/>").parts.size(), 5U);
}

TEST(SvgFill, WhereAPartTouchesItselfItIsOpenedALittle) {
    // A hole whose corner lies on the boundary.
    const OutlineFile file = read("<path fill-rule='evenodd' d='M0 0H100V100H0Z M0 50L30 30V70Z'/>");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_THAT(file.parts.front().holes, IsEmpty());
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 10000 - 600, 2);
    EXPECT_THAT(file.remarks, Contains(HasSubstr("1 point where the shape touches itself")));
}

TEST(SvgFill, OpenPathsAreClosedAndLinesWithoutAreaAreNothing) {
    EXPECT_NEAR(filled("<path d='M 0 0 L 10 0 L 10 10'/>"), 50, kExact);
    EXPECT_NEAR(filled("<polyline points='0 0 10 0 10 10'/>"), 50, kExact);
    EXPECT_EQ(filled("<path d='M 0 0 H 10 Z'/><polygon points='0 0 1 0'/><circle r='0'/><rect width='5'/>"),
              0);
}

TEST(SvgFill, WhereNothingIsFilledClosedLinesAreOutlines) {
    const std::string style = " fill='none' stroke='#000'";
    const OutlineFile ring =
        read("<circle cx='20' cy='20' r='15'" + style + "/><circle cx='20' cy='20' r='5'" + style +
             "/><line x2='5' stroke='red'/>");
    ASSERT_EQ(ring.parts.size(), 1U);
    EXPECT_EQ(ring.parts.front().holes.size(), 1U);
    EXPECT_THAT(ring.remarks,
                ElementsAre("nothing is filled: the closed lines are taken as 1 outline with 1 hole",
                            "1 open line (the longest, 5 mm, at line 1, line) left out"));
    EXPECT_NEAR(filled("<path d='M0 0H10V10H0V0'" + style + "/>"), 100, kExact) << "the ends meet";
    EXPECT_NEAR(filled("<rect width='9' height='5'" + style + "/>"), 45, kExact);
    EXPECT_NEAR(filled("<polygon points='0 0 10 0 10 10'" + style + "/>"), 50, kExact);
}

TEST(SvgFill, OpenOrInvisibleLinesAreNoOutline) {
    EXPECT_THAT(complaint_of([] {
                    read("<path d='M0 0H10V10' fill='none' stroke='#000'/><line x2='5' stroke='red'/>");
                }),
                AllOf(HasSubstr("nothing in it is filled"), HasSubstr("none of its 2 lines is closed")));
    EXPECT_THAT(complaint_of([] { read("<rect width='9' height='9' fill='none'/>"); }),
                HasSubstr("nothing in it is filled"));
    EXPECT_THAT(complaint_of([] {
                    read("<rect width='9' height='9' fill='none' stroke='#000' visibility='hidden'/>");
                }),
                HasSubstr("nothing in it is filled"));
}

TEST(SvgFill, WhereSomethingIsFilledLinesAreLeftOut) {
    EXPECT_EQ(
        read("<rect width='9' height='9'/><path d='M0 0 nonsense' fill='none' stroke='#000'/>").parts.size(),
        1U)
        << "nobody looks at them";
    EXPECT_THAT(read("<rect width='9' height='9'/><line x2='5' stroke='red'/>").remarks,
                ElementsAre("1 unfilled line left out"));
    const OutlineFile file =
        read("<rect width='9' height='9'/><rect width='99' height='90' fill='none' stroke='#000'/>");
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 81, 1e-6);
    EXPECT_THAT(file.remarks, ElementsAre("1 unfilled line left out"));
}

TEST(SvgFill, AClipLeavesWhatLiesInIt) {
    const std::string half = "<clipPath id='c'><rect width='10' height='100'/></clipPath>";
    const std::string square = "<rect width='20' height='20' clip-path='url(#c)'/>";
    EXPECT_NEAR(filled(half + square), 200, kExact);
    EXPECT_NEAR(filled(half + "<g clip-path='url(#c)'><rect width='20' height='20'/></g>"), 200, kExact);
    EXPECT_NEAR(
        filled(half + "<rect x='-5' width='20' height='20' clip-path='url(#c)' transform='translate(5)'/>"),
        200, kExact);
    EXPECT_NEAR(filled("<clipPath id='c'/>" + square), 0, kExact);
    EXPECT_NEAR(filled(square), 400, kExact);  // no such clip
    EXPECT_NEAR(
        filled(
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.25'/></clipPath>" +
            square),
        50, kExact);
    EXPECT_NEAR(
        filled(
            "<clipPath id='d'><rect height='5' width='99'/></clipPath><clipPath id='c' clip-path='url(#d)'>"
            "<rect width='10' height='100'/></clipPath>" +
            square),
        50, kExact);
    EXPECT_NEAR(
        filled("<clipPath id='c'><path clip-rule='evenodd' d='M0 0H20V20H0Z M5 5H15V15H5Z'/></clipPath>" +
               square),
        300, kExact);
    EXPECT_NEAR(filled("<rect id='r' width='4' height='4'/><clipPath id='c'><use href='#r' x='2'/></clipPath>"
                       "<rect x='5' width='20' height='20' clip-path='url(#c)'/>"),
                20, kExact);
}

TEST(SvgFill, WhatLiesOutsideOneOfTheClipsInOneAnotherIsHidden) {
    const std::string clips =
        "<clipPath id='left'><rect width='10' height='100'/></clipPath>"
        "<clipPath id='right'><rect x='20' width='10' height='100'/></clipPath>"
        "<clipPath id='both' clip-path='url(#left)'><rect x='5' width='30' height='100'/></clipPath>"
        "<clipPath id='inner'><rect width='30' height='100' clip-path='url(#left)'/></clipPath>";
    const std::string square = "<rect width='30' height='10'/>";
    const auto in = [](const std::string& clip, const std::string& content) {
        return "<g clip-path='url(#" + clip + ")'>" + content + "</g>";
    };
    EXPECT_NEAR(filled(clips + in("both", square)), 50, kExact);
    EXPECT_NEAR(filled(clips + in("left", in("both", square))), 50, kExact);
    EXPECT_NEAR(filled(clips + in("inner", square)), 100, kExact);
    for (const char* clip : {"left", "both", "inner"}) {
        EXPECT_EQ(filled(clips + in(clip, in("right", square))), 0) << clip;
        EXPECT_EQ(filled(clips + in("right", in(clip, square))), 0) << clip;
    }
    const OutlineFile file = read(clips + in("left", in("both", "<rect x='12' width='5' height='5'/>")) +
                                  "<rect x='50' width='3' height='3'/>");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 9, kExact);
}

TEST(SvgFill, CopiesAreDrawnWhereTheyAreUsed) {
    const std::string tile = "<defs><rect id='r' width='10' height='10'/></defs>";
    EXPECT_NEAR(filled(tile + "<use href='#r'/><use xlink:href='#r' x='20' y='5'/>"), 200, kExact);
    EXPECT_NEAR(filled(tile + "<use href='#r' transform='scale(2)'/>"), 400, kExact);
    EXPECT_NEAR(filled("<defs><g id='g'><rect width='5' height='10'/><rect x='5' width='5' height='10' "
                       "fill='none'/></g></defs>"
                       "<use href='#g'/><use href='#g' x='50' fill='none'/>"),
                50, kExact);
    EXPECT_NEAR(filled("<symbol id='s' viewBox='0 0 10 10'><circle r='1000' style='display:none'/><rect "
                       "width='10' height='20'/></symbol>"
                       "<use href='#s' width='50' height='50'/>"),
                2500, kExact);
    EXPECT_THAT(read("<rect width='1' height='1'/><use href='#none'/><use href='other.svg#a'/>").remarks,
                ElementsAre("2 use of a missing element left out"));
}

TEST(SvgFill, CopiesThatCopyThemselvesAreRefused) {
    EXPECT_THAT(complaint_of([] { read("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"); }),
                HasSubstr("copies itself"));
    EXPECT_THAT(complaint_of([] { read("<g id='a'><use id='u' href='#a'/></g>"); }),
                AllOf(HasSubstr("use 'u'"), HasSubstr("copies itself")));
    std::string bomb = "<g id='n0'><text/></g>";
    for (int i = 1; i < 30; ++i) {
        const std::string before = "<use href='#n" + std::to_string(i - 1) + "'/>";
        bomb += "<g id='n" + std::to_string(i) + "'>" + before + before + "</g>";
    }
    EXPECT_THAT(complaint_of([&] { read(bomb); }), HasSubstr("more than 200000 elements"));
}

TEST(SvgFill, ASwitchShowsTheFirstThatFits) {
    EXPECT_NEAR(filled("<switch><g systemLanguage='de'><rect width='50' height='50'/></g>"
                       "<g systemLanguage='fr, en-GB'><rect width='10' height='10'/></g><rect width='90' "
                       "height='90'/></switch>"),
                100, kExact);
    EXPECT_NEAR(filled("<switch><foreignObject requiredExtensions='http://a.b'/><rect width='10' "
                       "height='10'/></switch>"),
                100, kExact);
}

TEST(SvgFill, ADrawingInADrawingShowsItsViewBoxInItsBox) {
    EXPECT_NEAR(filled("<svg x='10' y='10' width='50' height='50' viewBox='0 0 10 10'><rect width='10' "
                       "height='10'/></svg>"),
                2500, kExact);
    EXPECT_NEAR(filled("<svg width='50' height='50'><rect width='100' height='10'/></svg>"), 500, kExact);
    EXPECT_NEAR(
        filled("<svg width='50' height='50' overflow='visible'><rect width='100' height='10'/></svg>"), 1000,
        kExact);
    EXPECT_NEAR(filled("<svg width='50%' height='50%'><rect width='100%' height='100%'/></svg>"), 5000,
                kExact);
    EXPECT_NEAR(filled("<svg width='50' height='20' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMin "
                       "slice'><rect width='10' height='10'/></svg>"),
                1000, kExact);
}

TEST(SvgFill, DrawingsInDrawingsShowWhatLiesInAllOfThem) {
    const auto drawing = [](const std::string& attributes, const std::string& content) {
        return "<svg " + attributes + ">" + content + "</svg>";
    };
    const std::string square = "<rect width='100' height='100'/>";
    const std::string outer = "x='10' width='50' height='50'";
    EXPECT_NEAR(filled(drawing(outer, drawing("x='40' width='30' height='30'", square))), 300, kExact);
    EXPECT_NEAR(
        filled(drawing(outer + " overflow='visible'", drawing("x='40' width='30' height='30'", square))), 900,
        kExact);
    EXPECT_EQ(filled(drawing(outer, drawing("x='60' width='30' height='30'", square))), 0);
    // Clips and viewports.
    const std::string clip = "<clipPath id='c'><rect width='10' height='100'/></clipPath>";
    const std::string clipped = "<g clip-path='url(#c)'>";
    EXPECT_NEAR(filled(clip + drawing("x='20' width='30' height='30'", clipped + square + "</g>")), 300,
                kExact);
    EXPECT_EQ(filled(clip + clipped + drawing("x='20' width='30' height='30'", square) + "</g>"), 0);
}

TEST(SvgFill, WhatIsNoShapeIsCountedAndTold) {
    EXPECT_THAT(
        read("<rect width='9' height='9'/><text>A</text><text>B</text><image/><rect width='1' height='1' "
             "mask='url(#m)'/>")
            .remarks,
        ElementsAre(HasSubstr("covers all other shapes"), "2 text, 1 image, 1 mask of an element left out"));
    EXPECT_THAT(complaint_of([] { read("<text>A</text>"); }),
                HasSubstr("nothing in it is filled (1 text left out)"));
    std::string many = "<rect width='9' height='9'/>";
    for (int i = 0; i < 5000; ++i) many += "<odd" + std::to_string(i) + std::string(100, 'x') + "/>";
    EXPECT_LT(read(many).remarks.front().size(), 600U);
}

TEST(SvgFill, AShapeBehindAllOthersIsNamed) {
    EXPECT_THAT(
        read("\n<rect id='paper' width='200' height='100'/>\n<circle cx='50' cy='50' r='20'/>").remarks,
        ElementsAre(AllOf(HasSubstr("line 2, rect 'paper', covers all other shapes"))));
    EXPECT_THAT(read("<circle cx='50' cy='50' r='20'/><rect width='50' height='90'/>").remarks, IsEmpty());
}

TEST(SvgFill, WithoutWidthAndHeightTheSizeIsThatOfTheViewBoxInPixels) {
    const auto size_of = [](const std::string& attributes) {
        const TemporaryFolder folder;
        const OutlineFile file = read_outline_file(
            folder.file("o.svg", "<svg " + attributes + "><rect width='100%' height='100%'/></svg>"));
        return size_text(file.parts) + (file.remarks.empty() ? "" : " " + file.remarks.front());
    };
    // A pixel is 25.4 mm / 96.
    EXPECT_EQ(
        size_of("viewBox='0 0 960 480'"),
        "254 x 127 mm it does not say its width and height; from its viewBox it is taken as 254 x 127 mm");
    EXPECT_THAT(size_of("viewBox='0 0 960 480' width='100%' height='100%'"),
                HasSubstr("taken as 254 x 127 mm"));
    EXPECT_THAT(size_of("viewBox='0 0 960 480' width='50mm'"), HasSubstr("taken as 50 x 25 mm"));
    EXPECT_THAT(size_of(""), HasSubstr("x 39.69 mm"));
    EXPECT_EQ(size_of("style='width: 10cm; height: 5cm' viewBox='0 0 10 5'"), "100 x 50 mm");
    EXPECT_EQ(size_of("width='6in' height='72pt'"), "152.4 x 25.4 mm");
    EXPECT_EQ(size_of("width='10em' height='10rem'"), "42.33 x 42.33 mm");  // 160 pixels
}

TEST(SvgFill, SmallDrawingsAreReadAsFinelyAsLargeOnes) {
    const TemporaryFolder folder;
    const OutlineFile icon = read_outline_file(
        folder.file("o.svg", "<svg width='16' height='16'><circle cx='8' cy='8' r='1'/></svg>"));
    const double pixel = 0.0254 / 96;
    EXPECT_NEAR(area_of(icon.parts.front()), std::numbers::pi * pixel * pixel, 4e-3 * pixel * pixel);
}

TEST(SvgFill, EntitiesOfTheDocumentAreReplaced) {
    const TemporaryFolder folder;
    const auto read_text = [&](const std::string& text) {
        return read_outline_file(folder.file("o.svg", text));
    };
    const OutlineFile file = read_text(
        "<!DOCTYPE svg [ <!ENTITY st0 \"fill:none\"> <!ENTITY ten '10'> ]>\n"
        "<svg width='50' height='50'><rect width='40' height='40' style='&st0;'/>"
        "<rect width='&ten;' height='&ten;'/></svg>");
    EXPECT_NEAR(area_of(file.parts.front()), 100 * std::pow(0.0254 / 96, 2), 1e-15);
    std::string bomb = "<!DOCTYPE svg [ <!ENTITY a0 'lol'>";
    for (int i = 1; i < 12; ++i) {
        bomb += "<!ENTITY a" + std::to_string(i) + " '";
        for (int j = 0; j < 10; ++j) bomb += "&a" + std::to_string(i - 1) + ";";
        bomb += "'>";
    }
    EXPECT_THAT(complaint_of([&] { read_text(bomb + "]><svg>&a11;</svg>"); }), HasSubstr("grow beyond"));
    EXPECT_THAT(
        complaint_of([&] { read_text("<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg>&a;</svg>"); }),
        HasSubstr("too deeply"));
}

// Before, the time grew with the square of the number of equal shapes, and more: a thousand took minutes.
TEST(SvgFill, AThousandEqualShapesAreOneAndToldOf) {
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "<rect x='10' y='10' width='50' height='40'/>";
    const OutlineFile file = read(many + "<rect x='100' width='5' height='5'/>");
    ASSERT_EQ(file.parts.size(), 2U);
    EXPECT_EQ(file.parts.front().boundary.size(), 4U);
    EXPECT_THAT(file.remarks, Contains(HasSubstr("999 shapes drawn over an equal one counted once")));
}

TEST(SvgFill, EqualShapesMayBeginElsewhereAndRunBackwards) {
    EXPECT_THAT(read("<path d='M0 0H9V9H0Z'/><path d='M9 9V0H0V9Z'/><path d='M9 0H0V9H9Z'/>").remarks,
                Contains(HasSubstr("2 shapes drawn over an equal one counted once")));
    EXPECT_THAT(read("<path d='M0 0H9V9H0Z'/><path d='M0 0H9V8H0Z'/>").remarks,
                Not(Contains(HasSubstr("counted once"))));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
