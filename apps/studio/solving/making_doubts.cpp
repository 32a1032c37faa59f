// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <studio/solving/making_doubts.hpp>

#include <algorithm>
#include <cstdio>

namespace fretwork::studio {
namespace {

using base::Json;
using Place = MakingDoubts::Place;

void add_overlaps(const simulation::Surface& surface, const base::Control& control, MakingDoubts& doubts) {
    auto close = simulation::close_bars(surface, 0.0, control);
    if (close.empty()) return;
    doubts.counts.overlaps = close.size();
    doubts.words.push_back(simulation::close_bars_text(close));
    std::ranges::stable_sort(close, {}, &simulation::CloseBars::gap);
    const simulation::SurfaceBeams beams = simulation::surface_beams(surface);
    for (const simulation::CloseBars& pair : close) {
        if (doubts.places.size() == MakingDoubts::kMostPlaces) return;
        const auto& ends = beams.ends[pair.bars[0]];
        const Eigen::Vector3d middle = 0.5 * (beams.nodes[ends[0]] + beams.nodes[ends[1]]);
        doubts.places.push_back({"overlap", {middle.x(), middle.y()}, pair.gap});
    }
}

std::string narrow_text(const std::vector<fabrication::NarrowPlace>& narrow, double clearance) {
    char text[160];
    std::snprintf(text, sizeof text, "%zu %s narrower than %.3g mm, the narrowest %.2g mm", narrow.size(),
                  narrow.size() == 1 ? "gap or opening is" : "gaps and openings are", 1e3 * clearance,
                  1e3 * narrow.front().width);
    return text;
}

void add_narrow_places(const simulation::Surface& surface, const fabrication::ShapeOptions& options,
                       double clearance, MakingDoubts& doubts) {
    const fabrication::BarPlan plan = fabrication::bar_plan(surface, options.frame_width);
    const fabrication::Shape shape = fabrication::make_shape(plan, options.without_kerf());
    options.control.check();
    const auto narrow = fabrication::narrow_places(shape, plan, clearance, options.control);
    if (narrow.empty()) return;
    doubts.words.push_back(narrow_text(narrow, clearance));
    doubts.counts.gaps = static_cast<std::size_t>(
        std::ranges::count(narrow, fabrication::NarrowPlace::Kind::Gap, &fabrication::NarrowPlace::kind));
    doubts.counts.openings = narrow.size() - doubts.counts.gaps;
    for (const fabrication::NarrowPlace& one : narrow) {
        if (doubts.places.size() == MakingDoubts::kMostPlaces) return;
        const bool is_gap = one.kind == fabrication::NarrowPlace::Kind::Gap;
        doubts.places.push_back({is_gap ? "gap" : "opening", one.place, one.width});
    }
}

}  // namespace

MakingDoubts making_doubts(const simulation::Surface& surface, const fabrication::ShapeOptions& shape,
                           double clearance) {
    MakingDoubts doubts;
    add_overlaps(surface, shape.control, doubts);
    shape.control.check();
    add_narrow_places(surface, shape, clearance, doubts);
    return doubts;
}

Json making_event(const MakingDoubts& doubts, std::int64_t revision) {
    Json places = Json::array();
    for (const Place& place : doubts.places)
        places.push_back({{"kind", place.kind}, {"place", {place.at.x, place.at.y}}, {"width", place.width}});
    const auto& counts = doubts.counts;
    return {{"event", "making"},
            {"revision", revision},
            {"words", doubts.words},
            {"counts", {{"overlap", counts.overlaps}, {"gap", counts.gaps}, {"opening", counts.openings}}},
            {"places", places}};
}

}  // namespace fretwork::studio
