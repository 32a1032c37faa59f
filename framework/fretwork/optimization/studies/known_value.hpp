// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// The lowest known objective of one problem.
struct KnownValue {
    std::string problem;      ///< id of the problem
    double best_value = 0.0;  ///< the lowest known value of the objective
    double scale = 1.0;       ///< scale of targets: a target is best_value + share * scale
    std::string found_by;     ///< method and run that found the value, or "construction"
};

/// Read a table of known values. Throws InputError that names file and line.
std::vector<KnownValue> read_known_values(const std::filesystem::path& path);
/// Known values as CSV.
std::string known_values_csv(const std::vector<KnownValue>& values);

/// Options of the search for known values.
struct KnownValueOptions {
    ProblemFamilies families{};  ///< families to which the ids of problems may refer
    int starts = 300;            ///< number of starts of each multistart method on each problem
    int threads = 0;             ///< number of threads; 0: one for each processor
    base::Control control{};     ///< progress counts finished problems
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Find the lowest value of each problem by many starts of the framework's two multistart methods, unless the
/// value is known in closed form. The scale of a known value is that of the problem (StudyProblem::scale).
/// For calibrations, the scale is the lowest value. For synthetic problems, the scale is 1, because the
/// lowest value is 0. For analytic problems, the scale is the median of (value - minimum) over 1,001 spread
/// points. Throws InputError if an option is invalid, and as make_study_problem() and minimize().
std::vector<KnownValue> find_known_values(const std::vector<std::string>& problems,
                                          const KnownValueOptions& options);

/// Replace each known value by the best value in a table of results, if the table's value is lower by more
/// than 1e-9 of the known value. If the old value is also the scale, so is the new value; another scale
/// stays. Values that are known in closed form stay. Throws InputError if the file is not a table of runs, or
/// if a value to compare is negative.
void improve_known_values(std::vector<KnownValue>& values, const std::filesystem::path& results);

}  // namespace fretwork::optimization::study
