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

/// The solution of a structure, and further results that were requested by the options.
struct Result {
    /// A node of a result.
    struct Node {
        int id = 0;                                               ///< number of the node in the file
        Eigen::Vector3d rest_position = Eigen::Vector3d::Zero();  ///< m
        bool is_interface = false;                                ///< true for interface nodes of a surface
    };
    std::string solver;  ///< name of the solver: "linear", "newton", ..
    /// Version of the program that wrote the file; empty: the result was not read from a file.
    std::string program{};
    base::IndexVector<NodeIndex, Node> nodes;  ///< nodes, one for each row of the solution
    Solution solution;                         ///< equilibrium at the full load
    /// Solutions of the load steps; empty unless the options ask for them.
    std::vector<Solution> load_steps;
    /// Modes of vibration; empty unless the options ask for them.
    std::vector<Mode> vibration_modes{};
    /// Modes of buckling; empty unless the options ask for them.
    std::vector<Mode> buckling_modes{};
    /// Discretization error of the solution; none unless the options ask for it.
    std::optional<DiscretizationError> discretization_error{};
    double seconds = 0.0;  ///< wall time of the computation without files, s
};

/// Parse the text of a result file. Throws InputError that names `source` and a place in the text, also if
/// values contradict each other.
Result parse_result(std::string_view text, const std::string& source);
/// The text of a result file. Throws NumericalError if a value is not finite.
std::string result_text(const Result& result);

/// Read a result file. Throws as parse_result.
Result read_result(const std::filesystem::path& path);
/// Write a result file atomically. Throws IoError, or NumericalError if a value is not finite. After an
/// error, the file is as before.
void write_result(const Result& result, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
