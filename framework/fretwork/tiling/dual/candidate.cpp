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
constexpr double kFinestFactor = 0.45;       // smallest share of the start's factor that is tried
constexpr double kGoodSideError = 0.008;     // ends the search for the density
constexpr double kAcceptedSideError = 0.01;  // below, regularity decides
/// The same as kGoodSideError, if wanted sides differ from place to place; then their mean is matched less
/// closely.
constexpr double kGoodGradedError = 0.06;
constexpr int kRegularizingIterations = 60;
constexpr int kRepairs = 4;  // rounds of collapsing short sides
constexpr int kRepairIterations = 30;
constexpr int kEveningIterations = 40;
constexpr std::size_t kMostToRemove = 12;  // largest number of defects to mend by removing tiles
constexpr double kRemovedShare = 1e-3;     // share of the outline's area that one removed tile may uncover
/// A search for the factor (distance of sites over wanted side) avoids the range kNearFactor around a tried
/// factor whose sides were farther off than kFarRatio. Both are differences of logarithms.
constexpr double kNearFactor = 0.03;
constexpr double kFarRatio = 0.2;
constexpr double kRoughFactor = 1.6;
constexpr int kRoughIterations = 8;
constexpr int kLastRelaxations = 10;  // iterations after chords were bridged

/// A search for the distance of sites that gives the wanted sides. Sides grow with this distance, but in
/// jumps, because the number of tiles is a whole number. A thousand equal holes cause one large jump; the
/// search then tries the middle of the known range instead of a factor that was tried before.
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
    /// True if the sides jumped from too short to too long.
    [[nodiscard]] bool has_jumped() const { return has_jumped_; }

  private:
    [[nodiscard]] bool is_refuted(double guess) {
        const auto is_near = [&](double tried) { return std::abs(std::log(guess / tried)) < kNearFactor; };
        if (std::ranges::any_of(far_off_, is_near)) return has_jumped_ = true;
        return guess <= std::min(low_, high_) || guess >= std::max(low_, high_);
    }

    double factor_;
    double low_ = 0.0;   // last factor with sides that were too short
    double high_ = 0.0;  // last factor with sides that were too long
    std::vector<double> far_off_;
    bool has_jumped_ = false;
};

/// Makes the tilings of one start.
class Tiler {
  public:
    Tiler(const TilingProblem& problem, const Start& start, SharedTask& task)
        : problem_(problem), start_(start), task_(task) {}

    /// A first sketch of the tiles. Neighbouring sites are `factor` times the wanted side apart.
    [[nodiscard]] Dual sketch(double factor) const {
        const Spacing spacing{problem_.field, factor};
        const Rim rim = sample_rim(problem_.outline, spacing, task_.control());
        if (!rim_crossings(rim, task_.control()).empty()) return {};
        return tiles_around(rim, relax(rim, problem_.field, first_sites(rim, spacing),
                                       rough_iterations(problem_.options), task_));
    }

    /// The tiles around sites that are `factor` times the wanted side apart, made as regular as possible. The
    /// candidate lists the defects of the tiles.
    [[nodiscard]] Candidate tiles(double factor) const {
        const Spacing spacing{problem_.field, factor};
        const Rim rim = sample_rim(problem_.outline, spacing, task_.control());
        Candidate candidate;
        for (const Point2& place : rim_crossings(rim, task_.control()))
            candidate.defects.push_back({DefectKind::Torn, place});
        if (!candidate.defects.empty()) return candidate;
        candidate.dual = tiles_around(rim, sites(rim, spacing));
        if (candidate.dual.cells.empty()) {
            candidate.defects.push_back({DefectKind::Uncovered, rim.points.front().place});
            return candidate;
        }
        regularize(candidate.dual, rim, kRegularizingIterations, task_);
        repair(candidate, rim);
        if (candidate.defects.size() <= kMostToRemove) {
            while (remove_cell(candidate, rim)) {
            }
        }
        if (candidate.defects.empty()) even(candidate, rim);
        return candidate;
    }
    /// Merge the small tiles of narrow parts, if no defects result.
    void merge(Candidate& candidate) const {
        const Rim rim = sample_rim(problem_.outline, {problem_.field, std::numbers::sqrt3}, task_.control());
        Candidate merged = candidate;
        merge_small_cells(merged.dual, problem_.field, task_.control());
        judge(merged, rim);
        if (merged.defects.empty()) candidate = std::move(merged);
    }
    static int rough_iterations(const TessellationOptions& options) {
        return std::min(kRoughIterations, options.relaxation_iterations);
    }

