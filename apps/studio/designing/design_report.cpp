// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/design_words.hpp>
#include <studio/designing/design_report.hpp>
#include <studio/document/painting_request.hpp>

#include <vector>

namespace fretwork::studio {

using base::Json;
using design::DesignReport;
using design::TargetError;

namespace {

/// The share of the best single pattern's error that the design has taken away.
Json share_closed(const DesignReport& report) {
    if (!report.error || !report.best_uniform || report.best_uniform->mean <= 0.0) return nullptr;
    return 1.0 - report.error->mean / report.best_uniform->mean;
}

using Warnings = std::vector<design::DesignWarning>;

/// Warnings with their lengths and angles as numbers, which the page shows in its units.
Json warning_parts(const Warnings& warnings) {
    Json parts = Json::array();
    for (const design::DesignWarning& warning : warnings) {
        Json values = Json::array();
        for (const design::WarnedValue& own : warning.values)
            values.push_back(
                {{"value", own.value},
                 {"quantity", own.quantity == design::WarnedValue::Quantity::Length ? "length" : "angle"}});
        parts.push_back({{"text", warning.text}, {"values", std::move(values)}});
    }
    return parts;
}

}  // namespace

Edited with_design(const State& state, const DesignReport& report) {
    Edited edit{state, "design"};
    Painting painting = painted_as(state, report.project.tessellation);
    if (painting != *state.painting)
        edit.state.painting = std::make_shared<const Painting>(std::move(painting));
    if (report.project.load_cases != *state.load_cases)
        edit.state.load_cases =
            std::make_shared<const std::vector<simulation::LoadCase>>(report.project.load_cases);
    return edit;
}

Json designed_event(const DesignFound& found, std::int64_t revision) {
    const DesignReport& report = found.report;
    const Warnings warnings = design::design_warnings(report, found.options);
    return {{"event", "designed"},
            {"revision", revision},
            {"sketch", found.stage == DesignFound::Stage::Sketch},
            {"error_mean", base::or_null(report.error, &TargetError::mean)},
            {"error_largest", base::or_null(report.error, &TargetError::largest)},
            {"stable", base::or_null(report.error, &TargetError::is_stable)},
            {"error_best_uniform", base::or_null(report.best_uniform, &TargetError::mean)},
            {"best_uniform_pattern", report.best_uniform_pattern},
            {"uniform_tried", report.uniform_tried},
            {"share_closed", share_closed(report)},
            {"is_better", report.is_better()},
            {"patterns", report.patterns},
            {"load_cases", report.load_cases},
            {"factors", report.factors},
            {"warnings", design::plain_texts(warnings)},
            {"warning_parts", warning_parts(warnings)},
            {"end", design::design_end_name(report.end)},
            {"words", design::design_end_words(report.end)},
            {"seconds", report.seconds},
            {"solutions", report.solutions},
            {"full_solutions", report.full_solutions},
            {"seed", report.seed}};
}

}  // namespace fretwork::studio
