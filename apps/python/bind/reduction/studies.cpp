// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: optimizers run on problems, and the table of what they reach.
#include "core/bind.hpp"
#include "reduction/methods.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/optimization/studies/study.hpp>
#include <fretwork/reduction/calibration/study_problems.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

namespace fretwork::python {
namespace {

using namespace optimization;

/// A method or its name, and how many starts it has.
using ContenderGiven = std::pair<std::variant<std::string, OptimizerRow>, int>;

/// The rows of some contenders; a contender refers to its row.
std::vector<OptimizerRow> rows_of(const std::vector<ContenderGiven>& given) {
    std::vector<OptimizerRow> rows;
    for (const auto& [method, starts] : given)
        rows.push_back(std::holds_alternative<OptimizerRow>(method)
                           ? std::get<OptimizerRow>(method)
                           : find_optimizer(std::get<std::string>(method)));
    return rows;
}

study::StudyPlan make_plan(const std::vector<std::string>& problems, const std::vector<ContenderGiven>& given,
                           const std::vector<OptimizerRow>& rows) {
    study::StudyPlan plan;
    plan.problems = problems;
    plan.families = reduction::study_families();
    for (std::size_t c = 0; c < rows.size(); ++c) plan.contenders.push_back({&rows[c], given[c].second});
    return plan;
}

}  // namespace

void bind_studies(py::module_& m) {
    Record<study::StudyReport>(m, "StudyReport", "The report of run_study().")
        .constant("runs_before", &study::StudyReport::runs_before, "number of runs in the table at the start")
        .constant("runs_done", &study::StudyReport::runs_done, "")
        .constant("runs_left_out", &study::StudyReport::runs_left_out,
                  "number of runs not done because of a stop")
        .constant("runs_stopped", &study::StudyReport::runs_stopped,
                  "number of runs whose program did not come to its end and was stopped")
        .done(Made::ByFunctions);
    m.def("study_problem_ids", &reduction::study_problem_ids, "patterns"_a,
          "The ids of the problems on which the framework compares optimizers: calibrations of this number "
          "of patterns, synthetic problems and analytic problems. run_study() takes these ids.");
    m.def(
        "default_contenders",
        [] {
            std::vector<std::pair<std::string, int>> found;
            for (const study::Contender& contender : study::default_contenders())
                found.emplace_back(contender.method->name, contender.starts);
            return found;
        },
        "All built-in methods with their numbers of starts in a study.");
    m.def(
        "run_study",
        [](const std::filesystem::path& folder, const std::vector<std::string>& problems,
           const std::vector<ContenderGiven>& contenders, int repetitions, long cost, std::uint64_t seed,
           int threads, const py::object& progress) {
            const std::vector<OptimizerRow> rows = rows_of(contenders);
            study::StudyPlan plan = make_plan(problems, contenders, rows);
            plan.conditions.budget.cost = cost;
            plan.conditions.seed = seed;
            plan.repetitions = repetitions;
            plan.threads = threads;
            return run_long(progress, [&](const base::Control& control) {
                plan.control = control;
                return study::run_study(plan, folder);
            });
        },
        "folder"_a, "problems"_a, "contenders"_a, py::kw_only(), "repetitions"_a = 15, "cost"_a = 40000,
        "seed"_a = 1, "threads"_a = 0, "progress"_a = py::none(),
        "Run methods (pairs of a name or row and a number of starts) on problems, and write the table "
        "results.csv into a folder. Runs that are in the table are not repeated. After Ctrl-C, finished runs "
        "are kept.");
    m.def(
        "spread_over_edges",
        [](const std::vector<pattern::Pattern>& patterns, std::size_t size) {
            return reduction::spread_over_edges(patterns, size);
        },
        "patterns"_a, "size"_a, "Up to `size` of these patterns, spread over the numbers of edges.");
}

}  // namespace fretwork::python
