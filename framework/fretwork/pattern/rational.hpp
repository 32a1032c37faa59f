// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace fretwork::pattern {

/// An exact fraction in lowest terms with a positive denominator.
///
/// Numerator and denominator have 64 bits. An operation whose result does not fit throws NumericalError.
class Rational {
  public:
    constexpr Rational() = default;
    /// Make a whole number.
    constexpr Rational(std::int64_t whole) : numerator_(whole) {}  // NOLINT(google-explicit-constructor)
    /// Make the fraction numerator / denominator. Throws NumericalError if the denominator is zero.
    Rational(std::int64_t numerator, std::int64_t denominator);

    /// The numerator in lowest terms.
    [[nodiscard]] constexpr std::int64_t numerator() const { return numerator_; }
    /// The denominator in lowest terms, above 0.
    [[nodiscard]] constexpr std::int64_t denominator() const { return denominator_; }
    /// The quotient of the numerator and the denominator, each rounded to a double.
    [[nodiscard]] double to_double() const;
    /// The text "3/10", or "2" for a whole number. parse_rational reads it back if its numbers have at most
    /// 18 digits.
    [[nodiscard]] std::string text() const;

    friend Rational operator+(const Rational& left, const Rational& right);
    friend Rational operator-(const Rational& left, const Rational& right);
    friend Rational operator*(const Rational& left, const Rational& right);
    /// Throws NumericalError if `right` is zero.
    friend Rational operator/(const Rational& left, const Rational& right);
    friend bool operator==(const Rational&, const Rational&) = default;
    friend std::strong_ordering operator<=>(const Rational& left, const Rational& right);

  private:
    std::int64_t numerator_ = 0;
    std::int64_t denominator_ = 1;
};

/// Parse a fraction ("1/3", "-2/5"), a whole number ("1") or a decimal ("0.3") exactly. Throws InputError on
/// anything else, on a zero denominator, and on a number of more than 18 digits.
Rational parse_rational(std::string_view text);

}  // namespace fretwork::pattern
