// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/box_quadratic.hpp>
#include <fretwork/optimization/detail/starts.hpp>
#include <fretwork/optimization/gauss_newton_multistart.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::optimization {
namespace {

/// One descent: a point, and the quadratic model of the smoothed objective there.
class Descent {
  public:
    Descent(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd start)
        : evaluator_(evaluator), options_(options), point_(std::move(start)) {}

    Termination run() {
        Termination termination = Termination::Converged;
        for (const double smoothing : options_.smoothing) {
            const bool is_last = smoothing == options_.smoothing.back();
            termination = run_stage(smoothing, is_last ? options_.tolerance : options_.loose_tolerance);
            if (termination == Termination::BudgetSpent) break;
        }
        return termination;
    }
    [[nodiscard]] const Eigen::VectorXd& point() const { return point_; }

  private:
    Termination run_stage(double smoothing, double tolerance) {
        const auto model = evaluator_.curvature(point_, smoothing);
        if (!model) return Termination::BudgetSpent;
        if (!std::isfinite(model->value)) return Termination::Stalled;
        model_ = *model;
        for (int iteration = 0; iteration < options_.largest_iterations; ++iteration) {
            const Eigen::VectorXd step = damped_step();
            const double predicted = -model_.gradient.dot(step) - 0.5 * step.dot(model_.curvature * step);
            if (predicted <= tolerance * model_.value) return Termination::Converged;
            const auto trial = evaluator_.curvature(evaluator_.bounds().clamp(point_ + step), smoothing);
            if (!trial) return Termination::BudgetSpent;
            judge(step, *trial, (model_.value - trial->value) / predicted);
        }
        return Termination::Stalled;
    }

    [[nodiscard]] Eigen::VectorXd damped_step() const {
        Eigen::MatrixXd H = model_.curvature;
        const double floor = 1e-12 * std::max(H.diagonal().maxCoeff(), 1e-300);
        H.diagonal() = (1.0 + damping_) * H.diagonal().cwiseMax(floor);
        const Bounds& bounds = evaluator_.bounds();
        return detail::minimize_box_quadratic(H, model_.gradient,
                                              {bounds.lower - point_, bounds.upper - point_});
    }

    /// Take the step if it gains, and set the damping by how well the model foresaw the gain [Nielsen1999].
    void judge(const Eigen::VectorXd& step, const CurvatureEvaluation& trial, double gain_ratio) {
        if (gain_ratio > 1e-4) {
            point_ = evaluator_.bounds().clamp(point_ + step);
            model_ = trial;
            damping_ *= std::max(1.0 / 10.0, 1.0 - std::pow(2.0 * gain_ratio - 1.0, 3));
            damping_ = std::max(damping_, kSmallestDamping);
            growth_ = 2.0;
        } else {
            damping_ *= growth_;
            growth_ *= 2.0;
        }
    }

    static constexpr double kSmallestDamping = 1e-10;
    Evaluator& evaluator_;
    const ContinuationOptions& options_;
    Eigen::VectorXd point_;
    CurvatureEvaluation model_;
    double damping_ = 1e-2;
    double growth_ = 2.0;
};

class GaussNewtonMultistart final : public Optimizer {
  public:
    explicit GaussNewtonMultistart(const GaussNewtonMultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome{Termination::BudgetSpent, {}};
        const int samples = options_.common.starts * options_.continuation.samples_per_start;
        for (const Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, samples)) {
            Descent descent(evaluator, options_.continuation, start);
            outcome.termination = descent.run();
            outcome.final_point = descent.point();
            if (outcome.termination == Termination::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    GaussNewtonMultistartOptions options_;
};

}  // namespace

void GaussNewtonMultistartOptions::validate() const {
    common.validate();
    continuation.validate();
}

std::unique_ptr<Optimizer> make_gauss_newton_multistart(const GaussNewtonMultistartOptions& options) {
    options.validate();
    return std::make_unique<GaussNewtonMultistart>(options);
}

}  // namespace fretwork::optimization
