// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/free_factor.hpp>

#include <limits>

namespace fretwork::reduction::detail {

FreeFactor::FreeFactor(const PlaneStiffness& stiffness, std::span<const Eigen::Index> free_dofs)
    : free_dofs_(free_dofs) {
    for (std::size_t j = 0; j < free_dofs.size(); ++j) {
        for (std::size_t i = j; i < free_dofs.size(); ++i) {
            factor_(i, j) = stiffness(free_dofs[i], free_dofs[j]);
        }
    }
    is_positive_definite_ = factorize();
}

bool FreeFactor::factorize() {
    const auto size = static_cast<Eigen::Index>(free_dofs_.size());
    for (Eigen::Index k = 0; k < size; ++k) {
        const double pivot = factor_(k, k);
        if (!(pivot > 0.0)) return false;
        for (Eigen::Index j = k + 1; j < size; ++j) {
            const double share = factor_(j, k) / pivot;
            factor_.col(j).segment(j, size - j) -= share * factor_.col(k).segment(j, size - j);
        }
        factor_.col(k).segment(k + 1, size - k - 1) /= pivot;
    }
    return true;
}

PlaneVector FreeFactor::solve(const PlaneVector& load) const {
    if (!is_positive_definite_) return PlaneVector::Constant(std::numeric_limits<double>::quiet_NaN());
    const auto size = static_cast<Eigen::Index>(free_dofs_.size());
    PlaneVector x;
    for (Eigen::Index k = 0; k < size; ++k) x[k] = load[free_dofs_[k]];
    for (Eigen::Index k = 0; k < size; ++k) {
        const Eigen::Index below = size - k - 1;
        x.segment(k + 1, below) -= x[k] * factor_.col(k).segment(k + 1, below);
    }
    for (Eigen::Index k = size - 1; k >= 0; --k) {
        const Eigen::Index below = size - k - 1;
        x[k] = x[k] / factor_(k, k) - factor_.col(k).segment(k + 1, below).dot(x.segment(k + 1, below));
    }
    PlaneVector displacements = PlaneVector::Zero();
    for (Eigen::Index k = 0; k < size; ++k) displacements[free_dofs_[k]] = x[k];
    return displacements;
}

}  // namespace fretwork::reduction::detail
