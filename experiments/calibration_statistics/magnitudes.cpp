// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <fretwork/base/parallel.hpp>

#include <cstdio>

namespace fretwork::experiments {
namespace {

constexpr std::size_t kEvery = 12;  ///< of the patterns, one in so many

reduction::Setting scaled(reduction::Setting setting, double factor) {
    for (reduction::Scenario& scenario : setting.scenarios) scenario.max_magnitude *= factor;
    return setting;
}

struct Found {
    double objective = 0.0;
    std::size_t not_converged = 0;
};

Found examine(const TableInput& input, const pattern::Pattern& pattern, const reduction::Setting& setting) {
    const auto responses = reduction::compute_responses(input.library.layout(), pattern, setting);
    Found found;
    for (const auto& response : responses) {
        for (const auto& sample : response.samples) found.not_converged += sample.converged ? 0 : 1;
    }
    found.objective =
        reduction::calibrate(reduction::find_tile_model("paper6"),
                             {input.library.layout(), pattern, setting, responses}, input.options)
            .objective;
    return found;
}

}  // namespace

void print_magnitudes(const TableInput& input) {
    std::vector<pattern::Pattern> chosen;
    for (std::size_t i = 0; i < input.patterns.size(); i += kEvery)
        chosen.push_back(input.patterns[i].pattern);
    std::printf("All largest magnitudes times a factor, on one pattern in %zu (%zu)\n\n", kEvery,
                chosen.size());
    print_head({"factor", "mean E", "deviation", "median", "samples that did not converge"});
    for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        const reduction::Setting setting = scaled(input.library.setting(), factor);
        std::vector<Found> found(chosen.size());
        base::parallel_for(found.size(), input.threads,
                           [&](std::size_t i) { found[i] = examine(input, chosen[i], setting); });
        std::vector<double> objectives;
        std::size_t not_converged = 0;
        for (const Found& one : found) {
            objectives.push_back(one.objective);
            not_converged += one.not_converged;
        }
        const Distribution d = distribution(std::move(objectives));
        print_row({fixed(factor, 2), fixed(d.mean, 2), fixed(d.deviation, 2), fixed(d.quantile(0.5), 2),
                   std::to_string(not_converged)});
    }
    std::printf("\n");
}

}  // namespace fretwork::experiments
