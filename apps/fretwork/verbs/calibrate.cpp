// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "options/pattern_choice.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <fretwork/base/stopwatch.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/fill.hpp>
#include <fretwork/library/statistics.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <ranges>
#include <set>
#include <span>

namespace fretwork::app {
namespace {

using base::Json;
using library::CalibrationStatistics;
using library::FillReport;
using library::Library;

constexpr const char* kCalibrateExample = R"(
If the command is stopped, the next run continues from there.

Examples:
  fretwork enumerate --library lib.db && fretwork calibrate --library lib.db
  fretwork calibrate --library lib.db --patterns sample:24 --starts 16
  fretwork calibrate --library part2.db --shard 2/4)";

struct CalibrateOptions {
    std::string library_path;
    std::string setting;  ///< a name or a file
    std::string policy;
    std::string patterns = "all";
    std::string shard;
    library::FillOptions fill;
    bool retry = false;
    bool json = false;
};

/// Patterns that failed alike.
struct FailureReason {
    std::string reason;
    std::string example;  ///< a pattern's id
    std::size_t patterns = 0;
};

struct Result {
    library::CalibrationKey key;
    std::string_view policy;
    FillReport report{};
    CalibrationStatistics statistics{};
    std::vector<FailureReason> failures{};  ///< of this run and of earlier ones, most patterns first
    double seconds = 0.0;
    bool is_stopped = false;
    bool is_papers = false;  ///< layout and setting are the paper's; the policy may differ
};

void adopt_setting(Library& library, const CalibrateOptions& options) {
    if (options.setting.empty() && options.policy.empty()) return;
    reduction::Setting setting =
        options.setting.empty() ? library.setting() : reduction::find_setting(options.setting);
    if (!options.policy.empty())
        setting.sample_policy =
            options.policy == "paper" ? reduction::SamplePolicy::Paper : reduction::SamplePolicy::Stable;
    const reduction::Setting before = library.setting();
    library.adopt_setting(setting);
    const reduction::Setting& after = library.setting();
    if (before.strength != after.strength)
        warn("the library's strength is " + base::format_number(after.strength.value_or(0.0) / 1e6) +
             " MPa now");
    if (before.section.shape != after.section.shape)
        warn(std::string("the bars of the library have the section of a ") +
             mechanics::shape_name(mechanics::shape_of(after.section)) + " now");
}

/// Whether layout and setting are the paper's, whatever the policy.
bool is_papers(const Library& library) {
    reduction::Setting papers = reduction::paper_setting();
    papers.sample_policy = library.setting().sample_policy;
    return library.layout().name() == "paper7" &&
           reduction::setting_difference(papers, library.setting()).empty();
}

/// Warns of values that look like errors of units.
void tell_doubts(const reduction::Setting& setting) {
    const std::vector<std::string> doubts = reduction::warnings_about(setting);
    if (!doubts.empty()) warn("is that meant? " + base::join(doubts, "; "));
}

/// The reasons why some of these patterns lack this calibration.
std::vector<FailureReason> failure_reasons(const Library& library,
                                           std::span<const pattern::NamedPattern> patterns,
                                           const library::CalibrationKey& key) {
    std::set<std::string_view> wanted;
    for (const pattern::NamedPattern& entry : patterns) wanted.insert(entry.id);
    std::vector<FailureReason> reasons;
    for (const library::Failure& failure : library.failures()) {
        const bool is_stage = failure.computation == library::responses_computation() ||
                              failure.computation == library::calibration_computation(key);
        if (!is_stage || !wanted.contains(failure.pattern)) continue;
        auto known = std::ranges::find(reasons, failure.reason, &FailureReason::reason);
        if (known == reasons.end())
            known = reasons.insert(known, FailureReason{failure.reason, failure.pattern, 0});
        ++known->patterns;
    }
    std::ranges::stable_sort(reasons, std::greater(), &FailureReason::patterns);
    return reasons;
}

void print_failures(const std::vector<FailureReason>& failures) {
    constexpr std::size_t kShown = 5;
    for (const FailureReason& failure : failures | std::views::take(kShown))
        std::printf("failed: %s, such as %s: %s\n", base::counted(failure.patterns, "pattern").c_str(),
                    failure.example.c_str(), base::printable(failure.reason).c_str());
    if (failures.size() > kShown) std::printf("failed for other reasons, too: see library show\n");
    if (!failures.empty()) std::printf("--retry tries them again\n");
}

void print_text(const Result& result) {
    const CalibrationStatistics& s = result.statistics;
    std::printf("%zu of %zu open patterns done in %.1f s; %zu failed\n", result.report.done,
                result.report.open, result.seconds, result.report.failed);
    print_failures(result.failures);
    std::printf("%zu calibrated with model %s, optimizer %s\n", s.calibrated, result.key.model.c_str(),
                result.key.optimizer.c_str());
    const char* published =
        result.key.model == "paper6" && result.is_papers
            ? " (paper: 9.7 and 9.9, with magnitudes whose number and sizes it does not print)"
            : "";
    std::printf("objective E: mean %.2f, standard deviation %.2f, median %.2f%s\n", s.mean, s.deviation,
                s.median, published);
    for (const auto& [name, count] : s.at_bound) std::printf("%s at a bound: %zu\n", name.c_str(), count);
    std::printf(
        "samples: %zu, of which %zu did not converge (%zu beyond a limit load) and %zu are unstable (policy "
        "%s: %s)\n",
        s.samples, s.samples - s.converged, s.limit_load, s.unstable, std::string(result.policy).c_str(),
        result.policy == "paper" ? "these are fitted, too" : "from the first of them on, not fitted");
}

Json failures_json(const std::vector<FailureReason>& failures) {
    Json list = Json::array();
    for (const FailureReason& failure : failures)
        list.push_back(
            {{"reason", failure.reason}, {"patterns", failure.patterns}, {"example", failure.example}});
    return list;
}

Json far_above_json(const CalibrationStatistics& statistics) {
    Json list = Json::array();
    for (const library::FarAbove& far : statistics.far_above)
        list.push_back({{"pattern", far.pattern}, {"objective", far.objective}});
    return list;
}

void print_json(const Result& result) {
    const CalibrationStatistics& s = result.statistics;
    print_document({{"model", result.key.model},
                    {"optimizer", result.key.optimizer},
                    {"policy", result.policy},
                    {"open", result.report.open},
                    {"done", result.report.done},
                    {"failed", result.report.failed},
                    {"failures", failures_json(result.failures)},
                    {"dead_starts", result.report.dead_starts},
                    {"interrupted", result.is_stopped},
                    {"calibrated", s.calibrated},
                    {"objective_mean", s.mean},
                    {"objective_standard_deviation", s.deviation},
                    {"objective_median", s.median},
                    {"far_above_its_like", far_above_json(s)},
                    {"at_bound", Json(s.at_bound)},
                    {"samples", s.samples},
                    {"samples_not_converged", s.samples - s.converged},
                    {"samples_beyond_limit_load", s.limit_load},
                    {"samples_unstable", s.unstable},
                    {"seconds", result.seconds}});
}

/// Refuses the options of a search for a model that has no parameters.
void refuse_ignored_options(const CLI::App& verb, const CalibrateOptions& options) {
    if (!reduction::find_tile_model(options.fill.model).parameters.empty()) return;
    refuse_given(verb, {"--optimizer", "--starts", "--budget", "--seed"},
                 "is for models with parameters, and " + options.fill.model + " has none");
}

/// Warns of searches that did not end by themselves: their results may be far from the best.
void warn_of_spent_budgets(const Library& library, std::span<const pattern::NamedPattern> patterns,
                           const library::CalibrationKey& key) {
    std::size_t spent = 0;
    std::size_t all = 0;
    for (const pattern::NamedPattern& entry : patterns) {
        for (const library::CalibrationRecord& record : library.calibrations(entry.id)) {
            if (record.key() != key) continue;
            ++all;
            spent += record.calibration.converged ? 0 : 1;
        }
    }
    if (spent > 0)
        warn(std::to_string(spent) + " of " + std::to_string(all) +
             " calibrations ended before their search met its own criterion (the budget of " +
             std::to_string(key.budget) +
             " evaluations was spent, or no step went further down): their E may be too high; raise "
             "--budget, or change --starts");
}

/// Warns of searches that may have failed. Such a search can end with an ordinary number, which stands out
/// only beside those of similar calibrations.
void warn_of_odd_searches(const Result& result) {
    if (result.report.dead_starts > 0)
        warn(std::to_string(result.report.dead_starts) +
             " starts of these searches died at their first point");
    const std::vector<library::FarAbove>& far = result.statistics.far_above;
    if (far.empty()) return;
    const auto worst = std::ranges::max_element(far, {}, &library::FarAbove::objective);
    const bool is_one = far.size() == 1;
    warn(base::counted(far.size(), "calibration") + (is_one ? " is" : " are") + " far above others like " +
         (is_one ? "it" : "them") + " (E over " + base::format_number(result.statistics.far_above_limit) +
         ", where the median is " + base::format_number(result.statistics.median) +
         "), such as E = " + base::format_number(worst->objective) + " of " + worst->pattern +
         ": the search may have failed; try another --seed or more --starts");
}

ExitCode calibrate(CalibrateOptions options) {
    LongWork work;
    options.fill.control = work.control();
    options.fill.validate();
    auto library = Library::open(options.library_path, library::Access::ReadWrite);
    adopt_setting(library, options);
    tell_doubts(library.setting());
    const auto patterns = in_shard(wanted_patterns(library, options.patterns), options.shard);
    if (options.retry) library.forget_failures();
    Result result;
    result.key = options.fill.key();
    result.policy = sample_policy_name(library.setting().sample_policy);
    result.is_papers = is_papers(library);
    const base::Stopwatch watch;
    result.report = library::fill(library, patterns, options.fill);
    result.is_stopped = work.is_stopped();
    result.seconds = watch.seconds();
    result.statistics = library::calibration_statistics(library, patterns, result.key);
    result.failures = failure_reasons(library, patterns, result.key);
    options.json ? print_json(result) : print_text(result);
    warn_of_spent_budgets(library, patterns, result.key);
    warn_of_odd_searches(result);
    if (result.is_stopped) warn("interrupted; what is done is stored, run again to go on");
    const bool is_done = result.report.done == result.report.open && result.statistics.calibrated > 0;
    return is_done ? ExitCode::Done : ExitCode::DidNotSucceed;
}

template <class Rows>
std::string catalogue_help(std::string text, const Rows& rows) {
    for (const auto& row : rows) text += "\n" + std::string(row.name) + ": " + std::string(row.summary);
    return text;
}

void add_method_options(CLI::App& verb, library::FillOptions& fill) {
    constexpr const char* kGroup = "Method";
    verb.add_option("--starts", fill.calibration.starts,
                    "Number of searches, each from another starting point")
        ->capture_default_str()
        ->group(kGroup);
    verb.add_option("--budget", fill.calibration.budget,
                    "Maximum number of evaluations of the objective for one pattern")
        ->capture_default_str()
        ->group(kGroup);
    verb.add_option("--seed", fill.calibration.seed, "Seed of the random numbers")
        ->check(seed_check())
        ->capture_default_str()
        ->group(kGroup);
    verb.add_option(
            "--model", fill.model,
            catalogue_help(
                "The tile model; one without parameters is not fitted, only compared with the responses:",
                reduction::tile_models()))
        ->capture_default_str()
        ->group(kGroup);
    verb.add_option("--optimizer", fill.calibration.optimizer,
                    catalogue_help("The optimizer that fits the model:", optimization::optimizer_catalogue()))
        ->capture_default_str()
        ->group(kGroup);
}

void add_setting_options(CLI::App& verb, CalibrateOptions& options) {
    constexpr const char* kGroup = "Setting, for a library that has no results yet";
    verb.add_option(
            "--setting", options.setting,
            "Setting with material, section, joints, tile side and scenarios: paper, made (as paper, "
            "but with stiff joints), or a setting file (default: the library's setting; a new library "
            "has paper)")
        ->group(kGroup);
    verb.add_option("--policy", options.policy,
                    "Treatment of samples (one for each load magnitude) beyond the first loss of stability:\n"
                    "paper: they are fitted, too\n"
                    "stable: they are left out\n"
                    "(default: as in the setting, else paper)")
        ->check(CLI::IsMember({"paper", "stable"}))
        ->group(kGroup);
}

}  // namespace

