// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/ring/ring_problem.hpp>

#include <cmath>

namespace fretwork::reduction {

RingProblem::RingProblem(base::Borrowed<RingHexagon> model, base::Borrowed<RingParameters> parameters,
                         base::Borrowed<Objective> objective, const Setting& setting)
    : model_(model),
      parameters_(parameters),
      objective_(objective),
      units_(parameters->select(ring_units(setting))) {
    const auto limits = ring_bounds(setting);
    const auto point_at = [&](const RingParts& parts) {
        const Eigen::VectorXd values = parameters->select(parts);
        return point({values.data(), static_cast<std::size_t>(values.size())});
    };
    bounds_ = {point_at(limits.lower), point_at(limits.upper)};
}

RingProblem::RingProblem(std::unique_ptr<const RingHexagon> model, base::Borrowed<RingParameters> parameters,
                         base::Borrowed<Objective> objective, const Setting& setting)
    : RingProblem(*model, parameters, objective, setting) {
    owned_model_ = std::move(model);
}

std::string RingProblem::name() const {
    return parameters_->model;
}

std::vector<double> RingProblem::parameter_values(const Eigen::VectorXd& x) const {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        values.push_back(units_[i] * (is_logarithm(static_cast<int>(i)) ? std::exp(x[i]) : x[i]));
    return values;
}

UnitDisplacements RingProblem::displacements(const Eigen::VectorXd& x) const {
    return model_->displacements(parameters_->parts(parameter_values(x)));
}

Eigen::VectorXd RingProblem::point(std::span<const double> values) const {
    Eigen::VectorXd x(units_.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double share = values[i] / units_[i];
        x[i] = is_logarithm(static_cast<int>(i)) ? std::log(share) : share;
    }
    return x;
}

double RingProblem::value(const Eigen::VectorXd& x) const {
    return objective_->value(displacements(x));
}

RingDirections RingProblem::directions_at(std::span<const double> values) const {
    RingDirections directions = parameters_->ties;
    for (Eigen::Index i = 0; i < directions.cols(); ++i)
        directions.col(i) *= is_logarithm(static_cast<int>(i)) ? values[i] : units_[i];
    return directions;
}

UnitDisplacementsAndDerivatives RingProblem::model_at(const Eigen::VectorXd& x) const {
    const std::vector<double> values = parameter_values(x);
    return model_->derivatives(parameters_->parts(values), directions_at(values));
}

optimization::GradientEvaluation RingProblem::gradient(const Eigen::VectorXd& x, double smoothing) const {
    const std::vector<double> values = parameter_values(x);
    optimization::GradientEvaluation result;
    const RingParts slopes =
        model_->gradient(parameters_->parts(values), [&](const UnitDisplacements& displacements) {
            DisplacementGradient of_error = objective_->gradient(displacements, smoothing);
            result.objective = of_error.objective;
            result.value = of_error.value;
            return std::move(of_error.slopes);
        });
    result.gradient = directions_at(values).transpose() * slopes;
    return result;
}

optimization::ResidualEvaluation RingProblem::residuals(const Eigen::VectorXd& x, double smoothing) const {
    return objective_->residuals(model_at(x), smoothing);
}

optimization::CurvatureEvaluation RingProblem::curvature(const Eigen::VectorXd& x, double smoothing) const {
    return objective_->curvature(model_at(x), smoothing);
}

}  // namespace fretwork::reduction
