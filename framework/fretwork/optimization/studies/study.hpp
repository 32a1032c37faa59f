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
    ProblemFamilies families;           ///< the families of the ids
    std::vector<Contender> contenders;  ///< methods with their starts
    RunConditions conditions;           ///< its budget's control is ignored; the plan's control is used
    int repetitions = 15;               ///< runs of each method that uses the seed
    int threads = 0;                    ///< 0: one for each processor
    base::Control control{};            ///< progress counts finished runs
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// What run_study() did.
struct StudyReport {
    std::size_t runs_before = 0;    ///< runs in the table at the start
    std::size_t runs_done = 0;      ///< by this call
    std::size_t runs_left_out = 0;  ///< runs not done because of a stop
};

/// The path of the table in a study's folder.
std::filesystem::path run_table_path(const std::filesystem::path& folder);

/// Do the runs that the table in a folder lacks: first one repetition on all problems, then the next.
///
/// The table is replaced every few seconds, so an interrupted study can continue. After a request to stop,
/// the function stores the finished runs and returns. Several processes may share one folder: each adds its
/// runs to the stored ones under a lock of the folder. Except for times, the table depends on the plan alone.
/// A missing folder is created before the first run. Throws IoError if the folder cannot be created,
/// InputError if the table was made under other conditions.
StudyReport run_study(const StudyPlan& plan, const std::filesystem::path& folder);

}  // namespace fretwork::optimization::study
