// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// The treatment of samples past the first loss of stability. The key "branch" in files.
enum class SamplePolicy {
    Paper,   ///< fitted, as a solver without a check of stability does; the paper seems to do so
    Stable,  ///< left out: only states that a specimen reaches are fitted
};
/// The word for it in files.
std::string_view sample_policy_name(SamplePolicy policy);

/// The flexible length of a bar. The key "joints" in files. experiments/joints compares both with solids of
/// the true outline.
enum class Joints {
    Centreline,  ///< the whole centreline, as in the paper
    Stiff        ///< all but the ends that merge with other bars, which neither stretch nor twist nor bend in
                 ///< the plane
};
/// The word for it in files.
std::string_view joints_name(Joints joints);

/// Material and section of the beams of a tile.
struct TileMaterial {
    mechanics::Section section;    ///< of each bar
    mechanics::Material material;  ///< of each bar
};

/// Everything that a response depends on besides its pattern: material, section, tile size, scenarios and
/// discretization. The strength of the material is kept here, too.
struct Setting {
    mechanics::Material material;  ///< of the bars
    /// The stress that the material bears, Pa. The key "material/strength" in files. No response depends on
    /// it, so libraries and results treat settings that differ only in strength as the same. They do so too
    /// if only the shape of the section differs, with equal areas and moments.
    std::optional<double> strength{};
    mechanics::Section section;       ///< of the bars
    double tile_side = 0.0;           ///< m; side of the regular polygon, a hexagon
    int sides = 6;                    ///< of the regular polygon in which patterns are loaded
    std::vector<Scenario> scenarios;  ///< under which patterns respond
    int divisions = 2;    ///< elements of each beam in responses; two err by at most 7e-4 in the sample of
                          ///< experiments/verification
    int magnitudes = 10;  ///< sample k = 1..magnitudes has k / magnitudes of the scenario's largest magnitude
    SamplePolicy sample_policy = SamplePolicy::Paper;  ///< which samples are fitted
    Joints joints = Joints::Centreline;                ///< whether joints have a size
    /// Throws InputError if a value is invalid, or a scenario does not fit the polygon. `source` names the
    /// setting in the message.
    void validate(const std::string& source = "setting") const;
    friend bool operator==(const Setting&, const Setting&) = default;
};

/// Warnings about values of a setting that look like errors of units, one line each.
std::vector<std::string> doubts_about(const Setting& setting);

/// The paper's setting: a hexagon inscribed in a circle of diameter 0.03 sqrt(3) m, bars of 2 x 2 mm, 1 GPa,
/// nu 0.3, and the five scenarios. One value differs: two elements for each beam, where the paper has one.
Setting paper_setting();

/// The paper's setting with stiff joints, for surfaces that are made: their bars merge where they meet. New
/// projects without a library have this setting. experiments/joints compares it with solids.
Setting made_setting();

}  // namespace fretwork::reduction
