// SPDX-License-Identifier: GPL-3.0-or-later
// Small instances whose every painting is solved: how often the search finds the best one. README.md.
#include "instances.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/preparation.hpp>
#include <fretwork/design/search/search.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

using namespace fretwork;
using design::detail::Point;
using design::detail::Trial;
using design::detail::Trials;

struct Arguments {
    int columns = 7;
    int rows = 1;
    std::string patterns = "5";
    int targets = 10;
    std::uint64_t seed = 1;  ///< of the palette and of the targets
    bool enumerate = false;
    int only = -1;  ///< number of the only target that is searched for; below zero: all
    int solutions = 0;
};

constexpr double kShare = 0.4;

/// The surface, its palette, and the tip force that bends one random painting of it to 0.4 of its span.
struct Instance {
    simulation::Project project;
    std::vector<pattern::NamedPattern> palette;
    std::vector<design::Target> targets;
};

Instance instance_of(const Arguments& arguments) {
    Instance instance;
    instance.project = experiments::lattice(arguments.columns, arguments.rows);
    instance.palette = experiments::palette(arguments.patterns, arguments.seed);
    simulation::Project hidden = instance.project;
    experiments::paint(hidden, {experiments::Hidden::Random, instance.palette, arguments.seed});
    instance.project.load_cases = {experiments::tip_load(experiments::force_for(hidden, kShare))};
    base::SplitMix64 random(base::SplitMix64::mix(1000 + arguments.seed));
    for (int i = 0; i < arguments.targets; ++i) {
        experiments::Bend bend;
        bend.angle = 2.0 * kShare * (0.6 + 0.6 * random.share());
        bend.first = 1.2 * (random.share() - 0.5);
        bend.second = 1.2 * (random.share() - 0.5);
        bend.twist = 0.2 * (random.share() - 0.5);
        instance.targets.push_back(experiments::bent(instance.project, bend));
    }
    return instance;
}

design::DesignOptions options_of(const Arguments& arguments, const Instance& instance) {
    design::DesignOptions options;
    options.load_case = "tip";
    options.palette = instance.palette;
    if (arguments.solutions > 0) options.most_solutions = arguments.solutions;
    options.seed = arguments.seed;
    options.threads = 1;
    return options;
}

std::string digits(const std::vector<std::size_t>& patterns) {
    std::string text;
    for (const std::size_t pattern : patterns) text += std::to_string(pattern);
    return text;
}

/// Goes through all paintings so that neighbours differ in one tile (the reflected Gray code of base n).
class PaintingCounter {
  public:
    PaintingCounter(std::size_t tiles, std::size_t patterns)
        : patterns_(patterns), digits_(tiles, 0), steps_(tiles, 1) {}
    [[nodiscard]] const std::vector<std::size_t>& painting() const { return digits_; }
    /// Returns false after the last one.
    bool next() {
        for (std::size_t i = 0; i < digits_.size(); ++i) {
            const bool is_at_end = steps_[i] > 0 ? digits_[i] + 1 == patterns_ : digits_[i] == 0;
            if (!is_at_end) {
                digits_[i] += static_cast<std::size_t>(steps_[i]);
                return true;
            }
            steps_[i] = -steps_[i];
        }
        return false;
    }

  private:
    std::size_t patterns_;
    std::vector<std::size_t> digits_;
    std::vector<std::ptrdiff_t> steps_;
};

/// The best of all paintings for each target. One solution of a painting serves all targets.
void print_enumeration(const Arguments& arguments, const Instance& instance) {
    std::vector<Trials> judges;
    for (const design::Target& target : instance.targets)
        judges.emplace_back(
            design::detail::prepare(instance.project, nullptr, target, options_of(arguments, instance))
                .parts);
    Trials& solver = judges.front();
    Point point = solver.uniform(0);
    struct Best {
        double objective = std::numeric_limits<double>::infinity();
        std::vector<std::size_t> painting;
    };
    std::vector<Best> best(judges.size());
    PaintingCounter counter(point.patterns.size(), solver.parts().candidates.patterns().size());
    int unstable = 0;
    do {
        point.patterns = counter.painting();
        const Trial trial = solver.solve(point, {});
        if (!trial.is_found) ++unstable;
        for (std::size_t t = 0; trial.is_found && t < judges.size(); ++t) {
            const double objective = judges[t].objective_of(trial.displacements);
            if (objective < best[t].objective) best[t] = {objective, point.patterns};
        }
    } while (counter.next());
    for (std::size_t t = 0; t < best.size(); ++t)
        std::printf("%llu,%zu,%.12g,%s,%d,%d\n", static_cast<unsigned long long>(arguments.seed), t,
                    best[t].objective, digits(best[t].painting).c_str(), solver.solutions(), unstable);
}

/// The search with the reduced model alone, as a design makes it before the check with all beams.
void print_designs(const Arguments& arguments, const Instance& instance) {
    for (std::size_t t = 0; t < instance.targets.size(); ++t) {
        if (arguments.only >= 0 && static_cast<std::size_t>(arguments.only) != t) continue;
        const design::DesignOptions options = options_of(arguments, instance);
        const auto started = std::chrono::steady_clock::now();
        design::detail::Preparation preparation =
            design::detail::prepare(instance.project, nullptr, instance.targets[t], options);
        Trials trials(preparation.parts);
        const design::detail::TimeLimit time(0.0);
        design::DesignReport report;
        design::detail::Search search(trials, options, time, report);
        const std::vector<std::size_t>& palette = preparation.palette;
        const std::vector<design::detail::Solved> starts =
            search.try_uniform(palette, preparation.coordinates);
        search.set_columns(palette, palette);
        design::detail::Solved found = search.improve(starts.front(), 0.0);
        found = search.improve_from_others(std::move(found), starts, 0.0, search.left_for_defect());
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        std::printf("%llu,%zu,%.12g,%s,%d,%zu,%.4f\n", static_cast<unsigned long long>(arguments.seed), t,
                    found.trial.objective, digits(found.point.patterns).c_str(), trials.solutions(),
                    report.start_misfits.size(), seconds);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Small instances whose every painting is solved: one palette and several targets");
    app.add_option("--columns", arguments.columns, "Of hexagons")->check(CLI::Range(1, 20));
    app.add_option("--rows", arguments.rows, "Of hexagons")->check(CLI::Range(1, 20));
    app.add_option("--patterns", arguments.patterns, "Of the palette");
    app.add_option("--targets", arguments.targets, "Of this palette")->check(CLI::Range(1, 1000));
    app.add_option("--seed", arguments.seed, "Of the palette and of the targets");
    app.add_option("--only", arguments.only, "Number of the only target to search for, from 0");
    app.add_option("--solutions", arguments.solutions,
                   "Maximum number of nonlinear solutions of the search; 0: the default");
    app.add_flag("--enumerate", arguments.enumerate, "Solve every painting instead of searching");
    CLI11_PARSE(app, argc, argv);
    try {
        const Instance instance = instance_of(arguments);
        if (arguments.enumerate)
            print_enumeration(arguments, instance);
        else
            print_designs(arguments, instance);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "inverse_design_small: %s\n", error.what());
        return 2;
    }
    return 0;
}
