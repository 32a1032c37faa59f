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

/// A parameter's name and value.
struct NamedValue {
    std::string name;    ///< name of the parameter
    double value = 0.0;  ///< value, SI
    friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

/// Options of calibrate().
struct CalibrationOptions {
    std::string optimizer = "ceres-multistart";  ///< name of a row of `optimizers`
    /// The catalogue that has the optimizer.
    std::span<const optimization::OptimizerRow> optimizers = optimization::optimizer_catalogue();
    int starts = 8;           ///< number of descents, or of repetitions of a method without descents
    std::uint64_t seed = 1;   ///< seed of all random choices
    int budget = 20000;       ///< largest cost, in the unit of the calibration's problem
    base::Control control{};  ///< progress and stop
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The result of fitting a tile model to the responses of one pattern. A tile model without parameters is
/// only compared with the responses.
struct Calibration {
    std::string model;       ///< name of the tile model
    std::string optimizer;   ///< name of the optimizer; "none" if nothing is fitted
    std::uint64_t seed = 0;  ///< seed of all random choices
    int starts = 0;          ///< number of starts, as in the options; 0 if nothing is fitted
    double objective = 0.0;  ///< E of Eq. (8) at the parameters
    /// Weighted contribution of each scenario of the setting to E: the sum over the magnitudes in Eq. (8).
    std::vector<double> scenario_errors;
    /// Cost of the fit, in the unit of the calibration's problem. Libraries call it `evaluations`.
    long cost = 0;
    /// Fitted parameters in the order of the model's row (if read from a library, sorted by name); empty if
    /// nothing is fitted.
    std::vector<NamedValue> parameters;
    std::vector<std::string> at_bound;  ///< names of the parameters at a bound
    /// True if the budget was not spent, and the start that found these parameters met the method's
    /// criterion. True if nothing is fitted.
    bool converged = true;
    int dead_starts = 0;  ///< number of starts without a descent; not stored in libraries
};

/// The values of the parameters in the order of a model's row. Throws InputError that names a missing
/// parameter, or a parameter that the model does not have.
std::vector<double> parameter_values(const Calibration& calibration, const TileModel& model);

/// The input of calibrate(): a pattern, its layout and setting, and the responses to be fitted.
struct CalibrationInput {
    base::Borrowed<pattern::NodeLayout> layout;       ///< node layout of the pattern
    base::Borrowed<pattern::Pattern> pattern;         ///< the pattern
    base::Borrowed<Setting> setting;                  ///< the setting of the responses
    base::Borrowed<std::vector<Response>> responses;  ///< responses of the pattern to the setting's scenarios
    /// Throws InputError if the setting is invalid, or if the responses are not those of a tile of this
    /// layout and setting: one response for each scenario, in order, with one sample for each magnitude and
    /// one row for each interface node.
    void validate() const;
};

/// Fit the linear displacements of a tile model to a pattern's responses: Eqs. (1) to (11). A model without
/// parameters is only compared with the responses: by its linear displacements if it is for small
/// displacements, else by its nonlinear responses. The result depends on the input and the options alone.
/// Throws InputError if an option or the input is invalid, and as build_tile(). Throws NumericalError if no
/// sample can be fitted, if the tile is a mechanism under a scenario (InputError if the model uses
/// RingHexagon), if no start of the search gave a descent, or if a model without parameters does not converge
/// where the pattern does. Throws base::Stopped, and as optimization::minimize().
Calibration calibrate(const TileModel& model, const CalibrationInput& input,
                      const CalibrationOptions& options = {});

}  // namespace fretwork::reduction
