// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// Whether samples past the first loss of stability are fitted. "branch" in files.
enum class SamplePolicy {
    Paper,   ///< fitted, as by a solver that does not check stability; so, it seems, did the paper
    Stable,  ///< left out from the first loss on: only states that a specimen reaches are fitted
};
std::string_view sample_policy_name(SamplePolicy policy);

/// Which part of a bar is flexible. "joints" in files. experiments/joints compares both with solids of the
/// true outline.
enum class Joints {
    Centreline,  ///< all of its centreline, as in the paper
    Stiff        ///< where it merges with others, it neither stretches nor twists nor bends in the plane
};
std::string_view joints_name(Joints joints);

/// Material and section of the beams of a tile.
struct TileMaterial {
    mechanics::Section section;
    mechanics::Material material;
};

/// All that a response depends on besides its pattern: material, section, tile size, scenarios and
/// discretization; and what the material bears.
struct Setting {
    mechanics::Material material;
    /// Pa; the stress that the material bears. No response depends on it: with another strength a setting is
    /// the same to libraries and results, and so with a section of another shape and the same numbers.
    /// "material/strength" in files.
    std::optional<double> strength{};
    mechanics::Section section;
    double tile_side = 0.0;  ///< m; side of the regular polygon, a hexagon
    int sides = 6;
    std::vector<Scenario> scenarios;
    int divisions =
        2;  ///< elements a beam in responses: off by at most 7e-4 in the sample of experiments/verification
    int magnitudes = 10;  ///< k = 1..magnitudes, at k / magnitudes of the scenario's largest magnitude
    SamplePolicy sample_policy = SamplePolicy::Paper;
    Joints joints = Joints::Centreline;
    /// Throws InputError if a value is invalid, or a scenario does not fit the polygon. `source` names the
    /// setting in the message.
    void validate(const std::string& source = "setting") const;
    friend bool operator==(const Setting&, const Setting&) = default;
};

/// Values of a setting that look like errors of units, one line each.
std::vector<std::string> doubts_about(const Setting& setting);

/// The paper's: hexagon inscribed in a circle of diameter 0.03 sqrt(3) m, 2 x 2 mm, 1 GPa, nu 0.3, the five
/// scenarios; but two elements a beam, where the paper takes one.
Setting paper_setting();

/// The paper's with stiff joints: of things that are made, whose bars merge where they meet. New projects
/// without a library have it. How near it is to solids: experiments/joints.
Setting made_setting();

}  // namespace fretwork::reduction
