// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/run.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// The runs of a study: every contender on every problem, with this many repetitions.
struct StudyPlan {
    std::vector<std::string> problems;  ///< ids (see study_problem.hpp)
    ProblemFamilies families;           ///< that they name
    std::vector<Contender> contenders;
    RunConditions conditions;  ///< its budget's control is not used: that of the plan is
    int repetitions = 15;
    int threads = 0;          ///< 0: all there are
    base::Control control{};  ///< receives every finished run
    /// Throws InputError if a value is invalid.
    void validate() const;
};

struct StudyReport {
    std::size_t runs_before = 0;  ///< that were in the table when it began
    std::size_t runs_done = 0;
    std::size_t runs_left_out = 0;  ///< since it was asked to stop
};

/// The table of a study's folder.
std::filesystem::path run_table_path(const std::filesystem::path& folder);

/// Do the runs that the table in a folder lacks: all problems once, then all of them again.
///
/// The table is replaced every few seconds, so that a study which is stopped goes on where it was; asked to
/// stop, it stores what is done and returns. Several processes may work in one folder: each adds its runs to
/// those that the others have stored, under a lock of the folder. But for the times, the table depends on the
/// plan alone. The folder is made if it is missing, before the first run. Throws IoError if it cannot be;
/// InputError if the table was made under other conditions.
StudyReport run_study(const StudyPlan& plan, const std::filesystem::path& folder);

}  // namespace fretwork::optimization::study
