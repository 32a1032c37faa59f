// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/checks/finer_beams.hpp>
#include <fretwork/design/checks/full_check.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/simulation/results/beam_table.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::design::detail {
namespace {

double largest_utilization(const simulation::Session& session, const mechanics::Solution& solution) {
    const simulation::BeamTable table = simulation::beam_table(session, solution);
    double largest = 0.0;
    for (const simulation::BeamRow& row : table.rows)
        largest = std::max(largest, table.utilization(row).value_or(0.0));
    return largest;
}

}  // namespace

FullCheck check_in_full(const Trials& trials, const Point& point, BeamDemand beams,
                        const base::Control& control) {
    FullCheck check;
    check.has_converged = true;
    const simulation::Surface surface = trials.surface_at(point);
    if (beams != BeamDemand::None) check.largest_utilization = 0.0;
    std::optional<double> finer;
    if (beams == BeamDemand::UtilizationAndError) finer = 0.0;
    for (std::size_t c = 0; c < trials.parts().cases.size(); ++c) {
        simulation::SimulationOptions options{.model = "full", .threads = trials.parts().threads};
        std::optional<simulation::Session> session(std::in_place, surface, trials.load_case_at(point, c),
                                                   options);
        auto result = session->solve(control.silent());
        ++check.solutions;
        if (!result.solution.is_stable_equilibrium()) {
            // The path from flat ends at no stable equilibrium: solve again, along the stable branch.
            check.error.is_stable_from_flat = false;
            options.branch = mechanics::Branch::Stable;
            session.emplace(surface, trials.load_case_at(point, c), options);
            result = session->solve(control.silent());
            ++check.solutions;
        }
        check.has_converged = check.has_converged && result.solution.converged();
        check.error.is_stable = check.error.is_stable && result.solution.stable;
        if (beams != BeamDemand::None && check.has_converged)
            check.largest_utilization =
                std::max(*check.largest_utilization, largest_utilization(*session, result.solution));
        if (finer && check.has_converged) {
            const auto stress = largest_stress(
                surface, session->load_case(),
                {.elements = 2, .branch = options.branch, .threads = options.threads}, control.silent());
            if (stress) finer = std::max(*finer, *stress / *surface.setting.strength);
            if (!stress) finer.reset();
            check.solutions += stress ? 1 : 0;
        }
        check.displacements.push_back(std::move(result.solution.displacements));
    }
    if (!check.has_converged) return check;
    if (finer)
        check.utilization_error = mechanics::kErrorFromFiner * std::abs(*finer - *check.largest_utilization);
    const Trials::Distances distances = trials.distances(check.displacements);
    check.error.mean = distances.mean;
    check.error.largest = distances.largest;
    return check;
}

std::vector<CaseShape> shapes_of(const Trials& trials, const FullCheck& check) {
    std::vector<CaseShape> shapes;
    for (std::size_t c = 0; c < check.displacements.size(); ++c) {
        const DesignCase& own = trials.parts().cases[c];
        CaseShape shape{own.load_case.name, check.displacements[c], {}};
        for (const CaseGoals::Place& place : own.goals.places(check.displacements[c]))
            shape.goals.push_back({static_cast<int>(place.node), place.wanted, place.distance});
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

}  // namespace fretwork::design::detail
