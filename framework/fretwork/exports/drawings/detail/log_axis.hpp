// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// A logarithmic axis of a chart.
struct LogAxis {
    std::string label;
    double low = 1.0;
    double high = 10.0;

    /// Where a value lies between low (0) and high (1).
    [[nodiscard]] double share(double value) const;
    /// Round values from low to high: multiples of powers of ten, or on long axes the powers alone.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// The axis that holds all values with some room at both ends. Throws InputError if there are none,
/// NumericalError if one is not above zero.
LogAxis axis_of(std::string label, std::span<const double> values);

}  // namespace fretwork::exports::detail
