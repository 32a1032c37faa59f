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
    std::string model;              ///< the tile model, and the further models of a mixed surface
    bool is_reference = false;      ///< true if every tile has all of its beams: other results are compared
                                    ///< with this one
    std::string load_case;          ///< its name
    std::string load_case_text;     ///< the load case as the text of a file
    std::string tessellation_hash;  ///< SHA-256, as the hashes below
    std::string painting_hash;      ///< of the tiles' patterns
    std::string setting_hash;       ///< of material, section and joints
    std::optional<reduction::Joints> joints{};  ///< joints of the setting; none in older files
    std::vector<int> full_tiles{};  ///< for a mixed model, the tiles with all of their beams, ascending
    std::string stages_text{};      ///< the load stages as the text of a file; empty: none
    std::vector<std::string> stage_load_cases{};  ///< the load cases that the load stages name, as texts of
                                                  ///< files
    friend bool operator==(const ResultSubject&, const ResultSubject&) = default;
};

/// The estimated error of a surface's solution relative to the full model, in the translations of the
/// interface nodes and in the largest von Mises stress.
struct ModelError {
    double mean = 0.0;         ///< the mean error, as a share of the largest displacement
    double largest = 0.0;      ///< the largest error, as a share of the largest displacement
    double relative_l2 = 0.0;  ///< estimated |full - reduced| / |full| over all translations
    /// The relative error of the largest von Mises stress over all beams, which is also that of the largest
    /// utilization. None if the model does not give the motions of all beams.
    std::optional<double> largest_stress{};
    friend bool operator==(const ModelError&, const ModelError&) = default;
};

/// Indicators that a solution of corotational tiles may be far from the full model's. Their cost is
/// negligible.
struct ModelDoubt {
    /// The largest rotation of a node relative to the corotating axes of its tile, rad. The tile is linear in
    /// these axes, so it is wrong if displacements relative to them are large.
    double tile_rotation = 0.0;
    /// For mixed models, the distance between the solutions with and without tiles in full, at the worst
    /// interface node, as a share of the largest displacement.
    double change = 0.0;
    friend bool operator==(const ModelDoubt&, const ModelDoubt&) = default;
};

/// The solution of a surface, and the estimates that were asked for. The first rows are the interface nodes.
struct SurfaceResult : mechanics::Result {
    std::optional<ResultSubject>
        subject{};  ///< simulate() and files have one; Session::solve() leaves it out
    std::optional<mechanics::LinearRange> linear_range{};  ///< for linear solutions, if asked for
    /// For linear solutions of tiles with fitted parameters, together with linear_range: the largest distance
    /// between a translation and the one computed with the tiles' condensed stiffness, as a share of the
    /// largest displacement.
    std::optional<double> fit_error{};
    std::optional<ModelDoubt> model_doubt{};  ///< for nonlinear results of reduced tiles, if asked for
    std::optional<ModelError> model_error{};  ///< for reduced models, if asked for and known
    /// The tiles whose beams buckle between their interface nodes, ascending, if the model error was asked
    /// for.
    std::optional<std::vector<int>> buckled_tiles{};
};

/// Parse the text of a surface's result file. Throws InputError that names `source` and the place in it, also
/// if values contradict each other, or if the file has no subject, like a result file of a frame.
SurfaceResult parse_surface_result(std::string_view text, const std::string& source);
/// The text of a surface's result file. Throws NumericalError if a value is not finite, InputError without a
/// subject.
std::string surface_result_text(const SurfaceResult& result);

/// Read a surface's result file. Throws as parse_surface_result.
SurfaceResult read_surface_result(const std::filesystem::path& path);
/// Write a surface's result file. Throws IoError, or as surface_result_text; then nothing is written.
void write_surface_result(const SurfaceResult& result, const std::filesystem::path& path);

}  // namespace fretwork::simulation
