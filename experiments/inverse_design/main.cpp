// SPDX-License-Identifier: GPL-3.0-or-later
// One design and its baselines, as a row of a table: README.md.
#include "baselines.hpp"
#include "instances.hpp"
#include "rows.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/design/checks/full_check.hpp>
#include <fretwork/design/search/preparation.hpp>
#include <fretwork/design/search/search.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <utility>

namespace {

using namespace fretwork;
using design::detail::Point;
using design::detail::Trials;

struct Arguments {
    int columns = 11;
    int rows = 4;
    std::string hidden = "graded";
    std::string patterns = "24";
    std::string baseline;
    double share = 0.5;  ///< of the span: the largest displacement
    double angle = 0.0;  ///< deg; an arc is the target instead of a hidden painting
    double seconds = 0.0;
    int solutions = 40;
    std::uint64_t seed = 1;
    int threads = 2;
    bool free_factor = false;
    std::size_t max_patterns = 0;
};

struct Instance {
    simulation::Project project;
    design::Target target;
    std::vector<pattern::NamedPattern> palette;
    double bent = 0.0;                ///< the largest displacement of the target over the span
    std::vector<std::string> hidden;  ///< the pattern of each tile
};

double largest_of(const design::Target& target) {
    double largest = 0.0;
    for (const design::FreeVector& value : std::get<design::NodesGoal>(target.goals.front().what).values)
        largest = std::max(largest, std::hypot(*value[0], *value[1], *value[2]));
    return largest;
}

Instance instance_of(const Arguments& arguments) {
    Instance instance;
    instance.project = experiments::lattice(arguments.columns, arguments.rows);
    instance.palette = experiments::palette(arguments.patterns, arguments.seed);
    simulation::Project hidden = instance.project;
    experiments::paint(hidden,
                       {experiments::find_hidden(arguments.hidden), instance.palette, arguments.seed});
    const double force = experiments::force_for(hidden, arguments.share);
    instance.project.load_cases = hidden.load_cases = {experiments::tip_load(force)};
    for (const tiling::TileIndex tile : hidden.tessellation.tiles.indices())
        instance.hidden.push_back(tiling::pattern_of(hidden.tessellation, tile)->id);
    instance.target =
        arguments.angle > 0.0
            ? experiments::arc(instance.project, arguments.angle * 3.14159265358979323846 / 180.0)
            : experiments::reached_by(hidden);
    instance.bent = largest_of(instance.target) / experiments::span_of(instance.project);
    return instance;
}

design::DesignOptions options_of(const Arguments& arguments, const Instance& instance) {
    design::DesignOptions options;
    options.load_case = "tip";
    options.palette = instance.palette;
    options.seconds = arguments.seconds;
    options.most_solutions = arguments.solutions;
    options.seed = arguments.seed;
    options.threads = arguments.threads;
    options.free_factor = arguments.free_factor;
    options.max_patterns = arguments.max_patterns;
    return options;
}

/// Processor time of all threads so far, s: others keep the machine busy, and wall time says little.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Processor time of a corotational solution from rest, the best of five: the unit of time.
double unit_seconds(const Instance& instance, int threads) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
        const double before = processor_seconds();
        (void)simulation::simulate(simulation::make_surface(instance.project, nullptr),
                                   instance.project.load_cases.front(),
                                   {.model = "corotational", .threads = threads});
        best = std::min(best, processor_seconds() - before);
    }
    return best;
}

/// The mean distance, with all beams, of the best of 24 single patterns as different as can be: of the whole
/// palette if it has no more. A design tries fewer.
double best_uniform(const Arguments& arguments, const Instance& instance) {
    design::detail::Preparation preparation =
        design::detail::prepare(instance.project, nullptr, instance.target, options_of(arguments, instance));
    Trials trials(std::move(preparation.parts));
    double least = std::numeric_limits<double>::infinity();
    Point best;
    for (std::size_t p = 0; p < std::min<std::size_t>(24, preparation.palette.size()); ++p) {
        const Point point = trials.uniform(preparation.palette[p]);
        const design::detail::Trial trial = trials.solve(point, {});
        if (!trial.is_found || trial.objective >= least) continue;
        least = trial.objective;
        best = point;
    }
    return design::detail::check_in_full(trials, best, design::detail::BeamDemand::None, {}).error.mean;
}

experiments::Row row_of(const Arguments& arguments, const Instance& instance, const std::string& method) {
    experiments::Row row;
    row.method = method;
    row.tiles = instance.project.tessellation.tiles.size();
    row.target = arguments.angle > 0.0 ? "arc" : arguments.hidden;
    row.palette = arguments.patterns;
    row.seed = arguments.seed;
    row.bent = instance.bent;
    row.uniform = best_uniform(arguments, instance);
    return row;
}

