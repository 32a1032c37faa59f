// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/detail/narrow_parts.hpp>
#include <fretwork/tiling/detail/small_parts.hpp>
#include <fretwork/tiling/dual/candidate.hpp>
#include <fretwork/tiling/dual/numbering.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace fretwork::tiling {
namespace {

using detail::Candidate;
using detail::SharedTask;
using detail::SizeField;
using detail::Start;
using detail::TilingProblem;
using geometry::metres;
using geometry::short_number;

constexpr int kMostTiles = 100000;
/// The largest number of tiles with refinement, in which all work is repeated up to kAttempts times.
constexpr double kMostRefinedTiles = 20000;
constexpr int kAnglesOfMany = 2;  // number of lattices that are sketched if there are many refined tiles
constexpr double kBytesPerTile = 8000;  // measured, rounded up
/// The largest sum of the tiles of the starts that are tried in full. The best start is always tried, and
/// remeshing does not count. A small outline is thus tried in more ways.
constexpr double kTilesInFinal = 1600;
constexpr double kTilesInGraded = 500;   // the same if the wanted side varies
constexpr double kSketchingShare = 0.2;  // share of the remaining progress
constexpr double kAttemptShare = 0.8;    // share of the progress that then remains
constexpr int kAttempts = 8;
constexpr std::array kTurnedBy = {0.0, 0.5, 0.25};  // turns, as shares of the angle between two lattices
constexpr double kFiner = 0.7;        // factor on the wanted side from an attempt with defects to the next
constexpr double kFinest = 0.1;       // smallest share of the wanted side
constexpr double kBarsInSide = 1.5;   // smallest ratio of the wanted side to the smallest side allowed
constexpr double kSideInBand = 0.55;  // wanted side over a band's width: tiles about as long as wide
constexpr double kSliver = 0.5;       // largest side that fits a sliver, over the smallest wanted side
constexpr double kSideAtHole = 0.16;  // wanted side over a hole's perimeter: at least three tiles around it
constexpr double kLimbArea = 0.01;    // share of the outline's area that may be lost where no tile fits
constexpr int kSidesTried = 5;        // number of smaller sides tried before an outline is refused
constexpr double kNextSide = 0.7;     // factor from one tried side to the next
constexpr double kFewTiles = 4;       // smallest number of tiles tried: an outline may be smaller than a tile
constexpr double kMostTilesTried = 400;   // number of tiles with all tried sides; so many take seconds
constexpr double kTipArea = 1e-3;         // share of the outline's area that a sharp tip may lose
constexpr double kTipsArea = 8e-3;        // share that all tips together may lose
constexpr double kNegligibleArea = 4e-4;  // share of the outline's area; smaller narrow parts are ignored
/// The largest distance from the origin, in tile sides; beyond it, rounding destroys the smallest details.
constexpr double kFarthest = 1e9;
constexpr double kHexagonArea = 1.5 * std::numbers::sqrt3;  // area of a hexagon with side 1

/// The approximate number of tiles that an outline needs.
double estimated_tiles(const outlines::Outline& outline, const TessellationOptions& options) {
    const double hexagon = kHexagonArea * options.edge_length * options.edge_length;
    return std::abs(geometry::signed_area(outline.boundary)) / hexagon;
}

/// The angles of the lattices that are sketched: the wanted angle alone, or several angles, turned by a share
/// of the angle between two of them. A triangular lattice repeats after 60 degrees.
std::vector<double> sketched_angles(const TilingProblem& problem, double turned_by) {
    if (problem.options.angle) return {*problem.options.angle};
    const bool is_graded = !problem.field.is_uniform();
    const int wanted = is_graded ? (problem.options.lattice_angles + 1) / 2 : problem.options.lattice_angles;
    const int count = problem.has_many() ? std::min(wanted, kAnglesOfMany) : wanted;
    std::vector<double> angles(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) angles[i] = std::numbers::pi / 3 * (i + turned_by) / count;
    return angles;
}

/// The starts with the best sketches, best first, as many as the number of tiles allows. Remeshing follows if
/// there are several and the wanted side is uniform, and is the only start if no lattice is sketched.
std::vector<Start> best_starts(const TilingProblem& problem, double turned_by, SharedTask& task) {
    const bool is_graded = !problem.field.is_uniform();
    const std::vector<double> angles = sketched_angles(problem, turned_by);
    const std::size_t count = angles.size();
    std::vector<std::pair<detail::Sketch, Start>> ranking(count);
    task.begin_part(count * detail::rough_steps(problem.options), kSketchingShare);
    base::parallel_for(count, problem.options.threads, [&](std::size_t i) {
        Start start{angles[i]};
        const detail::Sketch sketch = detail::make_sketch(problem, start, task);
        start.factor = sketch.factor;
        ranking[i] = {sketch, start};
    });
    std::ranges::stable_sort(ranking, {}, [](const auto& entry) { return entry.first.irregularity; });
    std::vector<Start> starts;
    const double most = is_graded ? kTilesInGraded : kTilesInFinal;
    int tiles = 0;
    for (const auto& [sketch, start] : ranking) {
        tiles += sketch.tiles;
        if (starts.empty() || tiles <= most) starts.push_back(start);
    }
    if (starts.empty() || (!is_graded && starts.size() > 1))
        starts.push_back({.factor = std::numbers::sqrt3});  // remeshing
    return starts;
}

Candidate best_candidate(const TilingProblem& problem, const std::vector<Start>& starts, SharedTask& task) {
    task.begin_part(starts.size() * detail::candidate_steps(problem.options), kAttemptShare);
    std::vector<Candidate> candidates(starts.size());
    base::parallel_for(starts.size(), problem.options.threads, [&](std::size_t i) {
        candidates[i] = detail::make_candidate(problem, starts[i], task);
    });
    return std::move(*std::min_element(candidates.begin(), candidates.end(), detail::is_better));
}

double smallest_wanted(const TessellationOptions& options) {
    return std::max(kFinest * options.edge_length, kBarsInSide * options.smallest_side);
}

/// The limits of narrow places: the widest narrow place is about as wide as a tile with the wanted side.
detail::NarrowLimits narrow_limits(const outlines::Outline& outline, const TessellationOptions& options) {
    const double side = options.edge_length;
    return {side / kSideInBand, std::min(kNegligibleArea * outlines::area_of(outline), 0.5 * side * side)};
}

/// The length of the boundary and the holes, metres.
double length_of_loops(const outlines::Outline& outline) {
    double sum = geometry::perimeter(outline.boundary);
    for (const geometry::Polygon& hole : outline.holes) sum += geometry::perimeter(hole);
    return sum;
}

/// True if nearly all of an outline is far too narrow for tiles with this side, so that no attempt would
/// succeed.
bool is_sliver(const outlines::Outline& outline, double side) {
    const double mean_width = 2.0 * outlines::area_of(outline) / length_of_loops(outline);
    return kSideInBand * mean_width < kSliver * side;
}

struct WantedSides {
    SizeField field;
    /// A place that is too narrow for any tile, and that cuts off more than kLimbArea of the outline.
    std::optional<detail::NarrowPlace> too_narrow;
};

/// The approximate number of tiles with the sides that holes and narrow places want; 0 if all tiles have the
/// same wanted side, and for outlines without holes. Samples lie in the box around the outline; their sum is
/// scaled by the outline's share of the box.
double refined_tiles(const outlines::Outline& outline, const SizeField& field, const base::Control& control) {
    if (field.is_uniform() || outline.holes.empty()) return 0.0;
    constexpr int kSamples = 400;  // number of samples along the longer side of the box
    const geometry::Box box = geometry::box_of(outline.boundary);
    const double step = std::max(box.width(), box.height()) / kSamples;
    double tiles = 0.0;
    for (double x = box.xmin + 0.5 * step; x < box.xmax; x += step) {
        control.check();
        for (double y = box.ymin + 0.5 * step; y < box.ymax; y += step) {
            const double side = field.at({x, y});
            tiles += step * step / (kHexagonArea * side * side);
        }
    }
    return tiles * outlines::area_of(outline) / (box.width() * box.height());
}

/// The wanted sides: smaller where the outline is narrow, and around small holes.
WantedSides wanted_sides(const outlines::Outline& outline, const TessellationOptions& options) {
    SizeField field(options.edge_length);
    const double side = options.edge_length;
    const detail::NarrowLimits limits = narrow_limits(outline, options);
    const double least = smallest_wanted(options);
    for (const detail::NarrowPlace& narrow : detail::narrow_places(outline, limits, options.control)) {
        options.control.check();
        if (narrow.width < least && narrow.cut_off > kLimbArea * outlines::area_of(outline))
            return {field, narrow};
        field.limit(narrow.place, std::max(least, kSideInBand * narrow.width));
    }
    for (const geometry::Polygon& hole : outline.holes) {
        const double wanted = std::max(least, kSideAtHole * geometry::perimeter(hole));
        if (wanted < side) {
            for (const geometry::Point2& point : hole) {
                options.control.check();
                field.limit(point, wanted);
            }
        }
    }
    return {field, std::nullopt};
}

detail::BluntLimits blunt_limits(const outlines::Outline& outline, const TessellationOptions& options) {
    const double all = outlines::area_of(outline);
    return {std::min(kTipArea * all, 0.25 * options.edge_length * options.edge_length), kTipsArea * all};
}

/// An outline with blunt tips, the wanted sides of its tiles, and the limits by which tilings are judged.
struct Subject {
    const detail::BluntOutline& blunt;
    const SizeField& field;
    detail::QualityLimits limits;
    double refined_tiles = 0.0;
};

/// The best tiling of several attempts. Where an attempt has defects, the next attempt wants smaller tiles.
/// All attempts begin with lattices turned by a share of the angle between two of them.
Candidate best_attempt(const Subject& subject, const TessellationOptions& options, double turned_by,
                       SharedTask& task) {
    SizeField field = subject.field;
    const double least = smallest_wanted(options);
    Candidate best;
    std::vector<Start> starts;
    std::optional<double> known_factor;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const TilingProblem problem{subject.blunt.outline, field, options, subject.limits,
                                    subject.refined_tiles};
        // Wanted sides that are no longer uniform may need other starts.
        if (attempt == 0 || (attempt == 1 && !known_factor)) starts = best_starts(problem, turned_by, task);
        if (known_factor) starts.front().factor = *known_factor;
        Candidate candidate = best_candidate(problem, starts, task);
        if (starts.size() == 1 && candidate.factor) known_factor = candidate.factor;
        const bool is_first = attempt == 0;
        if (is_first || detail::is_better(candidate, best)) best = candidate;
        if (best.defects.empty() || options.narrow == Narrow::Refuse) break;
        bool is_finer = false;
        for (const detail::Defect& defect : candidate.defects) {
            const double wanted = std::max(least, kFiner * field.at(defect.place));
            is_finer = field.limit(defect.place, wanted) || is_finer;
        }
        if (!is_finer) break;
    }
    return best;
}

