// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/detail/box_quadratic.hpp>
#include <fretwork/optimization/detail/starts.hpp>
#include <fretwork/optimization/gauss_newton_multistart.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fretwork::optimization {
namespace {

/// One descent: a point, and the quadratic model of the smoothed objective there.
class Descent {
  public:
    Descent(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd start)
        : evaluator_(&evaluator), options_(&options), point_(std::move(start)) {}

    Ending run_stage(double smoothing) {
        const double tolerance =
            smoothing == options_->smoothing.back() ? options_->tolerance : options_->loose_tolerance;
        const auto model = evaluator_->curvature(point_, smoothing);
        if (!model) return Ending::BudgetSpent;
        if (!std::isfinite(model->value)) return Ending::Stalled;
        model_ = *model;
        for (int iteration = 0; iteration < options_->largest_iterations; ++iteration) {
            const Eigen::VectorXd step = damped_step();
            const double predicted = -model_.gradient.dot(step) - 0.5 * step.dot(model_.curvature * step);
            if (predicted <= tolerance * model_.value) return Ending::Converged;
            const auto trial = evaluator_->curvature(evaluator_->bounds().clamp(point_ + step), smoothing);
            if (!trial) return Ending::BudgetSpent;
            judge(step, *trial, (model_.value - trial->value) / predicted);
        }
        return Ending::Stalled;
    }

    [[nodiscard]] const Eigen::VectorXd& point() const { return point_; }
    /// Smoothed as in the last stage.
    [[nodiscard]] double value() const { return model_.value; }

  private:
    [[nodiscard]] Eigen::VectorXd damped_step() const {
        Eigen::MatrixXd H = model_.curvature;
        const double floor = 1e-12 * std::max(H.diagonal().maxCoeff(), 1e-300);
        H.diagonal() = (1.0 + damping_) * H.diagonal().cwiseMax(floor);
        const Bounds& bounds = evaluator_->bounds();
        return detail::minimize_box_quadratic(H, model_.gradient,
                                              {bounds.lower - point_, bounds.upper - point_});
    }

    /// Take the step if it gains, and set the damping by how well the model foresaw the gain [Nielsen1999].
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

class GaussNewtonMultistart final : public Optimizer {
  public:
    explicit GaussNewtonMultistart(const GaussNewtonMultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        const int samples = options_.common.starts * options_.continuation.samples_per_start;
        std::vector<Descent> descents;
        for (Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, samples))
            descents.emplace_back(evaluator, options_.continuation, std::move(start));
        RunOutcome outcome{Ending::BudgetSpent, {}};
        if (descents.empty()) return outcome;
        for (const double smoothing : options_.continuation.smoothing) {
            for (Descent& descent : descents) {
                outcome = {descent.run_stage(smoothing), descent.point()};
                if (outcome.ending == Ending::BudgetSpent) return outcome;
            }
            keep_promising(descents, evaluator.bounds());
        }
        return outcome;
    }

  private:
    /// Of descents that have met, keep the lowest, and none that lies far above the lowest of all, which
    /// comes last and so decides how the run ended.
    void keep_promising(std::vector<Descent>& descents, const Bounds& bounds) const {
        std::ranges::stable_sort(descents, {}, [](const Descent& descent) { return descent.value(); });
        const double lowest = descents.front().value();
        const double highest = lowest + (options_.pruning_ratio - 1.0) * std::abs(lowest);
        std::vector<Descent> kept;
        for (Descent& descent : descents) {
            const bool is_met = std::ranges::any_of(kept, [&](const Descent& other) {
                return share_distance(descent, other, bounds) < options_.merging_distance;
            });
            const bool is_far = descent.value() > highest;  // never if infinity times 0 is the limit
            if (!is_met && !is_far) kept.push_back(std::move(descent));
        }
        std::ranges::reverse(kept);
        descents = std::move(kept);
    }

    static double share_distance(const Descent& one, const Descent& other, const Bounds& bounds) {
        return ((one.point() - other.point()).array() / (bounds.upper - bounds.lower).array())
            .abs()
            .maxCoeff();
    }

    GaussNewtonMultistartOptions options_;
};

}  // namespace

void GaussNewtonMultistartOptions::validate() const {
    common.validate();
    continuation.validate();
    if (!(merging_distance >= 0.0)) throw base::InputError("merging_distance: must not be negative");
    if (!(pruning_ratio >= 1.0)) throw base::InputError("pruning_ratio: must be at least 1");
}

std::unique_ptr<Optimizer> make_gauss_newton_multistart(const GaussNewtonMultistartOptions& options) {
    options.validate();
    return std::make_unique<GaussNewtonMultistart>(options);
}

}  // namespace fretwork::optimization