void add_calibrate(CLI::App& app, ExitCode& exit_code) {
    const auto options = std::make_shared<CalibrateOptions>();
    CLI::App* verb = app.add_subcommand(
        "calibrate",
        "Compute the responses of a library's patterns, and fit a reduced model to each pattern");
    verb->add_option("--library", options->library_path,
                     "Library with the patterns; the results are added to it")
        ->required();
    verb->add_option("--patterns", options->patterns,
                     "Patterns to calibrate: all; computed (those that have responses); ids joined by "
                     "commas; or sample:N (N patterns, spread over all numbers of edges)")
        ->capture_default_str();
    verb->add_option("--threads", options->fill.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check());
    verb->add_flag("--retry", options->retry, "Try patterns with a recorded failure again");
    verb->add_option("--shard", options->shard,
                     "Only part I of N of the patterns, as I/N, so that several machines can share the work");
    verb->add_flag("--json", options->json,
                   "Print JSON: how many patterns are done, statistics of the objective and of the samples, "
                   "failures, seconds");
    add_setting_options(*verb, *options);
    add_method_options(*verb, options->fill);
    declare_files(*verb, {update("--library", kLibraryFile), input("--setting")});
    verb->footer(kCalibrateExample);
    verb->callback([options, verb, &exit_code] {
        refuse_ignored_options(*verb, *options);
        exit_code = calibrate(*options);
    });
}

}  // namespace fretwork::app
