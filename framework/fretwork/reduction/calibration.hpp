// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/setting.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::reduction {

/// The six parameters of the paper's reduced model, Eq. (4).
struct Paper6Parameters {
    double A = 0.0;      ///< m^2
    double I2 = 0.0;     ///< m^4
    double I3 = 0.0;     ///< m^4
    double J = 0.0;      ///< m^4
    double theta = 0.0;  ///< rad, counterclockwise positive
    double R = 0.0;      ///< m, circumradius of the inner ring
    static constexpr std::array<const char*, 6> names = {"A", "I2", "I3", "J", "theta", "R"};
};

struct CalibrationOptions {
    std::string optimizer = "gauss-newton-multistart";  ///< a row of the optimizer catalogue
    int starts = 8;
    std::uint64_t seed = 1;
    int budget = 20000;  ///< evaluations of the objective at most
    /// Throws InputError if a value makes no sense.
    void validate() const;
};

/// A reduced model fitted to, or only compared with, the responses of one pattern.
struct Calibration {
    std::string model = "paper6";
    std::string optimizer;
    std::uint64_t seed = 0;
    int starts = 0;
    double objective = 0.0;  ///< E of Eq. (8) at the parameters
    std::vector<double>
        scenario_errors;  ///< e_k summed over the magnitudes as in Eq. (8): weighted parts of E, by scenario
    long evaluations = 0;
    Paper6Parameters parameters;
    std::vector<std::string> at_bound;  ///< names of the parameters at a bound
    bool converged = true;
};

/// Fit the paper's six-parameter model to a pattern's responses: Eqs. (1) to (11). Deterministic given the
/// options.
Calibration calibrate_paper6(const std::vector<Response>& responses, const Setting& setting,
                             const CalibrationOptions& options = {});

}  // namespace fretwork::reduction
