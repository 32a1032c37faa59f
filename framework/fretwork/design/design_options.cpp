// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/design.hpp>

#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace fretwork::design {
namespace {

void require_not_negative(double value, const char* name) {
    if (value >= 0.0 && std::isfinite(value)) return;
    throw base::InputError(std::string(name) + " must be zero or more");
}

}  // namespace

void DesignOptions::validate(const simulation::Project& project) const {
    if (palette.empty()) throw base::InputError("the palette is empty: there is no pattern to paint with");
    std::set<std::string_view> ids;
    for (const pattern::NamedPattern& own : palette) {
        if (!ids.insert(own.id).second)
            throw base::InputError("the palette names the pattern " + own.id +
                                   " twice, where each pattern is named once");
    }
    require_not_negative(max_mass, "the largest mass");
    require_not_negative(max_utilization, "the largest utilization");
    require_not_negative(seconds, "the time");
    if (clearance) require_not_negative(*clearance, "the clearance");
    if (!load_case.empty()) (void)simulation::find_load_case(project, load_case);
    if (most_solutions < 0) throw base::InputError("the number of solutions must be zero or more");
    if (uniform_paintings < 1 || shortlist < 1)
        throw base::InputError("at least one uniform painting and one pattern are needed to begin with");
    for (const tiling::TileIndex tile : keep) {
        if (!project.tessellation.tiles.has(tile))
            throw base::InputError("there is no tile " + std::to_string(tile.value) +
                                   "; they run from 0 to " +
                                   std::to_string(project.tessellation.tiles.size() - 1));
    }
}

}  // namespace fretwork::design
