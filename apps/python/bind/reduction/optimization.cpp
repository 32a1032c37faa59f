// SPDX-License-Identifier: GPL-3.0-or-later
// Problems, methods that minimize them, and runs.
#include "core/bind.hpp"
#include "reduction/methods.hpp"
#include "reduction/problems.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/optimization/methods/outside_command.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/optimization/problems/analytic_problems.hpp>

namespace fretwork::python {
namespace {

using namespace optimization;

void bind_problem(py::module_& m) {
    Record<Bounds>(m, "Bounds", "lower <= x <= upper, component by component.")
        .constant("lower", &Bounds::lower, "n floats")
        .constant("upper", &Bounds::upper, "n floats")
        .done();
    py::class_<Problem, std::shared_ptr<Problem>>(
        m, "Problem",
        "A function to be minimized inside bounds.\n\n"
        ">>> import fretwork as fw\n"
        ">>> bowl = fw.Problem('bowl', [-1, -1], [2, 2], value=lambda x: float(x @ x))\n"
        ">>> bowl.value([1, 1])\n"
        "2.0\n")
        .def(py::init(&make_problem), "name"_a, "lower"_a, "upper"_a, "value"_a, "gradient"_a = py::none(),
             "residuals"_a = py::none(),
             "A problem of your own.\n\n"
             "value(x): the objective, a float\n"
             "gradient(x): the objective and its n derivatives\n"
             "residuals(x): m residuals whose squared norm is the objective, and their m x n Jacobian\n")
        .def_property_readonly("name", &Problem::name)
        .def_property_readonly("bounds", [](const Problem& self) { return self.bounds(); })
        .def_property_readonly("cost_unit", &Problem::cost_unit)
        .def_property_readonly("has_kinks", &Problem::has_kinks)
        .def("offers", &Problem::offers, "kind"_a)
        .def("cost", &Problem::cost, "kind"_a, "The cost of one evaluation, in the problem's unit.")
        .def(
            "is_logarithm",
            [](const Problem& self, int variable) {
                return self.is_logarithm(static_cast<int>(checked_index(
                    variable, static_cast<std::size_t>(self.bounds().dimension()), "variable")));
            },
            "variable"_a)
        .def(
            "value",
            [](const Problem& self, const Eigen::VectorXd& point) {
                check_dimension(self, point);
                return self.value(point);
            },
            "point"_a)
        .def(
            "gradient",
            [](const Problem& self, const Eigen::VectorXd& point, double smoothing) {
                check_dimension(self, point);
                return self.gradient(point, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0)
        .def(
            "residuals",
            [](const Problem& self, const Eigen::VectorXd& point, double smoothing) {
                check_dimension(self, point);
                return self.residuals(point, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0)
        .def(
            "curvature",
            [](const Problem& self, const Eigen::VectorXd& point, double smoothing) {
                check_dimension(self, point);
                return self.curvature(point, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0)
        .def("__repr__", [](const Problem& self) { return "<Problem " + self.name() + ">"; });
}

void bind_evaluations(py::module_& m) {
    bind_enum<Evaluation>(m);
    Record<GradientEvaluation>(m, "GradientEvaluation", "An objective with its gradient.")
        .constant("objective", &GradientEvaluation::objective, "")
        .constant("value", &GradientEvaluation::value, "smoothed objective, which is differentiated")
        .constant("gradient", &GradientEvaluation::gradient, "n floats")
        .done();
    Record<ResidualEvaluation>(m, "ResidualEvaluation", "An objective as a sum of squares.")
        .constant("objective", &ResidualEvaluation::objective, "")
        .constant("residuals", &ResidualEvaluation::residuals, "m floats")
        .constant("jacobian", &ResidualEvaluation::jacobian, "m x n floats")
        .done();
    Record<CurvatureEvaluation>(m, "CurvatureEvaluation",
                                "An objective with gradient and Gauss-Newton matrix.")
        .constant("objective", &CurvatureEvaluation::objective, "")
        .constant("value", &CurvatureEvaluation::value, "")
        .constant("gradient", &CurvatureEvaluation::gradient, "n floats")
        .constant("curvature", &CurvatureEvaluation::curvature, "n x n floats")
        .done();
}

void bind_method(py::module_& m) {
    bind_enum<OptimizerClass>(m);
    bind_enum<Ending>(m);
    Record<OptimizerOptions>(m, "OptimizerOptions", "The options that all methods understand.")
        .field("starts", &OptimizerOptions::starts,
               "number of descents, or of repetitions of a method without descents")
        .field("seed", &OptimizerOptions::seed,
               "seed of all random choices; the same seed gives the same run")
        .done();
    Record<RunOutcome>(
        m, "RunOutcome",
        "The outcome of a run: the reason why the method ended, and the point at which it ended.")
        .field("ending", &RunOutcome::ending, "a word of Ending: 'converged', 'budget-spent', ..")
        .constant("final_point", &RunOutcome::final_point, "n floats: point at which the method ended")
        .field("dead_starts", &RunOutcome::dead_starts, "number of starts that gave no descent")
        .done();
    py::class_<RunningEvaluator>(
        m, "Evaluator",
        "The access of a method to the problem: every evaluation is charged to the budget and remembered. An "
        "evaluation is None if the budget does not cover it, or if the point is outside the bounds.")
        .def_property_readonly(
            "bounds", [](const RunningEvaluator& self) { return self.get().bounds(); },
            "Bounds: arrays lower and upper, n floats each")
        .def_property_readonly(
            "cost", [](const RunningEvaluator& self) { return self.get().cost(); },
            "cost spent so far, in the problem's unit")
        .def_property_readonly(
            "best_value", [](const RunningEvaluator& self) { return self.get().best_value(); },
            "lowest value so far; infinity before the first evaluation")
        .def_property_readonly(
            "best_point", [](const RunningEvaluator& self) { return self.get().best_point(); },
            "n floats: point with the lowest value")
        .def(
            "can_afford",
            [](const RunningEvaluator& self, Evaluation kind) { return self.get().can_afford(kind); },
            "kind"_a, "True if the budget covers one more evaluation of this kind: 'value', 'gradient', ..")
        .def(
            "value",
            [](const RunningEvaluator& self, const Eigen::VectorXd& x) { return self.at(x).value(x); },
            "point"_a,
            "The objective at a point (n floats); None if the budget is spent, or if the point is outside "
            "the bounds.")
        .def(
            "gradient",
            [](const RunningEvaluator& self, const Eigen::VectorXd& x, double smoothing) {
                return self.at(x).gradient(x, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0,
            "The objective with its gradient, or None; `smoothing` rounds kinks. The problem states the "
            "cost.")
        .def(
            "residuals",
            [](const RunningEvaluator& self, const Eigen::VectorXd& x, double smoothing) {
                return self.at(x).residuals(x, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0, "The objective as a sum of squares, with the Jacobian, or None.")
        .def(
            "curvature",
            [](const RunningEvaluator& self, const Eigen::VectorXd& x, double smoothing) {
                return self.at(x).curvature(x, smoothing);
            },
            "point"_a, "smoothing"_a = 0.0, "The objective with gradient and Gauss-Newton matrix, or None.");
}

void bind_rows(py::module_& m) {
    py::class_<OptimizerRow>(
        m, "OptimizerRow",
        "A method that a user can choose by name, from the catalogue or your own.\n\n>>> import fretwork as "
        "fw, numpy as np\n>>> def dice(evaluator, options):\n...     random = "
        "np.random.default_rng(options.seed)\n...     bounds = evaluator.bounds\n...     while "
        "evaluator.value(random.uniform(bounds.lower, bounds.upper)) is not None:\n...         pass\n...     "
        "return fw.RunOutcome('budget-spent')\n>>> method = fw.OptimizerRow('dice', dice)\n>>> bowl = "
        "fw.Problem('bowl', [-1, -1], [2, 2], value=lambda x: float(x @ x))\n>>> fw.minimize(bowl, method, "
        "cost=500).value < 0.1\nTrue\n")
        .def(py::init(&make_method), "name"_a, "run"_a, "summary"_a = "", "kind"_a = OptimizerClass::Random,
             "needs"_a = Evaluation::Value,
             "A method of your own: run(evaluator, options) evaluates only through the Evaluator, and ends "
             "once an evaluation is None. It returns a RunOutcome, the point at which it ended, or None.")
        .def_property_readonly("name", [](const OptimizerRow& self) { return self.name; })
        .def_property_readonly("summary", [](const OptimizerRow& self) { return self.summary; })
        .def_property_readonly("kind", [](const OptimizerRow& self) { return self.kind; })
        .def_property_readonly(
            "needs", [](const OptimizerRow& self) { return self.needs; },
            "kind of evaluation needed besides the value")
        .def_property_readonly(
            "command", [](const OptimizerRow& self) { return self.command; },
            "command of a method that is a program of its own, else empty")
        .def("__repr__", [](const OptimizerRow& self) { return "<OptimizerRow " + self.name + ">"; });
    m.def(
        "optimizer_catalogue", [] { return rows_and_all({}); }, "All built-in methods.");
    m.def(
        "find_optimizer",
        [](std::string_view name, const std::vector<OptimizerRow>& rows) {
            return OptimizerRow(find_optimizer(name, rows_and_all(rows)));
        },
        "name"_a, "rows"_a = std::vector<OptimizerRow>{},
        "The row with this name among these rows and the built-in rows.");
}

void bind_commands(py::module_& m) {
    m.def(
        "outside_command_row",
        [](std::string name, std::string command) {
            return outside_command_row({std::move(name), std::move(command)});
        },
        "name"_a, "command"_a,
        "A method that is a program of its own, in any language: a command of the shell, started once for "
        "each "
        "run. The guide to your own optimizer says the lines that it reads and writes.");
}

void bind_minimize(py::module_& m) {
    Record<TracePoint>(m, "TracePoint", "The best objective value found up to a cost.")
        .constant("cost", &TracePoint::cost, "")
        .constant("value", &TracePoint::value, "")
        .done();
    Record<OptimizationReport>(m, "OptimizationReport", "The outcome of a run.")
        .constant("optimizer", &OptimizationReport::optimizer, "")
        .constant("ending", &OptimizationReport::ending, "")
        .constant("point", &OptimizationReport::point,
                  "n floats: best point found; empty if the objective was never finite")
        .constant("value", &OptimizationReport::value, "objective at the best point")
        .constant("final_point", &OptimizationReport::final_point, "point at which the method itself ended")
        .constant("cost", &OptimizationReport::cost, "cost of the run, in the problem's unit")
        .constant("evaluations", &OptimizationReport::evaluations, "of any kind")
        .constant("derivative_evaluations", &OptimizationReport::derivative_evaluations, "")
        .constant("dead_starts", &OptimizationReport::dead_starts, "number of starts that gave no descent")
        .constant("failures", &OptimizationReport::failures,
                  "number of evaluations whose objective was not finite")
        .constant("points_outside", &OptimizationReport::points_outside, "refused")
        .constant("trace", &OptimizationReport::trace, "best objective over the cost")
        .done(Made::ByFunctions);
    m.def(
        "minimize",
        [](const std::shared_ptr<Problem>& problem, const std::variant<std::string, OptimizerRow>& method,
           int starts, std::uint64_t seed, long cost, double seconds, const py::object& progress) {
            const OptimizerRow row = std::holds_alternative<OptimizerRow>(method)
                                         ? std::get<OptimizerRow>(method)
                                         : find_optimizer(std::get<std::string>(method));
            return run_long(progress, [&](const base::Control& control) {
                return minimize(*problem, row, {.starts = starts, .seed = seed},
                                {.cost = cost, .seconds = seconds, .control = control});
            });
        },
        "problem"_a, "method"_a = "ceres-multistart", py::kw_only(), "starts"_a = OptimizerOptions{}.starts,
        "seed"_a = OptimizerOptions{}.seed, "cost"_a = Budget{}.cost, "seconds"_a = Budget{}.seconds,
        "progress"_a = py::none(),
        "Minimize a problem by a method, given by its name or as a row. `cost` and `seconds` are the budget. "
        "The same arguments give the same report, unless `seconds` end the run.\n\n>>> import fretwork as "
        "fw\n>>> bowl = fw.Problem('bowl', [-1, -1], [2, 2], value=lambda x: float(x @ x))\n>>> "
        "fw.minimize(bowl, 'bobyqa').value < 1e-6\nTrue\n");
    m.def(
        "analytic_problems",
        [] {
            std::vector<std::tuple<std::shared_ptr<Problem>, double, Eigen::VectorXd>> found;
            for (AnalyticProblem& known : analytic_problems())
                found.emplace_back(std::move(known.problem), known.best_value, known.best_point);
            return found;
        },
        "Test functions of the literature, each with its minimum and the point of the minimum: a list of "
        "(Problem, float, n floats).");
}

}  // namespace

void bind_optimization(py::module_& m) {
    bind_evaluations(m);
    bind_problem(m);
    bind_method(m);
    bind_rows(m);
    bind_commands(m);
    bind_minimize(m);
}

}  // namespace fretwork::python
