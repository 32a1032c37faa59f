// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/calibration/calibration.hpp>

#include <string>
#include <vector>

namespace fretwork::tile_models {

/// A pattern with its best calibration of each model that has parameters.
struct CalibratedPattern {
    pattern::Pattern pattern;
    std::string id;
    std::vector<reduction::Calibration> calibrations;
};

/// One model on one pattern's scenarios.
struct ScenarioRow {
    std::string pattern;
    std::string model;
    std::size_t parameters = 0;
    double objective = 0.0;  ///< E: of linear displacements, or of the model's own large ones
    std::vector<double> scenario_errors;
    long evaluations = 0;
    double cpu_seconds = 0.0;
    std::size_t at_bound = 0;  ///< how many parameters
};

struct ScenarioStudy {
    std::vector<CalibratedPattern> patterns;
    std::vector<ScenarioRow> rows;
};

/// The built-in models and those that are measured here.
const std::vector<reduction::TileModel>& catalogue();

/// Every reduced model on `count` patterns of the paper's layout, spread over the numbers of edges.
ScenarioStudy study_scenarios(const reduction::Setting& setting, std::size_t count, int threads);

}  // namespace fretwork::tile_models
