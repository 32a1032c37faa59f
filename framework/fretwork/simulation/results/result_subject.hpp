// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// The subject of a result of a surface under a load case.
///
/// The tessellation's hash covers its polygons, its interface nodes and the node layout, but not each tile's
/// first vertex. The painting's hash covers each tile's pattern and first vertex. The setting's hash covers
/// all values but the strength and the section's shape. Throws InputError if a model is unknown, and
/// NumericalError as load_case_text().
///
/// @param full_tiles  the tiles with all of their beams in the result of a mixed model, ascending
ResultSubject result_subject(const Surface& surface, const LoadCase& load_case,
                             const SimulationOptions& options,
                             std::span<const tiling::TileIndex> full_tiles = {});

/// The numbers of tiles, for ResultSubject::full_tiles and SurfaceResult::buckled_tiles.
std::vector<int> tile_numbers(std::span<const tiling::TileIndex> tiles);

/// The model of the tiles without their own tile model, in the form of `simulate --model`.
std::string main_model(const ResultSubject& subject);

/// Check a subject from a file: all models are in the catalogue; the subject is a reference if all models are
/// references, and is none if no model is; only a mixed model has full tiles; load cases and load stages are
/// valid. Throws InputError that names `source` and the place.
void check_subject(const ResultSubject& subject, const std::string& source,
                   std::span<const reduction::TileModel> models = reduction::tile_models());

/// The differences between two subjects ("the painting, the setting"), load case and load stages included;
/// empty if there are none. Models and descriptions of load cases are not compared. Throws InputError if the
/// text of a load case or of load stages is invalid.
std::string subject_difference(const ResultSubject& left, const ResultSubject& right);

/// The common data of the subjects of all results of a surface. Compute it only once, because hashes take
/// time.
struct SurfaceIdentity {
    std::string tessellation_hash;  ///< hash of layout, vertices, tiles and interface nodes
    std::string painting_hash;      ///< hash of the tiles' patterns and first vertices
    std::string setting_hash;       ///< hash of the setting without strength and shape
    std::size_t tiles = 0;          ///< number of tiles
};
/// The identity of a surface.
SurfaceIdentity surface_identity(const Surface& surface);

/// The differences between a result's subject and a surface, load cases aside; empty if there are none.
std::string subject_difference(const ResultSubject& result, const SurfaceIdentity& surface);

}  // namespace fretwork::simulation
