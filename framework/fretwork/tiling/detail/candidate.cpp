// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/candidate.hpp>
#include <fretwork/tiling/detail/cell_sides.hpp>
#include <fretwork/tiling/detail/gaps.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/regularize.hpp>
#include <fretwork/tiling/detail/sites.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

constexpr int kSearchRounds = 8;
constexpr double kFinestEdge = 0.25;         // of the first: finer sites make tiles of another size
constexpr double kGoodSideError = 0.005;     // ends the search for the density
constexpr double kAcceptedSideError = 0.01;  // below, regularity decides
constexpr int kRegularizingIterations = 100;
constexpr double kRoughEdge =
    1.6;  // of the wanted side: between where the searches for lattices and meshes end
constexpr int kRoughIterations = 20;
constexpr double kSlenderAngle = 30 * std::numbers::pi / 180;

void measure_sides(const Dual& dual, const Work& work, TessellationReport& report) {
    double count = 0.0;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    report.smallest_side = std::numeric_limits<double>::infinity();
    const auto sides = sides_of_cells(dual, work.control());
    for_each_side(sides, work.control(), [&](std::span<const CellSide> same) {
        const auto [first, second] = same.front().ends();
        const double side = distance(dual.vertices[static_cast<std::size_t>(first)].place,
                                     dual.vertices[static_cast<std::size_t>(second)].place);
        count += 1.0;
        sum += side;
        sum_of_squares += side * side;
        report.smallest_side = std::min(report.smallest_side, side);
    });
    report.mean_side = sum / count;
    report.sd_side = std::sqrt(std::max(0.0, sum_of_squares / count - report.mean_side * report.mean_side));
}

/// How many sets of cells hang together by sides.
int count_pieces(const Dual& dual, const Work& work) {
    std::vector<std::size_t> parent(dual.cells.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](std::size_t cell) {
        while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
        return cell;
    };
    auto pieces = static_cast<int>(dual.cells.size());
    const auto sides = sides_of_cells(dual, work.control());
    for_each_side(sides, work.control(), [&](std::span<const CellSide> same) {
        for (const CellSide& other : same.subspan(1)) {
            if (root(same.front().cell) == root(other.cell)) continue;
            parent[root(other.cell)] = root(same.front().cell);
            --pieces;
        }
    });
    return pieces;
}

bool is_at_rim(const Dual& dual, const std::vector<int>& cell) {
    return std::any_of(cell.begin(), cell.end(),
                       [&](int vertex) { return dual.vertices[static_cast<std::size_t>(vertex)].loop >= 0; });
}

double area(const Outline& outline) {
    double sum = pattern::signed_area(outline.boundary);
    for (const Polygon& hole : outline.holes) sum += pattern::signed_area(hole);
    return sum;
}

double smallest_angle(const Polygon& polygon) {
    double smallest = std::numbers::pi;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 here = polygon[(i + 1) % polygon.size()];
        const Point2 next = polygon[(i + 2) % polygon.size()];
        smallest = std::min(smallest, std::abs(turn(next - here, polygon[i] - here)));
    }
    return smallest;
}

/// Count shapes, and judge them: the share of tiles with another number of sides than they should have (six;
/// at the rim also five), and the relative spreads of sides and areas.
void measure_shapes(const Outline& outline, const Work& work, Candidate& candidate) {
    TessellationReport& report = candidate.report;
    report.smallest_angle = std::numbers::pi;
    report.tiles = static_cast<int>(candidate.dual.cells.size());
    const auto count = static_cast<double>(report.tiles);
    const double outline_area = area(outline);
    int inner = 0;
    int inner_hexagons = 0;
    int misfits = 0;
    double sum_of_squared_areas = 0.0;
    for (std::size_t c = 0; c < candidate.dual.cells.size(); ++c) {
        work.check();
        const Polygon polygon = polygon_of(candidate.dual, c);
        const bool at_rim = is_at_rim(candidate.dual, candidate.dual.cells[c]);
        const bool is_hexagon = polygon.size() == 6;
        const double share = pattern::signed_area(polygon) / outline_area;
        report.hexagon_share += is_hexagon ? 1 / count : 0;
        inner += at_rim ? 0 : 1;
        inner_hexagons += !at_rim && is_hexagon ? 1 : 0;
        misfits += is_hexagon || (at_rim && polygon.size() == 5) ? 0 : 1;
        report.smallest_angle = std::min(report.smallest_angle, smallest_angle(polygon));
        report.covered_share += share;
        sum_of_squared_areas += share * share;
        candidate.not_convex += pattern::is_convex(polygon) ? 0 : 1;
        candidate.slender += smallest_angle(polygon) < kSlenderAngle ? 1 : 0;
    }
    report.inner_hexagon_share = inner > 0 ? static_cast<double>(inner_hexagons) / inner : 0.0;
    const double mean_share = report.covered_share / count;
    const double area_spread =
        std::sqrt(std::max(0.0, sum_of_squared_areas / count / (mean_share * mean_share) - 1));
    candidate.irregularity = misfits / count + report.sd_side / report.mean_side + area_spread;
}

/// Looks for the distance of the sites at which the mean side is the wanted one. The mean side grows with the
/// distance, but in jumps, since the number of tiles is a whole number.
class EdgeSearch {
  public:
    explicit EdgeSearch(double edge) : edge_(edge) {}
    [[nodiscard]] double edge() const { return edge_; }
    /// @param ratio  the mean side at edge() over the wanted one
    void learn(double ratio) {
        (ratio < 1 ? low_ : high_) = edge_;
        const double guess = edge_ / ratio;
        const bool is_bracketed = low_ > 0 && high_ > 0;
        edge_ = is_bracketed && (guess <= std::min(low_, high_) || guess >= std::max(low_, high_))
                    ? std::sqrt(low_ * high_)
                    : guess;
    }

