// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of a small surface with goals at all nodes.
#pragma once

#include "hidden.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/design/search/trials.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace fretwork::test {

inline design::detail::Trials trials_of(const simulation::Project& project, const design::Target& target,
                                        const design::detail::FreeUnknowns& free = {}) {
    simulation::Surface surface = simulation::make_surface(project, nullptr);
    std::vector<design::detail::DesignCase> cases;
    cases.push_back({project.load_cases.front(),
                     design::detail::CaseGoals(target, "cantilever", "cantilever", surface.tessellation)});
    simulation::CandidateTiles candidates(
        surface, pattern::parse_named_patterns(project.layout, kDesignPatterns), {1, {}});
    auto groups = design::detail::tile_groups(surface.tessellation, {}, {});
    return design::detail::Trials(
        {std::move(surface), std::move(cases), std::move(candidates), std::move(groups), {}, free, 1});
}

/// All nodes bent by `size` x^2 (m).
inline design::Target bent(double size) {
    return {"",
            "",
            {{design::FormulaGoal{simulation::NodesInBox{{-10, -10, 10, 10}},
                                  {"0", "0", std::to_string(size) + "*x*x"}}}}};
}

inline design::detail::Point random_painting(const design::detail::Trials& trials, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    design::detail::Point point = trials.uniform(0);
    for (std::size_t& pattern : point.patterns) pattern = random.below(kDesignPatterns.size());
    return point;
}

/// The table's derivative of the objective by each unknown, against central differences of solved surfaces.
inline void expect_derivatives(design::detail::Trials& trials, const design::detail::Point& point,
                               const design::detail::SwapTable& table, const Eigen::VectorXd& steps) {
    for (Eigen::Index unknown = 0; unknown < steps.size(); ++unknown) {
        const auto at = [&](double place) {
            design::detail::Point moved = point;
            moved.unknowns[unknown] += place * steps[unknown];
            return trials.solve(moved, {}).objective;
        };
        const double difference = (at(1.0) - at(-1.0)) / (2.0 * steps[unknown]);
        const double derivative = 2.0 * table.residual.dot(table.by_unknowns.col(unknown));
        EXPECT_NEAR(derivative, difference, 1e-4 * std::abs(difference)) << unknown;
    }
}

}  // namespace fretwork::test
