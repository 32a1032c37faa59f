// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "verbs/library/library_show.hpp"
#include "verbs/solve_output.hpp"

#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::app {
namespace {

using base::Json;
using library::CalibrationRecord;
using library::Library;

/// A pattern's response under one scenario, in short.
struct ScenarioSummary {
    std::string name;
    std::size_t converged = 0;
    std::size_t samples = 0;
    int first_unstable_step = 0;                   ///< 0: none
    double largest_magnitude = 0.0;                ///< N, of the samples that converged
    double largest_displacement = 0.0;             ///< m, at that magnitude
    std::optional<double> discretization_error{};  ///< share, the largest that is known
    bool meets_limit_load = false;                 ///< what did not converge lies beyond a limit load
};

ScenarioSummary summarize(const reduction::Response& response) {
    ScenarioSummary summary{response.scenario};
    summary.samples = response.samples.size();
    for (const auto& sample : response.samples) {
        summary.meets_limit_load = summary.meets_limit_load || sample.limit_load;
        if (!sample.converged) continue;
        ++summary.converged;
        summary.discretization_error = std::max(summary.discretization_error, sample.discretization_error);
        if (!sample.stable && summary.first_unstable_step == 0) summary.first_unstable_step = sample.step;
        summary.largest_magnitude = sample.magnitude;
        summary.largest_displacement = sample.displacements.leftCols<3>().rowwise().norm().maxCoeff();
    }
    return summary;
}

Json calibration_json(const CalibrationRecord& record) {
    const reduction::Calibration& calibration = record.calibration;
    Json document = {{"model", calibration.model},
                     {"optimizer", calibration.optimizer},
                     {"seed", calibration.seed},
                     {"starts", calibration.starts},
                     {"budget", record.budget},
                     {"objective", calibration.objective},
                     {"scenario_errors", calibration.scenario_errors},
                     {"evaluations", calibration.cost},
                     {"converged", calibration.converged},
                     {"at_bound", calibration.at_bound},
                     {"seconds", record.seconds}};
    for (const auto& [name, value] : calibration.parameters) document[name] = value;
    return document;
}

std::vector<library::Failure> failures_of(const Library& library, const pattern::NamedPattern& entry) {
    std::vector<library::Failure> failures = library.failures();
    std::erase_if(failures, [&](const library::Failure& failure) { return failure.pattern != entry.id; });
    return failures;
}

Json show_json(const Library& library, const pattern::NamedPattern& entry) {
    Json document = {{"id", entry.id},
                     {"layout", library.layout().name()},
                     {"edges", entry.pattern.edge_count()},
                     {"responses", Json::array()},
                     {"calibrations", Json::array()},
                     {"properties", Json::object()},
                     {"failures", Json::array()}};
    for (const reduction::Response& response : library.responses(entry.id)) {
        const ScenarioSummary summary = summarize(response);
        document["responses"].push_back(
            {{"scenario", summary.name},
             {"samples", summary.samples},
             {"converged", summary.converged},
             {"first_unstable_step", summary.first_unstable_step},
             {"meets_limit_load", summary.meets_limit_load},
             {"discretization_error", base::or_null(summary.discretization_error)},
             {"largest_magnitude", summary.largest_magnitude},
             {"largest_displacement", summary.largest_displacement}});
    }
    for (const CalibrationRecord& record : library.calibrations(entry.id))
        document["calibrations"].push_back(calibration_json(record));
    for (const auto& [name, value] : library.properties(entry.id)) document["properties"][name] = value;
    for (const library::Failure& failure : failures_of(library, entry))
        document["failures"].push_back({{"stage", failure.computation}, {"reason", failure.reason}});
    return document;
}

void print_response(const reduction::Response& response) {
    const ScenarioSummary summary = summarize(response);
    std::printf("  %-8s %2zu of %2zu converged, %6.2f mm at %.3g N", base::printable(summary.name).c_str(),
                summary.converged, summary.samples, 1e3 * summary.largest_displacement,
                summary.largest_magnitude);
    if (summary.discretization_error) std::printf(", to about %.1g", *summary.discretization_error);
    if (summary.first_unstable_step > 0)
        std::printf(", unstable from step %d on", summary.first_unstable_step);
    if (summary.meets_limit_load) std::printf(", then a limit load");
    std::printf("\n");
}

/// The unit of a parameter; none for a model that this program does not have.
std::string unit_of_parameter(const std::string& model_name, const std::string& name) {
    const auto& models = reduction::tile_models();
    const auto model = std::ranges::find(models, model_name, &reduction::TileModel::name);
    if (model == models.end()) return "";
    return model->parameters[reduction::parameter_index(*model, name)].unit;
}

/// "A 4.1e-06 m^2, theta 5.73 deg, .."
std::string parameters_text(const reduction::Calibration& calibration) {
    std::vector<std::string> texts;
    for (const auto& [name, value] : calibration.parameters) {
        const std::string unit = unit_of_parameter(calibration.model, name);
        const bool is_angle = unit == "rad";
        char text[64];
        std::snprintf(text, sizeof text, "%.4g %s", is_angle ? value * kDegreesPerRadian : value,
                      is_angle ? "deg" : unit.c_str());
        texts.push_back(name + " " + text);
    }
    return base::join(texts, ", ");
}

void print_calibration(const CalibrationRecord& record) {
    const reduction::Calibration& calibration = record.calibration;
    std::printf("  %s by %s, seed %llu, %d starts: E = %.4f after %ld evaluations%s\n",
                base::printable(calibration.model).c_str(), base::printable(calibration.optimizer).c_str(),
                static_cast<unsigned long long>(calibration.seed), calibration.starts, calibration.objective,
                calibration.cost, calibration.converged ? "" : ", not converged");
    if (calibration.parameters.empty()) return;
    std::printf("    %s", parameters_text(calibration).c_str());
    if (!calibration.at_bound.empty())
        std::printf("; at a bound: %s", base::join(calibration.at_bound, ", ").c_str());
    std::printf("\n");
}

/// The unit of a property that reduction::property_values() names.
std::string_view unit_of(std::string_view property) {
    if (property == "mass_per_area") return " kg/m^2";
    if (property.ends_with("_poisson") || property.ends_with("_anisotropy")) return "";
    if (property.starts_with("membrane_") || property.starts_with("A")) return " N/m";
    if (property.starts_with("bending_") || property.starts_with("D")) return " N m";
    return "";
}

}  // namespace

