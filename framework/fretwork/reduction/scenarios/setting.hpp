// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// The treatment of samples past the first loss of stability; the key "branch" in files.
enum class SamplePolicy {
    Paper,   ///< the samples are fitted, as probably in the paper: its solver does not check stability
    Stable,  ///< the samples are left out; only states that a specimen can reach are fitted
};
/// The word for a policy in files.
std::string_view sample_policy_name(SamplePolicy policy);

/// The part of a bar that is flexible; the key "joints" in files. experiments/joints compares both choices
/// with solids of the true outline.
enum class Joints {
    Centreline,  ///< the whole centreline, as in the paper
    /// The bar without its ends. The ends merge with other bars and do not stretch, twist or bend in the
    /// plane.
    Stiff
};
/// The word for a treatment of joints in files.
std::string_view joints_name(Joints joints);

/// Material and section of the beams of a tile.
struct TileMaterial {
    mechanics::Section section;    ///< section of each beam
    mechanics::Material material;  ///< material of each beam
};

/// The largest number of sides of the polygon of a setting.
inline constexpr int kMostSides = 100;
/// The largest number of elements of each beam of a setting.
inline constexpr int kMostBeamDivisions = 100;
/// The largest number of magnitudes of a scenario of a setting.
inline constexpr int kMostMagnitudes = 1000;

/// All inputs of a response besides its pattern: material, section, tile size, scenarios and discretization.
/// A setting also has the strength of the material.
struct Setting {
    mechanics::Material material;  ///< material of the bars
    /// The stress that the material bears, Pa; the key "material/strength" in files. No response depends on
    /// the strength, so libraries and results treat settings that differ only in strength as equal. They do
    /// the same for sections that differ only in shape, with equal areas and moments.
    std::optional<double> strength{};
    mechanics::Section section;  ///< section of the bars
    /// Side of the regular polygon (a hexagon unless `sides` differs from 6), m.
    double tile_side = 0.0;
    int sides = 6;                    ///< number of sides of the regular polygon in which patterns are loaded
    std::vector<Scenario> scenarios;  ///< the scenarios under which patterns are loaded
    /// Number of elements of each beam in responses. With two, the error is at most 7e-4 in the sample of
    /// experiments/verification.
    int divisions = 2;
    /// Number of magnitudes; sample k has k / magnitudes of the scenario's largest magnitude.
    int magnitudes = 10;
    SamplePolicy sample_policy = SamplePolicy::Paper;  ///< treatment of samples past a loss of stability
    Joints joints = Joints::Centreline;                ///< the flexible part of a bar
    /// Throws InputError if a value is invalid, or a scenario does not fit the polygon. `source` names the
    /// setting in the message.
    void validate(const std::string& source = "setting") const;
    friend bool operator==(const Setting&, const Setting&) = default;
};

/// Warnings, one line each, about values of a setting that look like errors of units.
std::vector<std::string> warnings_about(const Setting& setting);

/// The paper's setting: a hexagon inscribed in a circle of diameter 0.03 sqrt(3) m, bars of 2 x 2 mm, 1 GPa,
/// nu 0.3, and the five scenarios. One value differs: each beam has two elements, in the paper one.
Setting paper_setting();

/// The paper's setting with stiff joints, for surfaces to be made: their bars merge where they meet. A new
/// project without a library has this setting. experiments/joints compares such surfaces with solids.
Setting made_setting();

}  // namespace fretwork::reduction
