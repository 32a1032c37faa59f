// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/reach/survey.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::design::detail {
namespace {

using mechanics::NodeValues;
using Places = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using tiling::Tessellation;

constexpr double kMoreLoad = 10.0;
/// Displacements below this share of the largest wanted are none.
constexpr double kNothing = 1e-9;

double largest_displacement(const Trial& trial) {
    double largest = 0.0;
    for (const NodeValues& own : trial.displacements)
        largest = std::max(largest, own.leftCols<3>().rowwise().norm().maxCoeff());
    return largest;
}

const Solved& softest_of(const std::vector<Solved>& uniform) {
    return *std::ranges::max_element(uniform, {},
                                     [](const Solved& own) { return largest_displacement(own.trial); });
}

Places places_at(const Tessellation& tessellation, const NodeValues& displacements) {
    Places places = displacements.topRows(std::ssize(tessellation.interface_nodes)).leftCols<3>();
    for (const tiling::InterfaceIndex node : tessellation.interface_nodes.indices()) {
        places(node.value, 0) += tessellation.interface_nodes[node].x;
        places(node.value, 1) += tessellation.interface_nodes[node].y;
    }
    return places;
}

}  // namespace

void survey(const Trials& trials, const std::vector<Solved>& uniform, DesignReport& report) {
    const double wanted = trials.largest_wanted();
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const Solved& own : uniform) {
        least = std::min(least, largest_displacement(own.trial));
        most = std::max(most, largest_displacement(own.trial));
    }
    add_reached_curvatures(trials, uniform, report.gamut);
    report.nothing_moves = !(most > kNothing * wanted);
    if (report.nothing_moves) return;
    report.wanted_of_softest = wanted / most;
    report.wanted_of_stiffest = wanted / least;
}

void add_reached_curvatures(const Trials& trials, const std::vector<Solved>& uniform, Gamut& gamut) {
    const Tessellation& tessellation = trials.parts().surface.tessellation;
    for (const Solved& own : uniform) {
        for (const NodeValues& displacements : own.trial.displacements) {
            for (const auto& tile : tile_curvatures(tessellation, places_at(tessellation, displacements)))
                if (tile) gamut.reached.push_back(*tile);
        }
    }
}

std::optional<double> reach_of_ten_loads(Trials& trials, const std::vector<Solved>& uniform,
                                         const DesignReport& report, const base::Control& control) {
    const auto& parts = trials.parts();
    const bool is_loaded = std::ranges::any_of(parts.cases, [](const DesignCase& own) {
        return !own.load_case.loads.empty() || !own.load_case.area_loads.empty();
    });
    if (!is_loaded || report.wanted_of_softest <= kLoadTooSmall || parts.free.factor || parts.free.prescribed)
        return std::nullopt;
    const Point& softest = softest_of(uniform).point;
    double largest = 0.0;
    for (std::size_t c = 0; c < parts.cases.size(); ++c) {
        simulation::Session session(trials.surface_at(softest),
                                    with_factor(trials.load_case_at(softest, c), kMoreLoad),
                                    {.model = "corotational", .threads = parts.threads});
        const auto result = session.solve(control.silent());
        trials.count_solutions(1);
        if (!result.solution.converged()) return std::nullopt;
        largest = std::max(largest, result.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff());
    }
    return largest / trials.largest_wanted();
}

void add_wanted_curvatures(const Tessellation& tessellation, const std::vector<CaseShape>& shapes,
                           Gamut& gamut) {
    for (const CaseShape& shape : shapes) {
        Places wanted = Places::Constant(std::ssize(tessellation.interface_nodes), 3,
                                         std::numeric_limits<double>::quiet_NaN());
        const Places places = places_at(tessellation, shape.displacements);
        for (const CaseShape::GoalNode& goal : shape.goals) {
            auto own = wanted.row(goal.node);
            if (std::isnan(own[0])) own = places.row(goal.node);
            // A component with its present value is free: another goal of the node may want a value of it.
            for (Eigen::Index c = 0; c < 3; ++c) {
                if (goal.wanted[c] != places(goal.node, c)) own[c] = goal.wanted[c];
            }
        }
        const auto of_goals = tile_curvatures(tessellation, wanted);
        const auto of_painting = tile_curvatures(tessellation, places);
        for (const tiling::TileIndex tile : tessellation.tiles.indices()) {
            if (!of_goals[tile] || !of_painting[tile]) continue;
            gamut.wanted.push_back(*of_goals[tile]);
            gamut.designed.push_back(*of_painting[tile]);
        }
    }
}

}  // namespace fretwork::design::detail
