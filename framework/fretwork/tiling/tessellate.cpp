// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/numbering.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/regularize.hpp>
#include <fretwork/tiling/detail/sites.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <limits>
#include <numbers>
#include <set>

namespace fretwork::tiling {
namespace {

using namespace detail;

constexpr int kSearchRounds = 12;
constexpr double kGoodMeanSide = 0.002;  // relative error that ends the search

struct SideStatistics {
    double mean = 0.0;
    double standard_deviation = 0.0;
};

SideStatistics side_statistics(const Dual& dual) {
    std::set<std::pair<int, int>> sides;
    for (const std::vector<int>& cell : dual.cells) {
        for (std::size_t i = 0; i < cell.size(); ++i)
            sides.insert(std::minmax(cell[i], cell[(i + 1) % cell.size()]));
    }
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (const auto& [a, b] : sides) {
        const double side = distance(dual.vertices[static_cast<std::size_t>(a)].place,
                                     dual.vertices[static_cast<std::size_t>(b)].place);
        sum += side;
        sum_of_squares += side * side;
    }
    const auto count = static_cast<double>(sides.size());
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, sum_of_squares / count - mean * mean))};
}

/// The tiles that come from triangles with edges of a given length.
Dual tiles_of_triangles(const Outline& outline, double edge, const TessellationOptions& options) {
    const Rim rim = sample_rim(outline, edge);
    std::vector<Point2> sites = remeshed_sites(rim, edge, options.remeshing_iterations);
    sites = relax(rim, std::move(sites), options.relaxation_iterations);
    Dual dual = dual_of(rim, triangulate(rim, sites));
    std::erase_if(dual.cells, [](const std::vector<int>& cell) { return cell.size() < 3; });
    if (!dual.cells.empty()) regularize(dual, rim, options.relaxation_iterations);
    return dual;
}

/// Look for the triangles whose dual has the wanted mean side.
Dual search(const Outline& outline, const TessellationOptions& options) {
    Dual best;
    double best_error = std::numeric_limits<double>::infinity();
    double edge = std::numbers::sqrt3 * options.edge_length;  // of the dual of regular hexagons
    for (int round = 0; round < kSearchRounds && best_error > kGoodMeanSide; ++round) {
        Dual dual = tiles_of_triangles(outline, edge, options);
        if (dual.cells.empty()) break;
        const double ratio = side_statistics(dual).mean / options.edge_length;
        edge /= ratio;
        if (std::abs(ratio - 1) < best_error) {
            best_error = std::abs(ratio - 1);
            best = std::move(dual);
        }
    }
    if (best.cells.empty())
        throw base::GeometryError("the outline is too small for one tile with sides of " +
                                  base::format_number(options.edge_length) + " m");
    return best;
}

double area(const Outline& outline) {
    double sum = pattern::signed_area(outline.boundary);
    for (const pattern::Polygon& hole : outline.holes) sum += pattern::signed_area(hole);
    return sum;
}

TessellationReport report_on(const Dual& dual, const Outline& outline) {
    TessellationReport report;
    const SideStatistics sides = side_statistics(dual);
    report.mean_side = sides.mean;
    report.sd_side = sides.standard_deviation;
    report.tiles = static_cast<int>(dual.cells.size());
    for (std::size_t cell = 0; cell < dual.cells.size(); ++cell) {
        report.hexagon_share += dual.cells[cell].size() == 6 ? 1.0 / report.tiles : 0.0;
        report.covered_share += pattern::signed_area(polygon_of(dual, cell)) / area(outline);
    }
    return report;
}

}  // namespace

void TessellationOptions::validate() const {
    if (!(edge_length > 0) || !std::isfinite(edge_length))
        throw base::InputError("the edge length of a tessellation is " + base::format_number(edge_length) +
                               " m, where a length above zero is needed");
    if (remeshing_iterations < 1 || relaxation_iterations < 0)
        throw base::InputError(
            "a tessellation needs at least one iteration of remeshing, and none below zero");
}

TessellationResult tessellate(const Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options) {
    options.validate();
    const Dual dual = search(outline, options);
    return {number(dual, layout), report_on(dual, outline)};
}

}  // namespace fretwork::tiling
