// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations of tile models, their objective, and the calibration as a problem for any optimizer.
#include "core/bind.hpp"
#include "reduction/methods.hpp"
#include "reduction/problems.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/calibration/difference_problem.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/calibration/objective.hpp>

namespace fretwork::python {
namespace {

using namespace reduction;

/// All that the problem of a calibration refers to. It lives as long as the problem, and is never moved.
struct CalibrationTask {
    TileModel model;
    pattern::NodeLayout layout;
    pattern::Pattern pattern;
    Setting setting;
    Objective objective;
    std::optional<ModelTile> tile{};
    std::unique_ptr<CalibrationProblem> problem{};

    CalibrationTask(TileModel wanted, pattern::NodeLayout its_layout, pattern::Pattern its_pattern,
                    Setting its_setting, const std::vector<Response>& responses)
        : model(std::move(wanted)),
          layout(std::move(its_layout)),
          pattern(its_pattern),
          setting(std::move(its_setting)),
          objective(responses, setting) {
        if (model.parameters.empty())
            throw base::InputError("nothing is fitted to tile model " + model.name +
                                   ": it has no parameters");
        if (model.problem) problem = model.problem(objective, layout, setting);
        if (problem) return;
        tile.emplace(model, layout, pattern, setting);
        problem = std::make_unique<DifferenceProblem>(model, *tile, objective, setting);
    }
    CalibrationTask(const CalibrationTask&) = delete;
    CalibrationTask& operator=(const CalibrationTask&) = delete;
    ~CalibrationTask() = default;

