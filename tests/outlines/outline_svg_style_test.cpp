// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that hide a shape, and the places where they may stand.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// A square of 10 mm that is always there beside one of 20 mm with the given attributes: whether that is
/// filled. `before` stands in front of both.
bool is_filled(const std::string& attributes, const std::string& before = "") {
    const TemporaryFolder folder;
    const OutlineFile file = read_outline_file(folder.file(
        "o.svg",
        "<svg width='200mm' height='100mm' viewBox='0 0 200 100'>" + before +
            "<rect x='100' width='10' height='10' style='fill: red !important; display: inline !important'/>"
            "<g id='g' class='outer'><rect id='r' width='20' height='20' " +
            attributes + "/></g></svg>"));
    return file.parts.size() == 2;
}

TEST(SvgStyle, FillNoneAndTransparentColorsFillNothing) {
    for (const char* fill : {"red", "#000", "url(#none) blue", "currentColor", "rgba(0,0,0,0.1)", "#0001",
                             "inherit", "context-fill"})
        EXPECT_TRUE(is_filled("fill='" + std::string(fill) + "'")) << fill;
    for (const char* fill : {"none", "transparent", "url(#none)", "url(#none) none", "rgba(1, 2, 3, 0)",
                             "rgb(1 2 3 / 0%)", "#1230", "#11223300"})
        EXPECT_FALSE(is_filled("fill='" + std::string(fill) + "'")) << fill;
}

TEST(SvgStyle, GradientsFillIfTheyShowAnything) {
    const std::string stop = "<stop stop-color='red'/>";
    const std::string clear = "<stop stop-color='red' stop-opacity='0'/>";
    const auto with = [](const std::string& stops) {
        return "<linearGradient id='p'>" + stops + "</linearGradient>";
    };
    EXPECT_TRUE(is_filled("fill='url(#p)'", with(stop)));
    EXPECT_TRUE(is_filled("fill='url(#p)'", with(clear + stop)));
    EXPECT_FALSE(is_filled("fill='url(#p)'", with(clear + clear)));
    EXPECT_FALSE(is_filled("fill='url(#p)'", with("")));
    EXPECT_TRUE(is_filled("fill='url(#q)'", with(stop) + "<radialGradient id='q' xlink:href='#p'/>"));
    EXPECT_TRUE(is_filled("fill='url(#p)'", "<pattern id='p'/>"));
}

TEST(SvgStyle, OpacityVisibilityAndDisplayHide) {
    EXPECT_FALSE(is_filled("opacity='0'"));
    EXPECT_FALSE(is_filled("fill-opacity='0%'"));
    EXPECT_TRUE(is_filled("opacity='.01'"));
    EXPECT_FALSE(is_filled("visibility='hidden'"));
    EXPECT_FALSE(is_filled("visibility='collapse'"));
    EXPECT_FALSE(is_filled("display='none'"));
    EXPECT_FALSE(is_filled("", "<style>#g { opacity: 0 }</style>"));
    EXPECT_FALSE(is_filled("", "<style>#g { visibility: hidden }</style>"));
    EXPECT_TRUE(is_filled("visibility='visible'", "<style>#g { visibility: hidden }</style>"));
    EXPECT_FALSE(is_filled("style='display:inline'", "<style>#g { display: none }</style>"));
}

