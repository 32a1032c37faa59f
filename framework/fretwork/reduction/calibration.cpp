// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/reduction/calibration.hpp>
#include <fretwork/reduction/paper6_problem.hpp>

namespace fretwork::reduction {
namespace {

std::vector<std::string> parameters_at_bound(const optimization::Bounds& bounds,
                                             const Eigen::VectorXd& point) {
    /// As a share of the range: nearer than this is at the bound.
    constexpr double kNear = 1e-9;
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < point.size(); ++i) {
        const double margin = kNear * (bounds.upper[i] - bounds.lower[i]);
        if (point[i] - bounds.lower[i] > margin && bounds.upper[i] - point[i] > margin) continue;
        names.emplace_back(Paper6Parameters::names[static_cast<std::size_t>(i)]);
    }
    return names;
}

}  // namespace

void CalibrationOptions::validate() const {
    (void)optimization::find_optimizer(optimizer);
    optimization::OptimizerOptions{.starts = starts, .seed = seed}.validate();
    optimization::Budget{.cost = budget}.validate();
}

Calibration calibrate_paper6(const std::vector<Response>& responses, const Setting& setting,
                             const CalibrationOptions& options) {
    options.validate();
    const Paper6Hexagon model(setting);
    const Objective objective(responses, setting);
    if (objective.sample_count() == 0) {
        throw base::NumericalError(
            "no sample of the responses can be used: none converged to a state to fit");
    }
    const Paper6Problem problem(model, objective, setting);
    const auto report =
        optimization::minimize(problem, optimization::find_optimizer(options.optimizer),
                               {.starts = options.starts, .seed = options.seed}, {.cost = options.budget});
    if (report.ending == optimization::Ending::Invalid) {
        throw base::NumericalError("the objective of the six-parameter model is finite nowhere");
    }
    Calibration calibration;
    calibration.optimizer = options.optimizer;
    calibration.seed = options.seed;
    calibration.starts = options.starts;
    calibration.parameters = problem.parameters(report.point);
    const UnitDisplacements best = model.displacements(calibration.parameters);
    calibration.objective = objective.value(best);
    calibration.scenario_errors = objective.scenario_errors(best);
    calibration.evaluations = report.cost;
    calibration.at_bound = parameters_at_bound(problem.bounds(), report.point);
    calibration.converged = report.ending == optimization::Ending::Converged;
    return calibration;
}

}  // namespace fretwork::reduction
