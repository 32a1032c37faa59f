// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern_choice.hpp"
#include "verbs.hpp"

#include <fretwork/base/detail/json_text.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/model_catalogue.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>

namespace fretwork::app {
namespace {

using base::detail::Json;
using library::Library;
using library::PatternEntry;
using reduction::Preparation;

constexpr const char* kExample = R"(
Stopped at any moment, it goes on where it was when it is started again.

Examples:
  fretwork enumerate --library lib.db && fretwork calibrate --library lib.db
  fretwork calibrate --library lib.db --patterns sample:24 --starts 8
  fretwork calibrate --library part2.db --shard 2/4)";

/// What a person asks for.
struct Wishes {
    std::string library_path;
    std::string setting_path;
    std::string patterns = "all";
    std::string model = "paper6";
    std::string shard;
    reduction::CalibrationOptions options;
    int threads = 0;
    bool json = false;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Set by Ctrl-C: what has begun is finished, what is done is stored.
volatile std::sig_atomic_t interrupted = 0;
extern "C" void note_interrupt(int) {
    interrupted = 1;
}

/// Ctrl-C and a polite kill only set the flag as long as this lives.
class InterruptGuard {
  public:
    InterruptGuard()
        : int_(std::signal(SIGINT, note_interrupt)), term_(std::signal(SIGTERM, note_interrupt)) {}
    ~InterruptGuard() {
        std::signal(SIGINT, int_);
        std::signal(SIGTERM, term_);
    }
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

  private:
    void (*int_)(int);
    void (*term_)(int);
};

/// One line, whatever an exception says.
std::string one_line(std::string text) {
    for (char& c : text) c = c == '\n' ? ' ' : c;
    return text;
}

/// The whole task: what is missing, and what is made of it.
class CalibrationRun {
  public:
    CalibrationRun(Library& library, const Wishes& wishes)
        : library_(library),
          wishes_(wishes),
          model_(reduction::find_reduced_model(wishes.model)),
          key_(model_.preparation == Preparation::Calibration
                   ? library::calibration_key(wishes.options, wishes.model)
                   : library::CalibrationKey{.model = wishes.model, .optimizer = "none"}) {}

    /// Compute what is missing of these patterns, batch by batch; each batch is one transaction.
    void run(const std::vector<PatternEntry>& patterns) {
        const std::vector<Task> tasks = open_tasks(patterns);
        base::TerminalProgress progress;
        progress.start("calibrate", tasks.size());
        const std::size_t batch = 16 * static_cast<std::size_t>(base::resolved_thread_count(wishes_.threads));
        for (std::size_t begin = 0; begin < tasks.size() && interrupted == 0; begin += batch) {
            const std::size_t end = std::min(begin + batch, tasks.size());
            run_batch(std::span(tasks).subspan(begin, end - begin));
            progress.update(end);
        }
        progress.finish();
        open_count_ = tasks.size();
    }

    [[nodiscard]] std::size_t open_count() const { return open_count_; }
    [[nodiscard]] std::size_t done_count() const { return done_count_; }
    [[nodiscard]] std::size_t failed_count() const { return failed_count_; }
    [[nodiscard]] const library::CalibrationKey& key() const { return key_; }

  private:
    struct Task {
        PatternEntry entry;
        bool needs_responses;
    };
    struct Outcome {
        std::vector<reduction::Response> stored_responses;  ///< read from the library
        library::PatternData data;                          ///< what is new
        std::optional<library::Failure> failure;
    };

    [[nodiscard]] std::vector<Task> open_tasks(const std::vector<PatternEntry>& patterns) const {
        std::set<std::string> without_responses;
        std::set<std::string> without_calibration;
        for (const PatternEntry& entry : library_.patterns_without_responses())
            without_responses.insert(entry.id);
        for (const PatternEntry& entry : library_.patterns_without_calibration(key_)) {
            without_calibration.insert(entry.id);
        }
        std::vector<Task> tasks;
        for (const PatternEntry& entry : patterns) {
            if (without_calibration.contains(entry.id)) {
                tasks.push_back({entry, without_responses.contains(entry.id)});
            }
        }
        return tasks;
    }

