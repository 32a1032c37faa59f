// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/text.hpp>

#include <cstdlib>

namespace fretwork::base {
namespace THIS_TEST {

TEST(FormatNumber, ReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, 5e-324, -0.0, 123456789.0}) {
        EXPECT_EQ(std::strtod(format_number(value).c_str(), nullptr), value);
    }
    EXPECT_EQ(format_number(0.1), "0.1");
}

// As printf writes them with %.*g.
TEST(FormatNumber, RoundsToDigitsForPeople) {
    EXPECT_EQ(format_number(1.0 / 3.0, 3), "0.333");
    EXPECT_EQ(format_number(1234567.0, 2), "1.2e+06");
    EXPECT_EQ(format_number(0.00001234, 4), "1.234e-05");
    EXPECT_EQ(format_number(26.0, 4), "26");
    EXPECT_EQ(format_number(-0.5, 4), "-0.5");
}

TEST(Text, GetsSmallLettersInAsciiOnly) {
    EXPECT_EQ(in_small_letters("Stuhl-2 ÄZ"), "stuhl-2 Äz");
    EXPECT_EQ(in_small_letters(""), "");
}

TEST(Text, CountsOneInTheSingular) {
    EXPECT_EQ(counted(0, "tile"), "0 tiles");
    EXPECT_EQ(counted(1, "tile"), "1 tile");
    EXPECT_EQ(counted(12, "pair"), "12 pairs");
}

TEST(Split, IsUndoneByJoin) {
    for (const std::string text : {"", "a", "a,b", ",a,,b,"}) EXPECT_EQ(join(split(text, ','), ","), text);
}

TEST(FindOutside, PassesOverQuotesAndBrackets) {
    EXPECT_EQ(find_outside("a,b", ','), 1U);
    EXPECT_EQ(find_outside("rgb(1,2)=x,y", ','), 10U);
    EXPECT_EQ(find_outside("[x=',]'],y", ','), 8U);
    EXPECT_EQ(find_outside("\"a,'\",b", ','), 5U);
    EXPECT_EQ(find_outside("a),b", ','), 2U) << "a bracket that none has opened";
    for (const std::string_view text : {"", "ab", "(a,b", "'a,b"})
        EXPECT_EQ(find_outside(text, ','), text.size()) << text;
}

TEST(SplitLines, LeavesOutLineFeedsAndCarriageReturnsBeforeThem) {
    EXPECT_EQ(split_lines("a\r\n\r\nb\rc\n"), (std::vector<std::string>{"a", "", "b\rc", ""}));
    EXPECT_EQ(split_lines(""), std::vector<std::string>{""});
}

TEST(NearestName, FindsTyposAndNothingFar) {
    const std::vector<std::string> names = {"bending", "dome", "saddle"};
    EXPECT_EQ(nearest_name("bendign", names), "bending");
    EXPECT_EQ(nearest_name("sadle", names), "saddle");
    EXPECT_EQ(nearest_name("torsion", names), std::nullopt);
    EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

TEST(Text, PrintableShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("plain, \xc3\xa4 and \xe2\x82\xac"), "plain, \xc3\xa4 and \xe2\x82\xac");
    EXPECT_EQ(printable("a\x1b[31m\nb\x7f"), "a\\x1b[31m\\x0ab\\x7f");
    EXPECT_EQ(printable("\xc2\x9b|\xe2\x80\xae|\xe2\x81\xa6"), "\\u{009b}|\\u{202e}|\\u{2066}");
    EXPECT_EQ(printable("\xff|\xc3|\xe2\x80"), "\\xff|\\xc3|\\xe2\\x80") << "no UTF-8";
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "an overlong form";
}

TEST(Text, ShortenedKeepsStartAndEnd) {
    EXPECT_EQ(shortened("0123456789", 10), "0123456789");
    EXPECT_EQ(shortened("0123456789abcdef", 10), "0123...def");
    std::string umlauts;
    for (int i = 0; i < 20; ++i) umlauts += "\xc3\xa4";
    EXPECT_EQ(shortened(umlauts, 20), umlauts);
    EXPECT_EQ(shortened(umlauts, 10), umlauts.substr(0, 8) + "..." + umlauts.substr(0, 6));
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