/// The best tiling of all attempts. If attempts end with defects, further attempts begin with lattices at
/// other angles.
Candidate best_tiling(const outlines::Outline& outline, const TessellationOptions& options,
                      std::span<const double> turns, SharedTask& task) {
    if (is_sliver(outline, smallest_wanted(options))) {
        Candidate none;
        none.defects.push_back({detail::DefectKind::TooNarrow, outline.boundary.front()});
        return none;
    }
    const detail::BluntOutline blunt = detail::blunt(outline, options.edge_length / kSideInBand,
                                                     blunt_limits(outline, options), options.control);
    const auto [field, too_narrow] = wanted_sides(blunt.outline, options);
    Candidate best;
    if (too_narrow) {
        best.defects.push_back({detail::DefectKind::TooNarrow, too_narrow->place});
        return best;
    }
    const double tiles = refined_tiles(blunt.outline, field, options.control);
    if (tiles > kMostRefinedTiles) {
        best.defects.push_back({detail::DefectKind::TooMany, outline.boundary.front()});
        best.report.tiles = static_cast<int>(std::min(tiles, 1e9));
        best.report.smallest_side = field.smallest();
        return best;
    }
    const double share = blunt.lost_area / outlines::area_of(outline);
    const Subject subject{blunt,
                          field,
                          {.smallest_side = options.smallest_side,
                           .covered_share = detail::QualityLimits{}.covered_share / (1 - share)},
                          tiles};
    for (const double turned_by : turns) {
        Candidate candidate = best_attempt(subject, options, turned_by, task);
        if (best.dual.cells.empty() || detail::is_better(candidate, best)) best = std::move(candidate);
        if (best.defects.empty()) break;
    }
    best.report.covered_share *= 1 - share;
    return best;
}

