// SPDX-License-Identifier: GPL-3.0-or-later
// The outline beside CGAL's exact union of the same rectangles and discs in one go.
#include "sample.hpp"

#include <fretwork/fabrication/detail/patches.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Point2;

using namespace test;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

struct ExactUnion {
    double area = 0.0;
    std::size_t pieces = 0;
    std::size_t openings = 0;
};

/// Exact on the grid of a nanometre. What is smaller than a square micrometre is rounding of the corners.
ExactUnion exact_union(const std::vector<detail::Patch>& patches) {
    constexpr double kPerMetre = 1e9;
    std::vector<CGAL::Polygon_2<Kernel>> polygons;
    for (const detail::Patch& patch : patches) {
        CGAL::Polygon_2<Kernel>& polygon = polygons.emplace_back();
        for (const Point2& point : patch.polygon)
            polygon.push_back({std::round(point.x * kPerMetre), std::round(point.y * kPerMetre)});
    }
    CGAL::Polygon_set_2<Kernel> set;
    set.join(polygons.begin(), polygons.end());
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> found;
    set.polygons_with_holes(std::back_inserter(found));
    ExactUnion exact;
    const auto square_metres = [](const auto& loop) { return CGAL::to_double(loop.area()) * 1e-18; };
    for (const auto& piece : found) {
        ++exact.pieces;
        exact.area += square_metres(piece.outer_boundary());
        for (const auto& hole : piece.holes()) {
            exact.area += square_metres(hole);
            exact.openings += std::abs(square_metres(hole)) > 1e-12 ? 1U : 0U;
        }
    }
    return exact;
}

TEST(Shape, IsTheExactUnionOfItsBars) {
    const std::vector<std::string> patterns = sample_patterns(50);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const BarPlan plan = bar_plan(honeycomb(3, 2, patterns, seed), seed == 3 ? 4e-3 : 0.0);
        const auto patches = detail::bar_patches(plan, 0.0);
        const ExactUnion exact = exact_union(patches);
        const Shape shape = make_shape(plan, {});
        std::size_t openings = 0;
        for (const Piece& piece : shape.pieces) openings += piece.openings.size();
        EXPECT_EQ(shape.pieces.size(), exact.pieces);
        EXPECT_EQ(openings, exact.openings);
        // The discs' chords take 1.7e-3 of r^2 / 2 for each radian away from arcs: twice the largest sum of
        // them.
        const double ends = static_cast<double>(patches.size() - plan.bars.size());
        const double chords = ends * 2.0 * kPi * 1.7e-3 * 0.5 * 4e-6;
        EXPECT_GE(area(shape), exact.area - 1e-10) << seed;
        EXPECT_LE(area(shape), exact.area + chords) << seed;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
