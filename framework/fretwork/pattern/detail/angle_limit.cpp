// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/angle_limit.hpp>
#include <fretwork/pattern/detail/hexagon.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace fretwork::pattern::detail {
namespace {

using Float = boost::multiprecision::cpp_bin_float_100;

/// An angle whose cosine has a rational square. By Niven's theorem, no other angle that is rational in
/// degrees has this property.
struct RationalCosine {
    int degrees;
    int numerator;  ///< signed square of the cosine, in quarters
};
constexpr RationalCosine kRationalCosines[] = {{0, 4},    {30, 3},   {45, 2},   {60, 1},  {90, 0},
                                               {120, -1}, {135, -2}, {150, -3}, {180, -4}};

/// The number to about 47 digits, as the exact sum of three doubles.
ExactNumber to_exact(const Float& number) {
    ExactNumber sum(0);
    Float rest = number;
    for (int part = 0; part < 3; ++part) {
        const double leading = rest.convert_to<double>();
        sum += ExactNumber(leading);
        rest -= leading;
    }
    return sum;
}

}  // namespace

AngleLimit::AngleLimit(double radians) {
    if (!(radians >= 0.0 && radians <= std::numbers::pi))
        throw base::InputError("the smallest angle lies between 0 and 180 degrees, and " +
                               base::format_number(radians * 180 / std::numbers::pi) + " degrees was given");
    constexpr double kSame = 1e-12;
    for (const RationalCosine& known : kRationalCosines) {
        if (std::abs(radians - known.degrees * std::numbers::pi / 180) > kSame) continue;
        lower_ = upper_ = ExactNumber(known.numerator) / ExactNumber(4);
        return;
    }
    // The errors of the cosine (1e-99) and of its conversion (1e-47) are far below the margin.
    const Float cosine = cos(Float(radians));
    const Float square = cosine * abs(cosine);
    const Float margin("1e-41");
    lower_ = to_exact(square - margin);
    upper_ = to_exact(square + margin);
}

bool AngleLimit::exceeds_angle(const ExactVector& left, const ExactVector& right) const {
    const ExactNumber dot = hexagon_dot(left, right);
    const ExactNumber square = dot * CGAL::abs(dot);
    const ExactNumber lengths = hexagon_dot(left, left) * hexagon_dot(right, right);
    if (square > upper_ * lengths) return true;
    if (square <= lower_ * lengths) return false;
    throw base::NumericalError(
        "an angle of the layout cannot be compared with the limit: their cosines have squares within 1e-41");
}

}  // namespace fretwork::pattern::detail