/// Refuse sizes that would fill the memory, for example after a slip of units. The length of the rim counts,
/// too, because a needle has hardly any area.
void check_size(const outlines::Outline& outline, const TessellationOptions& options) {
    const double rim = length_of_loops(outline);
    const double tiles = std::max(0.5 * rim / options.edge_length, estimated_tiles(outline, options));
    if (tiles <= kMostTiles) return;
    const double enough =
        std::max(options.edge_length * std::sqrt(tiles / kMostTiles), 0.5 * rim / kMostTiles);
    const std::string need =
        std::isfinite(tiles) ? "about " + geometry::short_number(std::round(tiles)) : "countless";
    const geometry::Box box = geometry::box_of(outline.boundary);
    throw base::InputError("the outline is " + geometry::metres(box.width()) + " wide and " +
                           geometry::metres(box.height()) + " high: with sides of " +
                           geometry::metres(options.edge_length) + " it would need " + need +
                           " tiles, where " + std::to_string(kMostTiles) +
                           " are the most; is the unit of the outline right? Otherwise choose sides of " +
                           geometry::metres(enough) + " or more");
}

/// Refuse an outline so far from the origin that small details are lost, because coordinates have 53 bits.
void check_origin(const outlines::Outline& outline, const TessellationOptions& options) {
    double farthest = 0.0;
    for (const geometry::Point2& point : outline.boundary)
        farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    if (farthest <= kFarthest * options.edge_length) return;
    throw base::InputError("the outline lies " + geometry::metres(farthest) +
                           " from the origin, where coordinates are too coarse for tiles with sides of " +
                           geometry::metres(options.edge_length) + ": move it to within " +
                           geometry::metres(kFarthest * options.edge_length));
}

