// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame.hpp>
#include <fretwork/reduction/scenario.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// What becomes of samples past the first loss of stability.
enum class Branch {
    Paper,   ///< kept, as a solver gives them that does not look at stability: the paper must have done so
    Stable,  ///< left out, from the first loss on: the reduced model is fitted to what a specimen does
};
std::string_view branch_name(Branch branch);

/// Under what conditions patterns are loaded and compared: all that a response depends on besides its
/// pattern.
struct Setting {
    mechanics::Material material;
    mechanics::Section section;
    double tile_side = 0.0;  ///< m; side of the regular polygon, a hexagon
    int sides = 6;
    std::vector<Scenario> scenarios;
    int divisions =
        2;  ///< elements a beam in responses: off by at most 7e-4 in the sample of experiments/verification
    int magnitudes = 10;  ///< k = 1..magnitudes, at k / magnitudes of the scenario's largest magnitude
    Branch branch = Branch::Paper;
    /// Throws InputError if a value makes no sense, or a scenario does not fit the polygon. `source` names
    /// the setting in the message.
    void validate(const std::string& source = "setting") const;
    friend bool operator==(const Setting&, const Setting&) = default;
};

/// The paper's: hexagon inscribed in a circle of diameter 0.03 sqrt(3) m, 2 x 2 mm, 1 GPa, nu 0.3, the five
/// scenarios; but two elements a beam, where the paper takes one.
Setting paper_setting();

/// Read a setting file. What is left out is as in paper_setting(); a scenario is an object, the name of one
/// of the paper's, or {"use": name, "max_magnitude": newtons}. Throws InputError with file and JSON pointer.
Setting read_setting(const std::filesystem::path& path);

/// The setting as JSON text: what a library stores, and what identifies it.
std::string setting_text(const Setting& setting);
/// The inverse of setting_text; `source` names the text in messages.
Setting parse_setting(std::string_view text, std::string source);

/// In one line, the first difference between two settings ("/section/J: 2.25e-12, where the library
/// has 2.3e-12"), or "".
std::string setting_difference(const Setting& wanted, const Setting& present);

}  // namespace fretwork::reduction
