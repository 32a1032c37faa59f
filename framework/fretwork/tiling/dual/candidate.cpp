// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/candidate.hpp>
#include <fretwork/tiling/dual/edits.hpp>
#include <fretwork/tiling/dual/measures.hpp>
#include <fretwork/tiling/dual/rim_sides.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

constexpr int kSearchRounds = 6;
constexpr double kFinestFactor = 0.45;       // finer sites make tiles of another size
constexpr double kGoodSideError = 0.008;     // ends the search for the density
constexpr double kAcceptedSideError = 0.01;  // below, regularity decides
/// Where the wanted side differs from place to place, its mean is matched less closely.
constexpr double kGoodGradedError = 0.06;
constexpr int kRegularizingIterations = 60;
constexpr int kRepairs = 4;  // of short sides
constexpr int kRepairIterations = 30;
constexpr int kEveningIterations = 40;
constexpr std::size_t kMostToRemove = 12;  // more defects are left to smaller tiles
constexpr double kRemovedShare = 1e-3;     // of the outline's area: so much may one removed tile uncover
/// Distance of sites over wanted side: the range that the searches for lattices and meshes cover. A search
/// does not come this near to a factor that was tried if its sides were that far off.
constexpr double kNearFactor = 0.03;
constexpr double kFarRatio = 0.2;
constexpr double kRoughFactor = 1.6;
constexpr int kRoughIterations = 8;
constexpr int kLastRelaxations = 10;  // after chords are bridged

/// Looks for the distance of the sites at which the sides are the wanted ones. They grow with the distance,
/// but in jumps, since the number of tiles is a whole number. A thousand equal holes make one large jump:
/// there the search goes to the middle of what it knows, and not back to where it was.
class FactorSearch {
  public:
    explicit FactorSearch(double factor) : factor_(factor) {}
    [[nodiscard]] double factor() const { return factor_; }
    /// @param ratio  the mean of sides over wanted sides at factor()
    void learn(double ratio) {
        (ratio < 1 ? low_ : high_) = factor_;
        if (std::abs(std::log(ratio)) > kFarRatio) far_off_.push_back(factor_);
        const double guess = factor_ / ratio;
        factor_ = low_ > 0 && high_ > 0 && is_refuted(guess) ? std::sqrt(low_ * high_) : guess;
    }
    /// Whether the sides jumped from too short to too long.
    [[nodiscard]] bool has_jumped() const { return has_jumped_; }

  private:
    [[nodiscard]] bool is_refuted(double guess) {
        const auto is_near = [&](double tried) { return std::abs(std::log(guess / tried)) < kNearFactor; };
        if (std::ranges::any_of(far_off_, is_near)) return has_jumped_ = true;
        return guess <= std::min(low_, high_) || guess >= std::max(low_, high_);
    }

    double factor_;
    double low_ = 0.0;   // the last at which sides were too short
    double high_ = 0.0;  // the last at which sides were too long
    std::vector<double> far_off_;
    bool has_jumped_ = false;
};

/// Makes the tilings of one start.
class Tiler {
  public:
    Tiler(const Task& task, const Start& start, Work& work) : task_(task), start_(start), work_(work) {}

    /// A first sketch of the tiles around sites at this many wanted sides from each other.
    [[nodiscard]] Dual sketch(double factor) const {
        const Spacing spacing{task_.field, factor};
        const Rim rim = sample_rim(task_.outline, spacing, work_.control());
        if (!rim_crossings(rim, work_.control()).empty()) return {};
        return tiles_around(
            rim, relax(rim, task_.field, first_sites(rim, spacing), rough_iterations(task_.options), work_));
    }

    /// The tiles around sites at this many wanted sides from each other, made as regular as they can be.
    /// Their defects are in the candidate.
    [[nodiscard]] Candidate tiles(double factor) const {
        const Spacing spacing{task_.field, factor};
        const Rim rim = sample_rim(task_.outline, spacing, work_.control());
        Candidate candidate;
        for (const Point2& place : rim_crossings(rim, work_.control()))
            candidate.defects.push_back({DefectKind::Torn, place});
        if (!candidate.defects.empty()) return candidate;
        candidate.dual = tiles_around(rim, sites(rim, spacing));
        if (candidate.dual.cells.empty()) {
            candidate.defects.push_back({DefectKind::Uncovered, rim.points.front().place});
            return candidate;
        }
        regularize(candidate.dual, rim, kRegularizingIterations, work_);
        repair(candidate, rim);
        if (candidate.defects.size() <= kMostToRemove) {
            while (remove_cell(candidate, rim)) {
            }
        }
        if (candidate.defects.empty()) even(candidate, rim);
        return candidate;
    }
    /// Merge the small tiles of narrow parts, if that makes no defects.
    void merge(Candidate& candidate) const {
        const Rim rim = sample_rim(task_.outline, {task_.field, std::numbers::sqrt3}, work_.control());
        Candidate merged = candidate;
        merge_small_cells(merged.dual, task_.field, work_.control());
        judge(merged, rim);
        if (merged.defects.empty()) candidate = std::move(merged);
    }
    static int rough_iterations(const TessellationOptions& options) {
        return std::min(kRoughIterations, options.relaxation_iterations);
    }

