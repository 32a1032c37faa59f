// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// What a result of this surface under this load case is a result of.
///
/// The tessellation's hash is that of its polygons and nodes, wherever a tile's first vertex is; the
/// painting's that of each tile's pattern and first vertex.
ResultSubject result_subject(const Surface& surface, const LoadCase& load_case,
                             const SimulationOptions& options);

/// The model of the tiles that have none of their own, as `simulate --model` takes it.
std::string main_model(const ResultSubject& subject);

/// Check a subject that was read from a file: its models are in the catalogue, it is a reference only if they
/// are, and its load case is one. Throws InputError that names `source` and the place.
void check_subject(const ResultSubject& subject, const std::string& source,
                   std::span<const reduction::TileModel> models = reduction::tile_models());

/// What two subjects differ in besides their models, in words ("the painting"); empty: nothing.
/// Descriptions of load cases do not count.
std::string subject_difference(const ResultSubject& left, const ResultSubject& right);

/// What results of a surface have in common. To make it takes some time, so it is made once.
struct SurfaceIdentity {
    std::string tessellation_hash;
    std::string painting_hash;
    std::string setting_hash;
    std::size_t tiles = 0;
};
SurfaceIdentity surface_identity(const Surface& surface);

/// What a result and a surface, whose load case may be any, differ in; empty: nothing.
std::string subject_difference(const ResultSubject& result, const SurfaceIdentity& surface);

}  // namespace fretwork::simulation
