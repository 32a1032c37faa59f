// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/rational.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::pattern {
namespace {

// Wide enough for the sum of two products of 64-bit numbers. __extension__ because ISO C++ has no such type.
__extension__ using Wide = __int128;

Wide greatest_common_divisor(Wide left, Wide right) {
    while (right != 0) {
        const Wide rest = left % right;
        left = right;
        right = rest;
    }
    return left < 0 ? -left : left;
}

std::int64_t narrowed(Wide number) {
    using Limits = std::numeric_limits<std::int64_t>;
    if (number > Limits::max() || number < Limits::min()) {
        throw base::NumericalError("an exact fraction needs more than 64 bits");
    }
    return static_cast<std::int64_t>(number);
}

Rational reduced(Wide numerator, Wide denominator) {
    if (denominator == 0) throw base::NumericalError("division by zero in an exact fraction");
    const Wide divisor =
        greatest_common_divisor(numerator, denominator) * (denominator < 0 ? Wide{-1} : Wide{1});
    return {narrowed(numerator / divisor), narrowed(denominator / divisor)};
}

[[noreturn]] void refuse(std::string_view text) {
    throw base::InputError("'" + std::string(text) +
                           "' is not an exact number, such as 1/3 or 0.3, of at most 18 digits");
}

/// An unsigned whole number of 1 to 18 digits.
std::int64_t parse_digits(std::string_view digits, std::string_view whole_text) {
    constexpr std::size_t kMostDigits = 18;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (digits.empty() || digits.size() > kMostDigits || !std::all_of(digits.begin(), digits.end(), is_digit))
        refuse(whole_text);
    std::int64_t value = 0;
    for (const char c : digits) value = value * 10 + (c - '0');
    return value;
}

Rational parse_unsigned(std::string_view body, std::string_view text) {
    if (const auto slash = body.find('/'); slash != std::string_view::npos) {
        const std::int64_t denominator = parse_digits(body.substr(slash + 1), text);
        if (denominator == 0) refuse(text);
        return {parse_digits(body.substr(0, slash), text), denominator};
    }
    const auto point = body.find('.');
    if (point == std::string_view::npos) return parse_digits(body, text);
    const std::string_view decimals = body.substr(point + 1);
    const std::string digits = std::string(body.substr(0, point)) + std::string(decimals);
    if (point == 0 || decimals.empty()) refuse(text);
    std::int64_t scale = 1;
    const std::int64_t value = parse_digits(digits, text);
    for (std::size_t i = 0; i < decimals.size(); ++i) scale *= 10;
    return {value, scale};
}

}  // namespace

Rational::Rational(std::int64_t numerator, std::int64_t denominator)
    : numerator_(numerator), denominator_(denominator) {
    const bool is_reduced = denominator > 0 && greatest_common_divisor(numerator, denominator) == 1;
    if (!is_reduced) *this = reduced(numerator, denominator);
}

double Rational::to_double() const {
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);
}

std::string Rational::text() const {
    const std::string whole = std::to_string(numerator_);
    return denominator_ == 1 ? whole : whole + "/" + std::to_string(denominator_);
}

Rational operator+(const Rational& left, const Rational& right) {
    return reduced(Wide{left.numerator_} * right.denominator_ + Wide{right.numerator_} * left.denominator_,
                   Wide{left.denominator_} * right.denominator_);
}

Rational operator-(const Rational& left, const Rational& right) {
    return left + Rational(-1) * right;
}

Rational operator*(const Rational& left, const Rational& right) {
    return reduced(Wide{left.numerator_} * right.numerator_, Wide{left.denominator_} * right.denominator_);
}

Rational operator/(const Rational& left, const Rational& right) {
    return reduced(Wide{left.numerator_} * right.denominator_, Wide{left.denominator_} * right.numerator_);
}

std::strong_ordering operator<=>(const Rational& left, const Rational& right) {
    const Wide a = Wide{left.numerator_} * right.denominator_;
    const Wide b = Wide{right.numerator_} * left.denominator_;
    return a < b ? std::strong_ordering::less
                 : (a > b ? std::strong_ordering::greater : std::strong_ordering::equal);
}

Rational parse_rational(std::string_view text) {
    const bool is_negative = text.starts_with('-');
    const Rational value = parse_unsigned(is_negative ? text.substr(1) : text, text);
    return is_negative ? Rational(-1) * value : value;
}

}  // namespace fretwork::pattern
