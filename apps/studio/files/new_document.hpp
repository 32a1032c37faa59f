// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/new_project.hpp>
#include <studio/server/sent_outline.hpp>

#include <string>
#include <vector>

namespace fretwork::studio {

/// The request `new`: an example, or an outline and the way in which it is tiled and painted.
struct NewRequest {
    std::string example;
    SentOutline outline;
    simulation::NewProjectOptions options;
    bool is_to_be_made = false;  ///< painted with one pattern that can be made
};
/// Throws InputError if the request is malformed.
NewRequest read_new(const base::JsonReader& json);

struct NamedProject {
    std::string name;
    simulation::Project project;
    std::vector<std::string> remarks{};  ///< on how the outline was read, and tiled
    bool is_example = false;
};
/// Read the outline, tile and paint it. Throws InputError, GeometryError and Stopped.
NamedProject make(const NewRequest& wanted, const base::Control& control);

}  // namespace fretwork::studio
