// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// The least objective that is known of one problem.
struct KnownValue {
    std::string problem;
    double best_value = 0.0;
    double scale = 1.0;  ///< targets are best_value + share * scale
    std::string found_by;
};

/// Throws InputError that names file and line.
std::vector<KnownValue> read_known_values(const std::filesystem::path& path);
std::string known_values_csv(const std::vector<KnownValue>& values);

struct KnownValueOptions {
    ProblemFamilies families{};  ///< that the ids name
    int starts = 300;            ///< descents of each calibrator on each problem
    int threads = 0;             ///< 0: all there are
    base::Control control{};     ///< receives every finished problem
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Search each problem by many starts of our two calibrators, unless its minimum is known in closed form. The
/// scale is the value itself for calibrations, 1 for synthetic problems, whose least value is 0, and for
/// analytic ones the median of 1,001 spread points above the minimum. Throws base::Stopped.
std::vector<KnownValue> find_known_values(const std::vector<std::string>& problems,
                                          const KnownValueOptions& options);

/// Take over what the runs of a table found lower.
void improve_known_values(std::vector<KnownValue>& values, const std::filesystem::path& results);

}  // namespace fretwork::optimization::study
