// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::simulation {

/// Whether equilibrium is sought in the deformed or in the flat state.
enum class Analysis { OfTheModel, Linear };

struct SimulationOptions {
    /// A row of `models`, for the tiles without their own; or `mixed:SHARE` (mixed_model.hpp).
    std::string model = "full";
    std::span<const reduction::TileModel> models = reduction::tile_models();
    Analysis analysis = Analysis::OfTheModel;  ///< of the model: what its row says
    bool estimate_error = false;  ///< Result::discretization_error; of nonlinear models made of beams only
    bool estimate_model_error = false;  ///< SurfaceResult::model_error, of reduced models (model_error.hpp)
    /// SurfaceResult::model_doubt; and model_error, of the displacements alone, where that is large and the
    /// path is the primary one. Of nonlinear solutions.
    bool estimate_where_doubtful = false;
    int load_steps = 1;  ///< results at this many equal shares of the load; nonlinear only
    /// The path that is followed where it becomes unstable. Other branches than the primary one are for
    /// nonlinear models other than mixed ones, and without estimates of errors.
    mechanics::Branch branch = mechanics::Branch::Primary;
    /// Additional results of simulate(); a session does not compute them.
    int vibration_modes = 0;  ///< this many natural frequencies of the surface at rest, with all of its beams
    int buckling_modes =
        0;  ///< this many critical load factors by linearized buckling, with all of its beams
    bool estimate_linear_range = false;  ///< SurfaceResult::linear_range, of linear solutions
    int threads = 0;                     ///< 0: all there are. They change no bit of the result.
    /// Throws InputError if a value is invalid, or does not go with the others on this surface.
    void validate(const Surface& surface) const;
};

/// The row of the tiles of a mixed model that are not in full.
inline constexpr const char* kMixedTiles = "corotational";

/// The share of tiles in full of the model `mixed:SHARE`; none of any other name. Throws InputError unless
/// the share is a number from 0 to 1.
std::optional<double> mixed_share(const std::string& model);

/// The tile models of these options; of a mixed model that of the tiles which are not in full.
ModelChoice model_choice(const SimulationOptions& options);
/// Every tile in full: the first row of the catalogue that is a reference. Throws InputError if none is.
ModelChoice reference_choice(const SimulationOptions& options);

/// Whether equilibrium is sought in the deformed state: a tile model of the surface is made for large
/// displacements, and the analysis is that of the model. Throws InputError if a model is unknown.
bool is_nonlinear(const Surface& surface, const SimulationOptions& options);

/// Whether every tile has all of its beams.
bool is_reference(const Surface& surface, const SimulationOptions& options);

}  // namespace fretwork::simulation