void print_design(const Arguments& arguments, const Instance& instance) {
    experiments::Row row = row_of(arguments, instance, "design");
    row.unit = unit_seconds(instance, arguments.threads);
    const double before = processor_seconds();
    std::vector<std::pair<double, double>> course;  // processor time and misfit of each better painting
    design::DesignOptions options = options_of(arguments, instance);
    options.on_better = [&](const design::DesignProgress& own) {
        course.emplace_back(processor_seconds() - before, own.misfit);
    };
    const design::DesignReport report = design::design(instance.project, nullptr, instance.target, options);
    row.seconds = processor_seconds() - before;
    experiments::take_report(report, row);
    if (report.best_uniform) row.uniform = std::min(row.uniform, report.best_uniform->mean);
    for (const auto& [seconds, misfit] : course) {
        if (std::isnan(row.half) && misfit <= 0.5 * std::min(1.0, row.uniform)) row.half = seconds;
    }
    if (arguments.angle <= 0.0) {
        row.equal = 0.0;
        const tiling::Tessellation& found = report.project.tessellation;
        for (const tiling::TileIndex tile : found.tiles.indices())
            row.equal +=
                tiling::pattern_of(found, tile)->id == instance.hidden[static_cast<std::size_t>(tile.value)];
    }
    experiments::print(row);
}

experiments::Baseline search_otherwise(const Arguments& arguments, const Instance& instance, Trials& trials,
                                       const Point& start) {
    const int left = arguments.solutions - trials.solutions();
    if (arguments.baseline == "random") return experiments::random_paintings(trials, left, arguments.seed);
    if (arguments.baseline == "greedy") return experiments::greedy_swaps(trials, start, left);
    if (arguments.baseline == "annealing") return experiments::annealing(trials, start, left, arguments.seed);
    if (arguments.baseline == "table") {
        const long swaps =
            design::design(instance.project, nullptr, instance.target, options_of(arguments, instance))
                .swaps_scored;
        return experiments::table_annealing(trials, start, {left, swaps}, arguments.seed);
    }
    if (arguments.baseline == "cmaes") {
        const auto order =
            experiments::from_soft_to_stiff(instance.project, trials.parts().candidates.patterns());
        return experiments::cma_es(trials, order, left, arguments.seed);
    }
    throw base::InputError("'" + arguments.baseline +
                           "' is no baseline: expected random, greedy, annealing, table or cmaes");
}

/// The same instance by another search, which begins with the same uniform paintings, and has as many
/// solutions.
void print_baseline(const Arguments& arguments, const Instance& instance) {
    experiments::Row row = row_of(arguments, instance, arguments.baseline);
    const double before = processor_seconds();
    const design::DesignOptions options = options_of(arguments, instance);
    design::detail::Preparation preparation =
        design::detail::prepare(instance.project, nullptr, instance.target, options);
    Trials trials(std::move(preparation.parts));
    const design::detail::TimeLimit time(0.0);
    design::DesignReport report;
    design::detail::Search search(trials, options, time, report);
    const Point start = search.try_uniform(preparation.palette, preparation.coordinates).front().point;
    const experiments::Baseline found = search_otherwise(arguments, instance, trials, start);
    row.error =
        design::detail::check_in_full(trials, found.point, design::detail::BeamDemand::None, {}).error.mean;
    row.seconds = processor_seconds() - before;
    row.solutions = trials.solutions();
    row.swaps = found.swaps;
    row.full_solutions = 1;
    experiments::print(row);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("One design of a lattice of hexagons under a tip load, as a row of a table");
    app.add_option("--columns", arguments.columns, "Of hexagons")->check(CLI::Range(1, 1000));
    app.add_option("--rows", arguments.rows, "Of hexagons")->check(CLI::Range(1, 1000));
    app.add_option("--hidden", arguments.hidden, "The hidden painting: graded, patchy, random");
    app.add_option("--patterns", arguments.patterns,
                   "Of the palette, and of the hidden painting: a number, or all");
    app.add_option("--share", arguments.share,
                   "The largest displacement of the hidden painting over the span");
    app.add_option("--angle", arguments.angle, "deg; the target is an arc of this angle");
    app.add_option("--baseline", arguments.baseline,
                   "Another search: random, greedy, annealing, table, cmaes");
    app.add_option("--solutions", arguments.solutions, "Maximum number of nonlinear solutions");
    app.add_option("--seconds", arguments.seconds, "Wall time; 0: any");
    app.add_option("--seed", arguments.seed, "Of the instance and of the search");
    app.add_option("--threads", arguments.threads, "Of the design");
    app.add_option("--max-patterns", arguments.max_patterns, "Maximum number of different patterns");
    app.add_flag("--free-factor", arguments.free_factor, "Search the load's factor, too");
    CLI11_PARSE(app, argc, argv);
    try {
        if (arguments.baseline.empty()) {
            print_design(arguments, instance_of(arguments));
        } else {
            print_baseline(arguments, instance_of(arguments));
        }
    } catch (const base::Error& error) {
        std::fprintf(stderr, "inverse_design: %s\n", error.what());
        return 2;
    }
    return 0;
}
