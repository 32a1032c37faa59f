// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/candidate.hpp>
#include <fretwork/tiling/detail/numbering.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::tiling {
namespace {

using detail::Candidate;
using detail::Start;

constexpr int kMostTiles = 100000;
constexpr double kTilesInFinal =
    1500;  // so many are made in all, about: a small outline can be tried in more ways

/// About how many tiles an outline needs.
double estimated_tiles(const Outline& outline, const TessellationOptions& options) {
    const double hexagon = 1.5 * std::numbers::sqrt3 * options.edge_length * options.edge_length;
    return std::abs(pattern::signed_area(outline.boundary)) / hexagon;
}

/// The lattices whose first sketches are the most regular, best first. A triangular lattice is the same again
/// after 60 degrees.
std::vector<Start> best_lattices(const Outline& outline, const TessellationOptions& options) {
    const auto count = static_cast<std::size_t>(options.lattice_angles);
    std::vector<std::pair<double, std::size_t>> ranking(count);
    const auto lattice = [&](std::size_t i) {
        return Start{std::numbers::pi / 3 * static_cast<double>(i) / static_cast<double>(count)};
    };
    base::parallel_for(count, options.threads, [&](std::size_t i) {
        ranking[i] = {detail::rough_irregularity(outline, options, lattice(i)), i};
    });
    std::sort(ranking.begin(), ranking.end());
    std::vector<Start> starts;
    const double affordable = std::max(3.0, kTilesInFinal / estimated_tiles(outline, options));
    for (const auto& [irregularity, i] : ranking) {
        if (static_cast<double>(starts.size()) < affordable) starts.push_back(lattice(i));
    }
    return starts;
}

Candidate best_candidate(const Outline& outline, const TessellationOptions& options) {
    std::vector<Start> starts = best_lattices(outline, options);
    starts.emplace_back();  // remeshing
    std::vector<Candidate> candidates(starts.size());
    base::parallel_for(starts.size(), options.threads, [&](std::size_t i) {
        candidates[i] = detail::make_candidate(outline, options, starts[i]);
    });
    return std::move(*std::min_element(candidates.begin(), candidates.end(), detail::is_better));
}

/// How far the boundary reaches in x and in y, metres.
std::pair<double, double> extent(const Outline& outline) {
    const auto [left, right] = std::minmax_element(outline.boundary.begin(), outline.boundary.end(),
                                                   [](auto& a, auto& b) { return a.x < b.x; });
    const auto [low, high] = std::minmax_element(outline.boundary.begin(), outline.boundary.end(),
                                                 [](auto& a, auto& b) { return a.y < b.y; });
    return {right->x - left->x, high->y - low->y};
}

/// A slip of units should not fill the memory. An outline without area could still be too long.
void check_size(const Outline& outline, const TessellationOptions& options) {
    const auto [width, height] = extent(outline);
    const double tiles = std::max(estimated_tiles(outline, options), (width + height) / options.edge_length);
    if (tiles <= kMostTiles) return;
    const std::string need =
        std::isfinite(tiles) ? "about " + base::format_number(std::round(tiles)) : "countless";
    throw base::InputError(
        "the outline is " + base::format_number(width) + " m wide and " + base::format_number(height) +
        " m high: with sides of " + base::format_number(options.edge_length) + " m it would need " + need +
        " tiles, where " + std::to_string(kMostTiles) + " are the most; is the unit of the outline right?");
}

/// Refuse what could not be painted or simulated.
void check(const Candidate& candidate, const TessellationOptions& options) {
    const std::string tiles = "tiles with sides of " + base::format_number(options.edge_length) + " m";
    if (candidate.dual.cells.empty())
        throw base::GeometryError("the outline is too small or too narrow for " + tiles);
    if (candidate.pieces > 1)
        throw base::GeometryError("the outline is too narrow somewhere for " + tiles +
                                  ": they would fall into " + std::to_string(candidate.pieces) +
                                  " parts; choose a smaller edge length");
    for (std::size_t cell = 0; cell < candidate.dual.cells.size(); ++cell) {
        const pattern::Polygon polygon = detail::polygon_of(candidate.dual, cell);
        if (pattern::is_convex(polygon)) continue;
        throw base::GeometryError("the outline is too narrow for " + tiles + " near (" +
                                  base::format_number(polygon.front().x) + ", " +
                                  base::format_number(polygon.front().y) +
                                  "): a tile there would not be convex; choose a smaller edge length");
    }
}

}  // namespace

void TessellationOptions::validate() const {
    if (!(edge_length > 0) || !std::isfinite(edge_length))
        throw base::InputError("the edge length of a tessellation is " + base::format_number(edge_length) +
                               " m, where a length above zero is needed");
    if (remeshing_iterations < 1 || relaxation_iterations < 0 || lattice_angles < 0)
        throw base::InputError(
            "a tessellation needs at least one iteration of remeshing, and no number below zero");
}

TessellationResult tessellate(const Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options) {
    options.validate();
    check_size(outline, options);
    const Candidate best = best_candidate(outline, options);
    check(best, options);
    return {detail::number(best.dual, layout), best.report};
}

}  // namespace fretwork::tiling