  private:
    [[nodiscard]] std::vector<Point2> first_sites(const Rim& rim, const Spacing& spacing) const {
        auto sites = start_.lattice_angle
                         ? lattice_sites(rim, spacing, *start_.lattice_angle, work_)
                         : remeshed_sites(rim, spacing.largest(), task_.options.remeshing_iterations, work_);
        fill_empty_parts(rim, spacing, sites, work_);
        return sites;
    }
    [[nodiscard]] std::vector<Point2> sites(const Rim& rim, const Spacing& spacing) const {
        const int iterations = task_.options.relaxation_iterations;
        auto places = relax(rim, task_.field, first_sites(rim, spacing), iterations, work_);
        for (int round = 0; round < 3 && bridge_chords(rim, spacing, places, work_); ++round)
            places =
                relax(rim, task_.field, std::move(places), std::min(kLastRelaxations, iterations), work_);
        return places;
    }
    [[nodiscard]] Dual tiles_around(const Rim& rim, const std::vector<Point2>& sites) const {
        if (sites.empty()) return {};
        Triangulation triangulation = triangulate(rim, sites, work_);
        flip_ears(triangulation, work_);
        Dual dual = dual_of(rim, triangulation, work_);
        std::erase_if(dual.cells, [](const Cell& cell) { return cell.size() < 3; });
        divide_long_rim_sides(dual, rim, {task_.field, task_.limits.smallest_side}, work_.control());
        return dual;
    }

    void judge(Candidate& tiling, const Rim& rim) const {
        Shape shape = compare_with_outline(tiling.dual, rim, task_.field, task_.limits, work_.control());
        tiling.defects = std::move(shape.defects);
        tiling.report.covered_share = shape.covered_share;
        tiling.report.outside_share = shape.outside_share;
    }
    /// Collapse short sides as long as that leaves fewer defects.
    void repair(Candidate& candidate, const Rim& rim) const {
        judge(candidate, rim);
        for (int i = 0; i < kRepairs && !candidate.defects.empty(); ++i) {
            Candidate repaired = candidate;
            if (collapse_short_sides(repaired.dual, task_.field, task_.limits.smallest_side,
                                     work_.control()) == 0)
                return;
            regularize(repaired.dual, rim, kRepairIterations, work_);
            judge(repaired, rim);
            if (repaired.defects.size() >= candidate.defects.size()) return;
            candidate = std::move(repaired);
        }
    }

    /// Make the sides more even, if that makes no defects.
    void even(Candidate& candidate, const Rim& rim) const {
        Candidate evened = candidate;
        even_out(evened.dual, rim, task_.field, kEveningIterations, work_);
        judge(evened, rim);
        if (evened.defects.empty()) candidate = std::move(evened);
    }

    /// Take away a cell that has a defect, if that leaves fewer defects. Returns whether one was.
    bool remove_cell(Candidate& candidate, const Rim& rim) const {
        for (const Defect& defect : candidate.defects) {
            for (const std::size_t cell : defect.cells) {
                for (const Dual& dual : without_cell(candidate.dual, cell, most_removed(), work_.control())) {
                    if (replace(candidate, dual, rim)) return true;
                }
            }
        }
        return false;
    }
    /// Take other tiles, made regular or as they are, if they have fewer defects. Returns whether they have.
    bool replace(Candidate& candidate, const Dual& dual, const Rim& rim) const {
        for (const int iterations : {kRepairIterations, 0}) {
            Candidate other = candidate;
            other.dual = dual;
            regularize(other.dual, rim, iterations, work_);
            judge(other, rim);
            if (other.defects.size() >= candidate.defects.size()) continue;
            candidate = std::move(other);
            return true;
        }
        return false;
    }
    [[nodiscard]] double most_removed() const { return kRemovedShare * area_of(task_.outline); }

