// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/unit_box.hpp>

#include <cmath>

namespace fretwork::optimization::detail {
namespace {

constexpr double kRoundOff = 1e-12;

}  // namespace

UnitBox::UnitBox(const Problem& problem, Scale scale)
    : bounds_(problem.bounds()), is_exponential_(bounds_.dimension()) {
    for (int i = 0; i < bounds_.dimension(); ++i) {
        is_exponential_[i] = scale == Scale::Quantity && problem.is_logarithm(i);
    }
}

Eigen::VectorXd UnitBox::point(const Eigen::VectorXd& shares) const {
    Eigen::VectorXd result(shares.size());
    bool is_inside = true;
    for (Eigen::Index i = 0; i < shares.size(); ++i) {
        const double low = bounds_.lower[i];
        const double high = bounds_.upper[i];
        is_inside = is_inside && shares[i] >= -kRoundOff && shares[i] <= 1.0 + kRoundOff;
        result[i] = is_exponential_[i]
                        ? std::log(std::exp(low) + shares[i] * (std::exp(high) - std::exp(low)))
                        : low + shares[i] * (high - low);
    }
    return is_inside ? bounds_.clamp(result) : result;
}

}  // namespace fretwork::optimization::detail
