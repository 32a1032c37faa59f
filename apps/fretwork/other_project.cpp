// SPDX-License-Identifier: GPL-3.0-or-later
#include "other_project.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/project_file.hpp>

#include <algorithm>
#include <filesystem>

namespace fretwork::app {

void refuse_other_project(const std::string& file, const ProjectFrom& own) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return;
    for (const simulation::LoadCase& other : simulation::read_project(file).load_cases) {
        const auto has_name = [&](const simulation::LoadCase& known) { return known.name == other.name; };
        if (std::ranges::none_of(own.project.load_cases, has_name))
            throw base::InputError(file, "",
                                   "is another project: its load case '" + other.name +
                                       "' would be lost, which " + own.file +
                                       " has not; give --out another name");
    }
}

}  // namespace fretwork::app
