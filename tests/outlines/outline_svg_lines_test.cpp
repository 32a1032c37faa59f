// SPDX-License-Identifier: GPL-3.0-or-later
// Closed lines of an SVG drawing that fills nothing: the areas that they enclose.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/outlines/outline.hpp>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string drawing(const std::string& content) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">)"
           "<g fill='none' stroke='#000'>" +
           content + "</g></svg>";
}
OutlineFile read(const std::string& content) {
    const TemporaryFolder folder;
    return read_outline_file(folder.file("o.svg", drawing(content)));
}
/// Square millimetres of all parts.
double enclosed(const std::string& content) {
    double area = 0;
    for (const Outline& part : read(content).parts) area += area_of(part);
    return 1e6 * area;
}
constexpr double kExact = 1e-6;  // square millimetres: straight sides

TEST(SvgLines, AStrokeThatNobodySeesIsNoLine) {
    const std::string square = "<rect x='10' y='10' width='20' height='20'/>";
    for (const char* hidden :
         {"stroke-width='0'", "style='stroke-width:0mm'", "stroke-opacity='0'", "opacity='0'",
          "stroke='none'", "visibility='hidden'", "display='none'", "stroke='rgba(0,0,0,0)'"}) {
        const OutlineFile file = read("<rect width='99' height='99' " + std::string(hidden) + "/>" + square);
        ASSERT_EQ(file.parts.size(), 1U) << hidden;
        EXPECT_THAT(file.parts.front().holes, IsEmpty()) << hidden;
        EXPECT_NEAR(1e6 * area_of(file.parts.front()), 400, kExact) << hidden;
    }
    EXPECT_NEAR(enclosed("<g stroke-width='0'><rect width='99' height='99'/></g>" + square), 400, kExact);
    EXPECT_NEAR(enclosed("<g stroke-width='0'><rect width='9' height='9' stroke-width='.1'/></g>"), 81,
                kExact);
    EXPECT_THAT(complaint_of([] { read("<rect width='9' height='9' stroke-width='0'/>"); }),
                AllOf(HasSubstr("nothing in it is filled"), Not(HasSubstr("line is closed"))));
}

TEST(SvgLines, AClipCutsWhatALineEncloses) {
    const std::string clip = "<clipPath id='c'><rect width='10' height='100'/></clipPath>";
    EXPECT_NEAR(enclosed(clip + "<rect width='20' height='20' clip-path='url(#c)'/>"), 200, kExact);
    EXPECT_NEAR(enclosed(clip + "<rect x='2' width='8' height='20' clip-path='url(#c)'/>"), 160, kExact)
        << "on the edge of the clip";
    EXPECT_NEAR(enclosed(clip + "<rect x='50' width='9' height='9' clip-path='url(#c)'/><rect width='5' "
                                "height='5'/>"),
                25, kExact)
        << "out of sight";
    EXPECT_THAT(read(clip + "<rect width='5' height='5'/><path d='M5 50H20' clip-path='url(#c)'/>").remarks,
                Contains(HasSubstr("1 open line that a clip cuts or hides left out")));
    // Its corners lie in the clip, and its upper side runs across the notch.
    EXPECT_NEAR(enclosed("<clipPath id='u'><path d='M0 0H10V50H20V0H30V60H0Z'/></clipPath>"
                         "<path d='M5 10H25V55H5Z' clip-path='url(#u)'/>"),
                20 * 45 - 10 * 40, kExact);
}

TEST(SvgLines, TheClosedPieceOfAPathCountsWithoutItsOpenOne) {
    const OutlineFile file = read("<path id='p' d='M0 0H10V10H0Z M20 0H30V10'/>");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 100, kExact);
    EXPECT_THAT(file.remarks,
                ElementsAre("nothing is filled: the closed lines are taken as 1 outline with 0 holes",
                            "1 open line (the longest, 14.14 mm, at line 1, path 'p') left out"));
}

TEST(SvgLines, ALineDrawnTwiceIsTakenOnce) {
    const OutlineFile file = read(
        "<rect width='50' height='50'/><rect x='.002' width='49.998' height='50.002'/>"
        "<circle cx='25' cy='25' r='9'/><circle cx='25' cy='25.002' r='9'/>");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_EQ(file.parts.front().holes.size(), 1U);
    EXPECT_THAT(file.remarks, Contains("2 doubled lines taken once"));
}

TEST(SvgLines, FillsWithoutAreaDoNotHideThem) {
    for (const char* nothing :
         {"<path fill='#000' d='M0 0L50 50L20 20Z'/>", "<rect fill='#000' width='9' height='.0001'/>",
          "<path fill='red' d='M0 90H9'/>",
          "<clipPath id='c'/><rect fill='#000' width='9' height='9' clip-path='url(#c)'/>"})
        EXPECT_NEAR(enclosed(std::string(nothing) + "<rect x='60' width='10' height='10'/>"), 100, kExact)
            << nothing;
    // Black is the colour where no fill is said.
    EXPECT_NEAR(enclosed("<g fill='#000'><path d='M0 0H10'/><path d='M10 0V10'/><path d='M10 10L0 0'/></g>"),
                50, kExact);
}

TEST(SvgLines, LinesWhoseEndsMeetAreJoined) {
    const OutlineFile file =
        read("<line x2='30'/><path d='M30 20L30.00005 0'/><polyline points='30 20 0 20 0 .1'/>");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 600, 0.1);
    EXPECT_THAT(file.remarks,
                ElementsAre("1 gap of at most 0.1 mm closed",
                            "nothing is filled: the closed lines are taken as 1 outline with 0 holes"));
    EXPECT_THAT(complaint_of([] { read("<line x2='30'/><path d='M30 0V20H0V.5'/>"); }),
                AllOf(HasSubstr("none of its 2 lines is closed"), HasSubstr("joined up to 0.2 mm")));
}

TEST(SvgLines, AnOpenLineThatReachesFarOutSpoilsNothing) {
    const OutlineFile file =
        read("<line x2='1e9'/><rect width='20' height='20'/><line y1='5' x2='9' y2='5'/>");
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 400, kExact);
    EXPECT_THAT(file.remarks,
                Contains(HasSubstr("1 open line that reaches far out of the drawing left out")));
    EXPECT_THAT(complaint_of([] { read("<path d='M0 0H20V1e6Z'/>"); }), HasSubstr("far outside the drawing"));
}

TEST(SvgLines, OneOpenLineIsToldAsOne) {
    EXPECT_THAT(complaint_of([] { read("<path d='M0 0H10V10'/>"); }),
                HasSubstr("nothing in it is filled, and its line is not closed; loose ends are"));
}

TEST(SvgLines, APainterNeedsFillsWhetherLinesAreClosedOrNot) {
    const TemporaryFolder folder;
    const std::string path = folder.file("o.svg", drawing("<rect width='9' height='9'/>"));
    EXPECT_THAT(complaint_of([&] { const ColouredDrawing drawn(path); }),
                AllOf(HasSubstr("nothing in it is filled"), HasSubstr("colours"), Not(HasSubstr("closed"))));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