TEST(SvgStyle, SelectorsChooseAsInCss) {
    for (const char* selector : {"rect",
                                 "*",
                                 "#r",
                                 ".a",
                                 ".b",
                                 "rect.a.b",
                                 "g rect",
                                 "g > rect",
                                 "svg > g rect#r",
                                 "rect + g > .a",
                                 "rect ~ g .a",
                                 "[id]",
                                 "[id=r]",
                                 "[id='r']",
                                 "[class~=b]",
                                 "[class^='a ']",
                                 "[class$=b]",
                                 "[class*=' ']",
                                 "p, .a",
                                 "rect:first-child",
                                 ":root .b",
                                 "g:last-child rect",
                                 "svg.x, #g>#r"})
        EXPECT_FALSE(is_filled("class='a b'", "<style>" + std::string(selector) + " { fill: none }</style>"))
            << selector;
    for (const char* selector : {"path", ".c", "#s", "rect rect", "svg > rect.a", "rect + rect.a", "[x]",
                                 "[id=s]", "[class=a]", "rect:hover", "g:first-child rect", "rect..a",
                                 "rect::before", "@media print { rect", R"([\]\)", R"([a\]=b)"})
        EXPECT_TRUE(is_filled("class='a b'", "<style>" + std::string(selector) + " { fill: none }</style>"))
            << selector;
}

TEST(SvgStyle, TheStrongerDeclarationWins) {
    EXPECT_TRUE(is_filled("fill='none' class='a'", "<style>.a { fill: red }</style>"));
    EXPECT_TRUE(is_filled("class='a' id='r'",
                          "<style>#r { fill: red } .a { fill: none } rect { fill: none }</style>"));
    EXPECT_TRUE(is_filled("class='a'", "<style>.a { fill: none } .a { fill: red }</style>"));
    EXPECT_FALSE(is_filled("class='a' style='fill: red'", "<style>.a { fill: none !important }</style>"));
    EXPECT_TRUE(is_filled("class='a' style='fill: red'", "<style>.a { fill: none }</style>"));
    EXPECT_FALSE(is_filled("style='fill: red; fill: none'"));
}

TEST(SvgStyle, StyleSheetsMayBeWrittenInManyWays) {
    EXPECT_FALSE(is_filled("class='a'", "<style type='text/css'><![CDATA[ .a{fill:none} ]]></style>"));
    EXPECT_TRUE(is_filled("class='a'", "<style><!-- .a { fill : none; } --></style>")) << "a comment in XML";
    EXPECT_FALSE(is_filled("class='a'", "<style><![CDATA[<!-- .a { fill : none; } -->]]></style>"));
    EXPECT_FALSE(is_filled("class='a'",
                           "<style>/* .a { fill: red } */ @import 'x.css'; @font-face { src: url(a;b) } .a { "
                           "fill: none }</style>"));
    EXPECT_FALSE(is_filled("class='a'", "<style>@media screen { .a { fill: none } }</style>"));
    EXPECT_TRUE(is_filled("class='a'", "<style>@media print { .a { fill: none } }</style>"));
    EXPECT_TRUE(is_filled("class='a'", "<style media='print'>.a { fill: none }</style>"));
    EXPECT_FALSE(is_filled("class='a'", "<defs><style>.a { FILL: none }</style></defs>"));
}

TEST(SvgStyle, SpaceInAnAttributeSelectorDoesNotCountOutsideOfQuotes) {
    const auto is_hidden_by = [](const std::string& selector) {
        return !is_filled("class='a b'", "<style>rect" + selector + " { fill: none }</style>");
    };
    for (const char* selector :
         {"[id=\"r\"]", "[id = \"r\"]", "[ id=\"r\" ]", "[id= r ]", "[class = 'a b' ]"})
        EXPECT_TRUE(is_hidden_by(selector)) << selector;
    for (const char* selector : {"[id=' r']", "[id = 'r ' ]"})
        EXPECT_FALSE(is_hidden_by(selector)) << selector;
}

TEST(SvgStyle, SheetsThatWouldTakeForeverAreRefused) {
    std::string deep;
    for (int i = 0; i < 200; ++i) deep += "<g>";
    deep += "<rect/>";
    for (int i = 0; i < 200; ++i) deep += "</g>";
    EXPECT_THAT(complaint_of([&] {
                    is_filled("", "<style>x g g g g g g g g g g g g g g rect { fill: none }</style>" + deep);
                }),
                AllOf(HasSubstr("o.svg"), HasSubstr("too intricate")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
