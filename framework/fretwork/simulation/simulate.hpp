// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/result_file.hpp>
#include <fretwork/simulation/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>

namespace fretwork::simulation {

/// Whether equilibrium is sought in the deformed or in the flat state.
enum class Analysis { OfTheModel, Linear };

struct SimulationOptions {
    std::string model = "full";                ///< a row of the model catalogue
    Analysis analysis = Analysis::OfTheModel;  ///< of the model: what its row says
    bool estimate_error = false;  ///< Result::discretization_error; of the nonlinear full model only
    int load_steps = 1;           ///< results at so many equal shares of the load; nonlinear only
    int threads = 0;              ///< 0: all there are. They change no bit of the result.
    /// Whether equilibrium is sought in the deformed state. Throws InputError if there is no such model.
    [[nodiscard]] bool is_nonlinear() const;
    /// Throws InputError if a value makes no sense, or goes with none of the others.
    void validate() const;
};

/// Simulate a surface under a load case. Interface nodes come first in the result, with the same ids in every
/// model. Paper, Section 6. Throws InputError (load case, model, calibrations), NumericalError (structure not
/// held).
mechanics::Result simulate(const Surface& surface, const LoadCase& load_case,
                           const SimulationOptions& options = {});

}  // namespace fretwork::simulation
