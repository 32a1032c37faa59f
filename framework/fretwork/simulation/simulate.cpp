// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/model_catalogue.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <chrono>

namespace fretwork::simulation {
namespace {

std::vector<mechanics::Result::Node> result_nodes(const mechanics::Assembly& assembly,
                                                  const Surface& surface) {
    std::vector<mechanics::Result::Node> nodes;
    const auto interface_count = static_cast<int>(surface.tessellation.interface_nodes.size());
    for (int i = 0; i < assembly.reported_nodes; ++i) {
        nodes.push_back({i, assembly.nodes[static_cast<std::size_t>(i)], i < interface_count});
    }
    return nodes;
}

}  // namespace

bool SimulationOptions::is_nonlinear() const {
    return find_model(model).is_nonlinear && analysis == Analysis::OfTheModel;
}

void SimulationOptions::validate() const {
    if (threads < 0) throw base::InputError("threads: " + std::to_string(threads) + " must not be negative");
    if (estimate_error && (model != "full" || !is_nonlinear()))
        throw base::InputError("the discretization error is estimated for the nonlinear full model only");
    if (load_steps > 1 && !is_nonlinear())
        throw base::InputError("load_steps is " + std::to_string(load_steps) +
                               ", where a linear solution has no path to divide");
    constexpr int kMostSteps = 10000;
    if (load_steps < 1 || load_steps > kMostSteps) {
        throw base::InputError("load_steps is " + std::to_string(load_steps) + ", where 1 to " +
                               std::to_string(kMostSteps) + " are possible");
    }
}

mechanics::Result simulate(const Surface& surface, const LoadCase& load_case,
                           const SimulationOptions& options) {
    options.validate();
    const ModelRow& model = find_model(options.model);
    const bool nonlinear = options.is_nonlinear();
    const auto started = std::chrono::steady_clock::now();
    const Conditions conditions = resolve(load_case, surface);
    const mechanics::Assembly assembly = model.build(surface, conditions);

    mechanics::Result result;
    result.solver = nonlinear ? "newton" : "linear";
    result.nodes = result_nodes(assembly, surface);
    if (nonlinear) {
        const mechanics::EquilibriumOptions path_options{.threads = options.threads};
        result.load_steps = mechanics::follow_load_path(
            assembly, mechanics::even_load_factors(options.load_steps), path_options);
        result.solution = result.load_steps.back();
    } else {
        result.solution = mechanics::solve_linear(assembly, {.threads = options.threads});
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    if (options.estimate_error)
        result.discretization_error =
            mechanics::estimate_discretization_error(full_model_frame(surface, conditions),
                                                     mechanics::even_load_factors(options.load_steps),
                                                     result.load_steps, {.threads = options.threads})
                .back();
    if (options.load_steps == 1) result.load_steps.clear();
    return result;
}

}  // namespace fretwork::simulation
