// SPDX-License-Identifier: GPL-3.0-or-later
#include "design_output.hpp"

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

namespace fretwork::app {
namespace {

using base::Json;
using design::DesignReport;
using design::TargetError;

/// Multiples of a displacement that say that the load does not fit.
constexpr double kTooFar = 2.0;
constexpr double kTooNear = 0.5;

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <class Value>
Json member_json(const std::optional<TargetError>& error, Value TargetError::*which) {
    return error ? Json((*error).*which) : Json(nullptr);
}

Json history_json(const DesignReport& report) {
    Json history = Json::array();
    for (const design::DesignProgress& own : report.history)
        history.push_back({{"solutions", own.solutions}, {"seconds", own.seconds}, {"misfit", own.misfit}});
    return history;
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

const char* end_text(design::DesignEnd end) {
    switch (end) {
        case design::DesignEnd::NoSwapImproves:
            return "the search found no further swap that improves it";
        case design::DesignEnd::SolutionsSpent:
            return "the solutions were spent";
        case design::DesignEnd::TimeSpent:
            return "the time was spent";
        case design::DesignEnd::Unreachable:
            return "no painting comes near: it was not searched";
        default:
            return "it was stopped: this is the best painting so far";
    }
}

void print_unknowns(const DesignReport& report) {
    for (std::size_t c = 0; c < report.factors.size(); ++c) {
        if (report.factors[c] != 1.0)
            std::printf("load case '%s': its loads times %.4g\n",
                        base::printable(report.load_cases[c]).c_str(), report.factors[c]);
    }
    if (report.width && report.thickness)
        std::printf("bars %.4g mm wide and %.4g mm thick\n", 1e3 * *report.width, 1e3 * *report.thickness);
}

void warn_line(const std::string& line) {
    std::fprintf(stderr, "fretwork: %s\n", base::printable(line).c_str());
}

bool has_loads(const DesignReport& report) {
    return std::ranges::any_of(report.project.load_cases, [&](const simulation::LoadCase& own) {
        return std::ranges::find(report.load_cases, own.name) != report.load_cases.end() &&
               (!own.loads.empty() || !own.area_loads.empty() || !own.combines.empty());
    });
}

std::string short_number(double value) {
    return base::format_number(value, 3);
}

void warn_of_load(const DesignReport& report, const design::DesignOptions& options) {
    const bool is_one = report.uniform_tried == 1;
    const auto single = [&](const char* which) {
        return is_one ? std::string("the one single pattern tried")
                      : std::string("the ") + which + " of the " + std::to_string(report.uniform_tried) +
                            " single patterns tried";
    };
    const std::string hint = has_loads(report) && !options.free_factor ? " (--free factor searches one)" : "";
    if (report.nothing_moves) {
        warn_line("nothing moves under the load case: it has no load that acts, and moves no support");
    } else if (report.wanted_of_softest > kTooFar) {
        std::string line = "the target asks for " + short_number(report.wanted_of_softest) +
                           " times the displacement of " + single("softest");
        if (report.reach_of_ten_loads && *report.reach_of_ten_loads < 1.0)
            line += ": even ten times the load displaces it by " +
                    short_number(100.0 * *report.reach_of_ten_loads) + " % of what is wanted only";
        else if (report.reach_of_ten_loads)
            line += ": the load is too small for it, ten times the load would do" + hint;
        else
            line += ": what moves it is too small" + hint;
        warn_line(line);
    } else if (report.wanted_of_stiffest > 0.0 && report.wanted_of_stiffest < kTooNear) {
        warn_line("the target asks for " + short_number(report.wanted_of_stiffest) +
                  " times the displacement of " + single("stiffest") + ": what moves it is too large" + hint);
    }
}

}  // namespace

void print_design_json(const DesignReport& report) {
    const Json json = {{"error_mean", member_json(report.error, &TargetError::mean)},
                       {"error_largest", member_json(report.error, &TargetError::largest)},
                       {"error_best_uniform", member_json(report.best_uniform, &TargetError::mean)},
                       {"best_uniform_pattern", report.best_uniform_pattern},
                       {"uniform_tried", report.uniform_tried},
                       {"error_relaxed", nullptr},
                       {"bound", or_null(report.bound)},
                       {"stable", member_json(report.error, &TargetError::is_stable)},
                       {"stable_from_flat", member_json(report.error, &TargetError::is_on_path)},
                       {"model_error", report.model_error},
                       {"largest_utilization", or_null(report.largest_utilization)},
                       {"close_bars", report.close_bars},
                       {"load_cases", report.load_cases},
                       {"factors", report.factors},
                       {"width", or_null(report.width)},
                       {"thickness", or_null(report.thickness)},
                       {"wanted_of_softest", report.wanted_of_softest},
                       {"wanted_of_stiffest", report.wanted_of_stiffest},
                       {"reach_of_ten_loads", or_null(report.reach_of_ten_loads)},
                       {"curvatures_outside", or_null(report.gamut.share_outside())},
                       {"slides", report.slides},
                       {"end", design::design_end_name(report.end)},
                       {"starts", report.starts},
                       {"history", history_json(report)},
                       {"patterns", report.patterns},
                       {"warnings", report.warnings},
                       {"seconds", report.seconds},
                       {"solutions", report.solutions},
                       {"full_solutions", report.full_solutions},
                       {"seed", report.seed}};
    std::fputs(base::json_text(json).c_str(), stdout);
}

void print_design(const DesignReport& report) {
    if (report.error) {
        std::printf(
            "mean error %.3g %%, largest %.3g %% of the largest displacement wanted (checked with all "
            "beams)%s\n",
            100.0 * report.error->mean, 100.0 * report.error->largest,
            !report.error->is_stable    ? "; NOT STABLE"
            : !report.error->is_on_path ? "; it snaps on the way from flat"
                                        : "");
    } else {
        std::puts("distance to the target: not checked with all beams");
    }
    if (report.best_uniform)
        std::printf("best single pattern of %zu: %.3g %% (%s)\n", report.uniform_tried,
                    100.0 * report.best_uniform->mean, report.best_uniform_pattern.c_str());
    if (report.bound)
        std::printf("no painting of these patterns comes nearer than %.3g %% (root mean square, linear)\n",
                    100.0 * *report.bound);
    print_unknowns(report);
    if (report.largest_utilization)
        std::printf("largest utilization: %.3g %%\n", 100.0 * *report.largest_utilization);
    if (report.slides) std::puts("nodes slide along the target's surface: only distances to it count");
    std::printf("%s, %s and %d of all beams, %.2g s; %s\n",
                counted(report.patterns.size(), "pattern").c_str(),
                counted(static_cast<std::size_t>(report.solutions), "nonlinear solution").c_str(),
                report.full_solutions, report.seconds, end_text(report.end));
}

void warn_of_design(const DesignReport& report, const design::DesignOptions& options) {
    warn_of_load(report, options);
    for (const std::string& line : report.warnings) warn_line(line);
    if (report.end == design::DesignEnd::Unreachable)
        warn_line("the target is out of reach: no painting of these patterns comes nearer than " +
                  short_number(100.0 * report.bound.value_or(0.0)) +
                  " % of the largest displacement wanted (root mean square, in linear theory)");
    if (options.max_utilization > 0.0 && report.largest_utilization.value_or(0.0) > options.max_utilization)
        warn_line("no painting that was checked keeps the utilization below " +
                  short_number(options.max_utilization));
    if (report.close_bars > 0)
        warn_line("no painting that was checked keeps the clearance: " + counted(report.close_bars, "pair") +
                  " of bars of the one that was written " + (report.close_bars == 1 ? "does" : "do") +
                  " not");
}

}  // namespace fretwork::app
