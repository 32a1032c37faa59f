// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/sampling.hpp>

#include <cmath>

namespace fretwork::optimization {
namespace {

/// The positive root of x^(d+1) = x + 1, by its contracting fixed-point iteration.
double generalized_golden_ratio(int dimension) {
    double ratio = 2.0;
    for (int i = 0; i < 64; ++i) ratio = std::pow(1.0 + ratio, 1.0 / (dimension + 1));
    return ratio;
}

/// The number of the shift's random stream. The streams of methods are numbered from zero, so they differ.
constexpr std::uint64_t kShiftStream = 0x5A3D'1E70'0000'0000U;

}  // namespace

LowDiscrepancySequence::LowDiscrepancySequence(int dimension, std::uint64_t seed)
    : step_(dimension), shift_(dimension) {
    const double ratio = generalized_golden_ratio(dimension);
    base::RandomStream random(seed, kShiftStream);
    double power = 1.0;
    for (int i = 0; i < dimension; ++i) {
        power /= ratio;
        step_[i] = power;
        shift_[i] = random.uniform();
    }
}

Eigen::VectorXd LowDiscrepancySequence::point(std::uint64_t n) const {
    Eigen::VectorXd result = shift_ + static_cast<double>(n) * step_;
    for (double& share : result) share -= std::floor(share);
    return result;
}

}  // namespace fretwork::optimization
