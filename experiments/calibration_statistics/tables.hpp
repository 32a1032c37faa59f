// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of this experiment, and what they share.
#pragma once

#include <fretwork/library/library.hpp>

#include <string>
#include <vector>

namespace fretwork::experiments {

/// A calibrated library, and which of its calibrations the tables are about.
struct TableInput {
    const library::Library& library;
    std::vector<pattern::NamedPattern> patterns;
    reduction::CalibrationOptions options;  ///< of the calibrations that are looked at
    int threads = 0;
};

/// Mean, standard deviation (of the population) and quantiles.
struct Distribution {
    double mean = 0.0;
    double deviation = 0.0;
    std::vector<double> sorted;
    /// By linear interpolation; share from 0 to 1.
    [[nodiscard]] double quantile(double share) const;
};
Distribution distribution(std::vector<double> values);

/// One row of a Markdown table.
void print_row(const std::vector<std::string>& cells);
void print_head(const std::vector<std::string>& cells);
std::string fixed(double value, int digits);

/// How far the largest magnitudes move the tiles.
void print_displacements(const TableInput& input);
/// The effect of the policy for samples past the first loss of stability.
void print_policies(const TableInput& input);
/// How the objective depends on the largest magnitudes.
void print_magnitudes(const TableInput& input);

}  // namespace fretwork::experiments
