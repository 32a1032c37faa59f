// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_problems.hpp"
#include "comparison_runs.hpp"
#include "interrupt.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/sampling.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

namespace fretwork::app {
namespace {

using optimization::ComparisonTable;
using optimization::Contender;
using optimization::RunKey;
using optimization::RunRecord;

/// Apart from the seeds of the runs, which are hashes.
constexpr std::uint64_t kReferenceSeed = 1'000'003;
constexpr const char* kKnownHeader = "problem,best_value,scale,found_by";

struct Task {
    RunKey key;
    Contender contender;
};

std::vector<Task> missing_tasks(const ComparisonPlan& plan, const ComparisonTable& table) {
    std::vector<Task> tasks;
    for (int repetition = 1; repetition <= plan.repetitions; ++repetition) {
        for (const std::string& problem : plan.problems) {
            for (const Contender& contender : plan.contenders) {
                if (repetition > repetitions_of(contender, plan.repetitions)) continue;
                Task task{{problem, std::string(contender.method->name), repetition}, contender};
                if (!table.contains(task.key)) tasks.push_back(std::move(task));
            }
        }
    }
    return tasks;
}

/// Problems that were made once; making one takes longer than some runs. Threads may share it, and one makes
/// a problem while others get theirs.
class ProblemStore {
  public:
    const ComparisonProblem& get(const std::string& id) {
        Entry& entry = entry_of(id);
        std::call_once(entry.made, [&] { entry.problem = make_comparison_problem(id); });
        return *entry.problem;
    }

  private:
    struct Entry {
        std::once_flag made;
        std::optional<ComparisonProblem> problem;
    };
    Entry& entry_of(const std::string& id) {
        const std::lock_guard lock(mutex_);
        return entries_[id];
    }
    std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

/// Takes what threads have done, in any order: the table sorts it.
class TableWriter {
  public:
    TableWriter(ComparisonTable table, std::filesystem::path path, std::size_t tasks)
        : table_(std::move(table)), path_(std::move(path)) {
        progress_.start("compare optimizers", tasks);
    }

    void add(const RunRecord& record) {
        const std::lock_guard lock(mutex_);
        table_.add(record);
        progress_.update(++runs_done_);
        if (Clock::now() >= next_write_) write();
    }

    void finish() {
        progress_.finish();
        write();
    }

  private:
    using Clock = std::chrono::steady_clock;

    /// Every few seconds, but at most a twentieth of the time goes into it: a whole table is tens of
    /// megabytes.
    void write() {
        constexpr std::chrono::seconds kLeastPause(5);
        constexpr int kPausePerWrite = 19;
        const auto begin = Clock::now();
        base::write_file_atomically(path_, table_.csv());
        const auto end = Clock::now();
        next_write_ = end + std::max<Clock::duration>(kLeastPause, kPausePerWrite * (end - begin));
    }