  private:
    [[nodiscard]] std::vector<Point2> first_sites(const Rim& rim, const Spacing& spacing) const {
        auto sites = start_.lattice_angle ? lattice_sites(rim, spacing, *start_.lattice_angle, task_)
                                          : remeshed_sites(rim, spacing.largest(),
                                                           problem_.options.remeshing_iterations, task_);
        fill_empty_parts(rim, spacing, sites, task_);
        return sites;
    }
    [[nodiscard]] std::vector<Point2> sites(const Rim& rim, const Spacing& spacing) const {
        const int iterations = problem_.options.relaxation_iterations;
        auto places = relax(rim, problem_.field, first_sites(rim, spacing), iterations, task_);
        for (int round = 0; round < 3 && bridge_chords(rim, spacing, places, task_); ++round)
            places =
                relax(rim, problem_.field, std::move(places), std::min(kLastRelaxations, iterations), task_);
        return places;
    }
    [[nodiscard]] Dual tiles_around(const Rim& rim, const std::vector<Point2>& sites) const {
        if (sites.empty()) return {};
        Triangulation triangulation = triangulate(rim, sites, task_);
        flip_ears(triangulation, task_);
        Dual dual = dual_of(rim, triangulation, task_);
        std::erase_if(dual.cells, [](const Cell& cell) { return cell.size() < 3; });
        divide_long_rim_sides(dual, rim, {problem_.field, problem_.limits.smallest_side}, task_.control());
        return dual;
    }

    void judge(Candidate& tiling, const Rim& rim) const {
        Shape shape =
            compare_with_outline(tiling.dual, rim, problem_.field, problem_.limits, task_.control());
        tiling.defects = std::move(shape.defects);
        tiling.report.covered_share = shape.covered_share;
        tiling.report.outside_share = shape.outside_share;
    }
    /// Collapse short sides as long as the number of defects falls.
    void repair(Candidate& candidate, const Rim& rim) const {
        judge(candidate, rim);
        for (int i = 0; i < kRepairs && !candidate.defects.empty(); ++i) {
            Candidate repaired = candidate;
            if (collapse_short_sides(repaired.dual, problem_.field, problem_.limits.smallest_side,
                                     task_.control()) == 0)
                return;
            regularize(repaired.dual, rim, kRepairIterations, task_);
            judge(repaired, rim);
            if (repaired.defects.size() >= candidate.defects.size()) return;
            candidate = std::move(repaired);
        }
    }

    /// Make the sides more even, if no defects result.
    void even(Candidate& candidate, const Rim& rim) const {
        Candidate evened = candidate;
        even_out(evened.dual, rim, problem_.field, kEveningIterations, task_);
        judge(evened, rim);
        if (evened.defects.empty()) candidate = std::move(evened);
    }

