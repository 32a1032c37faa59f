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

/// The subject of a result: its surface, load case and model. Two results are of the same surface if their
/// hashes are equal.
struct ResultSubject {
    /// Names of the tile models, such as "condensed; full (3 tiles)"; see main_model().
    std::string model;
    /// True if every tile has all of its beams, so that results of other models can be compared with it.
    bool is_reference = false;
    std::string load_case;                      ///< name of the load case
    std::string load_case_text;                 ///< text of the load case's file
    std::string tessellation_hash;              ///< SHA-256 of layout, vertices, tiles and interface nodes
    std::string painting_hash;                  ///< SHA-256 of the tiles' patterns and first vertices
    std::string setting_hash;                   ///< SHA-256 of the setting without strength and section shape
    std::optional<reduction::Joints> joints{};  ///< joints of the setting; none in older files
    std::vector<int> full_tiles{};              ///< tiles with all of their beams in a mixed model, ascending
    std::string stages_text{};                  ///< text of the file of load stages; empty: no load stages
    /// For each load case that a load stage names, the text of its file, in the order of the names.
    std::vector<std::string> stage_load_cases{};
    friend bool operator==(const ResultSubject&, const ResultSubject&) = default;
};

/// The estimated error of a surface's solution relative to the full model, in the translations of the
/// interface nodes and in the largest von Mises stress.
struct ModelError {
    double mean = 0.0;         ///< mean error, as a share of the largest displacement
    double largest = 0.0;      ///< largest error, as a share of the largest displacement
    double relative_l2 = 0.0;  ///< estimated |full - reduced| / |full| over all translations
    /// The relative error of the largest von Mises stress over all beams, which is also the relative error of
    /// the largest utilization. None if stresses of beams are unknown (BeamTable::unknown), or if the better
    /// solution could not be refined around the largest stress (RefinedStress::is_settled).
    std::optional<double> largest_stress{};
    /// The share of tiles with all of their beams in the better solution (model_error.hpp). The error is the
    /// difference from that solution. 1: the numbers above are the error itself; below 1, they may be too
    /// small. 0 if a file does not state the share.
    double full_share = 0.0;
    friend bool operator==(const ModelError&, const ModelError&) = default;
};

/// Cheap indicators that a solution of corotational tiles may be far from the solution of the full model.
struct ModelDoubt {
    /// The largest rotation of a node relative to the corotating axes of its tile, rad. A tile is linear in
    /// these axes, so large displacements relative to them cause an error.
    double tile_rotation = 0.0;
    /// For mixed models, the distance between the mixed solution and the corotational solution, at the worst
    /// interface node, as a share of the largest displacement.
    double change = 0.0;
    friend bool operator==(const ModelDoubt&, const ModelDoubt&) = default;
};

/// The solution of a surface, and the estimates requested by the options. Where there is a row for each node,
/// the rows of the interface nodes come first.
struct SurfaceResult : mechanics::Result {
    std::optional<ResultSubject> subject{};  ///< subject of the result; results of Session::solve() have none
    /// For linear solutions, if the options ask for it.
    std::optional<mechanics::LinearRange> linear_range{};
    /// For linear solutions of tiles with fitted parameters, together with linear_range: the largest distance
    /// between an interface node here and in the linear solution with condensed tiles, as a share of the
    /// largest displacement there.
    std::optional<double> fit_error{};
    /// For nonlinear results of reduced tiles, if SimulationOptions::estimate_where_doubtful asks for it.
    std::optional<ModelDoubt> model_doubt{};
    /// For reduced models, and for linear solutions of the full model, if the options ask for it. None if a
    /// solution that it needs was not found.
    std::optional<ModelError> model_error{};
    /// The tiles with beams that buckle between the interface nodes, ascending, if the options ask for the
    /// model error.
    std::optional<std::vector<int>> buckled_tiles{};
};

/// Parse the text of a surface's result file. Throws InputError that names `source` and a place in the text,
/// if a value is wrong, if values contradict each other, or if there is no subject, as for a frame.
SurfaceResult parse_surface_result(std::string_view text, const std::string& source);
/// The text of a surface's result file. Throws NumericalError if a value is not finite, and InputError if the
/// result has no subject.
std::string surface_result_text(const SurfaceResult& result);

/// Read a surface's result file. Throws as parse_surface_result, and InputError if the file cannot be read.
SurfaceResult read_surface_result(const std::filesystem::path& path);
/// Write a surface's result file. Throws IoError, or as surface_result_text(). After an error, the file is as
/// before.
void write_surface_result(const SurfaceResult& result, const std::filesystem::path& path);

}  // namespace fretwork::simulation
