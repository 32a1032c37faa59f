// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduction/problems.hpp"

#include <fretwork/base/error.hpp>

namespace fretwork::python {
namespace {

using namespace optimization;

/// Throws InputError unless an array from Python has the wanted size, so that no read passes its end.
void require_size(Eigen::Index found, Eigen::Index wanted, const std::string& what) {
    if (found != wanted)
        throw base::InputError(what + " has " + std::to_string(found) + " numbers, where " +
                               std::to_string(wanted) + " are wanted");
}

class PythonProblem final : public Problem {
  public:
    PythonProblem(std::string name, Bounds bounds, ValueFunction value)
        : name_(std::move(name)), bounds_(std::move(bounds)), value_(std::move(value)) {
        bounds_.validate();
    }
    void offer(GradientFunction gradient) { gradient_ = std::move(gradient); }
    void offer(ResidualFunction residuals) { residuals_ = std::move(residuals); }

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation kind) const override {
        switch (kind) {
            case Evaluation::Value:
                return true;
            case Evaluation::Gradient:
                return gradient_ != nullptr || residuals_ != nullptr;
            case Evaluation::Residuals:
            case Evaluation::Curvature:
                break;
        }
        return residuals_ != nullptr;
    }
    [[nodiscard]] double value(const Eigen::VectorXd& point) const override { return value_(point); }
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& point, double smoothing) const override {
        if (gradient_ == nullptr) {
            const CurvatureEvaluation known = curvature(point, smoothing);
            return {known.objective, known.value, known.gradient};
        }
        auto [value, gradient] = gradient_(point);
        require_size(gradient.size(), bounds_.dimension(), "the gradient of '" + name_ + "'");
        return {value, value, std::move(gradient)};
    }
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& point,
                                               double smoothing) const override {
        if (residuals_ == nullptr) return Problem::residuals(point, smoothing);
        auto [residuals, jacobian] = residuals_(point);
        require_size(jacobian.rows(), residuals.size(), "a column of the Jacobian of '" + name_ + "'");
        require_size(jacobian.cols(), bounds_.dimension(), "a row of the Jacobian of '" + name_ + "'");
        return {residuals.squaredNorm(), residuals, std::move(jacobian)};
    }
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& point,
                                                double smoothing) const override {
        if (residuals_ == nullptr) return Problem::curvature(point, smoothing);
        const ResidualEvaluation known = residuals(point, smoothing);
        return {known.objective, known.objective, 2.0 * known.jacobian.transpose() * known.residuals,
                2.0 * known.jacobian.transpose() * known.jacobian};
    }

  private:
    std::string name_;
    Bounds bounds_;
    ValueFunction value_;
    GradientFunction gradient_;
    ResidualFunction residuals_;
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): the parameters of the constructor in Python
std::shared_ptr<Problem> make_problem(std::string name, Eigen::VectorXd lower, Eigen::VectorXd upper,
                                      ValueFunction value, std::optional<GradientFunction> gradient,
                                      std::optional<ResidualFunction> residuals) {
    require_size(upper.size(), lower.size(), "the upper bound");
    auto problem = std::make_shared<PythonProblem>(
        std::move(name), Bounds{std::move(lower), std::move(upper)}, std::move(value));
    if (gradient) problem->offer(std::move(*gradient));
    if (residuals) problem->offer(std::move(*residuals));
    return problem;
}

void check_dimension(const Problem& problem, const Eigen::VectorXd& point) {
    require_size(point.size(), problem.bounds().dimension(), "a point of '" + problem.name() + "'");
}

}  // namespace fretwork::python
