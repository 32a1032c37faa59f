// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// The six parameters of the paper's reduced model, Eq. (4).
struct Paper6Parameters {
    double A = 0.0;      ///< m^2
    double I2 = 0.0;     ///< m^4
    double I3 = 0.0;     ///< m^4
    double J = 0.0;      ///< m^4
    double theta = 0.0;  ///< rad, counterclockwise positive
    double R = 0.0;      ///< m, circumradius of the inner ring

    static constexpr std::array<const char*, 6> names = {"A", "I2", "I3", "J", "theta", "R"};
    /// In the order of `names`.
    [[nodiscard]] std::vector<double> values() const { return {A, I2, I3, J, theta, R}; }
    /// `values` has six entries, in the order of `names`.
    static Paper6Parameters from_values(std::span<const double> values) {
        return {values[0], values[1], values[2], values[3], values[4], values[5]};
    }
};

}  // namespace fretwork::reduction
