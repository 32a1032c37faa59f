// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/model_choice.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// Whether equilibrium is sought in the deformed or in the flat state.
enum class Analysis { OfTheModel, Linear };

struct SimulationOptions {
    std::string model = "full";  ///< a row of `models`, for the tiles that have none of their own
    std::span<const reduction::TileModel> models = reduction::tile_models();
    Analysis analysis = Analysis::OfTheModel;  ///< of the model: what its row says
    bool estimate_error = false;  ///< Result::discretization_error; of nonlinear models made of beams only
    int load_steps = 1;           ///< results at so many equal shares of the load; nonlinear only
    int threads = 0;              ///< 0: all there are. They change no bit of the result.
    /// Throws InputError if a value makes no sense, or does not go with the others on this surface.
    void validate(const Surface& surface) const;
};

/// Whether equilibrium is sought in the deformed state: a tile model of the surface is made for large
/// displacements, and the analysis is that of the model. Throws InputError if there is no such model.
bool is_nonlinear(const Surface& surface, const SimulationOptions& options);

}  // namespace fretwork::simulation
