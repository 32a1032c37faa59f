// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// What a surface's result is a result of. Two results belong together if the hashes agree.
struct ResultSubject {
    std::string model;              ///< the tile model; with the others of a mixed surface
    bool is_reference = false;      ///< others are compared with it: every tile has all of its beams
    std::string load_case;          ///< its name
    std::string load_case_text;     ///< the load case file
    std::string tessellation_hash;  ///< SHA-256, as the others
    std::string painting_hash;
    std::string setting_hash;
    std::vector<int> full_tiles{};  ///< of a mixed model: those with all of their beams, ascending
    std::string stages_text{};      ///< the stages that were followed, as a file; empty: none
    std::vector<std::string> stage_load_cases{};  ///< the load case files that stages name, by name
    friend bool operator==(const ResultSubject&, const ResultSubject&) = default;
};

/// How far a surface's solution is from the full model's, by estimate: translations of the interface nodes.
struct ModelError {
    double mean = 0.0;         ///< the mean error, as a share of the largest displacement
    double largest = 0.0;      ///< the largest error, as a share of the largest displacement
    double relative_l2 = 0.0;  ///< of all translations
    friend bool operator==(const ModelError&, const ModelError&) = default;
};

/// What `solve` and `simulate` write.
struct Result {
    struct Node {
        int id = 0;
        Eigen::Vector3d rest_position = Eigen::Vector3d::Zero();
        bool is_interface = false;
    };
    std::string solver;                      ///< "linear", "newton", ...
    std::string program;                     ///< the version that made it; empty: a file of the first format
    std::optional<ResultSubject> subject{};  ///< of a surface's result; none in files of the first format
    std::vector<Node> nodes;                 ///< as many as the solution has rows
    Solution solution;
    std::vector<Solution> load_steps;                           ///< only where asked for
    std::vector<Mode> vibration_modes{};                        ///< only where asked for
    std::vector<Mode> buckling_modes{};                         ///< only where asked for
    std::optional<DiscretizationError> discretization_error{};  ///< of the solution; only where asked for
    std::optional<LinearRange> linear_range{};                  ///< of linear solutions of surfaces
    std::optional<ModelError> model_error{};  ///< of reduced models; only where asked for, and known
    /// Tiles whose beams buckle between their interface nodes, ascending; only where the model error was
    /// asked for.
    std::optional<std::vector<int>> buckled_tiles{};
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
