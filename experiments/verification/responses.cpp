// SPDX-License-Identifier: GPL-3.0-or-later
// Every response of a library: how its load path ends, and (on a sample) what coarse divisions cost. See
// README.md.
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace fretwork;

struct Options {
    std::size_t patterns = 0;  ///< of the tally; 0: all
    std::size_t sample = 30;   ///< of the divisions
    bool stable_branch = false;
    int threads = 1;
};

struct Ending {
    mechanics::Termination termination = mechanics::Termination::Converged;
    double load_factor = 1.0;
    bool stable = true;
    bool refused = false;  ///< the structure, as held, is a mechanism
};

Ending follow(const mechanics::Frame& frame, const std::vector<double>& factors, const Options& options) {
    Ending ending;
    mechanics::EquilibriumOptions path_options;
    if (options.stable_branch) path_options.branch = mechanics::Branch::Stable;
    try {
        const auto path = follow_load_path(mechanics::assemble(frame), factors, path_options);
        ending.termination = path.back().termination;
        ending.load_factor = path.back().load_factor;
        ending.stable = path.back().stable;
    } catch (const base::NumericalError&) {
        ending.refused = true;
    }
    return ending;
}

std::vector<pattern::Pattern> all_patterns(const pattern::NodeLayout& layout) {
    return pattern::enumerate_patterns(layout, {.edges = pattern::default_edge_range(layout), .filters = {}});
}

void print_tally(const reduction::Setting& setting, const std::vector<std::vector<Ending>>& endings) {
    std::printf(
        "| scenario | responses | full load, stable | full load, unstable | limit load | diverged | "
        "mechanism | least factor reached |\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t s = 0; s < setting.scenarios.size(); ++s) {
        int stable = 0, unstable = 0, limit = 0, diverged = 0, refused = 0;
        double least = 1.0;
        for (const auto& row : endings) {
            const Ending& e = row[s];
            if (e.refused) ++refused;
            if (e.refused) continue;
            least = std::min(least, e.load_factor);
            if (e.termination == mechanics::Termination::Converged)
                ++(e.stable ? stable : unstable);
            else if (e.termination == mechanics::Termination::LimitLoad)
                ++limit;
            else
                ++diverged;
        }
        std::printf("| %s | %zu | %d | %d | %d | %d | %d | %.4f |\n", setting.scenarios[s].name.c_str(),
                    endings.size(), stable, unstable, limit, diverged, refused, least);
    }
}

void tally(const pattern::NodeLayout& layout, const reduction::Setting& setting, const Options& options) {
    const auto all = all_patterns(layout);
    const auto chosen = options.patterns == 0 ? all : reduction::spread_over_edges(all, options.patterns);
    const auto factors = mechanics::even_load_factors(setting.magnitudes);
    std::vector<std::vector<Ending>> endings(chosen.size());
    const auto start = std::chrono::steady_clock::now();
    base::parallel_for(chosen.size(), options.threads, [&](std::size_t i) {
        const auto tile =
            mechanics::refined(reduction::pattern_frame(layout, chosen[i], setting), setting.divisions);
        for (const auto& scenario : setting.scenarios)
            endings[i].push_back(follow(reduction::scenario_frame(tile, scenario), factors, options));
    });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    print_tally(setting, endings);
    std::printf("\n%zu patterns x %zu scenarios x %d magnitudes in %.1f s\n\n", chosen.size(),
                setting.scenarios.size(), setting.magnitudes, seconds.count());
}

void divisions(const pattern::NodeLayout& layout, const reduction::Setting& setting, const Options& options) {
    const auto factors = mechanics::even_load_factors(setting.magnitudes);
    const auto chosen = reduction::spread_over_edges(all_patterns(layout), options.sample);
    constexpr int kDivisions[] = {1, 2, 4};
    std::printf(
        "| scenario | elements a beam | median error | 90 %% | largest | median of the estimates | largest "
        "error "
        "over its estimate |\n|---|---|---|---|---|---|---|\n");
    for (const auto& scenario : setting.scenarios) {
        std::vector<std::vector<double>> errors(std::size(kDivisions));
        std::vector<std::vector<double>> estimates(std::size(kDivisions));
        std::vector<double> worst(std::size(kDivisions), 0.0);
        for (const auto& pattern : chosen) {
            const auto frame =
                reduction::scenario_frame(reduction::pattern_frame(layout, pattern, setting), scenario);
            const auto exact = follow_load_path(mechanics::assemble(mechanics::refined(frame, 8)), factors);
            if (!exact.back().converged()) continue;
            for (std::size_t d = 0; d < std::size(kDivisions); ++d) {
                const auto divided = mechanics::refined(frame, kDivisions[d]);
                const auto path = follow_load_path(mechanics::assemble(divided), factors);
                const auto estimate = estimate_discretization_error(divided, factors, path).back();
                if (!path.back().converged() || !estimate.known) continue;
                const auto rows = exact.back().displacements.topRows(setting.sides).leftCols<3>();
                const mechanics::NodeValues difference = path.back().displacements.topRows(setting.sides) -
                                                         exact.back().displacements.topRows(setting.sides);
                errors[d].push_back(difference.leftCols<3>().rowwise().norm().maxCoeff() /
                                    rows.rowwise().norm().maxCoeff());
                estimates[d].push_back(estimate.share);
                worst[d] = std::max(worst[d], errors[d].back() / estimate.share);
            }
        }
        for (std::size_t d = 0; d < std::size(kDivisions); ++d) {
            std::ranges::sort(errors[d]);
            std::ranges::sort(estimates[d]);
            const std::size_t count = errors[d].size();
            if (count == 0) continue;
            std::printf("| %s | %d | %.1e | %.1e | %.1e | %.1e | %.1f |\n", scenario.name.c_str(),
                        kDivisions[d], errors[d][count / 2], errors[d][count * 9 / 10], errors[d].back(),
                        estimates[d][count / 2], worst[d]);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"How the load paths of a library's responses end, and what coarse divisions cost."};
    app.add_option("--patterns", options.patterns, "so many patterns for the tally; 0: all")
        ->capture_default_str();
    app.add_option("--sample", options.sample, "so many patterns for the study of divisions")
        ->capture_default_str();
    app.add_flag("--stable-branch", options.stable_branch, "leave unstable paths for stable ones");
    app.add_option("--threads", options.threads)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    const auto layout = pattern::find_node_layout("paper7");
    const auto setting = reduction::paper_setting();
    tally(layout, setting, options);
    if (options.sample > 0) divisions(layout, setting, options);
}
