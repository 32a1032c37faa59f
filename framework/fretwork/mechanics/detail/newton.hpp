// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/detail/nonlinear_system.hpp>
#include <fretwork/mechanics/equilibrium.hpp>

#include <utility>
#include <vector>

namespace fretwork::mechanics::detail {

/// Newton's method on a NonlinearSystem, and the linear solves with its tangent.
class Newton {
  public:
    Newton(NonlinearSystem& system, const EquilibriumOptions& options)
        : system_(system), options_(options), factors_(system.layout(), options.threads) {}

    /// Bring a configuration to equilibrium under this load factor. On Converged the system is evaluated
    /// there.
    Termination solve(double load_factor, Configuration& configuration);

    /// Factorize the tangent of the last evaluation, which is at rest. Throws NumericalError that names a
    /// node if the structure can move without strain.
    void factorize_at_rest();
    /// Factorize the tangent of the last evaluation. Returns what its symmetric part is.
    Ldlt::Outcome factorize();
    /// The same with `shift` times the system's weights added to the diagonal.
    Ldlt::Outcome factorize(double shift);
    /// Solve with the symmetric part of the last factorization, in place.
    void solve_symmetric(Eigen::VectorXd& right_side);
    /// Solve with the whole tangent of the last factorization, its skew part included.
    [[nodiscard]] Eigen::VectorXd solve_tangent(const Eigen::VectorXd& right_side);

    /// Linear solves since the last call.
    int take_iterations() { return std::exchange(iterations_, 0); }

  private:
    [[nodiscard]] bool is_converged(const Configuration& configuration,
                                    const Eigen::VectorXd& last_step) const;

    NonlinearSystem& system_;
    const EquilibriumOptions& options_;
    Ldlt factors_;
    std::vector<double> shifted_;
    int iterations_ = 0;
};

}  // namespace fretwork::mechanics::detail
