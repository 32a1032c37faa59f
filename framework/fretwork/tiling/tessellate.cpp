// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/tiling/detail/candidate.hpp>
#include <fretwork/tiling/detail/message_text.hpp>
#include <fretwork/tiling/detail/numbering.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/small_parts.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::tiling {
namespace {

using detail::Candidate;
using detail::metres;
using detail::short_number;
using detail::Start;
using detail::Work;

constexpr int kMostTiles = 100000;
constexpr double kTilesInFinal =
    1500;  // so many are made in all, about: a small outline can be tried in more ways
constexpr double kSmallestEdge = 1e-9;  // m; products of such lengths are far from underflow
constexpr double kLargestEdge = 1e6;    // m
/// Beyond, in tile sides from the origin, rounding of coordinates reaches the size of the smallest details.
constexpr double kFarthest = 1e9;
constexpr double kHexagonArea = 1.5 * std::numbers::sqrt3;  // of side 1

/// About how many tiles an outline needs.
double estimated_tiles(const Outline& outline, const TessellationOptions& options) {
    const double hexagon = kHexagonArea * options.edge_length * options.edge_length;
    return std::abs(pattern::signed_area(outline.boundary)) / hexagon;
}

/// How many lattices are worked out, of those that are sketched.
std::size_t affordable_lattices(const Outline& outline, const TessellationOptions& options) {
    const double affordable = std::ceil(std::max(3.0, kTilesInFinal / estimated_tiles(outline, options)));
    return static_cast<std::size_t>(std::min(affordable, static_cast<double>(options.lattice_angles)));
}

/// The lattices whose first sketches are the most regular, best first. A triangular lattice is the same again
/// after 60 degrees.
std::vector<Start> best_lattices(const Outline& outline, const TessellationOptions& options, Work& work) {
    const auto count = static_cast<std::size_t>(options.lattice_angles);
    std::vector<std::pair<double, std::size_t>> ranking(count);
    const auto lattice = [&](std::size_t i) {
        return Start{std::numbers::pi / 3 * static_cast<double>(i) / static_cast<double>(count)};
    };
    base::parallel_for(count, options.threads, [&](std::size_t i) {
        ranking[i] = {detail::rough_irregularity(outline, options, lattice(i), work), i};
    });
    std::sort(ranking.begin(), ranking.end());
    ranking.resize(affordable_lattices(outline, options));
    std::vector<Start> starts;
    for (const auto& [irregularity, i] : ranking) starts.push_back(lattice(i));
    return starts;
}

Candidate best_candidate(const Outline& outline, const TessellationOptions& options) {
    const std::size_t sketches = static_cast<std::size_t>(options.lattice_angles);
    const std::size_t finished = affordable_lattices(outline, options) + 1;
    Work work(options.control, "tiling",
              sketches * detail::rough_steps(options) + finished * detail::candidate_steps(options));
    std::vector<Start> starts = best_lattices(outline, options, work);
    starts.emplace_back();  // remeshing
    std::vector<Candidate> candidates(starts.size());
    base::parallel_for(starts.size(), options.threads, [&](std::size_t i) {
        candidates[i] = detail::make_candidate(outline, options, starts[i], work);
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

/// The length of the boundary and the holes, metres.
double length_of_loops(const Outline& outline) {
    double sum = detail::perimeter(outline.boundary);
    for (const pattern::Polygon& hole : outline.holes) sum += detail::perimeter(hole);
    return sum;
}

/// A slip of units should not fill the memory. A needle without area has a long rim.
void check_size(const Outline& outline, const TessellationOptions& options) {
    const auto [width, height] = extent(outline);
    const double rim = length_of_loops(outline);
    const double tiles = std::max(0.5 * rim / options.edge_length, estimated_tiles(outline, options));
    if (tiles <= kMostTiles) return;
    const double enough =
        std::max(options.edge_length * std::sqrt(tiles / kMostTiles), 0.5 * rim / kMostTiles);
    const std::string need = std::isfinite(tiles) ? "about " + short_number(std::round(tiles)) : "countless";
    throw base::InputError("the outline is " + metres(width) + " wide and " + metres(height) +
                           " high: with sides of " + metres(options.edge_length) + " it would need " + need +
                           " tiles, where " + std::to_string(kMostTiles) +
                           " are the most; is the unit of the outline right? Otherwise choose sides of " +
                           metres(enough) + " or more");
}

/// Coordinates have 53 bits: far from the origin small details are lost.
void check_origin(const Outline& outline, const TessellationOptions& options) {
    double farthest = 0.0;
    for (const pattern::Point2& point : outline.boundary)
        farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    if (farthest <= kFarthest * options.edge_length) return;
    throw base::InputError("the outline lies " + metres(farthest) +
                           " from the origin, where coordinates are too coarse for tiles with sides of " +
                           metres(options.edge_length) + ": move it to within " +
                           metres(kFarthest * options.edge_length));
}

/// Refuse what could not be painted or simulated.
void check(const Candidate& candidate, const TessellationOptions& options) {
    const std::string tiles = "tiles with sides of " + metres(options.edge_length);
    if (candidate.dual.cells.empty())
        throw base::GeometryError("the outline is too small or too narrow for " + tiles);
    if (candidate.pieces > 1)
        throw base::GeometryError("the outline is too narrow somewhere for " + tiles +
                                  ": they would fall into " + std::to_string(candidate.pieces) +
                                  " parts; choose a smaller edge length");
    for (std::size_t cell = 0; cell < candidate.dual.cells.size(); ++cell) {
        options.control.check();
        const pattern::Polygon polygon = detail::polygon_of(candidate.dual, cell);
        if (pattern::is_convex(polygon)) continue;
        throw base::GeometryError("the outline is too narrow for " + tiles + " near " +
                                  detail::place_text(polygon.front()) +
                                  ": a tile there would not be convex; choose a smaller edge length");
    }
}

}  // namespace

void TessellationOptions::validate() const {
    if (!(edge_length >= kSmallestEdge) || !(edge_length <= kLargestEdge))
        throw base::InputError("the edge length of a tessellation is " + metres(edge_length) +
                               ", where a length from " + metres(kSmallestEdge) + " to " +
                               metres(kLargestEdge) + " is needed");
    if (remeshing_iterations < 1 || relaxation_iterations < 0 || lattice_angles < 0)
        throw base::InputError(
            "a tessellation needs at least one iteration of remeshing, and no number below zero");
}

TessellationResult tessellate(const Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options) {
    options.validate();
    check_size(outline, options);
    check_origin(outline, options);
    const detail::CleanOutline clean = detail::without_negligible_points(outline, options.edge_length);
    detail::check_small_parts(clean.outline, options.edge_length, options.control);
    Candidate best = best_candidate(clean.outline, options);
    check(best, options);
    best.report.negligible_points = clean.left_out;
    return {detail::number(best.dual, layout, options.control), best.report};
}

}  // namespace fretwork::tiling
