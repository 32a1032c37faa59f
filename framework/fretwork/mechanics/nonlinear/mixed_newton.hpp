// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/newton.hpp>
#include <fretwork/mechanics/nonlinear/stress_workspace.hpp>

#include <optional>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// Newton's method in displacements and stresses together. The stresses, extrapolated from the iteration
/// before, stand in the geometric terms of the tangent; their elimination leaves the unknowns and the
/// sparsity as they are. The next step then need not undo the membrane forces of a long step: steps may turn
/// nodes by half a radian, and more. [Magisano2017]
///
/// Factors are kept while they bring the steps down fast enough: with the slopes B0 of their configuration
/// the equations of an old tangent are B(x)^T s + B0^T (K e(x) - s), and s <- K (e(x) + B0 dx).
class MixedNewton {
  public:
    MixedNewton(NonlinearSystem& system, Newton& newton, const EquilibriumOptions& options)
        : system_(system),
          unknowns_(system.unknowns()),
          newton_(newton),
          options_(options),
          stresses_(unknowns_.assembly()) {}

    /// Take the stresses and factorize the tangent at rest. Throws as Newton::factorize_at_rest.
    void begin_at_rest(const Configuration& rest);
    /// The same at an equilibrium. False if the tangent there is singular.
    bool begin(const Configuration& equilibrium, double load_factor);

    /// How well equations are to be solved.
    enum class Goal {
        Approach,    ///< between two increments of the load: the last step is short
        Equilibrium  ///< as EquilibriumOptions say
    };
    /// Go on from a step that was made with the factors of this class; it moves the configuration. On
    /// Converged the factors are those of the configuration: exactly, or at an equilibrium up to a move that
    /// changes no sign of a pivot unless it is nearly singular.
    Termination solve(double load_factor, Goal goal, const Eigen::VectorXd& step,
                      Configuration& configuration);

    /// Make a step of the unknowns, and of the prescribed components by this share of their values.
    void move(const Eigen::VectorXd& step, double prescribed, Configuration& configuration);

    /// From an equilibrium of other loads, prescribed values or supports, with the factors there: move what
    /// is held to its values, and make a first step to the equilibrium at the full load.
    struct FirstStep {
        Eigen::VectorXd unbalanced;  ///< what it was solved for
        Eigen::VectorXd step;
    };
    FirstStep depart(Configuration& configuration);
    /// Go back to the equilibrium of the last departure, which was given up. False if the factors are no
    /// longer those there.
    bool come_back(const Configuration& equilibrium);

    /// Pivots of the last factorization.
    [[nodiscard]] const sparse::Ldlt::Outcome& outcome() const { return outcome_; }

    [[nodiscard]] const std::vector<double>& stresses() const { return stresses_.given(); }
    /// Go back to a configuration with these stresses, and factorize there. False if there are no factors.
    bool restore(const Configuration& configuration, double load_factor, const std::vector<double>& stresses);

  private:
    /// The goal of solve(), and its progress.
    struct Iteration {
        Goal goal;
        double load_factor;
        int negative_pivots;  ///< of the path
        Eigen::VectorXd step;
        double travelled;  ///< sum of the sizes of all steps
        double turn;       ///< rad, the largest of a node in the step
    };
    [[nodiscard]] bool has_own_factors(const Iteration& iteration) const;
    [[nodiscard]] bool wants_own_factors(const Iteration& iteration) const;
    std::optional<Termination> step_with_new_factors(Iteration& iteration,
                                                     const Configuration& configuration);
    std::optional<Termination> step_with_old_factors(Iteration& iteration,
                                                     const Configuration& configuration);
    Termination end_at_equilibrium(const Iteration& iteration, const Configuration& configuration);
    bool factorize(const Configuration& configuration, double load_factor);
    void give_own_stresses(const Configuration& configuration, double load_factor);
    [[nodiscard]] bool is_slow(double ratio) const;
    [[nodiscard]] double size_of(const Eigen::VectorXd& step) const;

    NonlinearSystem& system_;
    const Unknowns& unknowns_;
    Newton& newton_;
    const EquilibriumOptions& options_;
    StressWorkspace stresses_;
    sparse::Ldlt::Outcome outcome_;
    /// How far the configuration has gone since the factors were made.
    struct Way {
        double turned = 0.0;  ///< rad, at most
        double moved = 0.0;   ///< of whole steps, against the system's weights
    };
    Way way_{};
    std::optional<Way> way_at_departure_{};  ///< none: the factors were made after it
};

}  // namespace fretwork::mechanics::nonlinear
