// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/model_catalogue.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <chrono>

namespace fretwork::simulation {
namespace {

std::vector<mechanics::Solution> follow_in_steps(const mechanics::Assembly& assembly, int load_steps) {
    std::vector<double> factors;
    for (int k = 1; k <= load_steps; ++k) factors.push_back(static_cast<double>(k) / load_steps);
    return mechanics::follow_load_path(assembly, factors);
}

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

void SimulationOptions::validate() const {
    (void)find_model(model);
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
    const auto started = std::chrono::steady_clock::now();
    const mechanics::Assembly assembly = model.build(surface, resolve(load_case, surface));
    const bool nonlinear = model.is_nonlinear && options.analysis == Analysis::OfTheModel;

    mechanics::Result result;
    result.solver = nonlinear ? "newton" : "linear";
    result.nodes = result_nodes(assembly, surface);
    if (nonlinear) {
        std::vector<mechanics::Solution> steps = follow_in_steps(assembly, options.load_steps);
        result.solution = steps.back();
        if (options.load_steps > 1) result.load_steps = std::move(steps);
    } else {
        result.solution = mechanics::solve_linear(assembly);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return result;
}

}  // namespace fretwork::simulation
