// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/tiling/remeshing/inside.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>

namespace fretwork::tiling::detail {
namespace THIS_TEST {

TEST(RemeshedSites, FillABandWhoseEndsAreLongerThanRemeshingTakes) {
    constexpr double kEdge = 0.1;
    // One point at each corner only: each end is one edge, and CGAL takes none above 4/3.
    const outlines::Outline band{{{0, 0}, {2, 0}, {2, 1.45 * kEdge}, {0, 1.45 * kEdge}}, {}};
    const SizeField field(kEdge);
    const Rim rim = sample_rim(band, {field, 1.0}, {});
    SharedTask task({}, "sites");
    const std::vector<geometry::Point2> sites = remeshed_sites(rim, kEdge, 10, task);
    EXPECT_GE(sites.size(), 15u);
    const InsideTest is_inside(rim, 0.01);
    for (const geometry::Point2& site : sites) {
        EXPECT_TRUE(is_inside(site, 0.01)) << site.x << " " << site.y;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling::detail
