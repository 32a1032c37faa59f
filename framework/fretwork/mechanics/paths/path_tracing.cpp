// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/nonlinear/path_step.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::mechanics {
namespace {

using nonlinear::Configuration;

/// The wanted number of iterations of a step. After more iterations, the next step is shorter; after fewer,
/// longer.
constexpr double kGoodIterations = 4.0;

/// Riks' method: each step goes along the tangent of the path by a given arc length. Load factor and
/// displacements are then corrected together, in the plane normal to the tangent.
class Tracer {
  public:
    Tracer(const Assembly& assembly, const PathTracingOptions& options)
        : options_(options),
          system_(assembly, options.equilibrium.threads, options.equilibrium.control),
          newton_(system_, options_.equilibrium),
          point_{unknowns_.rest(), 0.0, {}, {}, 0.0} {
        system_.evaluate(point_.configuration, 0.0);
        newton_.factorize_at_rest();
        point_.rate = newton_.solve_tangent(system_.load_rate());
        direction_ = point_.rate;
        arc_ = std::min(options_.first_load_step * unknowns_.size_of(point_.rate), options_.largest_arc);
    }

    std::vector<Solution> run() {
        const base::Task task(options_.equilibrium.control, "path (points)", options_.steps);
        std::vector<Solution> path;
        const double shortest = arc_ / std::pow(2.0, options_.largest_cut_back);
        while (static_cast<int>(path.size()) < options_.steps &&
               std::abs(point_.load_factor) < options_.largest_load_factor) {
            bool found = try_step();
            while (!found && arc_ > shortest) {
                arc_ *= 0.5;
                found = try_step();
            }
            path.push_back(describe());
            task.update(path.size());
            if (found) continue;
            path.back().termination = Termination::Diverged;
            break;
        }
        return path;
    }

  private:
    bool try_step() {
        const double forward = unknowns_.product(direction_, point_.rate) >= 0.0 ? 1.0 : -1.0;
        const double load_step = forward * arc_ / unknowns_.size_of(point_.rate);
        const Eigen::VectorXd tangent = load_step * point_.rate;
        Configuration trial = point_.configuration;
        double factor = point_.load_factor + load_step;
        unknowns_.prescribe(factor, trial);
        unknowns_.move(tangent, trial);
        const int iterations = nonlinear::correct_across(system_, newton_, tangent, factor, trial);
        if (iterations < 0) return false;
        Eigen::VectorXd move = unknowns_.step_between(point_.configuration, trial);
        if (unknowns_.product(tangent, move) <= 0.25 * arc_ * arc_) return false;
        const double turn_bound = nonlinear::bound_relative_turn(system_, point_, move, factor, trial);
        if (turn_bound > std::numbers::pi) return false;
        direction_ = std::move(move);
        point_.configuration = std::move(trial);
        point_.load_factor = factor;
        point_.turn_bound = turn_bound;
        point_.outcome = newton_.factorize();
        if (point_.outcome.zero_pivot < 0) point_.rate = newton_.solve_tangent(system_.load_rate());
        arc_ *= std::clamp(std::sqrt(kGoodIterations / std::max(iterations, 1)), 0.5, 1.5);
        arc_ = std::min(arc_, options_.largest_arc);
        return true;
    }

    [[nodiscard]] Solution describe() {
        system_.evaluate(point_.configuration, point_.load_factor);
        Solution solution = system_.describe(point_.configuration, point_.load_factor);
        solution.stable = point_.outcome.positive_definite();
        solution.stability = system_.stability_test();
        solution.iterations = newton_.take_iterations();
        return solution;
    }

    const PathTracingOptions& options_;
    nonlinear::NonlinearSystem system_;
    const nonlinear::Unknowns& unknowns_ = system_.unknowns();
    nonlinear::Newton newton_;
    nonlinear::PathPoint point_;  ///< last equilibrium
    double arc_ = 0.0;
    Eigen::VectorXd direction_;  ///< the last move
};

}  // namespace

void PathTracingOptions::validate() const {
    equilibrium.validate();
    if (!(first_load_step > 0.0)) throw base::InputError("first_load_step must be above zero");
    if (!(largest_load_factor > 0.0)) throw base::InputError("largest_load_factor must be above zero");
    if (!(largest_arc > 0.0)) throw base::InputError("largest_arc must be above zero");
    if (largest_cut_back < 0 || largest_cut_back > 30)
        throw base::InputError("largest_cut_back must be from 0 to 30");
    if (steps < 1) throw base::InputError("steps must be above zero");
}

std::vector<Solution> trace_path(const Assembly& assembly, const PathTracingOptions& options) {
    options.validate();
    return Tracer(assembly, options).run();
}

}  // namespace fretwork::mechanics
