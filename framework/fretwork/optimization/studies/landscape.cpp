// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/ceres_residuals.hpp>
#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/optimization/studies/landscape.hpp>

#include <limits>
#include <memory>

namespace fretwork::optimization::study {
namespace {

using optimization::Optimizer;
using optimization::OptimizerOptions;
using optimization::Problem;

struct Kind {
    const char* name;
    std::unique_ptr<Optimizer> (*make)(const OptimizerOptions& common);
};

std::unique_ptr<Optimizer> smoothed(const OptimizerOptions& common) {
    return optimization::make_gauss_newton_multistart(
        {.common = common, .continuation = {.samples_per_start = 1}});
}

std::unique_ptr<Optimizer> sharp(const OptimizerOptions& common) {
    const auto stages = optimization::ContinuationOptions{}.smoothing;
    return optimization::make_gauss_newton_multistart(
        {.common = common, .continuation = {.smoothing = {stages.back()}, .samples_per_start = 1}});
}

std::unique_ptr<Optimizer> residuals(const OptimizerOptions& common) {
    return optimization::make_ceres_residuals({.common = common});
}

constexpr Kind kKinds[] = {{"smoothed", smoothed}, {"sharp", sharp}, {"residuals", residuals}};

struct Descent {
    double value = std::numeric_limits<double>::infinity();
    long cost = 0;
    Eigen::VectorXd point;
};

/// The point as shares of the box, joined by spaces.
std::string shares_text(const optimization::Bounds& bounds, const Eigen::VectorXd& point) {
    const Eigen::VectorXd shares = (point - bounds.lower).cwiseQuotient(bounds.upper - bounds.lower);
    std::vector<std::string> words;
    for (const double share : shares) words.push_back(base::format_number(share));
    return base::join(words, " ");
}

std::vector<Descent> descend(const Problem& problem, const Kind& kind, const LandscapeOptions& options) {
    std::vector<Descent> descents(options.descents);
    base::parallel_for(descents.size(), options.threads, [&](std::size_t i) {
        // With one start and a seed of its own, each descent begins at a uniform random point.
        const auto report = minimize(problem, *kind.make({.starts = 1, .seed = i + 1}),
                                     {.cost = 100'000, .control = options.control.silent()});
        descents[i] = {report.value, report.cost, report.point};
    });
    return descents;
}

std::string descent_rows(const StudyProblem& entry, const Kind& kind, const std::vector<Descent>& descents) {
    std::string text;
    for (std::size_t i = 0; i < descents.size(); ++i) {
        if (descents[i].point.size() == 0) continue;
        text += entry.id + "," + kind.name + "," + std::to_string(i + 1) + "," +
                base::format_number(descents[i].value) + "," + std::to_string(descents[i].cost) + "," +
                shares_text(entry.problem->bounds(), descents[i].point) + "\n";
    }
    return text;
}

std::string section_rows(const StudyProblem& entry, const Eigen::VectorXd& best) {
    constexpr int kSteps = 400;
    const Problem& problem = *entry.problem;
    const auto& bounds = problem.bounds();
    std::string text;
    for (Eigen::Index variable = 0; variable < best.size(); ++variable) {
        for (int k = 0; k <= kSteps; ++k) {
            const double share = static_cast<double>(k) / kSteps;
            Eigen::VectorXd point = best;
            point[variable] =
                bounds.lower[variable] + share * (bounds.upper[variable] - bounds.lower[variable]);
            point = bounds.clamp(point);
            text += entry.id + "," + std::to_string(variable) + "," + base::format_number(share) + "," +
                    base::format_number(problem.value(point)) + "," +
                    base::format_number(problem.curvature(point, 0.1).value) + "," +
                    base::format_number(problem.curvature(point, 0.01).value) + "\n";
        }
    }
    return text;
}

}  // namespace

void LandscapeOptions::validate() const {
    if (descents < 1) throw base::InputError("descents: " + std::to_string(descents) + " must be at least 1");
}

Landscape explore_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options) {
    options.validate();
    Landscape landscape{"problem,kind,descent,value,cost,shares\n",
                        "problem,variable,share,objective,smoothed_0.1,smoothed_0.01\n"};
    const base::Task task(options.control, "landscape", problems.size());
    for (std::size_t p = 0; p < problems.size(); ++p) {
        const StudyProblem entry = make_study_problem(problems[p], options.families);
        Descent best;
        for (const Kind& kind : kKinds) {
            const auto found = descend(*entry.problem, kind, options);
            landscape.descents += descent_rows(entry, kind, found);
            for (const Descent& descent : found) {
                if (descent.point.size() > 0 && descent.value < best.value) best = descent;
            }
        }
        if (best.point.size() > 0) landscape.sections += section_rows(entry, best.point);
        task.update(p + 1);
    }
    return landscape;
}

}  // namespace fretwork::optimization::study