    void run_batch(std::span<const Task> tasks) {
        std::vector<Outcome> outcomes(tasks.size());
        // A library serves one thread at a time: read before, store after.
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            outcomes[i].data.pattern = tasks[i].entry.id;
            if (!tasks[i].needs_responses)
                outcomes[i].stored_responses = library_.responses(tasks[i].entry.id);
        }
        base::parallel_for(tasks.size(), wishes_.threads, [&](std::size_t i) {
            if (interrupted == 0) compute(tasks[i], outcomes[i]);
        });
        std::vector<library::PatternData> data;
        std::vector<library::Failure> failures;
        for (Outcome& outcome : outcomes) {
            if (!outcome.data.calibrations.empty()) ++done_count_;
            if (!outcome.data.responses.empty() || !outcome.data.calibrations.empty()) {
                data.push_back(std::move(outcome.data));
            }
            if (outcome.failure) failures.push_back(std::move(*outcome.failure));
        }
        library_.store(data, failures);
        failed_count_ += failures.size();
    }

    void compute(const Task& task, Outcome& outcome) const {
        std::string stage = library::responses_stage();
        const reduction::Setting& setting = library_.setting();
        try {
            if (task.needs_responses) {
                outcome.data.responses =
                    reduction::compute_responses(library_.layout(), task.entry.pattern, setting);
                outcome.data.properties = properties_of(task.entry.pattern);
            }
            stage = library::calibration_stage(key_);
            const auto start = Clock::now();
            const auto& responses = task.needs_responses ? outcome.data.responses : outcome.stored_responses;
            library::CalibrationRecord record;
            record.calibration =
                model_.prepare({library_.layout(), task.entry.pattern, setting, responses}, wishes_.options);
            record.budget = key_.budget;
            record.seconds = seconds_since(start);
            outcome.data.calibrations.push_back(std::move(record));
        } catch (const base::Error& error) {
            outcome.failure = library::Failure{task.entry.id, stage, one_line(error.what())};
        }
    }

    /// Only of polygons whose regular kind tiles the plane by translations.
    [[nodiscard]] std::vector<std::pair<std::string, double>> properties_of(
        const pattern::Pattern& pattern) const {
        const reduction::Setting& setting = library_.setting();
        if (setting.sides != 4 && setting.sides != 6) return {};
        return reduction::property_values(
            reduction::effective_properties(library_.layout(), pattern, setting));
    }

