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

/// The solution of a structure, and the further results that were asked for.
struct Result {
    /// A node of the file.
    struct Node {
        int id = 0;                                               ///< its number in the file
        Eigen::Vector3d rest_position = Eigen::Vector3d::Zero();  ///< m
        bool is_interface = false;                                ///< true for interface nodes of a surface
    };
    std::string solver;                        ///< "linear", "newton", ...
    std::string program{};                     ///< the version of the program that wrote the file; empty: not
                                               ///< read from a file
    base::IndexVector<NodeIndex, Node> nodes;  ///< one for each row of the solution
    Solution solution;                         ///< the equilibrium
    std::vector<Solution> load_steps;          ///< only if asked for
    std::vector<Mode> vibration_modes{};       ///< only if asked for
    std::vector<Mode> buckling_modes{};        ///< only if asked for
    std::optional<DiscretizationError> discretization_error{};  ///< error of the solution; only if asked for
    double seconds = 0.0;  ///< wall time of the answer from nothing, without files
};

/// Parse the text of a result file. Throws InputError that names `source` and the place in it, also if values
/// contradict each other.
Result parse_result(std::string_view text, const std::string& source);
/// The text of a result file. Throws NumericalError if a value is not finite.
std::string result_text(const Result& result);

/// Read a result file. Throws as parse_result.
Result read_result(const std::filesystem::path& path);
/// Write a result file atomically. Throws IoError, or NumericalError if a value is not finite; then nothing
/// is written.
void write_result(const Result& result, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