    std::mutex mutex_;
    ComparisonTable table_;
    std::filesystem::path path_;
    base::TerminalProgress progress_;
    std::size_t runs_done_ = 0;
    Clock::time_point next_write_ = Clock::now();
};

ComparisonTable table_so_far(const std::filesystem::path& path, const ComparisonPlan& plan) {
    if (!std::filesystem::exists(path)) return {};
    return {base::read_text_file(path), path.string(), plan.options, plan.contenders};
}

double median_value(const optimization::Problem& problem) {
    constexpr int kPoints = 1001;
    const optimization::LowDiscrepancySequence sequence(problem.bounds().dimension(), kReferenceSeed);
    std::vector<double> values;
    for (int i = 0; i < kPoints; ++i) {
        values.push_back(
            problem.value(problem.bounds().at_shares(sequence.point(static_cast<std::uint64_t>(i)))));
    }
    std::ranges::nth_element(values, values.begin() + kPoints / 2);
    return values[kPoints / 2];
}

KnownValue find_known_value(const std::string& id, int starts) {
    const ComparisonProblem entry = make_comparison_problem(id);
    if (entry.best_value) {
        // The objective of a calibration has no unit; that of a good fit is of the order of 1.
        const double scale =
            family_of(id) == "synthetic" ? 1.0 : median_value(*entry.problem) - *entry.best_value;
        return {id, *entry.best_value, scale, "construction"};
    }
    KnownValue known{id, 0.0, 0.0, ""};
    for (const char* name : {"gauss-newton-multistart", "ceres-multistart"}) {
        const auto report = minimize(*entry.problem, optimization::find_optimizer(name),
                                     {.starts = starts, .seed = kReferenceSeed},
                                     {.cost = std::numeric_limits<long>::max() / 2});
        if (!known.found_by.empty() && report.value >= known.best_value) continue;
        known.best_value = report.value;
        known.found_by = std::string(name) + " with " + std::to_string(starts) + " starts";
    }
    known.scale = known.best_value;
    return known;
}

KnownValue read_known_value(const std::vector<std::string>& cells, const std::string& file,
                            const std::string& place) {
    const auto value = base::read_number<double>(cells[1]);
    const auto scale = base::read_number<double>(cells[2]);
    if (!value || !std::isfinite(*value))
        throw base::InputError(file, place, "best_value '" + cells[1] + "' is no finite number");
    if (!scale || !std::isfinite(*scale) || *scale <= 0.0)
        throw base::InputError(file, place, "scale '" + cells[2] + "' is no finite number above zero");
    return {cells[0], *value, *scale, cells[3]};
}

}  // namespace

ComparisonSummary run_comparison(const ComparisonPlan& plan, const std::filesystem::path& path) {
    plan.options.validate();
    ComparisonTable table = table_so_far(path, plan);
    const std::vector<Task> tasks = missing_tasks(plan, table);
    const std::size_t runs_before = table.size();
    ProblemStore store;
    TableWriter writer(std::move(table), path, tasks.size());
    std::atomic<std::size_t> left_out = 0;
    const LongWork work;
    base::parallel_for(tasks.size(), plan.threads, [&](std::size_t i) {
        if (work.is_stopped()) {
            ++left_out;
            return;
        }
        const Task& task = tasks[i];
        const ComparisonProblem& entry = store.get(task.key.problem);
        writer.add(record_run(*entry.problem, task.contender, task.key, plan.options, entry.optimum));
    });
    writer.finish();
    return {runs_before, tasks.size() - left_out, left_out};
}

std::vector<KnownValue> read_known_values(const std::filesystem::path& path) {
    const auto lines = base::split(base::read_text_file(path), '\n');
    if (lines.front() != kKnownHeader) {
        throw base::InputError(path.string(), "line 1", std::string("must be the header ") + kKnownHeader);
    }
    std::vector<KnownValue> values;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const auto cells = base::split(lines[i], ',');
        if (cells.size() != 4) {
            throw base::InputError(path.string(), "line " + std::to_string(i + 1),
                                   "'" + lines[i] + "' must have 4 columns: " + kKnownHeader);
        }
        values.push_back(read_known_value(cells, path.string(), "line " + std::to_string(i + 1)));
        if (std::ranges::count(values, cells[0], &KnownValue::problem) > 1)
            throw base::InputError(path.string(), "line " + std::to_string(i + 1),
                                   "problem " + cells[0] + " stands in the file already");
    }
    return values;
}

std::string known_values_csv(const std::vector<KnownValue>& values) {
    std::string text = std::string(kKnownHeader) + "\n";
    for (const KnownValue& value : values) {
        text += value.problem + "," + base::format_number(value.best_value) + "," +
                base::format_number(value.scale) + "," + value.found_by + "\n";
    }
    return text;
}

std::vector<KnownValue> find_known_values(const std::vector<std::string>& problems, int starts, int threads) {
    std::vector<KnownValue> values(problems.size());
    base::parallel_for(problems.size(), threads,
                       [&](std::size_t i) { values[i] = find_known_value(problems[i], starts); });
    return values;
}

void improve_known_values(std::vector<KnownValue>& values, const std::filesystem::path& results) {
    constexpr double kRoundOff = 1e-9;
    const auto lines = base::split(base::read_text_file(results), '\n');
    if (lines.front() != optimization::comparison_header()) {
        throw base::InputError(results.string(), "line 1", "is not the header of a table of runs");
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const auto cells = base::split(lines[i], ',');
        const auto value = std::ranges::find(values, cells[0], &KnownValue::problem);
        if (value == values.end() || value->found_by == "construction") continue;
        const double found = cells.size() > 9 ? base::read_number<double>(cells[9]).value_or(-1.0) : -1.0;
        if (!(found >= 0.0))
            throw base::InputError(results.string(), "line " + std::to_string(i + 1),
                                   "has no best_value from 0 on, as the objective of a calibration is");
        if (found >= value->best_value * (1.0 - kRoundOff)) continue;
        *value = {cells[0], found, found, cells[1] + " in repetition " + cells[2] + " of the comparison"};
    }
}

}  // namespace fretwork::app
