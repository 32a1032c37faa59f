// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/box_quadratic.hpp>
#include <fretwork/optimization/methods/detail/ceres_descent.hpp>
#include <fretwork/optimization/methods/detail/option_checks.hpp>
#include <fretwork/optimization/methods/multistart.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::optimization {
namespace {

/// True if a descent can go on from a point with this model.
bool is_usable(const CurvatureEvaluation& model) {
    return std::isfinite(model.value) && model.gradient.allFinite() && model.curvature.allFinite();
}

/// A descent: a point, and the quadratic model of the smoothed objective at this point.
class GaussNewtonDescent final : public detail::StagedDescent {
  public:
    GaussNewtonDescent(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd start)
        : evaluator_(&evaluator), options_(&options), point_(std::move(start)) {}

    Ending run_stage(double smoothing) override {
        const double tolerance =
            smoothing == options_->smoothing.back() ? options_->tolerance : options_->loose_tolerance;
        const auto model = evaluator_->curvature(point_, smoothing);
        if (!model) return Ending::BudgetSpent;
        if (!is_usable(*model)) {
            model_.value = kNothing;  // this descent is then left out of the next stage
            return Ending::Stalled;
        }
        model_ = *model;
        for (int iteration = 0; iteration < options_->largest_iterations; ++iteration) {
            const Eigen::VectorXd step = damped_step();
            const double predicted = -model_.gradient.dot(step) - 0.5 * step.dot(model_.curvature * step);
            if (predicted <= tolerance * model_.value) return Ending::Converged;
            const auto trial = evaluator_->curvature(evaluator_->bounds().clamp(point_ + step), smoothing);
            if (!trial) return Ending::BudgetSpent;
            judge(step, *trial, is_usable(*trial) ? (model_.value - trial->value) / predicted : -kNothing);
        }
        return Ending::Stalled;
    }

    [[nodiscard]] const Eigen::VectorXd& point() const override { return point_; }
    [[nodiscard]] double value() const override { return model_.value; }

  private:
    [[nodiscard]] Eigen::VectorXd damped_step() const {
        Eigen::MatrixXd H = model_.curvature;
        const double floor = 1e-12 * std::max(H.diagonal().maxCoeff(), 1e-300);
        H.diagonal() = (1.0 + damping_) * H.diagonal().cwiseMax(floor);
        const Bounds& bounds = evaluator_->bounds();
        return detail::minimize_box_quadratic(H, model_.gradient,
                                              {bounds.lower - point_, bounds.upper - point_});
    }

    /// Take the step if it lowers the value, and adapt the damping to the ratio of the gain to its prediction
    /// by the model [Nielsen1999].
    void judge(const Eigen::VectorXd& step, const CurvatureEvaluation& trial, double gain_ratio) {
        if (gain_ratio > 1e-4) {
            point_ = evaluator_->bounds().clamp(point_ + step);
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
    static constexpr double kNothing = std::numeric_limits<double>::infinity();
    Evaluator* evaluator_;
    const ContinuationOptions* options_;
    Eigen::VectorXd point_;
    CurvatureEvaluation model_{.objective = kNothing, .value = kNothing, .gradient = {}, .curvature = {}};
    double damping_ = 1e-2;
    double growth_ = 2.0;
};

/// @tparam Descent  a detail::StagedDescent
template <class Descent>
class Multistart final : public Optimizer {
  public:
    explicit Multistart(const MultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        return detail::run_multistart(evaluator, options_, [&](Eigen::VectorXd start) {
            return std::make_unique<Descent>(evaluator, options_.continuation, std::move(start));
        });
    }

  private:
    MultistartOptions options_;
};

}  // namespace

void ContinuationOptions::validate() const {
    detail::require_smoothing(smoothing);
    detail::require_more_than(0.0, "loose_tolerance", loose_tolerance);
    detail::require_more_than(0.0, "tolerance", tolerance);
    detail::require_at_least(1.0, "largest_iterations", largest_iterations);
    detail::require_at_least(1.0, "samples_per_start", samples_per_start);
}

void MultistartOptions::validate() const {
    common.validate();
    continuation.validate();
    detail::require_at_least(0.0, "merging_distance", merging_distance);
    detail::require_at_least(1.0, "pruning_ratio", pruning_ratio);
}

std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options) {
    options.validate();
    return std::make_unique<Multistart<detail::CeresDescent>>(options);
}

std::unique_ptr<Optimizer> make_gauss_newton_multistart(const MultistartOptions& options) {
    options.validate();
    return std::make_unique<Multistart<GaussNewtonDescent>>(options);
}

}  // namespace fretwork::optimization
