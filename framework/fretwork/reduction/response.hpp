// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/base/control.hpp>
#include <fretwork/geometry/polygon.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::reduction {

/// The displacements of a tile's interface nodes under one scenario, at its magnitudes k = 1, 2, ..
struct Response {
    struct Sample {
        int step = 0;                         ///< k
        double magnitude = 0.0;               ///< N
        mechanics::NodeValues displacements;  ///< one row for each interface node; not converged: zeros
        bool converged = true;
        bool stable = true;
        bool limit_load = false;  ///< did not converge, since the path turns back before this magnitude
        /// As a share of the largest displacement, or rotation, of the tile's nodes; estimated by Richardson.
        /// Empty: not asked for, or this sample or its twin with other divisions did not converge.
        std::optional<double> discretization_error{};
    };
    std::string scenario;
    std::vector<Sample> samples;
};

/// The beams of a fan in a convex polygon, without supports and loads; interface node i is node i. Interface
/// nodes that the pattern does not use have no beam.
mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const TileMaterial& bars);

/// The same with bars and joints of a setting.
mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const Setting& setting);

/// From a pattern.
mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const geometry::Polygon& polygon, const TileMaterial& bars);

/// The pattern's full model in the setting's polygon, without supports and loads; interface node i is node i.
mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const Setting& setting);

/// A frame of one tile, held and loaded as a scenario says, at its largest magnitude. Here and below, the
/// scenario names interface nodes as the tile has them (spread_over_sides).
mechanics::Frame scenario_frame(mechanics::Frame tile, const Scenario& scenario);

/// The same for one that is assembled already.
void apply_scenario(const Scenario& scenario, mechanics::Assembly& tile);

/// A tile that is held and loaded.
struct LoadedTile {
    base::Borrowed<mechanics::Assembly> structure;
    int interface_nodes = 0;  ///< its first nodes
};

/// The displacements of the interface nodes at the setting's magnitudes of a scenario. Throws as
/// mechanics::follow_load_path.
Response follow_scenario(const LoadedTile& tile, const Scenario& scenario, const Setting& setting,
                         const base::Control& control = {});

struct ResponseOptions {
    bool estimate_error = false;  ///< fill Sample::discretization_error, at half as much again of the time
    base::Control control{};      ///< receives every scenario
};

/// The nonlinear responses of a pattern, one for each scenario of the setting, with every beam in as many
/// elements as the setting says. Paper, Eq. (2); the paper takes one element a beam. Throws InputError,
/// NumericalError if a scenario lets the tile move freely, and Stopped.
std::vector<Response> compute_responses(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                        const Setting& setting, const ResponseOptions& options = {});

}  // namespace fretwork::reduction
