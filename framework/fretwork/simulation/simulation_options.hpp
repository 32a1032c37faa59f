// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::simulation {

/// The analysis of a surface.
enum class Analysis {
    OfTheModel,  ///< nonlinear if the model of any tile is for large displacements, and linear otherwise
    Linear       ///< linear for every model, with equilibrium in the flat state
};

/// Options of simulate() and of a session. A session ignores the options of modes, and all estimates but
/// `estimate_error`.
struct SimulationOptions {
    /// The name of the model of all tiles without their own tile model: a row of `models`, or `mixed:SHARE`
    /// (mixed_model.hpp).
    std::string model = "full";
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< catalogue of tile models
    /// Linear or nonlinear analysis.
    Analysis analysis = Analysis::OfTheModel;
    /// True: fill Result::discretization_error; only for nonlinear models made of beams.
    bool estimate_error = false;
    /// True: fill SurfaceResult::model_error (model_error.hpp) and SurfaceResult::buckled_tiles; not for the
    /// full model, unless the analysis is linear.
    bool estimate_model_error = false;
    /// True: fill SurfaceResult::model_doubt of converged nonlinear solutions of reduced tiles. If a solution
    /// of corotational or mixed tiles is doubtful (model_doubt.hpp), also fill SurfaceResult::model_error.
    /// simulate() ignores this option if `estimate_model_error` is set.
    bool estimate_where_doubtful = false;
    /// Number of equal steps of the load, each with a result, at most 10,000; above 1 only for nonlinear
    /// analyses.
    int load_steps = 1;
    /// The equilibria to follow after a loss of stability. All branches except the primary need a nonlinear
    /// model that is not mixed, and exclude `estimate_error` and `estimate_model_error`.
    mechanics::Branch branch = mechanics::Branch::Primary;
    int vibration_modes = 0;  ///< number of natural frequencies of the surface at rest, with all of its beams
    /// Number of critical load factors of the surface by linearized buckling, with all of its beams.
    int buckling_modes = 0;
    bool estimate_linear_range = false;  ///< true: fill SurfaceResult::linear_range; for linear solutions
    /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
    /// threads.
    int threads = 0;
    /// Throws InputError if a value is invalid, or if it contradicts other options or the surface.
    void validate(const Surface& surface) const;
};

/// The tile model of the reduced tiles of a mixed model.
inline constexpr const char* kMixedTiles = "corotational";

/// The share of tiles with all of their beams in the model `mixed:SHARE`; none for any other name. Throws
/// InputError unless the share is a number from 0 to 1.
std::optional<double> mixed_share(const std::string& model);
/// The name `mixed:SHARE` of a mixed model.
std::string mixed_model(double share);

/// The choice of tile models by the options. For a mixed model, ModelChoice::name is kMixedTiles. Throws
/// InputError if the model is unknown.
ModelChoice model_choice(const SimulationOptions& options);
/// The choice of the full model, the first reference in the catalogue, for all tiles without their own tile
/// model. Throws InputError if the catalogue has no reference.
ModelChoice reference_choice(const SimulationOptions& options);

/// True if the analysis is OfTheModel and a tile model of the surface is for large displacements: equilibrium
/// is then sought in the deformed state. Throws InputError if a model is unknown.
bool is_nonlinear(const Surface& surface, const SimulationOptions& options);

/// True if the model of every tile is a reference; false for a mixed model. Throws InputError if a model is
/// unknown.
bool is_reference(const Surface& surface, const SimulationOptions& options);

}  // namespace fretwork::simulation
