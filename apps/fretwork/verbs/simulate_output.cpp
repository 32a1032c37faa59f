// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "verbs/simulate_output.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/stages.hpp>

#include <cstdio>

namespace fretwork::app {
namespace {

std::string numbers_text(const std::vector<int>& numbers) {
    std::vector<std::string> texts;
    for (const int number : numbers) texts.push_back(std::to_string(number));
    return base::join(texts, ", ");
}

void print_model_error(const simulation::ModelError& error) {
    std::printf(
        "error of the model, estimated: %.2g %% of the largest displacement on average, %.2g %% at most",
        100.0 * error.mean, 100.0 * error.largest);
    if (error.largest_stress) std::printf("; %.2g %% of the largest stress", 100.0 * *error.largest_stress);
    std::puts("");
}

/// Null if it was not asked for, or is not known.
base::Json model_error_json(const simulation::SurfaceResult& result) {
    const auto& error = result.model_error;
    if (!error) return nullptr;
    return {{"mean", error->mean},
            {"largest", error->largest},
            {"relative_l2", error->relative_l2},
            {"full_share", error->full_share},
            {"largest_stress", base::or_null(error->largest_stress)}};
}

/// Null for linear results and for the full model.
base::Json model_doubt_json(const simulation::SurfaceResult& result) {
    const auto& doubt = result.model_doubt;
    if (!doubt) return nullptr;
    return {{"tile_rotation", doubt->tile_rotation},
            {"change", doubt->change},
            {"is_large", simulation::is_doubtful(result)}};
}

base::Json linear_range_json(const simulation::SurfaceResult& result) {
    const auto& range = result.linear_range;
    if (!range) return nullptr;
    return {{"error_estimate", range->error},
            {"loses_stability", range->loses_stability},
            {"is_exceeded", simulation::is_exceeded(*range)}};
}

base::Json values_of(const std::vector<mechanics::Mode>& modes) {
    base::Json values = base::Json::array();
    for (const mechanics::Mode& mode : modes) values.push_back(mode.value);
    return values;
}

base::Json stability_losses_json(const simulation::SurfaceResult& result,
                                 const mechanics::Solution& solution) {
    base::Json losses = base::Json::array();
    for (const mechanics::StabilityLoss& loss : solution.stability_losses)
        losses.push_back({{"load_factor", loss.load_factor},
                          {"node", result.nodes[loss.node].id},
                          {"component", mechanics::kDofNames[static_cast<std::size_t>(loss.dof)]},
                          {"pushed", loss.pushed}});
    return losses;
}

/// The solution of each load step or load stage; stages have names.
base::Json load_steps_json(const simulation::SurfaceResult& result) {
    const std::vector<std::string> names = simulation::stage_names(result);
    base::Json steps = base::Json::array();
    for (std::size_t i = 0; i < result.load_steps.size(); ++i) {
        const mechanics::Solution& step = result.load_steps[i];
        steps.push_back({{"stage", names.empty() ? base::Json() : base::Json(names.at(i))},
                         {"load_factor", step.load_factor},
                         {"termination", mechanics::termination_name(step.termination)},
                         {"stable", step.stable},
                         {"largest_displacement", simulation::largest_displacement(result, step)},
                         {"stability_losses", stability_losses_json(result, step)}});
    }
    return steps;
}

/// Prints each load stage.
void print_stages(const simulation::SurfaceResult& result) {
    const std::vector<std::string> names = simulation::stage_names(result);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const mechanics::Solution& step = result.load_steps[i];
        std::printf("  %zu '%s': %s at %.3g, largest displacement %.4g mm\n", i + 1,
                    base::printable(names.at(i)).c_str(),
                    std::string(mechanics::termination_name(step.termination)).c_str(), step.load_factor,
                    1e3 * simulation::largest_displacement(result, step));
        for (const mechanics::StabilityLoss& loss : step.stability_losses)
            std::printf("     jumped at %.4g: %s\n", loss.load_factor, component_text(result, loss).c_str());
    }
}

}  // namespace

std::vector<std::string> warnings_of(const simulation::SurfaceResult& result) {
    std::vector<std::string> warnings;
    if (simulation::is_out_of_range(result))
        warnings.push_back(simulation::linear_doubt_text(result) +
                           "; --model full, without --linear, or corotational tell");
    if (const std::string warning = simulation::model_warning(result); !warning.empty())
        warnings.push_back(warning + "; --model full tells");
    return warnings;
}

void print_result_json(const simulation::SurfaceResult& result) {
    const auto& solution = result.solution;
    const simulation::ResultSubject& subject = result.subject.value();
    print_document({{"model", subject.model},
                    {"load_case", subject.load_case},
                    {"joints", reduction::joints_name(subject.joints.value())},
                    {"solver", result.solver},
                    {"converged", solution.converged()},
                    {"stable", solution.stable},
                    {"termination", mechanics::termination_name(solution.termination)},
                    {"largest_displacement", simulation::largest_displacement(result, solution)},
                    {"largest_rotation", simulation::largest_rotation(result, solution)},
                    {"iterations", solution.iterations},
                    {"discretization_error", discretization_json(result)},
                    {"full_tiles", subject.full_tiles},
                    {"model_doubt", model_doubt_json(result)},
                    {"model_error_estimate", model_error_json(result)},
                    {"buckled_tiles", base::or_null(result.buckled_tiles)},
                    {"linear_range", linear_range_json(result)},
                    {"fit_error", base::or_null(result.fit_error)},
                    {"warnings", warnings_of(result)},
                    {"stability_losses", stability_losses_json(result, solution)},
                    {"load_steps", load_steps_json(result)},
                    {"frequencies", values_of(result.vibration_modes)},
                    {"buckling_load_factors", values_of(result.buckling_modes)},
                    {"seconds", result.seconds}});
}

void print_result(const simulation::SurfaceResult& result, const Wanted& wanted) {
    const auto& solution = result.solution;
    const simulation::ResultSubject& subject = result.subject.value();
    std::printf("%s model, joints: %s, load case '%s', %s: %s%s\n", base::printable(subject.model).c_str(),
                std::string(reduction::joints_name(subject.joints.value())).c_str(),
                base::printable(subject.load_case).c_str(), result.solver.c_str(),
                std::string(mechanics::termination_name(solution.termination)).c_str(),
                solution.is_unstable() ? ", unstable" : "");
    if (!solution.converged()) print_failure(result, wanted.branch);
    std::printf("largest displacement %.4g mm, largest rotation %.4g deg (interface nodes), %.3g s\n",
                1e3 * simulation::largest_displacement(result, solution),
                simulation::largest_rotation(result, solution) * kDegreesPerRadian, result.seconds);
    print_losses_and_modes(result, wanted);
    if (const auto& error = result.discretization_error)
        std::printf("%s\n", discretization_text(*error).c_str());
    if (!subject.full_tiles.empty())
        std::printf("tiles in full: %s\n", numbers_text(subject.full_tiles).c_str());
    if (const auto& error = result.model_error) print_model_error(*error);
    if (result.buckled_tiles && !result.buckled_tiles->empty())
        std::printf("tiles whose beams buckle between their interface nodes: %s\n",
                    numbers_text(*result.buckled_tiles).c_str());
    print_stages(result);
}

}  // namespace fretwork::app
