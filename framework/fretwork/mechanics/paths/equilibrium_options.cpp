// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

namespace fretwork::mechanics {
namespace {

void require(bool good, const std::string& message) {
    if (!good) throw base::InputError(message);
}

}  // namespace

void EquilibriumOptions::validate() const {
    require(relative_residual > 0.0 && relative_residual < 1.0, "relative_residual is " +
                                                                    base::format_number(relative_residual) +
                                                                    ", where a number in (0, 1) is needed");
    require(largest_rotation_step > 0.0 && largest_rotation_step < 3.0,
            "largest_rotation_step is " + base::format_number(largest_rotation_step) +
                ", where a number in (0, 3) is needed");
    require(threads >= 0, "threads is " + std::to_string(threads) + ", and must not be negative");
    require(iterations_per_step > 0, "iterations_per_step must be above zero");
}

std::vector<double> even_load_factors(int steps) {
    std::vector<double> factors;
    for (int k = 1; k <= steps; ++k) factors.push_back(static_cast<double>(k) / steps);
    return factors;
}

}  // namespace fretwork::mechanics
