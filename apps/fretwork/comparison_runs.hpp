// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/comparison.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::app {

/// What is run: every contender on every problem, so many times.
struct ComparisonPlan {
    std::vector<std::string> problems;
    std::vector<optimization::Contender> contenders;
    optimization::ComparisonOptions options;
    int repetitions = 15;
    int threads = 0;
};

struct ComparisonSummary {
    std::size_t runs_before = 0;
    std::size_t runs_done = 0;
    std::size_t runs_left_out = 0;  ///< since the program was interrupted
};

/// Do what is missing in the table at `path`, all problems once, then all of them again; the file is replaced
/// every few seconds, so that a run that is stopped goes on where it was. The table depends on the plan
/// alone, but for the times. Throws InputError if the table was made under other conditions.
ComparisonSummary run_comparison(const ComparisonPlan& plan, const std::filesystem::path& path);

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

/// Search each problem by many starts of our two calibrators, unless its minimum is known in closed form. The
/// scale is the value itself for calibrations, 1 for synthetic problems, whose least value is 0, and for
/// analytic ones the median of 1,001 spread points above the minimum.
std::vector<KnownValue> find_known_values(const std::vector<std::string>& problems, int starts, int threads);

/// Take over what the runs of a table found lower.
void improve_known_values(std::vector<KnownValue>& values, const std::filesystem::path& results);

}  // namespace fretwork::app
