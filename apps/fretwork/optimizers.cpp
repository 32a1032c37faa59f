// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork optimizers: the methods there are, and how they compare.
#include "comparison_landscape.hpp"
#include "comparison_problems.hpp"
#include "comparison_runs.hpp"
#include "verbs.hpp"

#include <fretwork/base/detail/json_text.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/text.hpp>

#include <chrono>
#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

using base::detail::Json;
using optimization::Contender;

constexpr const char* kExamples = R"(
Examples:
  fretwork optimizers list
  fretwork optimizers known --out known.csv
  fretwork optimizers run --known known.csv --problems calibration:4,analytic --repetitions 2 --out DIR)";

struct Wishes {
    std::string out;
    std::string known;
    std::string results;
    std::string problems = "all";
    std::string optimizers = "all";
    std::size_t patterns = 60;
    int starts = 300;
    ComparisonPlan plan;
    int descents = LandscapeOptions{}.descents;
    bool json = false;
};

void print(const Json& document) {
    std::fputs(base::detail::json_text(document).c_str(), stdout);
}

// ---- list ----

ExitCode list(const Wishes& wishes) {
    Json rows = Json::array();
    for (const Contender& contender : optimization::default_contenders()) {
        const auto& row = *contender.method;
        if (wishes.json) {
            rows.push_back({{"name", row.name},
                            {"class", optimizer_class_name(row.kind)},
                            {"needs", evaluation_name(row.needs)},
                            {"starts_in_comparison", contender.starts},
                            {"summary", row.summary}});
        } else {
            std::printf("%-24s %-7s %-10s %s\n", std::string(row.name).c_str(),
                        std::string(optimizer_class_name(row.kind)).c_str(),
                        std::string(evaluation_name(row.needs)).c_str(), std::string(row.summary).c_str());
        }
    }
    if (wishes.json) print({{"optimizers", rows}});
    return ExitCode::Done;
}

// ---- known ----

ExitCode known(const Wishes& wishes) {
    if (wishes.starts < 1) throw base::InputError("--starts", "", "must be at least 1");
    auto values = wishes.known.empty() ? find_known_values(comparison_problem_ids(wishes.patterns),
                                                           wishes.starts, wishes.plan.threads)
                                       : read_known_values(wishes.known);
    if (!wishes.results.empty()) improve_known_values(values, wishes.results);
    base::write_file_atomically(wishes.out, known_values_csv(values));
    if (wishes.json) {
        print({{"problems", values.size()}, {"out", wishes.out}});
    } else {
        std::printf("%zu problems with their best known values are in %s\n", values.size(),
                    wishes.out.c_str());
    }
    return ExitCode::Done;
}

// ---- run ----

std::vector<Contender> wanted_contenders(const std::string& wish) {
    const auto all = optimization::default_contenders();
    if (wish == "all") return all;
    std::vector<Contender> chosen;
    for (const std::string& name : base::split(wish, ',')) {
        const auto* row = &optimization::find_optimizer(name);
        chosen.push_back(*std::ranges::find(all, row, &Contender::method));
    }
    return chosen;
}

/// The problems that a person asks for, of those in the file of known values.
std::vector<std::string> chosen_problems(const Wishes& wishes) {
    std::vector<std::string> ids;
    for (const KnownValue& value : read_known_values(wishes.known)) ids.push_back(value.problem);
    return wanted_problems(ids, wishes.problems);
}

std::filesystem::path made_folder(const std::string& path) {
    std::error_code fault;
    std::filesystem::create_directories(path, fault);
    if (fault) throw base::IoError("--out: cannot make the folder '" + path + "': " + fault.message());
    return path;
}

ExitCode run(Wishes wishes) {
    wishes.plan.problems = chosen_problems(wishes);
    wishes.plan.contenders = wanted_contenders(wishes.optimizers);
    if (wishes.plan.repetitions < 1) throw base::InputError("--repetitions", "", "must be at least 1");
    wishes.plan.options.validate();
    const std::filesystem::path folder = made_folder(wishes.out);
    const auto begin = std::chrono::steady_clock::now();
    const ComparisonSummary summary = run_comparison(wishes.plan, folder / "results.csv");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const std::string path = (folder / "results.csv").string();
    if (wishes.json) {
        print({{"runs_before", summary.runs_before},
               {"runs_done", summary.runs_done},
               {"out", path},
               {"seconds", seconds.count()}});
    } else {
        std::printf("%zu runs in %.1f s, and %zu that were there before, are in %s\n", summary.runs_done,
                    seconds.count(), summary.runs_before, path.c_str());
    }
    if (summary.runs_left_out > 0)
        std::fputs("fretwork: interrupted; what is done is stored, run again to go on\n", stderr);
    return summary.runs_left_out > 0 ? ExitCode::DidNotSucceed : ExitCode::Done;
}

