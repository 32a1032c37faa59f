// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>

#include <random>

namespace fretwork::tiling::detail {
namespace THIS_TEST {

using geometry::Point2;

/// Every side is looked at.
bool is_inside(const Rim& rim, Point2 point, double margin) {
    bool inside = false;
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
        const Point2 a = rim.points[i].place;
        const Point2 b = rim.points[rim.next[i]].place;
        if (margin > 0 && distance(nearest_on_segment(a, b, point), point) < margin) return false;
        if ((a.y > point.y) != (b.y > point.y) && (cross(b - a, point - a) > 0) == (b.y > a.y))
            inside = !inside;
    }
    return inside;
}

TEST(InsideTest, SaysWhatALookAtEverySideSays) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(-0.1, 1.2);
    std::uniform_real_distribution<double> y(-0.1, 1.0);
    for (const char* name : {"example_a.svg", "example_b.svg", "example_c.svg", "specimen.svg"}) {
        const SizeField field(0.04);
        const Rim rim = sample_rim(outlines::read_outline(outlines::example_outline(name)), {field, 1.0}, {});
        const InsideTest fast(rim, 0.01);
        for (const double margin : {0.0, 0.004, 0.01}) {
            for (int i = 0; i < 2000; ++i) {
                const Point2 point{x(random), y(random)};
                EXPECT_EQ(fast(point, margin), is_inside(rim, point, margin))
                    << name << " " << point.x << " " << point.y;
            }
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling::detail
