// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/log_axis.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::exports::detail {

namespace {

/// Which multiples of powers of ten an axis of some length marks.
std::vector<double> factors_of(double decades) {
    if (decades > 2.2) return {1.0};
    if (decades > 1.0) return {1.0, 2.0, 5.0};
    return {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0};
}

}  // namespace

double LogAxis::share(double value) const {
    return std::log(value / low) / std::log(high / low);
}

std::vector<double> LogAxis::ticks() const {
    const double decades = std::log10(high / low);
    std::vector<double> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0) {
        for (const double factor : factors_of(decades)) {
            const double value = factor * power;
            if (value >= low && value <= high) ticks.push_back(value);
        }
    }
    return ticks;
}

LogAxis axis_of(std::string label, std::span<const double> values) {
    if (values.empty()) throw base::InputError("there is nothing to chart");
    const auto [least, most] = std::ranges::minmax(values);
    if (!(least > 0.0) || !std::isfinite(most)) {
        throw base::NumericalError(label + ": " + base::format_number(least > 0.0 ? most : least) +
                                   " has no place on a logarithmic axis");
    }
    const double room = std::max(1.12, std::pow(most / least, 0.05));
    return {std::move(label), least / room, most * room};
}

}  // namespace fretwork::exports::detail
