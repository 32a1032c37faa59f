// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/ceres_residuals.hpp>
#include <fretwork/optimization/methods/detail/ceres_solve.hpp>
#include <fretwork/optimization/methods/detail/option_checks.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>

#include <cmath>
#include <functional>

namespace fretwork::optimization {
namespace {

/// Unbounded variables u for the points of a box: x = middle + half width * sin(u).
class SineBox {
  public:
    explicit SineBox(const Bounds& bounds)
        : bounds_(bounds), middle_((bounds.lower + bounds.upper) / 2.0), half_(bounds.upper - middle_) {}
    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& u) const {
        return bounds_.clamp(middle_ + half_.cwiseProduct(u.array().sin().matrix()));
    }
    [[nodiscard]] Eigen::VectorXd rates(const Eigen::VectorXd& u) const {
        return half_.cwiseProduct(u.array().cos().matrix());
    }
    [[nodiscard]] Eigen::VectorXd variables(const Eigen::VectorXd& point) const {
        return (point - middle_).cwiseQuotient(half_).cwiseMax(-1.0).cwiseMin(1.0).array().asin();
    }

  private:
    const Bounds& bounds_;
    Eigen::VectorXd middle_;
    Eigen::VectorXd half_;
};

class CeresResiduals final : public Optimizer {
  public:
    explicit CeresResiduals(const CeresResidualsOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        detail::BestRun best(evaluator);
        for (const Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, 0)) {
            best.add(run_from(evaluator, start));
            if (best.is_over()) break;
        }
        return best.outcome();
    }

  private:
    [[nodiscard]] RunOutcome run_from(Evaluator& evaluator, const Eigen::VectorXd& start) const {
        RunOutcome run{Ending::Invalid, start};
        for (const double smoothing : options_.smoothing) {
            const Ending ending = descend(evaluator, smoothing, run.final_point);
            // A later stage that cannot begin leaves the point of the stage before it.
            const bool is_late = ending == Ending::Invalid && run.ending != Ending::Invalid;
            run.ending = is_late ? Ending::Stalled : ending;
            if (ending == Ending::BudgetSpent || ending == Ending::Invalid) break;
        }
        return run;
    }

    Ending descend(Evaluator& evaluator, double smoothing, Eigen::VectorXd& point) const {
        const Eigen::VectorXd start = point;
        const auto first = evaluator.residuals(start, smoothing);
        if (!first) return Ending::BudgetSpent;
        if (!std::isfinite(first->objective) || !first->jacobian.allFinite()) return Ending::Invalid;
        bool is_refused = false;
        const auto residuals = static_cast<int>(first->residuals.size());
        const auto linearize = [&](const Eigen::VectorXd& at) -> std::optional<detail::Linearization> {
            const auto model = at == start ? first : evaluator.residuals(at, smoothing);
            is_refused = !model;
            if (is_refused) return std::nullopt;
            // Ceres halves the squared norm.
            return detail::Linearization{std::sqrt(2.0) * model->residuals, std::sqrt(2.0) * model->jacobian};
        };
        const bool converged = options_.bounds == CeresBounds::Sine
                                   ? descend_on_sine(evaluator.bounds(), linearize, residuals, point)
                                   : descend_in_box(evaluator.bounds(), linearize, residuals, point);
        if (is_refused) return Ending::BudgetSpent;
        return converged ? Ending::Converged : Ending::Stalled;
    }

    using Linearize = std::function<std::optional<detail::Linearization>(const Eigen::VectorXd&)>;

    bool descend_in_box(const Bounds& bounds, const Linearize& linearize, int residuals,
                        Eigen::VectorXd& point) const {
        return detail::solve_with_ceres({linearize, residuals, bounds}, settings(), point).converged;
    }

    bool descend_on_sine(const Bounds& bounds, const Linearize& linearize, int residuals,
                         Eigen::VectorXd& point) const {
        const SineBox box(bounds);
        Eigen::VectorXd u = box.variables(point);
        const auto on_sine = [&](const Eigen::VectorXd& at) {
            auto model = linearize(box.point(at));
            if (model) model->jacobian *= box.rates(at).asDiagonal();
            return model;
        };
        const bool converged =
            detail::solve_with_ceres({on_sine, residuals, std::nullopt}, settings(), u).converged;
        point = box.point(u);
        return converged;
    }

    [[nodiscard]] detail::CeresSettings settings() const {
        return {.tolerance = options_.tolerance,
                .largest_iterations = options_.largest_iterations,
                .step = options_.step};
    }

    CeresResidualsOptions options_;
};

}  // namespace

void CeresResidualsOptions::validate() const {
    common.validate();
    detail::require_more_than(0.0, "tolerance", tolerance);
    detail::require_at_least(1.0, "largest_iterations", largest_iterations);
    detail::require_smoothing(smoothing);
}

std::unique_ptr<Optimizer> make_ceres_residuals(const CeresResidualsOptions& options) {
    options.validate();
    return std::make_unique<CeresResiduals>(options);
}

}  // namespace fretwork::optimization
