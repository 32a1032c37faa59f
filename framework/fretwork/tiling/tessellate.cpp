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

/// A triangular lattice is the same again after 60 degrees.
std::vector<Start> all_starts(int lattice_angles) {
    std::vector<Start> starts{Start{}};
    for (int i = 0; i < lattice_angles; ++i) starts.push_back({std::numbers::pi / 3 * i / lattice_angles});
    return starts;
}

Candidate best_candidate(const Outline& outline, const TessellationOptions& options) {
    const std::vector<Start> starts = all_starts(options.lattice_angles);
    std::vector<Candidate> candidates(starts.size());
    base::parallel_for(starts.size(), options.threads, [&](std::size_t i) {
        candidates[i] = detail::make_candidate(outline, options, starts[i]);
    });
    return std::move(*std::min_element(candidates.begin(), candidates.end(), detail::is_better));
}

/// Refuse what could not be painted or simulated.
void check(const Candidate& candidate, const TessellationOptions& options) {
    const std::string tiles = "tiles with sides of " + base::format_number(options.edge_length) + " m";
    if (candidate.dual.cells.empty()) throw base::GeometryError("the outline is too small for " + tiles);
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
    const Candidate best = best_candidate(outline, options);
    check(best, options);
    return {detail::number(best.dual, layout), best.report};
}

}  // namespace fretwork::tiling
