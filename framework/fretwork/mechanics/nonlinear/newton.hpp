// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// Newton's method on a NonlinearSystem, and the linear solves with its tangent. Functions that evaluate,
/// factorize or solve throw Stopped.
class Newton {
  public:
    Newton(NonlinearSystem& system, const EquilibriumOptions& options)
        : system_(system),
          unknowns_(system.unknowns()),
          options_(options),
          factors_(unknowns_.layout(), options.threads, options.control) {}

    /// Bring a configuration to equilibrium under this load factor. On Converged, the system is evaluated at
    /// the equilibrium.
    Termination solve(double load_factor, Configuration& configuration);

    /// Bring a configuration to equilibrium under this load factor. Factorize the tangent there, or at a
    /// configuration that is only a negligible part of `way` away. On success, the last evaluation may be of
    /// forces alone. Returns the outcome of the factorization; nothing if no equilibrium was found, or if the
    /// tangent is singular.
    /// @param way  the step from the last equilibrium to the given configuration
    std::optional<sparse::Ldlt::Outcome> solve_and_factorize(double load_factor, const Eigen::VectorXd& way,
                                                             Configuration& configuration);

    /// True if the configuration of the last evaluation is an equilibrium by EquilibriumOptions.
    /// @param last_step  the step that led to the configuration; may be empty
    [[nodiscard]] bool is_converged(const Configuration& configuration,
                                    const Eigen::VectorXd& last_step) const;

    /// Factorize the tangent of the last evaluation. Pre: the last evaluation was at rest. Throws
    /// NumericalError if the structure can move without strain (structure::refuse_mechanisms()), or if its
    /// stiffness is not finite.
    void factorize_at_rest();
    /// Factorize the tangent of the last evaluation. Returns the definiteness of its symmetric part.
    sparse::Ldlt::Outcome factorize();
    /// Factorize the tangent of the last evaluation with `shift` times the system's weights added to its
    /// diagonal.
    sparse::Ldlt::Outcome factorize(double shift);
    /// Declare that the tangent is singular along a direction because of a symmetry. After this call,
    /// factorize() makes the tangent regular by `shift`, and solve_tangent() does not move along the
    /// direction. An empty direction revokes the declaration.
    void set_neutral(Eigen::VectorXd direction, double shift);
    [[nodiscard]] bool has_neutral() const { return neutral_.size() > 0; }
    [[nodiscard]] const Eigen::VectorXd& neutral() const { return neutral_; }

    /// Solve with the symmetric part of the last factorization, in place.
    void solve_symmetric(Eigen::VectorXd& right_side);
    /// Solve with the tangent of the last factorization, its skew part included.
    [[nodiscard]] Eigen::VectorXd solve_tangent(const Eigen::VectorXd& right_side);

    /// The matrix of a linear system: the tangent, or its transpose for adjoint solutions.
    enum class Side { Tangent, Transposed };
    /// Solve with the tangent of the last *evaluation* up to rounding, one column for each right side.
    /// Solutions are refined with the current factors, which may belong to another tangent. Nothing if the
    /// two tangents differ too much. Throws Stopped.
    [[nodiscard]] std::optional<Eigen::MatrixXd> solve_refined(const Eigen::MatrixXd& right_sides, Side side);
    /// Solve without refinement. Pre: the factors belong to the tangent of the last evaluation, which has no
    /// skew part.
    [[nodiscard]] Eigen::MatrixXd solve_plainly(Eigen::MatrixXd right_sides) const;
    /// Blocks of the inverse of the symmetric part of the last factorization (sparse::Ldlt::inverse_blocks).
    [[nodiscard]] std::vector<Eigen::MatrixXd> inverse_blocks(
        std::span<const std::vector<int>> cliques) const {
        return factors_.inverse_blocks(cliques, options_.control);
    }

    /// The number of linear solves since the last call. The call resets the count.
    int take_iterations() { return std::exchange(iterations_, 0); }

  private:
    Termination make_step(Eigen::VectorXd& step, Configuration& configuration);
    [[nodiscard]] Eigen::VectorXd solve_skew(const Eigen::VectorXd& symmetric_solution, double sign) const;
    [[nodiscard]] Eigen::MatrixXd tangent_product(const Eigen::MatrixXd& x, double sign) const;
    [[nodiscard]] Eigen::VectorXd without_neutral_part(Eigen::VectorXd x);

    NonlinearSystem& system_;
    const Unknowns& unknowns_;
    const EquilibriumOptions& options_;
    sparse::Ldlt factors_;
    std::vector<double> shifted_;
    Eigen::VectorXd neutral_;  ///< neutral direction, of unit length in the system's weights; empty: none
    double neutral_shift_ = 0.0;
    int iterations_ = 0;
};

}  // namespace fretwork::mechanics::nonlinear
