// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/stopwatch.hpp>
#include <fretwork/library/fill.hpp>
#include <fretwork/reduction/effective_properties.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <string>
#include <system_error>

namespace fretwork::library {
namespace {

struct Task {
    pattern::NamedPattern entry;
    bool needs_responses;
};

struct Outcome {
    PatternData data;
    std::optional<Failure> failure{};
};

/// The patterns that lack a calibration, and whether they lack responses, too.
std::vector<Task> open_tasks(const Library& library, std::span<const pattern::NamedPattern> patterns,
                             const CalibrationKey& key) {
    std::vector<Task> tasks;
    for (const pattern::NamedPattern& entry : patterns) {
        if (library.lacks_calibration(entry.id, key))
            tasks.push_back({entry, library.lacks_responses(entry.id)});
    }
    return tasks;
}

/// Threads compute; the calling thread stores their results.
class Filling {
  public:
    Filling(Library& library, std::span<const pattern::NamedPattern> patterns, const FillOptions& options)
        : library_(library),
          options_(options),
          calibration_options_(options.calibration),
          model_(options.tile_model()),
          key_(options.key()),
          tasks_(open_tasks(library, patterns, key_)) {
        calibration_options_.control = options.control.silent();
    }

    FillReport run() {
        base::SilentProgress silent;
        base::Progress& progress = options_.control.progress != nullptr ? *options_.control.progress : silent;
        report_.open = tasks_.size();
        progress.start("calibrate", tasks_.size());
        std::future<void> computing = start_computing();
        const Abandonment at_exit{is_abandoned_};
        while (computing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            progress.update(wait_for_more());
            if (since_store_.seconds() >= options_.seconds_between_stores) store();
        }
        store();
        progress.update(report_.done + report_.failed);
        progress.finish();
        computing.get();
        return report_;
    }

  private:
    static constexpr auto kProgressPause = std::chrono::milliseconds(100);

    /// A guard that makes the threads skip the remaining tasks when the calling thread leaves run(), for
    /// example because storing has failed.
    struct Abandonment {
        std::atomic<bool>& flag;
        ~Abandonment() { flag = true; }
    };

    std::future<void> start_computing() {
        try {
            return std::async(std::launch::async, [this] {
                base::parallel_for(tasks_.size(), options_.threads,
                                   [this](std::size_t i) { work(tasks_[i]); });
            });
        } catch (const std::system_error& error) {
            throw base::IoError(std::string("no thread can be started, and filling a library needs one: ") +
                                error.what());
        }
    }

    void work(const Task& task) {
        if (is_abandoned_ || options_.control.stop_wanted()) return;
        std::optional<Outcome> outcome = compute(task);
        if (!outcome) return;
        {
            const std::lock_guard lock(finished_mutex_);
            finished_.push_back(std::move(*outcome));
        }
        more_.notify_one();
    }

    /// Wait for further results. Returns the number of patterns finished so far.
    std::size_t wait_for_more() {
        std::unique_lock lock(finished_mutex_);
        more_.wait_for(lock, kProgressPause);
        return report_.done + report_.failed + finished_.size();
    }

    void store() {
        std::vector<Outcome> outcomes;
        {
            const std::lock_guard lock(finished_mutex_);
            outcomes.swap(finished_);
        }
        std::vector<PatternData> batch;
        std::vector<Failure> failures;
        for (Outcome& outcome : outcomes) {
            for (const CalibrationRecord& record : outcome.data.calibrations)
                report_.dead_starts += record.calibration.dead_starts;
            if (outcome.failure) failures.push_back(std::move(*outcome.failure));
            batch.push_back(std::move(outcome.data));
        }
        if (!batch.empty()) {
            const std::lock_guard lock(library_mutex_);
            library_.store(batch, failures);
        }
        report_.failed += failures.size();
        report_.done += batch.size() - failures.size();
        since_store_ = {};
    }

    /// The outcome of a task; empty if the work was stopped meanwhile.
    [[nodiscard]] std::optional<Outcome> compute(const Task& task) {
        Outcome outcome{{task.entry.id, {}, {}, {}}};
        std::vector<reduction::Response> stored;
        if (!task.needs_responses) {
            const std::lock_guard lock(library_mutex_);
            stored = library_.responses(task.entry.id);
        }
        std::string computation = responses_computation();
        try {
            if (task.needs_responses) respond(task.entry.pattern, outcome.data);
            computation = calibration_computation(key_);
            outcome.data.calibrations.push_back(
                calibrate(task.entry.pattern, task.needs_responses ? outcome.data.responses : stored));
        } catch (const base::Stopped&) {
            return std::nullopt;
        } catch (const base::Error& error) {
            outcome.failure = Failure{task.entry.id, computation, one_line(error.what())};
        }
        return outcome;
    }

    void respond(const pattern::Pattern& pattern, PatternData& data) const {
        const reduction::Setting& setting = library_.setting();
        data.responses =
            reduction::compute_responses(library_.layout(), pattern, setting,
                                         {.estimate_error = true, .control = calibration_options_.control});
        // Homogenization needs a polygon that tiles the plane by translations.
        if (setting.sides != 4 && setting.sides != 6) return;
        data.properties =
            reduction::property_values(reduction::effective_properties(library_.layout(), pattern, setting));
    }

    [[nodiscard]] CalibrationRecord calibrate(const pattern::Pattern& pattern,
                                              const std::vector<reduction::Response>& responses) const {
        const base::Stopwatch watch;
        CalibrationRecord record;
        record.calibration = reduction::calibrate(
            model_, {library_.layout(), pattern, library_.setting(), responses}, calibration_options_);
        record.budget = key_.budget;
        record.seconds = watch.seconds();
        return record;
    }

    static std::string one_line(std::string text) {
        for (char& c : text) c = c == '\n' ? ' ' : c;
        return text;
    }

    Library& library_;
    const FillOptions& options_;
    /// Options for each calibration. A stop of fill() also stops running calibrations.
    reduction::CalibrationOptions calibration_options_;
    const reduction::TileModel& model_;
    CalibrationKey key_;
    std::vector<Task> tasks_;
    FillReport report_;
    base::Stopwatch since_store_;
    std::atomic<bool> is_abandoned_ = false;
    std::mutex library_mutex_;  ///< a library is used by one thread at a time
    std::mutex finished_mutex_;
    std::condition_variable more_;
    std::vector<Outcome> finished_;
};

}  // namespace

void FillOptions::validate() const {
    (void)tile_model();
    calibration.validate();
    if (!(seconds_between_stores >= 0.0))
        throw base::InputError("seconds_between_stores: must not be negative");
    if (threads < 0) throw base::InputError("threads: " + std::to_string(threads) + " must not be negative");
}

const reduction::TileModel& FillOptions::tile_model() const {
    return reduction::find_tile_model(model, models);
}

CalibrationKey FillOptions::key() const {
    return calibration_key(calibration, tile_model());
}

FillReport fill(Library& library, std::span<const pattern::NamedPattern> patterns,
                const FillOptions& options) {
    options.validate();
    return Filling(library, patterns, options).run();
}

}  // namespace fretwork::library
