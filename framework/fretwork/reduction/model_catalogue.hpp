// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/calibration.hpp>
#include <fretwork/reduction/condensed_tile.hpp>
#include <fretwork/reduction/paper6_hexagon.hpp>

#include <span>
#include <string_view>

namespace fretwork::reduction {

/// One pattern in its setting, with its responses: what a reduced model is fitted to or compared with.
struct PatternCase {
    const pattern::NodeLayout& layout;
    const pattern::Pattern& pattern;
    const Setting& setting;
    const std::vector<Response>& responses;
};

/// How a model comes to its parameters.
enum class Preparation {
    Calibration,  ///< fitted to the responses: depends on the options
    None,         ///< follows from the pattern; its objective is only evaluated
};

/// One reduced model of a tile.
struct ReducedModelRow {
    std::string_view name;
    std::string_view summary;  ///< one line
    Preparation preparation;
    Calibration (*prepare)(const PatternCase& input, const CalibrationOptions& options);
};

/// All reduced models. To add one: a file with its function, and a row.
std::span<const ReducedModelRow> reduced_model_catalogue();
/// Throws InputError that names the nearest model, or all of them.
const ReducedModelRow& find_reduced_model(std::string_view name);

/// What a tile with this stiffness of its interface nodes (6n x 6n) does under each scenario of the setting.
/// Throws NumericalError that names a scenario under which it can move freely.
UnitDisplacements stiffness_displacements(const Eigen::MatrixXd& stiffness, const Setting& setting);

}  // namespace fretwork::reduction
