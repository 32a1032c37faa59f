// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace fretwork::optimization {

/// A low-discrepancy sequence in the unit cube of any dimension: the additive recurrence on powers of the
/// generalized golden ratio [Roberts2018], shifted at random by the seed.
class LowDiscrepancySequence {
  public:
    /// Make a sequence. Pre: dimension >= 1.
    LowDiscrepancySequence(int dimension, std::uint64_t seed);
    /// Point n, which depends on dimension, seed and n alone.
    [[nodiscard]] Eigen::VectorXd point(std::uint64_t n) const;

  private:
    Eigen::VectorXd step_;
    Eigen::VectorXd shift_;
};

}  // namespace fretwork::optimization
