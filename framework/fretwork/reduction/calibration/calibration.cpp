// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/calibration/difference_problem.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>

#include <algorithm>
#include <numeric>

namespace fretwork::reduction {
namespace {

std::vector<std::string> parameters_at_bound(const optimization::Bounds& bounds, const Eigen::VectorXd& point,
                                             const TileModel& model) {
    /// The distance to a bound, as a share of the range, below which a parameter counts as at the bound.
    constexpr double kNear = 1e-9;
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < point.size(); ++i) {
        const double margin = kNear * (bounds.upper[i] - bounds.lower[i]);
        if (point[i] - bounds.lower[i] > margin && bounds.upper[i] - point[i] > margin) continue;
        names.push_back(model.parameters[i].name);
    }
    return names;
}

std::vector<NamedValue> named(const TileModel& model, const std::vector<double>& values) {
    std::vector<NamedValue> result;
    for (std::size_t i = 0; i < values.size(); ++i) result.push_back({model.parameters[i].name, values[i]});
    return result;
}

Calibration evaluate(const TileModel& model, const CalibrationInput& input, const Objective& objective,
                     const base::Control& control) {
    const ModelTile tile(model, input.layout, input.pattern, input.setting);
    Calibration result;
    result.model = model.name;
    result.optimizer = "none";
    result.scenario_errors = model.displacements == Displacements::Small
                                 ? objective.scenario_errors(tile.displacements({}))
                                 : objective.scenario_errors(tile.responses({}, control));
    result.objective = std::accumulate(result.scenario_errors.begin(), result.scenario_errors.end(), 0.0);
    return result;
}

/// Throw NumericalError if no start gave a descent, because the best of the starting points is not a
/// calibration.
void require_descent(const optimization::OptimizationReport& report, const TileModel& model,
                     const CalibrationOptions& options) {
    if (report.ending != optimization::Ending::Invalid) return;
    if (report.trace.empty())
        throw base::NumericalError("the objective of model " + model.name +
                                   " is not finite at any point that was tried");
    throw base::NumericalError("all " + std::to_string(options.starts) + " starts of " + options.optimizer +
                               " died at their first point: no model " + model.name +
                               " was fitted; take more starts, another seed or another optimizer");
}

Calibration fit(const TileModel& model, const CalibrationProblem& problem, const Objective& objective,
                const CalibrationOptions& options) {
    const auto report =
        optimization::minimize(problem, optimization::find_optimizer(options.optimizer, options.optimizers),
                               {.starts = options.starts, .seed = options.seed},
                               {.cost = options.budget, .control = options.control});
    require_descent(report, model, options);
    Calibration calibration;
    calibration.model = model.name;
    calibration.optimizer = options.optimizer;
    calibration.seed = options.seed;
    calibration.starts = options.starts;
    calibration.parameters = named(model, problem.parameter_values(report.point));
    const UnitDisplacements best = problem.displacements(report.point);
    calibration.objective = objective.value(best);
    calibration.scenario_errors = objective.scenario_errors(best);
    calibration.cost = report.cost;
    calibration.at_bound = parameters_at_bound(problem.bounds(), report.point, model);
    calibration.dead_starts = report.dead_starts;
    calibration.converged = report.ending == optimization::Ending::Converged;
    return calibration;
}

}  // namespace

void CalibrationOptions::validate() const {
    (void)optimization::find_optimizer(optimizer, optimizers);
    optimization::OptimizerOptions{.starts = starts, .seed = seed}.validate();
    optimization::Budget{.cost = budget}.validate();
}

void CalibrationInput::validate() const {
    setting->validate();
    const auto nodes = static_cast<Eigen::Index>(layout->interface_nodes().size()) * setting->sides;
    check_fit(*responses, *setting, nodes);
}

std::vector<double> parameter_values(const Calibration& calibration, const TileModel& model) {
    std::vector<double> values;
    for (const TileParameter& parameter : model.parameters) {
        const auto found = std::ranges::find(calibration.parameters, parameter.name, &NamedValue::name);
        if (found == calibration.parameters.end())
            throw base::InputError("a calibration of model " + model.name + " lacks the parameter " +
                                   parameter.name);
        values.push_back(found->value);
    }
    for (const NamedValue& value : calibration.parameters) (void)parameter_index(model, value.name);
    return values;
}

Calibration calibrate(const TileModel& model, const CalibrationInput& input,
                      const CalibrationOptions& options) {
    options.validate();
    input.validate();
    const Objective objective(input.responses, input.setting);
    if (objective.sample_count() == 0) {
        throw base::NumericalError(
            "no sample of the responses can be used: none converged to a state to fit");
    }
    if (model.parameters.empty()) return evaluate(model, input, objective, options.control);
    if (model.problem) {
        if (const auto problem = model.problem(objective, input.layout, input.setting))
            return fit(model, *problem, objective, options);
    }
    const ModelTile tile(model, input.layout, input.pattern, input.setting);
    return fit(model, DifferenceProblem(model, tile, objective, input.setting), objective, options);
}

}  // namespace fretwork::reduction
