// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::simulation {

/// The analysis of a surface. OfTheModel: nonlinear if the model of any tile is for large displacements, else
/// linear. Linear: linear for every model, with equilibrium in the flat state.
enum class Analysis { OfTheModel, Linear };

/// Options of simulate() and of a session.
struct SimulationOptions {
    /// The model of the tiles without their own: a row of `models`, or `mixed:SHARE` (mixed_model.hpp).
    std::string model = "full";
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< the catalogue
    Analysis analysis = Analysis::OfTheModel;                                 ///< see Analysis
    bool estimate_error = false;  ///< fill Result::discretization_error; only for nonlinear models made of
                                  ///< beams
    bool estimate_model_error = false;  ///< fill SurfaceResult::model_error, for reduced models
                                        ///< (model_error.hpp)
    /// SurfaceResult::model_doubt of nonlinear solutions; and model_error, where that is large, of
    /// corotational and mixed tiles.
    bool estimate_where_doubtful = false;
    int load_steps = 1;  ///< number of equal steps of the load, each with a result; nonlinear only
    /// The equilibria to follow when the path becomes unstable. A branch other than the primary one needs a
    /// nonlinear model that is not mixed, and excludes estimates of errors.
    mechanics::Branch branch = mechanics::Branch::Primary;
    /// Additional results of simulate(); a session does not compute them.
    int vibration_modes = 0;  ///< number of natural frequencies of the surface at rest, with all of its beams
    int buckling_modes =
        0;  ///< number of critical load factors by linearized buckling, with all of its beams
    bool estimate_linear_range = false;  ///< fill SurfaceResult::linear_range, for linear solutions
    int threads = 0;                     ///< 0: one for each processor. The number does not change a bit of
                                         ///< the result.
    /// Throws InputError if a value is invalid, or contradicts other options or the surface.
    void validate(const Surface& surface) const;
};

/// The tile model of those tiles of a mixed model that are not in full.
inline constexpr const char* kMixedTiles = "corotational";

/// The share of tiles in full of the model `mixed:SHARE`; none for any other name. Throws InputError unless
/// the share is a number from 0 to 1.
std::optional<double> mixed_share(const std::string& model);

/// The tile models of these options. For a mixed model, the model of the tiles that are not in full.
ModelChoice model_choice(const SimulationOptions& options);
/// The choice of the full model for every tile, which is the first reference of the catalogue. Throws
/// InputError if the catalogue has none.
ModelChoice reference_choice(const SimulationOptions& options);

/// True if equilibrium is sought in the deformed state: a tile model of the surface is for large
/// displacements, and the analysis is OfTheModel. Throws InputError if a model is unknown.
bool is_nonlinear(const Surface& surface, const SimulationOptions& options);

/// True if every tile has all of its beams.
bool is_reference(const Surface& surface, const SimulationOptions& options);

}  // namespace fretwork::simulation