void print_pattern_json(const Library& library, const pattern::NamedPattern& entry) {
    print_document(show_json(library, entry));
}

void print_pattern(const Library& library, const pattern::NamedPattern& entry) {
    // All is read before anything is printed: a damaged library gives no half of a page.
    const auto responses = library.responses(entry.id);
    const auto calibrations = library.calibrations(entry.id);
    const auto properties = library.properties(entry.id);
    const auto failures = failures_of(library, entry);
    std::printf("%s of the layout %s: %d edges\n", entry.id.c_str(),
                base::printable(library.layout().name()).c_str(), entry.pattern.edge_count());
    std::printf("responses:%s\n", responses.empty() ? " none" : "");
    for (const reduction::Response& response : responses) print_response(response);
    std::printf("calibrations:%s\n", calibrations.empty() ? " none" : "");
    for (const CalibrationRecord& record : calibrations) print_calibration(record);
    std::printf("as an endless plate:%s\n", properties.empty() ? " unknown" : "");
    for (const auto& [name, value] : properties)
        std::printf("  %-20s %.6g%s\n", base::printable(name).c_str(), value,
                    std::string(unit_of(name)).c_str());
    for (const library::Failure& failure : failures)
        std::printf("failed, %s: %s\n", base::printable(failure.computation).c_str(),
                    base::printable(failure.reason).c_str());
}

}  // namespace fretwork::app
