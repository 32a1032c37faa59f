// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/base/control.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/response.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// A number with its name, in SI units.
struct NamedValue {
    std::string name;    ///< of a parameter
    double value = 0.0;  ///< SI
    friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

/// Options of calibrate().
struct CalibrationOptions {
    std::string optimizer = "ceres-multistart";  ///< a row of `optimizers`
    /// The catalogue that has the optimizer.
    std::span<const optimization::OptimizerRow> optimizers = optimization::optimizer_catalogue();
    int starts = 8;           ///< descents from different points
    std::uint64_t seed = 1;   ///< of all random choices
    int budget = 20000;       ///< the most evaluations of the objective
    base::Control control{};  ///< how the caller follows and stops the work
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The result of fitting a tile model to the responses of one pattern, or only of comparing the two.
struct Calibration {
    std::string model;                    ///< a row of the catalogue of tile models
    std::string optimizer;                ///< "none" if nothing is fitted
    std::uint64_t seed = 0;               ///< of all random choices
    int starts = 0;                       ///< descents from different points
    double objective = 0.0;               ///< E of Eq. (8) at the parameters
    std::vector<double> scenario_errors;  ///< the weighted contribution of each scenario to E: e_k summed
                                          ///< over the magnitudes as in Eq. (8)
    long evaluations = 0;                 ///< of the objective
    std::vector<NamedValue> parameters;   ///< in the order of the model's row; empty if nothing is fitted
    std::vector<std::string> at_bound;    ///< names of the parameters at a bound
    /// True if the start that found these parameters ended by its method's own criterion before the budget
    /// was spent.
    bool converged = true;
    int dead_starts = 0;  ///< the number of `starts` that gave no descent; libraries do not store it
};

/// The parameters in the order of a model's row. Throws InputError that names a parameter that is missing, or
/// that the model does not have.
std::vector<double> parameter_values(const Calibration& calibration, const TileModel& model);

/// The input of calibrate(): a pattern, its layout and setting, and the responses to be fitted.
struct CalibrationInput {
    base::Borrowed<pattern::NodeLayout> layout;       ///< of the pattern
    base::Borrowed<pattern::Pattern> pattern;         ///< which is fitted
    base::Borrowed<Setting> setting;                  ///< under which it responded
    base::Borrowed<std::vector<Response>> responses;  ///< of the pattern, to the setting's scenarios
};

/// Fit the linear displacements of a tile model to a pattern's responses: Eqs. (1) to (11). A model without
/// parameters is only compared with them. The comparison takes the linear displacements of a model for small
/// displacements, and the nonlinear responses of a model for large ones. The result depends on the input and
/// the options alone. Throws NumericalError if no sample can be fitted, or if no start of the search got
/// beyond its first point; base::Stopped.
Calibration calibrate(const TileModel& model, const CalibrationInput& input,
                      const CalibrationOptions& options = {});

}  // namespace fretwork::reduction
