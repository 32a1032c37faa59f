// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/nonlinear/path_step.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>

#include <algorithm>
#include <cmath>

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
          configuration_(unknowns_.rest()) {
        system_.evaluate(configuration_, 0.0);
        newton_.factorize_at_rest();
        rate_ = newton_.solve_tangent(system_.load_rate());
        direction_ = rate_;
        arc_ = std::min(options_.first_load_step * unknowns_.size_of(rate_), options_.largest_arc);
    }

    std::vector<Solution> run() {
        const base::Task task(options_.equilibrium.control, "path (points)", options_.steps);
        std::vector<Solution> path;
        const double shortest = arc_ / std::pow(2.0, options_.largest_cut_back);
        while (static_cast<int>(path.size()) < options_.steps &&
               std::abs(factor_) < options_.largest_load_factor) {
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
        const double forward = unknowns_.product(direction_, rate_) >= 0.0 ? 1.0 : -1.0;
        const double load_step = forward * arc_ / unknowns_.size_of(rate_);
        const Eigen::VectorXd tangent = load_step * rate_;
        Configuration trial = configuration_;
        double factor = factor_ + load_step;
        unknowns_.prescribe(factor, trial);
        unknowns_.move(tangent, trial);
        const int iterations = nonlinear::correct_across(system_, newton_, tangent, factor, trial);
        if (iterations < 0) return false;
        Eigen::VectorXd move = unknowns_.step_between(configuration_, trial);
        if (unknowns_.product(tangent, move) <= 0.25 * arc_ * arc_) return false;
        direction_ = std::move(move);
        configuration_ = std::move(trial);
        factor_ = factor;
        outcome_ = newton_.factorize();
        if (outcome_.zero_pivot < 0) rate_ = newton_.solve_tangent(system_.load_rate());
        arc_ *= std::clamp(std::sqrt(kGoodIterations / std::max(iterations, 1)), 0.5, 1.5);
        arc_ = std::min(arc_, options_.largest_arc);
        return true;
    }

    [[nodiscard]] Solution describe() {
        system_.evaluate(configuration_, factor_);
        Solution solution = system_.describe(configuration_, factor_);
        solution.stable = outcome_.positive_definite();
        solution.stability = system_.stability_test();
        solution.iterations = newton_.take_iterations();
        return solution;
    }

    const PathTracingOptions& options_;
    nonlinear::NonlinearSystem system_;
    const nonlinear::Unknowns& unknowns_ = system_.unknowns();
    nonlinear::Newton newton_;
    Configuration configuration_;
    double factor_ = 0.0;
    double arc_ = 0.0;
    Eigen::VectorXd rate_;       ///< derivative of the unknowns with respect to the load factor
    Eigen::VectorXd direction_;  ///< the last move
    sparse::Ldlt::Outcome outcome_;
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
