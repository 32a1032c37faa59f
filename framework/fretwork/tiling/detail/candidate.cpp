// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/candidate.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/regularize.hpp>
#include <fretwork/tiling/detail/sites.hpp>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

constexpr int kSearchRounds = 8;
constexpr double kGoodSideError = 0.002;     // ends the search for the density
constexpr double kAcceptedSideError = 0.01;  // below, regularity decides
constexpr int kRegularizingIterations = 100;

/// The sides of the cells, as pairs of vertices, and the cells that have them.
std::map<std::pair<int, int>, std::vector<std::size_t>> sides_of(const Dual& dual) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> sides;
    for (std::size_t c = 0; c < dual.cells.size(); ++c) {
        const std::vector<int>& cell = dual.cells[c];
        for (std::size_t i = 0; i < cell.size(); ++i)
            sides[std::minmax(cell[i], cell[(i + 1) % cell.size()])].push_back(c);
    }
    return sides;
}

void measure_sides(const Dual& dual, TessellationReport& report) {
    const auto sides = sides_of(dual);
    double sum = 0.0;
    double sum_of_squares = 0.0;
    report.smallest_side = std::numeric_limits<double>::infinity();
    for (const auto& [ends, cells] : sides) {
        const double side = distance(dual.vertices[static_cast<std::size_t>(ends.first)].place,
                                     dual.vertices[static_cast<std::size_t>(ends.second)].place);
        sum += side;
        sum_of_squares += side * side;
        report.smallest_side = std::min(report.smallest_side, side);
    }
    const auto count = static_cast<double>(sides.size());
    report.mean_side = sum / count;
    report.sd_side = std::sqrt(std::max(0.0, sum_of_squares / count - report.mean_side * report.mean_side));
}

/// How many sets of cells hang together by sides.
int count_pieces(const Dual& dual) {
    std::vector<std::size_t> parent(dual.cells.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](std::size_t cell) {
        while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
        return cell;
    };
    auto pieces = static_cast<int>(dual.cells.size());
    for (const auto& [ends, cells] : sides_of(dual)) {
        for (std::size_t i = 1; i < cells.size(); ++i) {
            if (root(cells[0]) == root(cells[i])) continue;
            parent[root(cells[i])] = root(cells[0]);
            --pieces;
        }
    }
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

/// Count shapes, and judge them: the share of tiles with another number of sides than they should have (six;
/// at the rim also five), and the relative spread of the sides.
void measure_shapes(const Outline& outline, Candidate& candidate) {
    TessellationReport& report = candidate.report;
    int hexagons = 0;
    int inner = 0;
    int inner_hexagons = 0;
    int fitting = 0;
    for (std::size_t c = 0; c < candidate.dual.cells.size(); ++c) {
        const Polygon polygon = polygon_of(candidate.dual, c);
        const bool at_rim = is_at_rim(candidate.dual, candidate.dual.cells[c]);
        const bool is_hexagon = polygon.size() == 6;
        hexagons += is_hexagon ? 1 : 0;
        inner += at_rim ? 0 : 1;
        inner_hexagons += !at_rim && is_hexagon ? 1 : 0;
        fitting += is_hexagon || (at_rim && polygon.size() == 5) ? 1 : 0;
        candidate.not_convex += pattern::is_convex(polygon) ? 0 : 1;
        report.covered_share += pattern::signed_area(polygon) / area(outline);
    }
    report.tiles = static_cast<int>(candidate.dual.cells.size());
    report.hexagon_share = static_cast<double>(hexagons) / report.tiles;
    report.inner_hexagon_share = inner > 0 ? static_cast<double>(inner_hexagons) / inner : 0.0;
    candidate.irregularity =
        1 - static_cast<double>(fitting) / report.tiles + report.sd_side / report.mean_side;
}

/// The tiles around sites at distances near `edge` (metres).
Dual tiles_at(const Outline& outline, const TessellationOptions& options, const Start& start, double edge) {
    const Rim rim = sample_rim(outline, edge);
    std::vector<Point2> sites = start.lattice_angle ? lattice_sites(rim, edge, *start.lattice_angle)
                                                    : remeshed_sites(rim, edge, options.remeshing_iterations);
    sites = relax(rim, std::move(sites), options.relaxation_iterations);
    Dual dual = dual_of(rim, triangulate(rim, sites));
    std::erase_if(dual.cells, [](const std::vector<int>& cell) { return cell.size() < 3; });
    regularize(dual, rim, kRegularizingIterations);
    return dual;
}

}  // namespace

std::string Start::name() const {
    if (!lattice_angle) return "remeshing";
    return "lattice at " +
           base::format_number(std::round(*lattice_angle * 180 / std::numbers::pi * 10) / 10) + " deg";
}

Candidate make_candidate(const Outline& outline, const TessellationOptions& options, const Start& start) {
    Candidate best;
    best.side_error = std::numeric_limits<double>::infinity();
    double edge =
        std::numbers::sqrt3 * options.edge_length;  // regular hexagons have their centers so far apart
    for (int round = 0; round < kSearchRounds && best.side_error > kGoodSideError; ++round) {
        Candidate candidate;
        candidate.dual = tiles_at(outline, options, start, edge);
        if (candidate.dual.cells.empty()) {
            edge /= 1.5;
            continue;
        }
        measure_sides(candidate.dual, candidate.report);
        const double ratio = candidate.report.mean_side / options.edge_length;
        candidate.side_error = std::abs(ratio - 1);
        if (candidate.side_error < best.side_error) best = std::move(candidate);
        edge /= ratio;
    }
    if (best.dual.cells.empty()) return best;
    measure_shapes(outline, best);
    best.pieces = count_pieces(best.dual);
    best.report.start = start.name();
    return best;
}

bool is_better(const Candidate& first, const Candidate& second) {
    const auto key = [](const Candidate& candidate) {
        const int missing = candidate.dual.cells.empty() ? 1 : 0;
        return std::tuple(missing, candidate.pieces, candidate.not_convex,
                          std::max(candidate.side_error, kAcceptedSideError), candidate.irregularity);
    };
    return key(first) < key(second);
}

}  // namespace fretwork::tiling::detail