    /// Remove a cell with a defect, if fewer defects remain. Returns true if a cell was removed.
    bool remove_cell(Candidate& candidate, const Rim& rim) const {
        for (const Defect& defect : candidate.defects) {
            for (const std::size_t cell : defect.cells) {
                for (const Dual& dual : without_cell(candidate.dual, cell, most_removed(), task_.control())) {
                    if (replace(candidate, dual, rim)) return true;
                }
            }
        }
        return false;
    }
    /// Replace the tiles by other tiles, regularized or unchanged, if these have fewer defects. Returns true
    /// if the tiles were replaced.
    bool replace(Candidate& candidate, const Dual& dual, const Rim& rim) const {
        for (const int iterations : {kRepairIterations, 0}) {
            Candidate other = candidate;
            other.dual = dual;
            regularize(other.dual, rim, iterations, task_);
            judge(other, rim);
            if (other.defects.size() >= candidate.defects.size()) continue;
            candidate = std::move(other);
            return true;
        }
        return false;
    }
    [[nodiscard]] double most_removed() const { return kRemovedShare * area_of(problem_.outline); }

    const TilingProblem& problem_;
    const Start& start_;
    SharedTask& task_;
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

Sketch make_sketch(const TilingProblem& problem, const Start& start, SharedTask& task) {
    const Dual dual = Tiler(problem, start, task).sketch(kRoughFactor);
    if (dual.cells.empty()) return {std::numeric_limits<double>::infinity(), std::numbers::sqrt3, 1};
    const Measures measures = measure(dual, problem.field, task.control());
    return {measures.irregularity, kRoughFactor / std::clamp(measures.mean_ratio, 0.8, 1.25),
            measures.report.tiles};
}

namespace {

/// True if the first of two densities of one start is better. Tiles count first, then the side error (all
/// errors up to kAcceptedSideError are equal), then the number of defects, then the exact side error.
bool is_better_density(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        return std::tuple(candidate.dual.cells.empty(), std::max(candidate.side_error, kAcceptedSideError),
                          candidate.defects.size(), candidate.side_error);
    };
    return key(first) < key(second);
}

void describe(Candidate& candidate, const TilingProblem& problem, const Start& start, SharedTask& task) {
    const Measures measures = measure(candidate.dual, problem.field, task.control());
    const TessellationReport shape = candidate.report;
    candidate.report = measures.report;
    candidate.report.covered_share = shape.covered_share;
    candidate.report.outside_share = shape.outside_share;
    candidate.report.start = start.name();
    candidate.side_error = std::abs(measures.mean_ratio - 1);
    candidate.irregularity = measures.irregularity;
}

/// The mean of sides over wanted sides at a density, from a sketch, if this mean is far off; such a density
/// needs no full tiling.
std::optional<double> far_ratio(const Tiler& tiler, const TilingProblem& problem, double factor,
                                SharedTask& task) {
    const Dual dual = tiler.sketch(factor);
    if (dual.cells.empty()) return std::nullopt;
    const double ratio = measure(dual, problem.field, task.control()).mean_ratio;
    return std::abs(std::log(ratio)) > kFarRatio ? std::optional(ratio) : std::nullopt;
}

}  // namespace

Candidate make_candidate(const TilingProblem& problem, const Start& start, SharedTask& task) {
    const Tiler tiler(problem, start, task);
    const bool is_graded = !problem.field.is_uniform();
    std::optional<Candidate> best;
    FactorSearch search(start.factor);
    for (int round = 0; round < kSearchRounds; ++round) {
        if (best && search.factor() < kFinestFactor * start.factor) break;
        if (const auto far = problem.has_many() && round + 1 < kSearchRounds
                                 ? far_ratio(tiler, problem, search.factor(), task)
                                 : std::nullopt) {
            search.learn(*far);
            continue;
        }
        Candidate candidate = tiler.tiles(search.factor());
        double ratio = 1.5;
        if (!candidate.dual.cells.empty()) {
            describe(candidate, problem, start, task);
            ratio = measure(candidate.dual, problem.field, task.control()).mean_ratio;
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
    if (problem.options.narrow == Narrow::Merge && is_graded && best->defects.empty()) {
        const double error = best->side_error;
        tiler.merge(*best);
        describe(*best, problem, start, task);
        best->side_error = error;  // error before the tiles were merged
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
