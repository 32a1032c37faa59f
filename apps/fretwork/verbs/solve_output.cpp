// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "verbs/solve_output.hpp"

#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <cstdio>

namespace fretwork::app {
namespace {

base::Json summary_of(const mechanics::Result& result) {
    const mechanics::Solution& solution = result.solution;
    base::Json frequencies = base::Json::array();
    for (const mechanics::Mode& mode : result.vibration_modes) frequencies.push_back(mode.value);
    base::Json buckling = base::Json::array();
    for (const mechanics::Mode& mode : result.buckling_modes) buckling.push_back(mode.value);
    base::Json critical = base::Json::array();
    for (const mechanics::StabilityLoss& loss : solution.stability_losses)
        critical.push_back(loss.load_factor);
    return {{"solver", result.solver},
            {"converged", solution.converged()},
            {"termination", mechanics::termination_name(solution.termination)},
            {"load_factor", solution.load_factor},
            {"stable", solution.stable},
            {"stability", mechanics::stability_test_name(solution.stability)},
            {"largest_displacement", solution.displacements.leftCols<3>().rowwise().norm().maxCoeff()},
            {"largest_rotation", solution.displacements.rightCols<3>().rowwise().norm().maxCoeff()},
            {"energy", solution.energy},
            {"residual", solution.residual},
            {"iterations", solution.iterations},
            {"frequencies", frequencies},
            {"buckling_load_factors", buckling},
            {"critical_load_factors", critical},
            {"discretization_error", discretization_json(result)},
            {"seconds", result.seconds}};
}

std::string stability_text(const mechanics::Solution& solution) {
    switch (solution.stability) {
        case mechanics::StabilityTest::None:
            return "";
        case mechanics::StabilityTest::Tangent:
            return solution.stable ? ", stable" : ", unstable";
        case mechanics::StabilityTest::SymmetricPart:
            return solution.stable ? ", stable" : ", stability undecided (moments of fixed direction)";
    }
    return "";
}

/// Where a structure gives way at its limit load, if that is known.
std::string limit_place(const mechanics::Result& result) {
    const auto& losses = result.solution.stability_losses;
    if (losses.empty() || losses.back().pushed) return "";
    return " (" + component_text(result, losses.back()) + ")";
}

/// How a path that does not reach its load ends, and what helps.
std::string ending_text(const mechanics::Result& result, mechanics::Branch branch) {
    const mechanics::Solution& solution = result.solution;
    char share[32];
    std::snprintf(share, sizeof share, "%.6g", solution.load_factor);
    const std::string place = std::string(share) + " of the load";
    switch (solution.termination) {
        case mechanics::Termination::Converged:
            return "the full load is reached";
        case mechanics::Termination::LimitLoad:
            return "limit load at " + place + ": beyond it the load falls along the path" +
                   limit_place(result) +
                   (branch == mechanics::Branch::Snapping
                        ? "; no stable equilibrium of lower energy was found"
                        : "; --branch snapping looks beyond it");
        case mechanics::Termination::Diverged:
            return "no equilibrium that continues the path was found beyond " + place +
                   "; finer divisions or a smaller load may help";
        case mechanics::Termination::IterationsSpent:
            return "the load was not reached within the allowed steps; the path ends at " + place +
                   "; more load steps (--steps) or more load stages allow more";
    }
    return "";
}

}  // namespace

std::string component_text(const mechanics::Result& result, const mechanics::StabilityLoss& loss) {
    return "node " + std::to_string(result.nodes[loss.node].id) + " along " +
           std::string(mechanics::kDofNames[static_cast<std::size_t>(loss.dof)]);
}

base::Json discretization_json(const mechanics::Result& result) {
    const auto& error = result.discretization_error;
    return error && error->known ? base::Json(error->share) : base::Json(nullptr);
}

std::string discretization_text(const mechanics::DiscretizationError& error) {
    if (!error.known)
        return "no estimate of the discretization error: with other divisions the path ends elsewhere";
    char text[160];
    std::snprintf(text, sizeof text,
                  "off by about %.2g %% through the divisions of the beams: %.2g mm, %.2g deg",
                  100.0 * error.share, 1e3 * error.displacement, error.rotation * kDegreesPerRadian);
    return text;
}

void print_failure(const mechanics::Result& result, mechanics::Branch branch) {
    if (result.solver == mechanics::solver_name(mechanics::Solver::Linear)) {
        std::printf("rounding leaves %.1e of the load unbalanced: stiffnesses differ too much in size\n",
                    result.solution.residual);
    } else if (result.solver == mechanics::solver_name(mechanics::Solver::Newton)) {
        std::printf("%s; the result holds the last equilibrium\n", ending_text(result, branch).c_str());
    } else {
        std::printf("the result holds the last state, which is not an equilibrium\n");
    }
}

void print_solution_json(const mechanics::Result& result) {
    print_document(summary_of(result));
}

void print_losses_and_modes(const mechanics::Result& result, const Wanted& wanted) {
    const mechanics::Solution& solution = result.solution;
    for (const mechanics::StabilityLoss& loss : solution.stability_losses)
        std::printf("%s from %.6g of the load on%s: %s\n",
                    solution.stability == mechanics::StabilityTest::SymmetricPart ? "stability undecided"
                                                                                  : "unstable",
                    loss.load_factor, loss.pushed ? "; pushed onto a stable branch" : "",
                    component_text(result, loss).c_str());
    for (std::size_t i = 0; i < result.buckling_modes.size(); ++i)
        std::printf("buckling load %zu: %.6g times the load\n", i + 1, result.buckling_modes[i].value);
    for (std::size_t i = 0; i < result.vibration_modes.size(); ++i)
        std::printf("mode %zu: %.6g Hz\n", i + 1, result.vibration_modes[i].value);
    for (const std::string& missing :
         {mechanics::missing_buckling_modes_text(std::ssize(result.buckling_modes), wanted.buckling_modes),
          mechanics::missing_vibration_modes_text(std::ssize(result.vibration_modes),
                                                  wanted.vibration_modes)}) {
        if (!missing.empty()) std::printf("%s\n", missing.c_str());
    }
}

void print_solution(const mechanics::Result& result, const Wanted& wanted) {
    const auto summary = summary_of(result);
    const mechanics::Solution& solution = result.solution;
    std::printf("%zu nodes, %s: %s%s\n", result.nodes.size(), result.solver.c_str(),
                std::string(mechanics::termination_name(solution.termination)).c_str(),
                stability_text(solution).c_str());
    if (!solution.converged()) print_failure(result, wanted.branch);
    std::printf("largest displacement %.6g mm, largest rotation %.6g deg\n",
                1e3 * summary["largest_displacement"].get<double>(),
                summary["largest_rotation"].get<double>() * kDegreesPerRadian);
    if (const auto& error = result.discretization_error)
        std::printf("%s\n", discretization_text(*error).c_str());
    print_losses_and_modes(result, wanted);
    std::printf("relative residual %.1e, %d iterations, %.3g s\n", solution.residual, solution.iterations,
                result.seconds);
}

}  // namespace fretwork::app
