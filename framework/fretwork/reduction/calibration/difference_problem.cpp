// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/calibration/difference_problem.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::reduction {
namespace {

/// The step of the differences, as a share of the distance between a variable's bounds. This step balances
/// the rounding of condensed tiles (about 1e-12) and the error by the third derivative.
constexpr double kStep = 1e-5;

bool is_logarithmic(const TileParameter& parameter) {
    return parameter.scale == TileParameter::Scale::Logarithmic;
}

void check_bounds(const TileModel& model, const TileParameter& parameter,
                  const TileParameter::Bounds& bounds) {
    const bool fits = std::isfinite(bounds.lower) && std::isfinite(bounds.upper) &&
                      bounds.lower < bounds.upper && (!is_logarithmic(parameter) || bounds.lower > 0.0);
    if (!fits)
        throw base::InputError("tile model " + model.name + ": the bounds of " + parameter.name + ", " +
                               base::format_number(bounds.lower) + " to " +
                               base::format_number(bounds.upper) + ", are no range" +
                               (is_logarithmic(parameter) ? " above zero" : ""));
}

}  // namespace

DifferenceProblem::DifferenceProblem(base::Borrowed<TileModel> model, base::Borrowed<ModelTile> tile,
                                     base::Borrowed<Objective> objective, const Setting& setting)
    : model_(model), tile_(tile), objective_(objective) {
    const auto count = static_cast<Eigen::Index>(model->parameters.size());
    bounds_ = {Eigen::VectorXd(count), Eigen::VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const TileParameter& parameter = model->parameters[i];
        const TileParameter::Bounds bounds = parameter.bounds(setting);
        check_bounds(model, parameter, bounds);
        bounds_.lower[i] = is_logarithmic(parameter) ? std::log(bounds.lower) : bounds.lower;
        bounds_.upper[i] = is_logarithmic(parameter) ? std::log(bounds.upper) : bounds.upper;
    }
    not_finite_ = tile->displacements(parameter_values((bounds_.lower + bounds_.upper) / 2.0));
    for (auto& rows : not_finite_) rows.setConstant(std::numeric_limits<double>::quiet_NaN());
}

long DifferenceProblem::cost(optimization::Evaluation kind) const {
    return kind == optimization::Evaluation::Value ? 1 : 1 + 2 * static_cast<long>(model_->parameters.size());
}

bool DifferenceProblem::is_logarithm(int variable) const {
    return is_logarithmic(model_->parameters[variable]);
}

std::vector<double> DifferenceProblem::parameter_values(const Eigen::VectorXd& point) const {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < point.size(); ++i)
        values.push_back(is_logarithm(static_cast<int>(i)) ? std::exp(point[i]) : point[i]);
    return values;
}

UnitDisplacements DifferenceProblem::displacements(const Eigen::VectorXd& point) const {
    try {
        return tile_->displacements(parameter_values(point));
    } catch (const base::NumericalError&) {
        return not_finite_;
    }
}

UnitDisplacementsAndDerivatives DifferenceProblem::derivatives(const Eigen::VectorXd& point) const {
    UnitDisplacementsAndDerivatives result{displacements(point), {}};
    for (const auto& rows : result.displacements) result.derivatives.emplace_back(rows.size(), point.size());
    for (Eigen::Index i = 0; i < point.size(); ++i) {
        const double step = kStep * (bounds_.upper[i] - bounds_.lower[i]);
        Eigen::VectorXd ahead = point;
        Eigen::VectorXd behind = point;
        ahead[i] = std::min(point[i] + step, bounds_.upper[i]);
        behind[i] = std::max(point[i] - step, bounds_.lower[i]);
        const UnitDisplacements at_ahead = displacements(ahead);
        const UnitDisplacements at_behind = displacements(behind);
        for (std::size_t s = 0; s < at_ahead.size(); ++s) {
            const mechanics::NodeValues slope = (at_ahead[s] - at_behind[s]) / (ahead[i] - behind[i]);
            result.derivatives[s].col(i) = slope.reshaped<Eigen::RowMajor>();
        }
    }
    return result;
}

double DifferenceProblem::value(const Eigen::VectorXd& point) const {
    return objective_->value(displacements(point));
}

optimization::GradientEvaluation DifferenceProblem::gradient(const Eigen::VectorXd& point,
                                                             double smoothing) const {
    const UnitDisplacementsAndDerivatives model = derivatives(point);
    const DisplacementGradient of_error = objective_->gradient(model.displacements, smoothing);
    optimization::GradientEvaluation result{of_error.objective, of_error.value,
                                            Eigen::VectorXd::Zero(point.size())};
    for (std::size_t s = 0; s < model.derivatives.size(); ++s)
        result.gradient += model.derivatives[s].transpose() * of_error.slopes[s].reshaped<Eigen::RowMajor>();
    return result;
}

optimization::ResidualEvaluation DifferenceProblem::residuals(const Eigen::VectorXd& point,
                                                              double smoothing) const {
    return objective_->residuals(derivatives(point), smoothing);
}

optimization::CurvatureEvaluation DifferenceProblem::curvature(const Eigen::VectorXd& point,
                                                               double smoothing) const {
    return objective_->curvature(derivatives(point), smoothing);
}

}  // namespace fretwork::reduction
