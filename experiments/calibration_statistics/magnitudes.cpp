// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <fretwork/base/parallel.hpp>

#include <cstdio>

namespace fretwork::experiments {
namespace {

constexpr std::size_t kEvery = 12;  ///< one pattern in this number is taken

reduction::Setting scaled(reduction::Setting setting, double factor) {
    for (reduction::Scenario& scenario : setting.scenarios) scenario.max_magnitude *= factor;
    return setting;
}

struct Found {
    double objective = 0.0;
    std::size_t samples = 0;
    std::size_t not_converged = 0;
};

Found examine(const TableInput& input, const pattern::Pattern& pattern, const reduction::Setting& setting) {
    const auto responses = reduction::compute_responses(input.library.layout(), pattern, setting);
    Found found;
    for (const auto& response : responses) {
        found.samples += response.samples.size();
        for (const auto& sample : response.samples) found.not_converged += sample.converged ? 0 : 1;
    }
    found.objective =
        reduction::calibrate(reduction::find_tile_model("paper6"),
                             {input.library.layout(), pattern, setting, responses}, input.options)
            .objective;
    return found;
}

std::vector<Found> examine_all(const TableInput& input, const std::vector<pattern::Pattern>& patterns,
                               const reduction::Setting& setting) {
    std::vector<Found> found(patterns.size());
    base::parallel_for(found.size(), input.threads,
                       [&](std::size_t i) { found[i] = examine(input, patterns[i], setting); });
    return found;
}

/// Mean E, its deviation and median, E a sample, and the samples that E leaves out.
void print_found(std::string name, const std::vector<Found>& found) {
    std::vector<double> objectives;
    double share = 0.0;
    std::size_t not_converged = 0;
    for (const Found& one : found) {
        objectives.push_back(one.objective);
        share += one.objective / static_cast<double>(one.samples - one.not_converged);
        not_converged += one.not_converged;
    }
    const Distribution d = distribution(std::move(objectives));
    print_row({std::move(name), fixed(d.mean, 2), fixed(d.deviation, 2), fixed(d.quantile(0.5), 2),
               fixed(share / static_cast<double>(found.size()), 4), std::to_string(not_converged)});
}

}  // namespace

void print_magnitudes(const TableInput& input) {
    std::vector<pattern::Pattern> chosen;
    for (std::size_t i = 0; i < input.patterns.size(); i += kEvery)
        chosen.push_back(input.patterns[i].pattern);
    std::printf("All largest magnitudes times a factor, on one pattern in %zu (%zu)\n\n", kEvery,
                chosen.size());
    print_head({"factor", "mean E", "deviation", "median", "mean E a sample", "samples left out"});
    for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0})
        print_found(fixed(factor, 2), examine_all(input, chosen, scaled(input.library.setting(), factor)));
    std::printf("\nOther numbers of magnitudes, on the same patterns\n\n");
    print_head({"magnitudes", "mean E", "deviation", "median", "mean E a sample", "samples left out"});
    for (const int magnitudes : {5, 10, 20, 26}) {
        reduction::Setting setting = input.library.setting();
        setting.magnitudes = magnitudes;
        print_found(std::to_string(magnitudes), examine_all(input, chosen, setting));
    }
    std::printf("\n");
}

}  // namespace fretwork::experiments
