// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/optimization/studies/run_table.hpp>
#include <fretwork/optimization/studies/study.hpp>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace fretwork::optimization::study {
namespace {

struct Task {
    RunKey key;
    Contender contender;
};

std::vector<Task> missing_tasks(const StudyPlan& plan, const RunTable& table) {
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

/// The problems of a study, each of which is made once, because making a problem takes longer than some runs.
/// Threads may share the store. While one thread makes a problem, another thread can get another problem.
class ProblemStore {
  public:
    explicit ProblemStore(const ProblemFamilies& families) : families_(families) {}
    const StudyProblem& get(const std::string& id) {
        Entry& entry = entry_of(id);
        std::call_once(entry.made, [&] { entry.problem = make_study_problem(id, families_); });
        return *entry.problem;
    }

  private:
    struct Entry {
        std::once_flag made;
        std::optional<StudyProblem> problem;
    };
    Entry& entry_of(const std::string& id) {
        const std::lock_guard lock(mutex_);
        return entries_[id];
    }
    const ProblemFamilies& families_;
    std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

RunTable stored_table(const std::filesystem::path& folder, const StudyPlan& plan) {
    const std::filesystem::path path = run_table_path(folder);
    std::error_code fault;
    if (!std::filesystem::exists(path, fault)) {
        if (fault) throw base::IoError(path.string(), "", "cannot be read: " + fault.message());
        return {};
    }
    return {base::read_text_file(path), path.string(), plan.conditions, plan.contenders};
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (!std::filesystem::is_directory(folder, fault))
        throw base::IoError(folder.string(), "", "cannot be made: " + fault.message());
}

/// Adds the finished runs of all threads to the table, in any order, because the table sorts them.
class TableWriter {
  public:
    TableWriter(RunTable table, std::filesystem::path folder, const StudyPlan& plan)
        : table_(std::move(table)), folder_(std::move(folder)), plan_(plan) {}

    void add(const RunRecord& record) {
        const std::lock_guard lock(mutex_);
        table_.add(record);
        ++runs_done_;
        if (record.report.ending == Ending::Stopped) ++runs_stopped_;
        if (Clock::now() >= next_write_) write();
    }

    /// Write the table, and return the report. `tasks` is the number of runs that the table lacked at first.
    StudyReport finish(std::size_t runs_before, std::size_t tasks) {
        write();
        return {runs_before, runs_done_, tasks - runs_done_, runs_stopped_};
    }

  private:
    using Clock = std::chrono::steady_clock;

    /// Write the table, and set the time of the next write: some seconds later, and so late that writing
    /// takes at most a twentieth of the time. A table may have tens of megabytes.
    void write() {
        constexpr std::chrono::seconds kLeastPause(5);
        constexpr int kPausePerWrite = 19;
        const auto begin = Clock::now();
        const base::FileLock lock(folder_);
        table_.merge(stored_table(folder_, plan_));
        base::write_file_atomically(run_table_path(folder_), table_.csv());
        const auto end = Clock::now();
        next_write_ = end + std::max<Clock::duration>(kLeastPause, kPausePerWrite * (end - begin));
    }

    std::mutex mutex_;
    RunTable table_;
    std::filesystem::path folder_;
    const StudyPlan& plan_;
    std::size_t runs_done_ = 0;
    std::size_t runs_stopped_ = 0;
    Clock::time_point next_write_ = Clock::now();
};

}  // namespace

void StudyPlan::validate() const {
    conditions.validate();
    if (repetitions < 1)
        throw base::InputError("repetitions: " + std::to_string(repetitions) + " must be at least 1");
    std::set<std::string_view> names;
    for (const Contender& contender : contenders) {
        const std::string_view name = contender.method->name;
        if (!names.insert(name).second)
            throw base::InputError("optimizers", "",
                                   "'" + std::string(name) +
                                       "' is listed twice; a study has one number of starts for each method, "
                                       "so use one folder for each number");
    }
}

std::filesystem::path run_table_path(const std::filesystem::path& folder) {
    return folder / "results.csv";
}

StudyReport run_study(const StudyPlan& plan, const std::filesystem::path& folder) {
    plan.validate();
    make_folder(folder);  // before the first run, because no run could be stored without the folder
    RunTable table = stored_table(folder, plan);
    const std::vector<Task> tasks = missing_tasks(plan, table);
    const std::size_t runs_before = table.size();
    RunConditions conditions = plan.conditions;
    conditions.budget.control = plan.control.silent();
    ProblemStore store(plan.families);
    TableWriter writer(std::move(table), folder, plan);
    try {
        base::ParallelTask progress(plan.control, "run optimizers", tasks.size());
        base::parallel_for(tasks.size(), plan.threads, [&](std::size_t i) {
            if (plan.control.stop_wanted()) return;
            const Task& task = tasks[i];
            const StudyProblem& entry = store.get(task.key.problem);
            try {
                writer.add(record_run({*entry.problem, entry.optimum}, task.contender, task.key, conditions));
                progress.advance();
            } catch (const base::Stopped&) {
                return;  // finished runs are stored below
            }
        });
    } catch (...) {
        (void)writer.finish(runs_before,
                            tasks.size());  // an error of one method does not lose the runs of the others
        throw;
    }
    return writer.finish(runs_before, tasks.size());
}

}  // namespace fretwork::optimization::study