    const Task& task_;
    const Start& start_;
    Work& work_;
};

}  // namespace

std::size_t rough_steps(const TessellationOptions& options) {
    return Tiler::rough_iterations(options);
}

std::size_t candidate_steps(const TessellationOptions& options) {
    return static_cast<std::size_t>(kSearchRounds) * static_cast<std::size_t>(options.relaxation_iterations);
}

std::string Start::name() const {
    if (!lattice_angle) return "remeshing";
    return "lattice at " +
           base::format_number(std::round(*lattice_angle * 180 / std::numbers::pi * 10) / 10) + " deg";
}

Sketch make_sketch(const Task& task, const Start& start, Work& work) {
    const Dual dual = Tiler(task, start, work).sketch(kRoughFactor);
    if (dual.cells.empty()) return {std::numeric_limits<double>::infinity(), std::numbers::sqrt3, 1};
    const Measures measures = measure(dual, task.field, work.control());
    return {measures.irregularity, kRoughFactor / std::clamp(measures.mean_ratio, 0.8, 1.25),
            measures.report.tiles};
}

namespace {

/// Compares two densities of one start: the fewest defects first, then the right sides.
bool is_better_density(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        return std::tuple(candidate.dual.cells.empty(), std::max(candidate.side_error, kAcceptedSideError),
                          candidate.defects.size(), candidate.side_error);
    };
    return key(first) < key(second);
}

void describe(Candidate& candidate, const Task& task, const Start& start, Work& work) {
    const Measures measures = measure(candidate.dual, task.field, work.control());
    const TessellationReport shape = candidate.report;
    candidate.report = measures.report;
    candidate.report.covered_share = shape.covered_share;
    candidate.report.outside_share = shape.outside_share;
    candidate.report.start = start.name();
    candidate.side_error = std::abs(measures.mean_ratio - 1);
    candidate.irregularity = measures.irregularity;
}

/// The mean of sides over wanted sides at a density, by a sketch, where it is far off: more than that need
/// not be known of this density.
std::optional<double> far_ratio(const Tiler& tiler, const Task& task, double factor, Work& work) {
    const Dual dual = tiler.sketch(factor);
    if (dual.cells.empty()) return std::nullopt;
    const double ratio = measure(dual, task.field, work.control()).mean_ratio;
    return std::abs(std::log(ratio)) > kFarRatio ? std::optional(ratio) : std::nullopt;
}

}  // namespace

Candidate make_candidate(const Task& task, const Start& start, Work& work) {
    const Tiler tiler(task, start, work);
    const bool is_graded = !task.field.is_uniform();
    std::optional<Candidate> best;
    FactorSearch search(start.factor);
    for (int round = 0; round < kSearchRounds; ++round) {
        if (best && search.factor() < kFinestFactor * start.factor) break;
        if (const auto far = task.has_many() && round + 1 < kSearchRounds
                                 ? far_ratio(tiler, task, search.factor(), work)
                                 : std::nullopt) {
            search.learn(*far);
            continue;
        }
        Candidate candidate = tiler.tiles(search.factor());
        double ratio = 1.5;
        if (!candidate.dual.cells.empty()) {
            describe(candidate, task, start, work);
            ratio = measure(candidate.dual, task.field, work.control()).mean_ratio;
        } else {
            candidate.side_error = std::numeric_limits<double>::infinity();
        }
        candidate.factor = search.factor();
        search.learn(ratio);
        if (!best || is_better_density(candidate, *best)) best = std::move(candidate);
        const double good = is_graded ? kGoodGradedError : kGoodSideError;
        if (best->side_error <= good && (best->defects.empty() || is_graded)) break;
        if (best->side_error <= good && round >= 2) break;
    }
    if (!search.has_jumped()) best->factor.reset();
    if (task.options.narrow == Narrow::Merge && is_graded && best->defects.empty()) {
        const double error = best->side_error;
        tiler.merge(*best);
        describe(*best, task, start, work);
        best->side_error = error;  // of the tiles before
    }
    return std::move(*best);
}

bool is_better(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        return std::tuple(candidate.dual.cells.empty(), candidate.defects.size(),
                          std::max(candidate.side_error, kAcceptedSideError), candidate.irregularity);
    };
    return key(first) < key(second);
}

}  // namespace fretwork::tiling::detail
