// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/rational.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace fretwork::pattern {
namespace THIS_TEST {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

TEST(Rational, IsInLowestTermsWithPositiveDenominator) {
    const Rational half(-3, -6);
    EXPECT_EQ(half.numerator(), 1);
    EXPECT_EQ(half.denominator(), 2);
    EXPECT_EQ(Rational(0, -5), Rational(0));
    EXPECT_EQ(Rational(4, -6).text(), "-2/3");
}

TEST(Rational, ArithmeticIsExact) {
    const Rational third(1, 3);
    const Rational tenth(1, 10);
    EXPECT_EQ(third + third + third, Rational(1));
    EXPECT_EQ(tenth + Rational(1, 5), Rational(3, 10));
    EXPECT_EQ(third - tenth, Rational(7, 30));
    EXPECT_EQ(third * tenth, Rational(1, 30));
    EXPECT_EQ(third / tenth, Rational(10, 3));
}

TEST(Rational, OrderIsThatOfTheNumbers) {
    EXPECT_LT(Rational(1, 3), Rational(34, 100));
    EXPECT_LT(Rational(-1, 2), Rational(-1, 3));
    EXPECT_GT(Rational(kLargest, 2), Rational(kLargest - 1, 2));
}

TEST(Rational, OverflowIsAnErrorNotAWrongNumber) {
    EXPECT_THROW(Rational(kLargest) + Rational(1), base::NumericalError);
    EXPECT_THROW(Rational(1, kLargest) * Rational(1, 2), base::NumericalError);
    EXPECT_THROW(Rational(-1) * Rational(std::numeric_limits<std::int64_t>::min()), base::NumericalError);
    EXPECT_THROW(Rational(1) / Rational(0), base::NumericalError);
    EXPECT_THROW(Rational(1, 0), base::NumericalError);
}

TEST(ParseRational, ReadsFractionsDecimalsAndWholeNumbers) {
    EXPECT_EQ(parse_rational("1/3"), Rational(1, 3));
    EXPECT_EQ(parse_rational("0.30"), Rational(3, 10));
    EXPECT_EQ(parse_rational("1"), Rational(1));
    EXPECT_EQ(parse_rational("-2/4"), Rational(-1, 2));
    EXPECT_EQ(parse_rational("-0.5"), Rational(-1, 2));
}

TEST(ParseRational, ReadsBackWhatTextWrites) {
    for (const Rational& number : {Rational(0), Rational(-7), Rational(22, 7), Rational(-1, 1000000)})
        EXPECT_EQ(parse_rational(number.text()), number);
}

TEST(ParseRational, RefusesEverythingElse) {
    for (const char* text : {"", "-", "1/", "/3", "1/0", ".5", "5.", "1e-3", "0x1", "1/3 ", " 1", "1/-3",
                             "nan", "0.3/2", "--1", "+1", "1234567890123456789", "1/2/3", "1.2.3"}) {
        EXPECT_THROW(parse_rational(text), base::InputError) << text;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