/// A smaller side of the tiles with which the outline can be tiled.
struct SmallerSide {
    std::optional<double> works;  ///< a side found by trying, m
    int tried = 0;                ///< number of sides tried, as many as take a few seconds
};

SmallerSide side_that_works(const outlines::Outline& outline, const TessellationOptions& options,
                            double first, SharedTask& task) {
    const double side_of_few = std::sqrt(outlines::area_of(outline) / (kFewTiles * kHexagonArea));
    double side = std::min(first, side_of_few);
    double tiles = 0.0;
    SmallerSide found;
    for (; found.tried < kSidesTried; ++found.tried, side *= kNextSide) {
        TessellationOptions smaller = options;
        smaller.edge_length = std::stod(base::format_number(side, 2));
        smaller.smallest_side = std::min(options.smallest_side, 0.25 * smaller.edge_length);
        tiles += estimated_tiles(outline, smaller);
        if (tiles > kMostTilesTried) return found;
        if (best_tiling(outline, smaller, std::span(kTurnedBy).first(1), task).defects.empty()) {
            found.works = smaller.edge_length;
            return found;
        }
    }
    return found;
}

std::string advice(const SmallerSide& side) {
    if (side.works) return "; sides of " + geometry::metres(*side.works) + " work";
    if (side.tried == 0) return "; make the outline wider there, or take smaller sides";
    return "; no smaller side that was tried works: make the outline wider there";
}

/// Refuse an outline with thousands of small holes, which would take hours.
[[noreturn]] void refuse_many(const outlines::Outline& outline, const TessellationReport& wanted) {
    throw base::InputError(
        "the outline has " + std::to_string(outline.holes.size()) + " holes: with sides down to " +
        metres(wanted.smallest_side) + " around them and where it is narrow it would need about " +
        std::to_string(wanted.tiles / 1000) + "000 tiles and " +
        short_number(std::ceil(wanted.tiles * kBytesPerTile / 1e8) / 10) + " GB of memory, where " +
        short_number(kMostRefinedTiles) +
        " tiles are the most that are refined; leave out the smallest holes, or tile a part of the outline");
}

[[noreturn]] void refuse(const outlines::Outline& outline, const TessellationOptions& options,
                         const detail::Defect& defect, SharedTask& task) {
    const auto works = side_that_works(outline, options, kNextSide * options.edge_length, task);
    throw base::GeometryError("the outline is too narrow for tiles with sides of " +
                              geometry::metres(options.edge_length) + " near " +
                              geometry::place_text(defect.place) + ": " +
                              std::string(detail::words_for(defect.kind)) + advice(works));
}

void refuse_narrow(const outlines::Outline& outline, const TessellationOptions& options) {
    const auto places = detail::narrow_places(outline, narrow_limits(outline, options), options.control);
    if (places.empty()) return;
    const detail::NarrowPlace& place = places.front();
    TessellationOptions silent = options;
    silent.control = options.control.silent();
    SharedTask task(silent.control, "");
    const auto works = side_that_works(outline, silent, kSideInBand * place.width, task);
    throw base::GeometryError("the outline is " + geometry::metres(place.width) + " wide near " +
                              geometry::place_text(place.place) + ", narrower than tiles with sides of " +
                              geometry::metres(options.edge_length) + advice(works) +
                              "; or refine the tiles where it is narrow");
}

}  // namespace

TessellationResult tessellate(const outlines::Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options) {
    options.validate();
    check_size(outline, options);
    check_origin(outline, options);
    const detail::CleanOutline clean =
        detail::without_negligible_points(outline, options.edge_length, options.control);
    detail::check_small_parts(clean.outline, options.edge_length, options.control);
    if (options.narrow == Narrow::Refuse) refuse_narrow(clean.outline, options);
    SharedTask task(options.control, "tiling");
    const std::span<const double> turns = std::span(kTurnedBy).first(options.angle ? 1 : kTurnedBy.size());
    Candidate best = best_tiling(clean.outline, options, turns, task);
    if (!best.defects.empty() && best.defects.front().kind == detail::DefectKind::TooMany)
        refuse_many(clean.outline, best.report);
    if (!best.defects.empty()) refuse(clean.outline, options, best.defects.front(), task);
    task.complete();
    best.report.negligible_points = clean.left_out;
    return {detail::number(best.dual, layout, options.control), best.report};
}

}  // namespace fretwork::tiling
