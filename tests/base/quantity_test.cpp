// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/quantity.hpp>

#include <numbers>

namespace fretwork::base {
namespace THIS_TEST {

TEST(Quantity, LengthsComeOutInMetres) {
    EXPECT_EQ(parse_length("26mm"), 0.026);
    EXPECT_EQ(parse_length("2.6 cm"), 0.026);
    EXPECT_EQ(parse_length("0.026m"), 0.026);
    EXPECT_EQ(parse_length("0.026"), 0.026);
    EXPECT_EQ(parse_length("26000um"), 0.026);
    EXPECT_EQ(parse_length("2.6e+1mm"), 0.026);
    EXPECT_EQ(parse_length("260e-1 mm"), 0.026);
    EXPECT_EQ(parse_length("-0mm"), 0.0);
    EXPECT_EQ(parse_length("0e-2147483648mm"), 0.0);
    EXPECT_EQ(parse_length("1e-320mm"), 1e-323);
}

TEST(Quantity, AnglesComeOutInRadians) {
    EXPECT_DOUBLE_EQ(parse_angle("180"), std::numbers::pi);
    EXPECT_DOUBLE_EQ(parse_angle("90deg"), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(parse_angle("0.5rad"), 0.5);
}

TEST(Quantity, AnythingElseIsRefusedWithTheText) {
    for (const char* text : {"", "mm", "26 miles", "nan", "inf", "1e999", "26mmm", "--3", "26deg"}) {
        EXPECT_THAT(test::complaint_of([&] { parse_length(text); }),
                    testing::HasSubstr("'" + std::string(text) + "'"));
    }
    EXPECT_THROW(parse_angle("3mm"), InputError);
    EXPECT_THROW(parse_number("3x"), InputError);
}

TEST(Quantity, LargeLengthsNeedAUnit) {
    for (const char* text : {"26", "26 ", "26  "}) {
        EXPECT_THAT(test::complaint_of([&] { refuse_missing_unit("--edge-length", text, 1.0); }),
                    testing::AllOf(testing::HasSubstr("--edge-length"),
                                   testing::HasSubstr("did you mean 26mm? Metres are written 26m")))
            << "'" << text << "'";
    }
    for (const char* text : {"0.5", "0.5 ", "26mm", "26 m", "", " "})
        EXPECT_NO_THROW(refuse_missing_unit("--edge-length", text, 1.0)) << "'" << text << "'";
}

TEST(Quantity, AReadNumberIsTheWholeText) {
    EXPECT_EQ(read_number<int>("-12"), -12);
    EXPECT_EQ(read_number<double>("+1.5e3"), 1500.0);
    for (const char* text : {"", "+", "1 ", " 1", "1.5", "+-1", "++1", "0x1", "3000000000"})
        EXPECT_EQ(read_number<int>(text), std::nullopt) << text;
    EXPECT_EQ(read_number<unsigned>("-1"), std::nullopt);
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
