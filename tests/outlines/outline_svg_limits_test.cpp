// SPDX-License-Identifier: GPL-3.0-or-later
// SVG drawings that would take minutes, gigabytes or the whole stack are refused, or read fast all the same.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/detail/bezier.hpp>
#include <fretwork/outlines/outline.hpp>

#include <limits>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

std::string repeated(const std::string& piece, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += piece;
    return text;
}

/// A drawing of 200 x 100 mm in millimetres.
std::string drawing(const std::string& content) {
    return "<svg width='200mm' height='100mm' viewBox='0 0 200 100'>" + content + "</svg>";
}
OutlineFile read(const std::string& svg) {
    const TemporaryFolder folder;
    return read_outline_file(folder.file("o.svg", svg));
}
std::string refuse(const std::string& svg) {
    return refuse_file("o.svg", svg);
}
std::string refuse_sheet(const std::string& sheet, const std::string& value = "") {
    return refuse(drawing("<style>" + sheet + "</style><rect width='9' height='9' x-long='" + value + "'/>"));
}
/// True if a sheet hides one of two squares, which has the id r.
bool hides(const std::string& sheet) {
    return read(drawing("<style>" + sheet +
                        "</style><rect width='9' height='9'/><rect id='r' x='20' width='9' height='9'/>"))
               .parts.size() == 1;
}

TEST(SvgLimits, ASelectorHasNotManyConditions) {
    EXPECT_TRUE(hides(repeated("#r", 30) + "{fill:none}"));
    EXPECT_FALSE(hides(repeated("#r", 2200) + "{fill:none}"));
    EXPECT_FALSE(hides(repeated("[id]", 2200) + "{fill:none}"));
}

