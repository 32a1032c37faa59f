// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::simulation {

/// The surface, load case and model that a result belongs to. Two results belong together if the hashes
/// agree.
struct ResultSubject {
    std::string model;              ///< the tile model, with the further ones of a mixed surface
    bool is_reference = false;      ///< every tile has all of its beams: other results are compared with it
    std::string load_case;          ///< its name
    std::string load_case_text;     ///< the load case file
    std::string tessellation_hash;  ///< SHA-256, as the hashes below
    std::string painting_hash;
    std::string setting_hash;
    std::optional<reduction::Joints> joints{};  ///< of the setting; none in older files
    std::vector<int> full_tiles{};  ///< of a mixed model: the tiles with all of their beams, ascending
    std::string stages_text{};      ///< the load stages that were followed, as a file; empty: none
    std::vector<std::string> stage_load_cases{};  ///< the load case files that the load stages name, by name
    friend bool operator==(const ResultSubject&, const ResultSubject&) = default;
};

/// Estimated distance of a surface's solution from the full model's: translations of the interface nodes, and
/// the largest von Mises stress.
struct ModelError {
    double mean = 0.0;         ///< the mean error, as a share of the largest displacement
    double largest = 0.0;      ///< the largest error, as a share of the largest displacement
    double relative_l2 = 0.0;  ///< of all translations
    /// The error of the largest von Mises stress over all beams, as a share of it, and so that of the largest
    /// utilization; none where the model does not give the motions of all beams.
    std::optional<double> largest_stress{};
    friend bool operator==(const ModelError&, const ModelError&) = default;
};

/// Indicators that a solution of corotational tiles may be far from the full model's. They cost next to
/// nothing.
struct ModelDoubt {
    /// rad: the largest turn of a node against the frame of its corotational tile. Such a tile is linear in
    /// its frame: it is wrong where displacements against the frame are large.
    double tile_rotation = 0.0;
    /// Of mixed models: the distance between the solutions with and without tiles in full, at the worst
    /// interface node, as a share of the largest displacement.
    double change = 0.0;
    friend bool operator==(const ModelDoubt&, const ModelDoubt&) = default;
};

/// The solution of a surface, and the estimates that were asked for. The first rows are the interface nodes.
struct SurfaceResult : mechanics::Result {
    std::optional<ResultSubject>
        subject{};  ///< simulate() and files have one; Session::solve() leaves it out
    std::optional<mechanics::LinearRange> linear_range{};  ///< of linear solutions; only where asked for
    /// Of linear solutions of tiles with fitted parameters, together with linear_range: the largest distance
    /// of a translation from that with the tiles' condensed stiffness, as a share of the largest
    /// displacement.
    std::optional<double> fit_error{};
    std::optional<ModelDoubt> model_doubt{};  ///< of nonlinear results of reduced tiles; only where asked for
    std::optional<ModelError> model_error{};  ///< of reduced models; only where asked for, and known
    /// Tiles whose beams buckle between their interface nodes, ascending; only where the model error was
    /// asked for.
    std::optional<std::vector<int>> buckled_tiles{};
};

/// Read the text of a surface's result file. Throws InputError that names `source`, and the place in it: also
/// where values contradict each other, and where the file has no subject, as that of a frame.
SurfaceResult parse_surface_result(std::string_view text, const std::string& source);
/// The text of a surface's result file. Throws NumericalError if a value is not finite, InputError without a
/// subject.
std::string surface_result_text(const SurfaceResult& result);

/// Read a surface's result file. Throws as parse_surface_result.
SurfaceResult read_surface_result(const std::filesystem::path& path);
/// Write a surface's result file. Throws IoError, or as surface_result_text; then nothing is written.
void write_surface_result(const SurfaceResult& result, const std::filesystem::path& path);

}  // namespace fretwork::simulation