// ---- landscape ----

ExitCode landscape(const Wishes& wishes) {
    if (wishes.descents < 1) throw base::InputError("--descents", "", "must be at least 1");
    const auto problems = chosen_problems(wishes);
    const auto folder = made_folder(wishes.out);
    write_landscape(problems, {.descents = wishes.descents, .threads = wishes.plan.threads}, folder);
    if (wishes.json) {
        print({{"problems", problems.size()}, {"out", wishes.out}});
    } else {
        std::printf("descents.csv and sections.csv of %zu problems are in %s\n", problems.size(),
                    wishes.out.c_str());
    }
    return ExitCode::Done;
}

// ---- the command line ----

void add_threads(CLI::App& action, Wishes& wishes) {
    action.add_option("--threads", wishes.plan.threads, "Threads to use; 0: all there are")
        ->check(thread_check());
}

void add_list(CLI::App& verb, const std::shared_ptr<Wishes>& wishes, ExitCode& exit_code) {
    CLI::App* action =
        verb.add_subcommand("list", "List the methods: name, class, what they need, what they are");
    action->add_flag("--json", wishes->json, "Print JSON");
    action->callback([wishes, &exit_code] { exit_code = list(*wishes); });
}

void add_known(CLI::App& verb, const std::shared_ptr<Wishes>& wishes, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand(
        "known", "Choose the problems of a comparison and search their best known values, once for all");
    action->add_option("--out", wishes->out, "The CSV file to write")->required();
    action
        ->add_option("--patterns", wishes->patterns, "Calibration problems, spread over edges and stiffness")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    action->add_option("--starts", wishes->starts, "Descents of each calibrator on each problem")
        ->capture_default_str();
    action->add_option("--from", wishes->known, "Begin with this file instead of searching")
        ->excludes("--patterns")
        ->excludes("--starts");
    action->add_option("--results", wishes->results, "Take over what these runs found lower");
    add_threads(*action, *wishes);
    action->add_flag("--json", wishes->json, "Print JSON");
    action->callback([wishes, &exit_code] { exit_code = known(*wishes); });
}

void add_run(CLI::App& verb, const std::shared_ptr<Wishes>& wishes, ExitCode& exit_code) {
    CLI::App* action =
        verb.add_subcommand("run",
                            "Run methods on problems; goes on where it was stopped. Columns: see "
                            "experiments/optimizer_comparison/README.md");
    action->add_option("--known", wishes->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", wishes->out, "Folder for results.csv")->required();
    action->add_option("--problems", wishes->problems, "all, or ids, families and family:N joined by commas")
        ->capture_default_str();
    action->add_option("--optimizers", wishes->optimizers, "all, or names joined by commas")
        ->capture_default_str();
    action->add_option("--repetitions", wishes->plan.repetitions, "Runs of each method that uses the seed")
        ->capture_default_str();
    action
        ->add_option("--budget", wishes->plan.options.budget.cost,
                     "Of one run, in the problem's unit of cost")
        ->capture_default_str();
    action->add_option("--seed", wishes->plan.options.seed, "Changes the seeds of all runs")
        ->check(seed_check())
        ->capture_default_str();
    add_threads(*action, *wishes);
    action->add_flag("--json", wishes->json, "Print JSON");
    action->callback([wishes, &exit_code] { exit_code = run(*wishes); });
}

void add_landscape(CLI::App& verb, const std::shared_ptr<Wishes>& wishes, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand(
        "landscape", "Tables of where many single descents end, and of sections through the best point");
    action->add_option("--known", wishes->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", wishes->out, "Folder for descents.csv and sections.csv")->required();
    action->add_option("--problems", wishes->problems, "all, or ids, families and family:N joined by commas")
        ->capture_default_str();
    action->add_option("--descents", wishes->descents, "Of each kind on each problem")->capture_default_str();
    add_threads(*action, *wishes);
    action->add_flag("--json", wishes->json, "Print JSON");
    action->callback([wishes, &exit_code] { exit_code = landscape(*wishes); });
}

}  // namespace

void add_optimizers(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand("optimizers", "List the optimizers, and compare them");
    const auto wishes = std::make_shared<Wishes>();
    add_list(*verb, wishes, exit_code);
    add_known(*verb, wishes, exit_code);
    add_run(*verb, wishes, exit_code);
    add_landscape(*verb, wishes, exit_code);
    verb->require_subcommand(1);
    verb->footer(kExamples);
}

}  // namespace fretwork::app
