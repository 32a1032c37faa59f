// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_identity.hpp"
#include "options/file_options.hpp"
#include "other_project.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/project_file.hpp>

#include <algorithm>

namespace fretwork::app {

void refuse_other_project(const std::string& file, const ProjectFrom& own) {
    if (content_of(file) != kProjectFile.contents) return;
    const simulation::Project present = simulation::read_project(file);
    for (const simulation::LoadCase& other : present.load_cases) {
        const auto has_name = [&](const simulation::LoadCase& known) { return known.name == other.name; };
        if (std::ranges::none_of(own.project.load_cases, has_name))
            throw base::InputError(file, "",
                                   "is another project: its load case '" + other.name +
                                       "' would be lost, because " + own.file +
                                       " does not have it; give --out another name");
    }
    if (present.outline != own.project.outline || present.further_outlines != own.project.further_outlines)
        throw base::InputError(
            file, "",
            "is another project: its outline is not that of " + own.file + "; give --out another name");
}

}  // namespace fretwork::app
