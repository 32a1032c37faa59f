// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/solution.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::mechanics {

/// What `solve` and `simulate` write (design: files, "Result").
struct Result {
    struct Node {
        int id = 0;
        Eigen::Vector3d rest_position = Eigen::Vector3d::Zero();
        bool is_interface = false;
    };
    std::string solver;       ///< "linear", "newton", ...
    std::vector<Node> nodes;  ///< as many as the solution has rows
    Solution solution;
    std::vector<Solution> load_steps;                           ///< only where asked for
    std::vector<Mode> vibration_modes{};                        ///< only where asked for
    std::vector<Mode> buckling_modes{};                         ///< only where asked for
    std::optional<DiscretizationError> discretization_error{};  ///< of the solution; only where asked for
    double seconds = 0.0;
};

/// The text of a result file. Throws NumericalError if a value is not finite.
std::string result_text(const Result& result);
/// Throws IoError, or NumericalError if a value is not finite; then nothing is written.
void write_result(const Result& result, const std::filesystem::path& path);
/// Throws InputError with file and JSON pointer.
Result read_result(const std::filesystem::path& path);

}  // namespace fretwork::mechanics
