// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/newton.hpp>
#include <fretwork/mechanics/nonlinear/stress_workspace.hpp>

#include <optional>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// Newton's method in displacements and stresses together [Magisano2017]. The geometric terms of the tangent
/// take stresses that are extrapolated from the previous iteration. The stresses are eliminated, so the
/// unknowns and the sparsity do not change. The next step need not undo the membrane forces of a long step,
/// so a step may turn nodes by half a radian and more.
///
/// Old factors are kept as long as the steps shrink fast enough. Let B0 be the slopes of the strains at the
/// configuration of the factors. With an old tangent, the internal force is B(x)^T s + B0^T (K e(x) - s), and
/// the stresses become s <- K (e(x) + B0 dx).
class MixedNewton {
  public:
    MixedNewton(NonlinearSystem& system, Newton& newton, const EquilibriumOptions& options)
        : system_(system),
          unknowns_(system.unknowns()),
          newton_(newton),
          options_(options),
          stresses_(unknowns_.assembly()) {}

    /// Begin at rest: take the stresses at rest and factorize the tangent. Throws as
    /// Newton::factorize_at_rest.
    void begin_at_rest(const Configuration& rest);
    /// Begin at an equilibrium: take the stresses at the equilibrium and factorize the tangent. False if the
    /// tangent is singular, or if the residual is not finite.
    bool begin(const Configuration& equilibrium, double load_factor);

    /// The accuracy to which the equations are solved.
    enum class Goal {
        Approach,    ///< iterate until a step is short, between two increments of the load
        Equilibrium  ///< iterate to the tolerances of EquilibriumOptions
    };
    /// Iterate, and move the configuration. The first step is `step`, a solution with the factors of this
    /// object. On Converged, the factors belong to the configuration. With Goal::Equilibrium, they may belong
    /// to a configuration a small move away; such a move changes no sign of a pivot unless the tangent is
    /// nearly singular. If stability is not classified, they may be older.
    Termination solve(double load_factor, Goal goal, const Eigen::VectorXd& step,
                      Configuration& configuration);

    /// Move the unknowns by a step. Extrapolate the stresses along the step and the share `prescribed` of the
    /// change of the prescribed components, which Unknowns::prescribe() has to move.
    void move(const Eigen::VectorXd& step, double prescribed, Configuration& configuration);

    /// The first step of a departure from an equilibrium.
    struct FirstStep {
        Eigen::VectorXd unbalanced;  ///< right side of the equations for `step`
        Eigen::VectorXd step;        ///< empty: it is still an equilibrium, and nothing was moved
    };
    FirstStep depart(Configuration& configuration);
    /// Return to the equilibrium of the last departure, which failed. False if the factors no longer belong
    /// to that equilibrium.
    bool come_back(const Configuration& equilibrium);

    /// The pivots of the last factorization.
    [[nodiscard]] const sparse::Ldlt::Outcome& outcome() const { return outcome_; }

    [[nodiscard]] const std::vector<double>& stresses() const { return stresses_.given(); }
    /// An equilibrium of a path.
    struct Place {
        const Configuration& configuration;
        double load_factor;
        const sparse::Ldlt::Outcome& outcome;
    };
    /// Go back to the equilibrium `place` at which a failed attempt began, with the stresses at that
    /// equilibrium. The factors are those of the attempt, so solve() begins with new factors.
    void go_back(const Place& place, const std::vector<double>& stresses);

  private:
    /// The goal of solve(), and its progress.
    struct Iteration {
        Goal goal;
        double load_factor;
        int negative_pivots;  ///< number of negative pivots on the path
        Eigen::VectorXd step;
        double travelled;  ///< sum of the sizes of all steps
        double turn;       ///< largest rotation of a node in the step, rad
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

    NonlinearSystem& system_;
    const Unknowns& unknowns_;
    Newton& newton_;
    const EquilibriumOptions& options_;
    StressWorkspace stresses_;
    sparse::Ldlt::Outcome outcome_;
    bool has_foreign_factors_ = false;  ///< true if the factors are those of a failed attempt
    /// The distance of the configuration from the configuration of the factors.
    struct Way {
        double turned = 0.0;  ///< upper bound on the rotation of a node, rad
        double moved = 0.0;   ///< sum of the lengths of the steps, measured with the system's weights
    };
    Way way_{};
    /// Distance at the last departure; none: the factors are newer than the departure.
    std::optional<Way> way_at_departure_{};
};

}  // namespace fretwork::mechanics::nonlinear
