// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/run.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// The runs of a study: every contender on every problem, repeated.
struct StudyPlan {
    std::vector<std::string> problems;  ///< ids of problems (see study_problem.hpp)
    ProblemFamilies families;           ///< families to which the ids of problems may refer
    std::vector<Contender> contenders;  ///< methods with their numbers of starts
    /// Conditions of all runs. The control of their budget is ignored: the plan's `control` is used.
    RunConditions conditions;
    int repetitions = 15;     ///< number of runs of each method that uses the seed
    int threads = 0;          ///< number of threads; 0: one for each processor
    base::Control control{};  ///< progress counts finished runs
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The report of run_study().
struct StudyReport {
    std::size_t runs_before = 0;    ///< number of runs in the table at the start
    std::size_t runs_done = 0;      ///< number of runs done by this call
    std::size_t runs_left_out = 0;  ///< number of runs not done because of a stop
    /// Number of runs done by this call that ended as Ending::Stopped.
    std::size_t runs_stopped = 0;
};

/// The path of the table in a study's folder.
std::filesystem::path run_table_path(const std::filesystem::path& folder);

/// Do the runs that the table in a folder lacks: the first repetition on all problems, then the second
/// repetition, and so on.
///
/// The table is replaced every few seconds, so an interrupted study can continue. After a request to stop,
/// the function stores the finished runs and returns. Several processes may share one folder: each process
/// adds its runs to the stored runs under a lock of the folder. Except for times, the table depends on the
/// plan alone. A missing folder is created before the first run. Throws IoError if the folder cannot be
/// created or searched, or the table cannot be written, InputError if the plan is invalid or the table was
/// made under other conditions. An error of make_study_problem() or minimize() is thrown after the finished
/// runs are stored.
StudyReport run_study(const StudyPlan& plan, const std::filesystem::path& folder);

}  // namespace fretwork::optimization::study
