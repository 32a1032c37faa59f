// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/stride.hpp>

#include <optional>

namespace fretwork::mechanics::nonlinear {

/// An equilibrium of a path, and the direction of the path at this equilibrium.
struct PathState {
    PathPoint point;
    Eigen::VectorXd direction;  ///< change of the unknowns along the path; of unit length in the system's
                                ///< weights
    double load_rate = 0.0;     ///< derivative of the load factor along the direction; below zero: the load
                                ///< falls
};

/// A step to an equilibrium that continues the path.
struct PathStep {
    PathState state;
    Eigen::VectorXd move;
    double length = 0.0;  ///< length of the move in the system's weights
    /// The distance between the move and its prediction by the directions at both ends, as a share of the
    /// largest accepted distance.
    double deviation = 0.0;
};

/// Correct a trial, load factor and unknowns together, to an equilibrium in the plane normal to a step
/// [Riks1979]. On success, the system is evaluated at the equilibrium.
/// @return  the number of iterations; -1 if no equilibrium was found
int correct_across(NonlinearSystem& system, Newton& newton, const Eigen::VectorXd& step, double& load_factor,
                   Configuration& trial);

/// Makes steps along an equilibrium path. A step continues the path if the mean of the directions at its two
/// ends predicts every component of the move. A step over a sharp bend of the path, or to another path, fails
/// this test.
class PathStepper {
  public:
    PathStepper(NonlinearSystem& system, Newton& newton, const EquilibriumOptions& options)
        : system_(system), unknowns_(system.unknowns()), newton_(newton), options_(options) {}

    /// The state at an equilibrium with a known rate, in the direction in which the load rises.
    [[nodiscard]] PathState rising(PathPoint point) const;

    /// A step of a given length. Nothing if no step of this length continues the path.
    /// @param previous  the previous state; null: not known
    std::optional<PathStep> step(const PathState& from, const PathState* previous, double length);

    /// A step to a larger load factor, starting from a guess of the move. Nothing if no equilibrium is found,
    /// or if the rates at both ends of the step do not predict the move.
    std::optional<PathStep> step_to_load(const PathState& from, double load_factor,
                                         const Eigen::VectorXd& guess);
    /// A step to a load factor within `known`, a step that continues the path. Nothing if no such step
    /// continues the path.
    std::optional<PathStep> step_within(const PathState& from, const PathStep& known, double load_factor);

    /// The length of a first step in which no node turns far and the load does not rise above `load_factor`.
    [[nodiscard]] double first_length(const PathState& from, double load_factor) const;
    /// The length of a step with a largest component of this size (rad, or element lengths).
    [[nodiscard]] double length_of(const PathState& from, double largest_component) const;

  private:
    struct Guess {
        Eigen::VectorXd move;
        double load_factor = 0.0;
    };
    [[nodiscard]] Guess predict(const PathState& from, const PathState* previous, double length) const;
    /// An equilibrium, at which the system is evaluated and the tangent factorized.
    struct Arrival {
        Configuration configuration;
        double load_factor;
        sparse::Ldlt::Outcome outcome;
    };
    std::optional<Arrival> correct_under_load(const PathState& from, double load_factor,
                                              const Eigen::VectorXd& guess);
    std::optional<PathStep> step_to(const PathState& from, Arrival arrival);
    [[nodiscard]] double deviation(const Eigen::VectorXd& move, const Eigen::VectorXd& explained) const;
    [[nodiscard]] double deviation_on_arc(const PathState& from, const PathStep& step) const;

    NonlinearSystem& system_;
    const Unknowns& unknowns_;
    Newton& newton_;
    const EquilibriumOptions& options_;
};

}  // namespace fretwork::mechanics::nonlinear
