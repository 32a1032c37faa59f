// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <cstdio>

namespace fretwork::experiments {
namespace {

/// The displacements of all patterns under one scenario at its largest magnitude.
struct Largest {
    std::vector<double> displacements;  ///< m, the largest of the interface nodes; of what converged
    std::vector<double> rotations;      ///< rad, likewise
    std::size_t unstable = 0;
    std::size_t not_converged = 0;
};

void add(const reduction::Response::Sample& last, Largest& largest) {
    if (!last.converged) {
        ++largest.not_converged;
        return;
    }
    largest.unstable += last.stable ? 0 : 1;
    largest.displacements.push_back(last.displacements.leftCols<3>().rowwise().norm().maxCoeff());
    largest.rotations.push_back(last.displacements.rightCols<3>().rowwise().norm().maxCoeff());
}

}  // namespace

void print_displacements(const TableInput& input) {
    const auto& scenarios = input.library.setting().scenarios;
    std::vector<Largest> largest(scenarios.size());
    for (const auto& entry : input.patterns) {
        const auto responses = input.library.responses(entry.id);
        for (std::size_t s = 0; s < responses.size(); ++s) add(responses[s].samples.back(), largest[s]);
    }
    std::printf(
        "Largest displacement of a tile's rim at the scenario's largest magnitude, mm, over patterns\n\n");
    print_head({"scenario", "largest F, N", "5 %", "25 %", "median", "75 %", "95 %", "largest",
                "median rotation, deg", "unstable", "not converged"});
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
        const Distribution mm = distribution(largest[s].displacements);
        std::vector<std::string> row = {scenarios[s].name, fixed(scenarios[s].max_magnitude, 2)};
        for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95, 1.0})
            row.push_back(fixed(1e3 * mm.quantile(share), 2));
        row.push_back(fixed(57.29577951308232 * distribution(largest[s].rotations).quantile(0.5), 1));
        row.push_back(std::to_string(largest[s].unstable));
        row.push_back(std::to_string(largest[s].not_converged));
        print_row(row);
    }
    std::printf("\n");
}

}  // namespace fretwork::experiments
