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

/// The displacements of a tile's interface nodes under one scenario, at the magnitudes k = 1, 2, .. of the
/// setting.
struct Response {
    /// The displacements under one magnitude.
    struct Sample {
        int step = 0;                         ///< number k of the magnitude
        double magnitude = 0.0;               ///< magnitude, N
        mechanics::NodeValues displacements;  ///< one row for each interface node; zeros if not converged
        bool converged = true;                ///< true if an equilibrium was found
        /// True if the sample converged, and no test says that the equilibrium is not stable.
        bool stable = true;
        /// True if no equilibrium was found because the path turns back before this magnitude.
        bool limit_load = false;
        /// The discretization error, estimated by Richardson extrapolation, as a share of the largest
        /// displacement (or rotation) of the tile's nodes. None if no estimate was requested, if the sample
        /// did not converge with both numbers of divisions, or if the two solutions differ too much.
        std::optional<double> discretization_error{};
    };
    std::string scenario;         ///< name of the scenario
    std::vector<Sample> samples;  ///< samples in order of ascending magnitude
};

/// The beams of a fan in a convex polygon, without supports and loads. Node i of the frame is node i of the
/// fan, so the interface nodes come first. Interface nodes that the pattern does not use have no beam. Throws
/// as pattern::place_fan().
mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const TileMaterial& bars);

/// The beams of a fan in a convex polygon, with the bars and joints of a setting. Throws as
/// pattern::place_fan().
mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const Setting& setting);

/// The beams of a pattern in a convex polygon. Throws as pattern::make_fan() and pattern::place_fan().
mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const geometry::Polygon& polygon, const TileMaterial& bars);

/// The pattern's full model in the setting's polygon, without supports and loads. The interface nodes are the
/// first nodes of the frame. Throws as geometry::regular_polygon().
mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const Setting& setting);

/// The frame of one tile with the supports and loads of a scenario at its largest magnitude. Here and below,
/// the scenario must number the interface nodes as the tile does (see spread_over_sides()).
mechanics::Frame scenario_frame(mechanics::Frame tile, const Scenario& scenario);

/// Add the supports and loads of a scenario at its largest magnitude to an assembled tile.
void apply_scenario(const Scenario& scenario, mechanics::Assembly& tile);

/// A tile with the supports and loads of a scenario at its largest magnitude.
struct LoadedTile {
    base::Borrowed<mechanics::Assembly> structure;  ///< the tile with its inner nodes
    /// Number of interface nodes, which come first in the structure.
    int interface_nodes = 0;
};

/// The displacements of the interface nodes at the setting's magnitudes of the scenario with which the tile
/// is loaded. Throws as mechanics::follow_load_path.
Response follow_scenario(const LoadedTile& tile, const Scenario& scenario, const Setting& setting,
                         const base::Control& control = {});

/// Options of compute_responses().
struct ResponseOptions {
    /// True: fill Sample::discretization_error. The cost is 50 % higher; with odd divisions, it triples.
    bool estimate_error = false;
    base::Control control{};  ///< progress counts scenarios
};

/// The nonlinear responses of a pattern, one for each scenario of the setting, with each beam divided into
/// the setting's number of elements. The paper's Eq. (2) has one element for each beam. Throws InputError if
/// the setting is invalid, or if mechanics::validate() refuses the tile under the first scenario, for example
/// because it can move freely. Throws NumericalError if the tile can move freely under another scenario.
/// Throws Stopped.
std::vector<Response> compute_responses(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                        const Setting& setting, const ResponseOptions& options = {});

}  // namespace fretwork::reduction