    [[nodiscard]] std::vector<NamedValue> parameters_at(const Eigen::VectorXd& point) const {
        check_dimension(*problem, point);
        const std::vector<double> values = problem->parameter_values(point);
        std::vector<NamedValue> named;
        for (std::size_t p = 0; p < values.size(); ++p)
            named.push_back({model.parameters[p].name, values[p]});
        return named;
    }
};

void bind_objective(py::module_& m) {
    Record<ErrorMetric>(m, "ErrorMetric",
                        "The weights of translations and rotations in the error of a sample.")
        .field("translation_weight", &ErrorMetric::translation_weight, "w_trans")
        .field("rotation_weight", &ErrorMetric::rotation_weight, "w_rot")
        .field("smallest_translation", &ErrorMetric::smallest_translation, "eps_trans, m")
        .field("smallest_rotation", &ErrorMetric::smallest_rotation, "eps_rot, rad")
        .done();
    const auto checked = [](const Objective&, const UnitDisplacements& model, std::size_t scenarios) {
        if (model.size() != scenarios)
            throw base::InputError("there are displacements of " + std::to_string(model.size()) +
                                   " scenarios, and the objective has " + std::to_string(scenarios));
    };
    struct OwnedObjective {
        Setting setting;
        Objective objective;
        Eigen::Index nodes;
    };
    const auto require = [checked](const OwnedObjective& self, const UnitDisplacements& model) {
        checked(self.objective, model, self.setting.scenarios.size());
        for (const auto& rows : model)
            if (rows.rows() != self.nodes)
                throw base::InputError("the displacements of a scenario have " + std::to_string(rows.rows()) +
                                       " rows, and the tile has " + std::to_string(self.nodes) +
                                       " interface nodes");
    };
    py::class_<OwnedObjective>(m, "Objective", "The distance of a linear model from responses: E of Eq. (8).")
        .def(py::init([](const std::vector<Response>& responses, const Setting& setting,
                         const ErrorMetric& metric) {
                 setting.validate();
                 const Eigen::Index nodes = responses.empty() || responses.front().samples.empty()
                                                ? 0
                                                : responses.front().samples.front().displacements.rows();
                 return OwnedObjective{setting, Objective(responses, setting, metric), nodes};
             }),
             "responses"_a, "setting"_a, "metric"_a = ErrorMetric{})
        .def(
            "value",
            [require](const OwnedObjective& self, const UnitDisplacements& model) {
                require(self, model);
                return self.objective.value(model);
            },
            "model"_a, "E of displacements at 1 N: an n x 6 array for each scenario.")
        .def(
            "scenario_errors",
            [require](const OwnedObjective& self, const UnitDisplacements& model) {
                require(self, model);
                return self.objective.scenario_errors(model);
            },
            "model"_a, "The contributions to E, one for each scenario.")
        .def_property_readonly("sample_count",
                               [](const OwnedObjective& self) { return self.objective.sample_count(); });
}

void bind_calibrations(py::module_& m) {
    Record<CalibrationOptions>(m, "CalibrationOptions", "Options of calibrate().")
        .field("optimizer", &CalibrationOptions::optimizer,
               "name of a row of optimizer_catalogue() or of `optimizers`")
        .field("starts", &CalibrationOptions::starts,
               "number of descents, or of repetitions of a method without descents")
        .field("seed", &CalibrationOptions::seed, "seed of all random choices")
        .field("budget", &CalibrationOptions::budget, "largest number of evaluations of the objective")
        .done();
    Record<Calibration>(m, "Calibration",
                        "A tile model fitted to, or compared with, the responses of a pattern.")
        .constant("model", &Calibration::model, "name of the tile model")
        .constant("optimizer", &Calibration::optimizer, "name of the optimizer; 'none' if nothing is fitted")
        .constant("seed", &Calibration::seed, "")
        .constant("starts", &Calibration::starts, "")
        .constant("objective", &Calibration::objective, "E of Eq. (8) at the parameters")
        .constant("scenario_errors", &Calibration::scenario_errors,
                  "contributions to E, one for each scenario")
        .constant("cost", &Calibration::cost,
                  "cost of the fit, in the unit of the calibration's problem: factorizations of a stiffness, "
                  "or condensed tiles")
        .constant("parameters", &Calibration::parameters, "by name, SI")
        .constant("at_bound", &Calibration::at_bound, "names of the parameters at a bound")
        .constant("converged", &Calibration::converged, "")
        .constant("dead_starts", &Calibration::dead_starts, "")
        .done();
}

void bind_calibrate(py::module_& m) {
    m.def(
        "calibrate",
        [](const ModelOrName& model, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
           const Setting& setting, const std::vector<Response>& responses, const py::kwargs& named) {
            check(layout, pattern);
            const TileModel row = model_of(model);
            py::dict others(named.attr("copy")());
            const std::vector<optimization::OptimizerRow> rows = taken_optimizers(others);
            auto keywords = Keywords<CalibrationOptions>::rest(others);
            keywords.options.optimizers = rows;
            return keywords.run([&](const auto& options) {
                return calibrate(row, {layout, pattern, setting, responses}, options);
            });
        },
        "model"_a, "layout"_a, "pattern"_a, "setting"_a, "responses"_a,
        "Fit a tile model, or its name, to a pattern's responses: Eqs. (1) to (11). `optimizers` are rows of "
        "your own "
        "beside those of the library.\n\n"
        "Options: CalibrationOptions, optimizers, progress\n\n"
        ">>> import fretwork as fw\n"
        ">>> layout, setting = fw.paper_layout(), fw.paper_setting()\n"
        ">>> pattern = fw.parse_pattern_id(layout, '0-1+1-6')\n"
        ">>> responses = fw.compute_responses(layout, pattern, setting)\n"
        ">>> calibration = fw.calibrate('paper6', layout, pattern, setting, responses)\n"
        ">>> sorted(calibration.parameters)\n"
        "['A', 'I2', 'I3', 'J', 'R', 'theta']\n");
    m.def(
        "calibration_problem",
        [](const ModelOrName& model, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
           const Setting& setting, const std::vector<Response>& responses) {
            check(layout, pattern);
            CalibrationInput{layout, pattern, setting, responses}.validate();
            const auto task =
                std::make_shared<CalibrationTask>(model_of(model), layout, pattern, setting, responses);
            auto parameters = [task](const Eigen::VectorXd& point) { return task->parameters_at(point); };
            return std::pair(
                std::shared_ptr<optimization::Problem>(task, task->problem.get()),
                std::function<std::vector<NamedValue>(const Eigen::VectorXd&)>(std::move(parameters)));
        },
        "model"_a, "layout"_a, "pattern"_a, "setting"_a, "responses"_a,
        "The calibration as a Problem for any optimizer, and a function that returns the parameters, by "
        "name, at a point of the problem.");
}

}  // namespace

void bind_calibration(py::module_& m) {
    bind_objective(m);
    bind_calibrations(m);
    bind_calibrate(m);
}

}  // namespace fretwork::python
