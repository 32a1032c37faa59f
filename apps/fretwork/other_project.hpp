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

/// A project that is replaced keeps what is its own. Throws InputError if `file` is a project with a load
/// case that `own` has not.
void refuse_other_project(const std::string& file, const ProjectFrom& own);

}  // namespace fretwork::app