  private:
    double edge_;
    double low_ = 0.0;   // the last at which sides were too short
    double high_ = 0.0;  // the last at which sides were too long
};

Dual tiles_around(const Rim& rim, const std::vector<Point2>& sites, const Work& work) {
    if (sites.empty()) return {};
    Dual dual = dual_of(rim, triangulate(rim, sites, work), work);
    std::erase_if(dual.cells, [](const std::vector<int>& cell) { return cell.size() < 3; });
    close_gaps(dual, work.control());
    return dual;
}

/// Makes the tilings of one start.
class Tiler {
  public:
    Tiler(const Outline& outline, const TessellationOptions& options, const Start& start, Work& work)
        : outline_(outline), options_(options), start_(start), work_(work) {}

    /// A first sketch of the tiles around sites at distances near `edge` (metres).
    [[nodiscard]] Dual sketch(double edge) const {
        const Rim rim = sample_rim(outline_, edge, work_.control());
        return tiles_around(rim, sites(rim, edge, rough_iterations(options_)), work_);
    }
    /// The tiles around sites at distances near `edge` (metres).
    [[nodiscard]] Dual tiles(double edge) const {
        const Rim rim = sample_rim(outline_, edge, work_.control());
        Dual dual = tiles_around(rim, sites(rim, edge, options_.relaxation_iterations), work_);
        regularize(dual, rim, kRegularizingIterations, work_);
        return dual;
    }
    static int rough_iterations(const TessellationOptions& options) {
        return std::min(kRoughIterations, options.relaxation_iterations);
    }

  private:
    [[nodiscard]] std::vector<Point2> sites(const Rim& rim, double edge, int relaxations) const {
        auto first = start_.lattice_angle ? lattice_sites(rim, edge, *start_.lattice_angle, work_)
                                          : remeshed_sites(rim, edge, options_.remeshing_iterations, work_);
        return relax(rim, std::move(first), relaxations, work_);
    }

    const Outline& outline_;
    const TessellationOptions& options_;
    const Start& start_;
    Work& work_;
};

/// Of each density that is tried: relaxations, and regularization as one.
std::size_t steps_of_density(const TessellationOptions& options) {
    return static_cast<std::size_t>(options.relaxation_iterations) + 1;
}

}  // namespace

std::size_t rough_steps(const TessellationOptions& options) {
    return static_cast<std::size_t>(Tiler::rough_iterations(options));
}

std::size_t candidate_steps(const TessellationOptions& options) {
    return kSearchRounds * steps_of_density(options);
}

std::string Start::name() const {
    if (!lattice_angle) return "remeshing";
    return "lattice at " +
           base::format_number(std::round(*lattice_angle * 180 / std::numbers::pi * 10) / 10) + " deg";
}

double rough_irregularity(const Outline& outline, const TessellationOptions& options, const Start& start,
                          Work& work) {
    Candidate candidate;
    candidate.dual = Tiler(outline, options, start, work).sketch(kRoughEdge * options.edge_length);
    if (candidate.dual.cells.empty()) return std::numeric_limits<double>::infinity();
    measure_sides(candidate.dual, work, candidate.report);
    measure_shapes(outline, work, candidate);
    return candidate.irregularity;
}

namespace {

/// Of two densities of one start: the right mean side first, then no gaps, then the better side.
bool is_better_density(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        return std::tuple(std::max(candidate.side_error, kAcceptedSideError), candidate.pinched,
                          candidate.side_error);
    };
    return key(first) < key(second);
}

}  // namespace

Candidate make_candidate(const Outline& outline, const TessellationOptions& options, const Start& start,
                         Work& work) {
    const Tiler tiler(outline, options, start, work);
    Candidate best;
    best.side_error = std::numeric_limits<double>::infinity();
    const double first_edge = std::numbers::sqrt3 * options.edge_length;  // between regular hexagons
    EdgeSearch search(first_edge);
    const auto is_good = [&] { return best.side_error <= kGoodSideError && best.pinched == 0; };
    int round = 0;
    for (; round < kSearchRounds && !is_good(); ++round) {
        if (search.edge() < kFinestEdge * first_edge) break;
        Candidate candidate;
        candidate.dual = tiler.tiles(search.edge());
        if (candidate.dual.cells.empty()) {
            search.learn(1.5);
            continue;
        }
        measure_sides(candidate.dual, work, candidate.report);
        const double ratio = candidate.report.mean_side / options.edge_length;
        search.learn(ratio);
        candidate.side_error = std::abs(ratio - 1);
        candidate.pinched = count_pinches(candidate.dual, work.control());
        if (is_better_density(candidate, best)) best = std::move(candidate);
    }
    work.advance(static_cast<std::size_t>(kSearchRounds - round) * steps_of_density(options));
    if (best.dual.cells.empty()) return best;
    measure_shapes(outline, work, best);
    best.pieces = count_pieces(best.dual, work);
    best.report.start = start.name();
    return best;
}

bool is_better(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        const int missing = candidate.dual.cells.empty() ? 1 : 0;
        return std::tuple(missing, candidate.pieces, candidate.not_convex, candidate.pinched,
                          candidate.slender, std::max(candidate.side_error, kAcceptedSideError),
                          candidate.irregularity);
    };
    return key(first) < key(second);
}

}  // namespace fretwork::tiling::detail