    Library& library_;
    const Wishes& wishes_;
    const reduction::ReducedModelRow& model_;
    library::CalibrationKey key_;
    std::size_t open_count_ = 0;
    std::size_t done_count_ = 0;
    std::size_t failed_count_ = 0;
};

/// What the library now holds of the patterns that were asked for.
struct Statistics {
    std::size_t calibrated = 0;
    double mean = 0.0;
    double deviation = 0.0;  ///< of the population
    std::map<std::string, std::size_t> at_bound;
    std::size_t samples = 0;
    std::size_t not_converged = 0;
    std::size_t unstable = 0;
};

void add_samples(const std::vector<reduction::Response>& responses, Statistics& statistics) {
    for (const reduction::Response& response : responses) {
        for (const auto& sample : response.samples) {
            ++statistics.samples;
            statistics.not_converged += sample.converged ? 0 : 1;
            statistics.unstable += sample.converged && !sample.stable ? 1 : 0;
        }
    }
}

Statistics take_statistics(const Library& library, const std::vector<PatternEntry>& patterns,
                           const library::CalibrationKey& key) {
    Statistics result;
    double sum = 0.0;
    double squares = 0.0;
    for (const PatternEntry& entry : patterns) {
        for (const auto& record : library.calibrations(entry.id)) {
            if (record.key() != key) continue;
            ++result.calibrated;
            sum += record.calibration.objective;
            squares += record.calibration.objective * record.calibration.objective;
            for (const std::string& name : record.calibration.at_bound) ++result.at_bound[name];
            add_samples(library.responses(entry.id), result);
        }
    }
    const double count = std::max<double>(1.0, static_cast<double>(result.calibrated));
    result.mean = sum / count;
    result.deviation = std::sqrt(std::max(0.0, squares / count - result.mean * result.mean));
    return result;
}

void print_text(const Statistics& s, const CalibrationRun& run, double seconds) {
    std::printf("%zu of %zu open patterns done in %.1f s; %zu failed\n", run.done_count(), run.open_count(),
                seconds, run.failed_count());
    std::printf("%zu calibrated with model %s, optimizer %s\n", s.calibrated, run.key().model.c_str(),
                run.key().optimizer.c_str());
    std::printf(
        "objective E: mean %.2f, standard deviation %.2f (paper: 9.7 and 9.9, with largest magnitudes that "
        "it does not print)\n",
        s.mean, s.deviation);
    for (const auto& [name, count] : s.at_bound) std::printf("%s at a bound: %zu\n", name.c_str(), count);
    std::printf("samples: %zu, of which %zu did not converge and %zu are unstable\n", s.samples,
                s.not_converged, s.unstable);
}

void print_json(const Statistics& s, const CalibrationRun& run, double seconds) {
    const Json document = {{"model", run.key().model},
                           {"optimizer", run.key().optimizer},
                           {"open", run.open_count()},
                           {"done", run.done_count()},
                           {"failed", run.failed_count()},
                           {"interrupted", interrupted != 0},
                           {"calibrated", s.calibrated},
                           {"objective_mean", s.mean},
                           {"objective_standard_deviation", s.deviation},
                           {"at_bound", Json(s.at_bound)},
                           {"samples", s.samples},
                           {"samples_not_converged", s.not_converged},
                           {"samples_unstable", s.unstable},
                           {"seconds", seconds}};
    std::fputs(base::detail::json_text(document).c_str(), stdout);
}

ExitCode calibrate(const Wishes& wishes) {
    wishes.options.validate();
    auto library = Library::open(wishes.library_path, library::Access::ReadWrite);
    if (!wishes.setting_path.empty()) library.adopt_setting(reduction::read_setting(wishes.setting_path));
    const auto patterns = in_shard(wanted_patterns(library, wishes.patterns), wishes.shard);
    CalibrationRun run(library, wishes);
    const auto start = Clock::now();
    {
        const InterruptGuard guard;
        run.run(patterns);
    }
    const double seconds = seconds_since(start);
    const Statistics statistics = take_statistics(library, patterns, run.key());
    wishes.json ? print_json(statistics, run, seconds) : print_text(statistics, run, seconds);
    if (interrupted != 0)
        std::fputs("fretwork: interrupted; what is done is stored, run again to go on\n", stderr);
    return run.done_count() == run.open_count() ? ExitCode::Done : ExitCode::DidNotSucceed;
}

std::string optimizer_help() {
    std::string text = "The method that fits the model:";
    for (const auto& row : optimization::optimizer_catalogue()) {
        text += "\n" + std::string(row.name) + ": " + std::string(row.summary);
    }
    return text;
}

std::string model_help() {
    std::string text = "The reduced model:";
    for (const auto& row : reduction::reduced_model_catalogue()) {
        text += "\n" + std::string(row.name) + ": " + std::string(row.summary);
    }
    return text;
}

}  // namespace

void add_calibrate(CLI::App& app, ExitCode& exit_code) {
    const auto wishes = std::make_shared<Wishes>();
    CLI::App* verb = app.add_subcommand(
        "calibrate", "Compute the responses of a library's patterns, and fit a reduced model to each.");
    verb->add_option("--library", wishes->library_path, "The library: patterns in, results out")->required();
    verb->add_option("--setting", wishes->setting_path,
                     "Material, section, tile side and scenarios, for a library that has no results yet");
    verb->add_option("--patterns", wishes->patterns,
                     "all, ids joined by commas, or sample:N for N spread over the numbers of edges")
        ->capture_default_str();
    verb->add_option("--model", wishes->model, model_help())->capture_default_str();
    verb->add_option("--optimizer", wishes->options.optimizer, optimizer_help())->capture_default_str();
    verb->add_option("--starts", wishes->options.starts, "Descents from different points")
        ->capture_default_str();
    verb->add_option("--budget", wishes->options.budget, "Evaluations of the objective at most")
        ->capture_default_str();
    verb->add_option("--seed", wishes->options.seed, "What random numbers begin with")->capture_default_str();
    verb->add_option("--threads", wishes->threads, "Threads to use; 0: all there are")
        ->check(CLI::NonNegativeNumber);
    verb->add_option("--shard", wishes->shard, "Only the I-th of N parts, as I/N: for several machines");
    verb->add_flag("--json", wishes->json, "Print for programs");
    verb->footer(kExample);
    verb->callback([wishes, &exit_code] { exit_code = calibrate(*wishes); });
}

}  // namespace fretwork::app
