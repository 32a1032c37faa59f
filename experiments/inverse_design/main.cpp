// SPDX-License-Identifier: GPL-3.0-or-later
// One design and its baselines, as a row of a table: README.md.
#include "baselines.hpp"
#include "instances.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/full_check.hpp>
#include <fretwork/design/search/preparation.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

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
    int solutions = 60;
    std::uint64_t seed = 1;
    int threads = 2;
    bool free_factor = false;
    std::size_t max_patterns = 0;
};

struct Instance {
    simulation::Project project;
    design::Target target;
    std::vector<pattern::NamedPattern> palette;
    double bent = 0.0;  ///< the largest displacement of the target over the span
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

/// Seconds of a corotational solution from rest, the best of five: the unit of time.
double unit_seconds(const Instance& instance, int threads) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i)
        best = std::min(best, simulation::simulate(simulation::make_surface(instance.project, nullptr),
                                                   instance.project.load_cases.front(),
                                                   {.model = "corotational", .threads = threads})
                                  .seconds);
    return best;
}

void print_design(const Arguments& arguments, const Instance& instance) {
    const double unit = unit_seconds(instance, arguments.threads);
    const design::DesignReport report =
        design::design(instance.project, nullptr, instance.target, options_of(arguments, instance));
    const double error = report.error ? report.error->mean : NAN;
    const double uniform = report.best_uniform ? report.best_uniform->mean : NAN;
    double half = NAN;  // time to half of the first misfit
    for (const design::DesignProgress& own : report.history) {
        if (std::isnan(half) && own.misfit <= 0.5 * std::min(1.0, uniform)) half = own.seconds;
    }
    std::printf("design,%d,%s,%s,%llu,%.3f,%.6f,%.6f,%.4f,%d,%d,%zu,%.3f,%.5f,%.0f,%.0f,%.6f,%s\n",
                arguments.columns * arguments.rows, arguments.angle > 0.0 ? "arc" : arguments.hidden.c_str(),
                arguments.patterns.c_str(), static_cast<unsigned long long>(arguments.seed), instance.bent,
                uniform, error, error / uniform, report.solutions, report.full_solutions,
                report.patterns.size(), report.seconds, unit, report.seconds / unit, half / unit,
                report.model_error, std::string(design::design_end_name(report.end)).c_str());
}

/// The same instance by another search, which begins with the best of the same uniform paintings.
void print_baseline(const Arguments& arguments, const Instance& instance) {
    const auto started = std::chrono::steady_clock::now();
    design::detail::Preparation preparation =
        design::detail::prepare(instance.project, nullptr, instance.target, options_of(arguments, instance));
    Trials trials(std::move(preparation.parts));
    Point start;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < std::min<std::size_t>(24, preparation.palette.size()); ++p) {
        const Point point = trials.uniform(preparation.palette[p]);
        const design::detail::Trial trial = trials.solve(point, {});
        if (!trial.is_found || trial.objective >= best) continue;
        best = trial.objective;
        start = point;
    }
    const double uniform =
        design::detail::check_in_full(trials, start, design::detail::BeamDemand::None, {}).error.mean;
    const int left = arguments.solutions - trials.solutions();
    experiments::Baseline found;
    if (arguments.baseline == "random") {
        found = experiments::random_paintings(trials, left, arguments.seed);
    } else if (arguments.baseline == "greedy") {
        found = experiments::greedy_swaps(trials, start, left);
    } else if (arguments.baseline == "annealing") {
        found = experiments::annealing(trials, start, left, arguments.seed);
    } else {
        throw base::InputError("'" + arguments.baseline +
                               "' is no baseline: expected random, greedy or annealing");
    }
    const double error =
        design::detail::check_in_full(trials, found.point, design::detail::BeamDemand::None, {}).error.mean;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    std::printf("%s,%d,%s,%s,%llu,%.3f,%.6f,%.6f,%.4f,%d,2,,%.3f,,,,,\n", arguments.baseline.c_str(),
                arguments.columns * arguments.rows, arguments.hidden.c_str(), arguments.patterns.c_str(),
                static_cast<unsigned long long>(arguments.seed), instance.bent, uniform, error,
                error / uniform, trials.solutions(), seconds);
}

/// Every painting of a small instance, and the design on the same reduced model.
void print_enumeration(const Arguments& arguments) {
    Arguments small = arguments;
    Instance instance = instance_of(small);
    // A target that no painting reaches: an arc whose size a random painting has.
    instance.target = experiments::arc(
        instance.project, 2.0 * instance.bent * (0.6 + 0.4 * base::SplitMix64(arguments.seed).share()));
    design::DesignOptions options = options_of(small, instance);
    design::detail::Preparation preparation =
        design::detail::prepare(instance.project, nullptr, instance.target, options);
    Trials trials(std::move(preparation.parts));
    const std::size_t patterns = trials.parts().candidates.patterns().size();
    Point point = trials.uniform(0);
    double best = std::numeric_limits<double>::infinity();
    const auto total = static_cast<std::size_t>(
        std::pow(static_cast<double>(patterns), static_cast<double>(point.patterns.size())));
    for (std::size_t number = 0; number < total; ++number) {
        std::size_t rest = number;
        for (std::size_t& pattern : point.patterns) {
            pattern = rest % patterns;
            rest /= patterns;
        }
        const design::detail::Trial trial = trials.solve(point, {});
        if (trial.is_found) best = std::min(best, trial.objective);
    }
    const design::DesignReport report = design::design(instance.project, nullptr, instance.target, options);
    const double misfit = std::ranges::min(report.starts);  // before the aim is moved by the model's error
    const double found = misfit * misfit;
    std::printf("enumerate,%zu,arc,%s,%llu,%.3f,,,%.6f,%d,%d,,%.3f,,,,,\n", point.patterns.size(),
                arguments.patterns.c_str(), static_cast<unsigned long long>(arguments.seed), instance.bent,
                found / best, report.solutions, report.full_solutions, report.seconds);
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
                   "Another search: random, greedy, annealing; or enumerate");
    app.add_option("--solutions", arguments.solutions, "Most nonlinear solutions");
    app.add_option("--seconds", arguments.seconds, "Wall time; 0: any");
    app.add_option("--seed", arguments.seed, "Of the instance and of the search");
    app.add_option("--threads", arguments.threads, "Of the design");
    app.add_option("--max-patterns", arguments.max_patterns, "Most different patterns");
    app.add_flag("--free-factor", arguments.free_factor, "Search the load's factor, too");
    CLI11_PARSE(app, argc, argv);
    try {
        if (arguments.baseline == "enumerate") {
            print_enumeration(arguments);
        } else if (arguments.baseline.empty()) {
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
