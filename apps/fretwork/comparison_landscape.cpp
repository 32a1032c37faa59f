// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_landscape.hpp"
#include "comparison_problems.hpp"

#include <fretwork/base/file.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/ceres_residuals.hpp>
#include <fretwork/optimization/gauss_newton_multistart.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <limits>
#include <memory>

namespace fretwork::app {
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
    std::vector<Descent> descents(static_cast<std::size_t>(options.descents));
    base::parallel_for(descents.size(), options.threads, [&](std::size_t i) {
        // One start under a seed of its own begins at a uniform random point.
        const auto report = minimize(problem, *kind.make({.starts = 1, .seed = i + 1}), {.cost = 100'000});
        descents[i] = {report.value, report.cost, report.point};
    });
    return descents;
}

std::string section_rows(const ComparisonProblem& entry, const Eigen::VectorXd& best) {
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

void write_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options,
                     const std::filesystem::path& folder) {
    std::string descents = "problem,kind,descent,value,cost,shares\n";
    std::string sections = "problem,variable,share,objective,smoothed_0.1,smoothed_0.01\n";
    base::TerminalProgress progress;
    progress.start("landscape", problems.size());
    for (std::size_t p = 0; p < problems.size(); ++p) {
        const ComparisonProblem entry = make_comparison_problem(problems[p]);
        Descent best;
        for (const Kind& kind : kKinds) {
            const auto found = descend(*entry.problem, kind, options);
            for (std::size_t i = 0; i < found.size(); ++i) {
                if (found[i].point.size() == 0) continue;
                if (found[i].value < best.value) best = found[i];
                descents += entry.id + "," + kind.name + "," + std::to_string(i + 1) + "," +
                            base::format_number(found[i].value) + "," + std::to_string(found[i].cost) + "," +
                            shares_text(entry.problem->bounds(), found[i].point) + "\n";
            }
        }
        if (best.point.size() > 0) sections += section_rows(entry, best.point);
        progress.update(p + 1);
    }
    progress.finish();
    base::write_file_atomically(folder / "descents.csv", descents);
    base::write_file_atomically(folder / "sections.csv", sections);
}

}  // namespace fretwork::app
