// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::studio {

/// A document that the start screen offers.
struct Example {
    std::string name;
    std::string title;
    std::string description;  ///< one line
};

/// All of them, in the order in which they are offered.
const std::vector<Example>& examples();

/// Throws as make_example().
std::string example_title(std::string_view name);

/// Make an example's project: tiled, painted, held and loaded. Throws InputError that lists the names.
simulation::Project make_example(std::string_view name, const base::Control& control);

}  // namespace fretwork::studio
