// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <studio/solving/first_painting.hpp>
#include <studio/solving/making_doubts.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <tuple>

namespace fretwork::studio {
namespace {

using pattern::NamedPattern;
using simulation::Project;

/// Patterns with few bars have the widest gaps: if this many cannot be made, one with more bars hardly can.
constexpr std::size_t kMostTried = 200;

/// Fewest bars first, then by name.
std::vector<NamedPattern> candidates(const pattern::NodeLayout& layout, const base::Control& control) {
    pattern::EnumerationOptions options;
    options.edges = pattern::default_edge_range(layout);
    options.control = control;
    std::vector<NamedPattern> all;
    for (const pattern::Pattern& one : pattern::enumerate_patterns(layout, options))
        all.push_back(pattern::named(layout, one));
    std::ranges::sort(all, {}, [](const NamedPattern& one) {
        return std::pair<int, const std::string&>(one.pattern.edge_count(), one.id);
    });
    all.resize(std::min(all.size(), kMostTried));
    return all;
}

void paint(Project& project, const NamedPattern& pattern) {
    project.tessellation.patterns = {pattern};
    for (tiling::Tile& tile : project.tessellation.tiles) tile.pattern = 0;
}

/// The surface with the bars of two tiles only.
simulation::Surface only_tiles(simulation::Surface surface, const std::array<tiling::TileIndex, 2>& kept) {
    std::vector<tiling::Tile>& tiles = surface.tessellation.tiles;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        if (std::ranges::find(kept, tiling::TileIndex(t)) == kept.end()) tiles[t].pattern = -1;
    }
    return surface;
}

/// Tries patterns on the tiles of a project.
class Trials {
  public:
    explicit Trials(const base::Control& control) : control_(control) {}

    bool can_be_made(const Project& project, double clearance) {
        const simulation::Surface surface = simulation::make_surface(project, nullptr);
        // Bars that overlap are found in a hundredth of the time that gaps take.
        if (do_bars_overlap(surface)) return false;
        return making_doubts(surface, {.control = control_}, clearance).words.empty();
    }

  private:
    /// Bars of the next pattern often overlap in the same tiles as those of the last one. Overlaps do not
    /// depend on other tiles, so these two tiles are looked at first, and alone.
    bool do_bars_overlap(const simulation::Surface& surface) {
        if (worst_ && !simulation::close_bars(only_tiles(surface, *worst_), 0.0, control_).empty())
            return true;
        const auto close = simulation::close_bars(surface, 0.0, control_);
        if (close.empty()) return false;
        worst_ = std::ranges::min_element(close, {}, &simulation::CloseBars::gap)->tiles;
        return true;
    }

    const base::Control& control_;
    std::optional<std::array<tiling::TileIndex, 2>> worst_;
};

std::string none_text(const Project& project) {
    const simulation::Surface surface = simulation::make_surface(project, nullptr);
    char text[200];
    std::snprintf(
        text, sizeof text,
        "no pattern can be made here without bars that overlap or gaps below %.3g mm: larger tiles or "
        "narrower bars than %.3g mm are needed; the tiles are left bare",
        1e3 * fabrication::FactsOptions().clearance,
        1e3 * mechanics::rectangle_width(surface.setting.section));
    return text;
}

}  // namespace

std::string paint_to_be_made(Project& project, const base::Control& control) {
    const double clearance = fabrication::FactsOptions().clearance;
    Project trial = project;
    Trials trials(control);
    for (const NamedPattern& candidate : candidates(project.layout, control)) {
        control.check();
        paint(trial, candidate);
        if (!trials.can_be_made(trial, clearance)) continue;
        project = std::move(trial);
        return "";
    }
    return none_text(project);
}

}  // namespace fretwork::studio