TEST(SvgLimits, AnArcBeyondTheRangeOfNumbersIsRefused) {
    for (const char* d : {"M0 0A1 1 1e308 0 1 5 5", "M-1e308 0A1 1 0 0 1 1e308 0"})
        EXPECT_THAT(refuse(drawing("<path d='" + std::string(d) + "'/>")),
                    AllOf(HasSubstr("line 1, path: d: "), HasSubstr("angle of an arc is not finite")))
            << d;
    for (const double sweep :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(detail::beziers_of(detail::Arc{.center{}, .axes{}, .start = 0, .sweep = sweep}),
                     base::GeometryError);
}

TEST(SvgLimits, SwitchesNestOnlySoDeep) {
    const auto nested = [](int depth) {
        return drawing(repeated("<switch>", depth) + "<rect width='10' height='10'/>" +
                       repeated("</switch>", depth));
    };
    EXPECT_THAT(refuse(nested(20'000)), AllOf(HasSubstr("line 1, switch"), HasSubstr("more than 256 deep")));
    EXPECT_EQ(read(nested(200)).parts.size(), 1U);
}

/// Clips a0, a1, .. of which each is clipped by the next.
std::string chain_of_clips(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "<clipPath id='a" + std::to_string(i) + "' clip-path='url(#a" + std::to_string(i + 1) +
                ")'><rect width='10' height='10'/></clipPath>";
    return text;
}

TEST(SvgLimits, ClipsOfClipsNestOnlySoDeep) {
    const std::string clipped = "<rect width='20' height='20' clip-path='url(#a0)'/>";
    EXPECT_THAT(refuse(drawing(chain_of_clips(25'000) + clipped)),
                AllOf(HasSubstr("clipPath 'a"), HasSubstr("more than 256 deep")));
    EXPECT_NEAR(1e6 * area_of(read(drawing(chain_of_clips(100) + clipped)).parts.front()), 100, 1e-6);
    // Each group adds its own chain to those around it.
    EXPECT_THAT(refuse(drawing(chain_of_clips(20) + repeated("<g clip-path='url(#a0)'>", 20) + clipped +
                               repeated("</g>", 20))),
                AllOf(HasSubstr("clipPath 'a"), HasSubstr("clips lie more than 256 deep")));
}

TEST(SvgLimits, DrawingsInDrawingsAddTheirClipsToThoseAround) {
    const auto nested = [](int depth) {
        return drawing(chain_of_clips(100) + "<g clip-path='url(#a0)'>" + repeated("<svg>", depth) +
                       "<rect width='20' height='20'/>" + repeated("</svg>", depth) + "</g>");
    };
    EXPECT_NEAR(1e6 * area_of(read(nested(100)).parts.front()), 100, 1e-6);
    EXPECT_THAT(refuse(nested(200)),
                AllOf(HasSubstr("line 1, svg"), HasSubstr("clips lie more than 256 deep")));
}

TEST(SvgLimits, ClipsCountAsElements) {
    std::string clips;
    for (int i = 0; i < 200; ++i)
        clips +=
            "<clipPath id='a" + std::to_string(i) + "' clip-path='url(#a" + std::to_string(i + 1) + ")'/>";
    EXPECT_THAT(refuse(drawing(clips + repeated("<rect clip-path='url(#a0)'/>", 1000))),
                HasSubstr("more than 200000 elements"));
}

TEST(SvgLimits, EntitiesThatAddNothingAreCounted) {
    std::string doctype = "<!DOCTYPE svg [<!ENTITY a ''>";
    for (char name = 'b'; name <= 'l'; ++name)
        doctype += std::string("<!ENTITY ") + name + " '" +
                   repeated(std::string("&") + static_cast<char>(name - 1) + ";", 10) + "'>";
    const std::string square = "<rect width='9' height='9'/>";
    EXPECT_THAT(refuse(doctype + "]>" + drawing(square + "&l;")), HasSubstr("more than 2000000 entities"));
    EXPECT_EQ(read(doctype + "]>" + drawing(square + "&d;")).parts.size(), 1U);
}

TEST(SvgLimits, DeclarationsWithoutANameAreReadFast) {
    const OutlineFile file = read("<!DOCTYPE svg [<!ENTITY wide '60'>" + repeated("<!ENTITY>", 33'000) +
                                  "]>" + drawing("<rect width='&wide;' height='10'/>"));
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 600, 1e-6);
}

/// The path data of a curve far larger than its page of 100 pixels: more than 90,000 points.
std::string huge_curves(int count) {
    return "M0 0" + repeated("c0 2e7 2e7 0 0 0", count);
}

TEST(SvgLimits, PointsAreCountedWhileAPathIsFlattened) {
    const std::string page = "<svg width='100' height='100'>";
    EXPECT_THAT(refuse(page + "<path d='" + huge_curves(20) + "'/></svg>"),
                AllOf(HasSubstr("a curve near (0, "), HasSubstr("more than 1000000 points")));
    EXPECT_THAT(
        refuse(page + repeated("<path fill='none' stroke='red' d='" + huge_curves(1) + "'/>", 3) + "</svg>"),
        AllOf(HasSubstr("line 1, path"), HasSubstr("more than 200000 points")));
}

TEST(SvgLimits, TheTextOfCopiesIsCounted) {
    const auto copied = [](int characters) {
        return drawing("<defs><path id='a' fill='none' d='" + repeated("M0 0 ", characters / 5) +
                       "'/><g id='b'>" + repeated("<use href='#a'/>", 100) + "</g></defs>" +
                       repeated("<use href='#b'/>", 100) + "<rect width='9' height='9'/>");
    };
    EXPECT_THAT(refuse(copied(500'000)), AllOf(HasSubstr("path 'a'"), HasSubstr("200000000 characters")));
    EXPECT_EQ(read(copied(50)).parts.size(), 1U);
}

TEST(SvgLimits, ThePicturesInImagesAreNotCounted) {
    const std::string image = "<image id='a' href='data:" + repeated("A", 1'000'000) + "'/>";
    EXPECT_EQ(read(drawing(image + repeated("<use href='#a'/>", 300) + "<rect width='9' height='9'/>"))
                  .parts.size(),
              1U);
}

/// A zigzag of many points, to the right.
std::string zigzag(int points) {
    std::string path = "M0 0";
    for (int i = 1; i < points; ++i) path += "L" + std::to_string(i % 180) + " " + std::to_string(i % 2);
    return path;
}

TEST(SvgLimits, LinesInClipsOfManyPointsAreCounted) {
    const auto with_clip = [](int points) {
        return drawing("<clipPath id='c'><path d='" + zigzag(points) +
                       "'/></clipPath><path clip-path='url(#c)' d='" + zigzag(60'000) +
                       "' fill='none' stroke='red'/>");
    };
    EXPECT_THAT(refuse(with_clip(50'000)), HasSubstr("clips of many points cut very many lines"));
    EXPECT_THAT(refuse(with_clip(4)), HasSubstr("open line that a clip cuts or hides"));
}

TEST(SvgLimits, AttributesOfElementsThatAreNotDrawnAreCounted) {
    std::string attributes;
    for (int i = 0; i < 20'000; ++i) attributes += " a" + std::to_string(i) + "=''";
    EXPECT_THAT(refuse(drawing("<g id='g'><path" + attributes + " requiredExtensions=''/></g>" +
                               repeated("<use href='#g'/>", 5000))),
                HasSubstr("200000000"));
    EXPECT_THAT(refuse(drawing("<linearGradient id='l'" + attributes + "/>" +
                               repeated("<rect width='9' height='9' fill='url(#l)'/>", 5000))),
                HasSubstr("200000000"));
}

TEST(SvgLimits, TextThatRulesCompareIsCounted) {
    const std::string value(100'000, 'a');
    EXPECT_THAT(refuse_sheet(repeated("[x-long^=b]{}", 3000), value), HasSubstr("too intricate"));
    EXPECT_THAT(refuse_sheet(repeated("[x-long*='" + std::string(1000, 'a') + "b']{}", 3), value),
                HasSubstr("too intricate"));
    EXPECT_THAT(refuse_sheet(repeated("*,", 20'000) + "*{" + repeated("a:b;", 3000) + "}"),
                HasSubstr("too intricate"));
}

TEST(SvgLimits, MediaInMediaAreReadOnce) {
    EXPECT_TRUE(hides(repeated("@media{", 140'000) + "#r{fill:none}" + repeated("}", 140'000)));
    EXPECT_TRUE(hides(repeated("@media{", 140'000) + "#r{fill:none}"));
    EXPECT_TRUE(hides("@media screen { @import 'x'; nothing } #r { fill: none }"));
    EXPECT_FALSE(hides("@media screen { @media print { g {} #r { fill: none } } }"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
