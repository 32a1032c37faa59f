// SPDX-License-Identifier: GPL-3.0-or-later
#include "design_output.hpp"
#include "output.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/design/design_words.hpp>

#include <cstdio>
#include <string>

namespace fretwork::app {
namespace {

using base::Json;
using design::DesignReport;
using design::TargetError;

Json history_json(const DesignReport& report) {
    Json history = Json::array();
    for (const design::DesignProgress& own : report.history)
        history.push_back({{"solutions", own.solutions}, {"seconds", own.seconds}, {"misfit", own.misfit}});
    return history;
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

void print_utilization(const DesignReport& report) {
    const std::string error = report.utilization_error
                                  ? ", estimated error by one element a beam " +
                                        base::format_number(100.0 * *report.utilization_error, 2) + " %"
                                  : "";
    std::printf("largest utilization: %.3g %%%s\n", 100.0 * *report.largest_utilization, error.c_str());
}

}  // namespace

void print_design_json(const DesignReport& report, std::span<const design::DesignWarning> warnings) {
    const Json json = {{"error_mean", base::or_null(report.error, &TargetError::mean)},
                       {"error_largest", base::or_null(report.error, &TargetError::largest)},
                       {"error_best_uniform", base::or_null(report.best_uniform, &TargetError::mean)},
                       {"best_uniform_pattern", report.best_uniform_pattern},
                       {"uniform_tried", report.uniform_tried},
                       {"error_relaxed", base::or_null(report.relaxed)},
                       {"bound", base::or_null(report.bound)},
                       {"stable", base::or_null(report.error, &TargetError::is_stable)},
                       {"stable_from_flat", base::or_null(report.error, &TargetError::is_stable_from_flat)},
                       {"model_error", report.model_error},
                       {"largest_utilization", base::or_null(report.largest_utilization)},
                       {"utilization_error", base::or_null(report.utilization_error)},
                       {"close_bars", report.close_bars},
                       {"load_cases", report.load_cases},
                       {"factors", report.factors},
                       {"width", base::or_null(report.width)},
                       {"thickness", base::or_null(report.thickness)},
                       {"wanted_of_softest", report.wanted_of_softest},
                       {"wanted_of_stiffest", report.wanted_of_stiffest},
                       {"reach_of_ten_loads", base::or_null(report.reach_of_ten_loads)},
                       {"curvatures_outside", base::or_null(report.gamut.share_outside())},
                       {"slides", report.slides},
                       {"end", design::design_end_name(report.end)},
                       {"starts", report.start_misfits},
                       {"history", history_json(report)},
                       {"patterns", report.patterns},
                       {"warnings", design::plain_texts(warnings)},
                       {"seconds", report.seconds},
                       {"solutions", report.solutions},
                       {"full_solutions", report.full_solutions},
                       {"seed", report.seed}};
    print_document(json);
}

void print_design(const DesignReport& report) {
    if (report.error) {
        std::printf(
            "mean error %.3g %%, largest %.3g %% of the largest displacement wanted (checked with all "
            "beams)%s\n",
            100.0 * report.error->mean, 100.0 * report.error->largest,
            !report.error->is_stable             ? "; NOT STABLE"
            : !report.error->is_stable_from_flat ? "; it snaps on the way from flat"
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
    if (report.relaxed)
        std::printf("mixtures of patterns in each tile are predicted to come to %.3g %% (root mean square)\n",
                    100.0 * *report.relaxed);
    if (report.largest_utilization) print_utilization(report);
    if (report.slides) std::puts("nodes slide along the target's surface: only distances to it count");
    std::printf(
        "%s, %s and %d of all beams, %.2g s; %s\n", base::counted(report.patterns.size(), "pattern").c_str(),
        base::counted(static_cast<std::size_t>(report.solutions), "nonlinear solution").c_str(),
        report.full_solutions, report.seconds, std::string(design::design_end_words(report.end)).c_str());
}

void warn_of_design(std::span<const design::DesignWarning> warnings) {
    for (const design::DesignWarning& warning : warnings)
        warn(plain_text(warning) + (warning.factor_may_help ? " (--free factor searches one)" : ""));
}

}  // namespace fretwork::app
