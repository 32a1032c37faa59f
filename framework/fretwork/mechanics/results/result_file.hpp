// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// The solution of a structure, and what else was asked for.
struct Result {
    struct Node {
        int id = 0;
        Eigen::Vector3d rest_position = Eigen::Vector3d::Zero();
        bool is_interface = false;
    };
    std::string solver;                        ///< "linear", "newton", ...
    std::string program{};                     ///< the version that made it; empty: not read from a file
    base::IndexVector<NodeIndex, Node> nodes;  ///< as many as the solution has rows
    Solution solution;
    std::vector<Solution> load_steps;                           ///< only where asked for
    std::vector<Mode> vibration_modes{};                        ///< only where asked for
    std::vector<Mode> buckling_modes{};                         ///< only where asked for
    std::optional<DiscretizationError> discretization_error{};  ///< of the solution; only where asked for
    double seconds = 0.0;
};

/// Read the text of a result file. Throws InputError that names `source`, and the place in it: also where
/// values contradict each other.
Result parse_result(std::string_view text, const std::string& source);
/// The text of a result file. Throws NumericalError if a value is not finite.
std::string result_text(const Result& result);

/// Throws as parse_result.
Result read_result(const std::filesystem::path& path);
/// Throws IoError, or NumericalError if a value is not finite; then nothing is written.
void write_result(const Result& result, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
