// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/project.hpp>

#include <string>

namespace fretwork::app {

/// A project and its file.
struct ProjectFrom {
    const simulation::Project& project;
    const std::string& file;
};

/// Check that `file` may be replaced by a project that is made from `own`. Throws InputError if `file` is a
/// project with another outline, or with a load case that `own` does not have. A device and a file of another
/// kind are not read.
void refuse_other_project(const std::string& file, const ProjectFrom& own);

}  // namespace fretwork::app
