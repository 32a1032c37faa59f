// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/exports/drawings/detail/bent_beams.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/linear_solver.hpp>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;

TEST(SurfaceLines, AreTheBeamsOfAllFans) {
    const simulation::Surface surface = sample_surface();
    const LineSet lines = surface_lines(surface);
    EXPECT_EQ(lines.nodes.size(), simulation::surface_fan(surface).nodes.size());
    // Per hexagon: 6 sectors of 2, 2 and 3 edges, each pattern on 2 of the 6 tiles.
    EXPECT_EQ(lines.lines.size(), 2U * 6U * (2U + 2U + 3U));
    EXPECT_EQ(lines.tiles.size(), lines.lines.size());
    EXPECT_EQ(lines.patterns.size(), lines.lines.size());
}

TEST(ResultLines, OfAReducedModelAreClosedThroughEachTilesInterfaceNodes) {
    const simulation::Surface surface = sample_surface();
    const LineSet lines = result_lines(surface, bent(surface, Rows::InterfaceNodes));
    EXPECT_EQ(lines.nodes.size(), surface.tessellation.interface_nodes.size());
    EXPECT_EQ(lines.lines.size(), 6U * surface.tessellation.tiles.size());
    EXPECT_EQ(lines.displacements->rows(), static_cast<Eigen::Index>(lines.nodes.size()));
}

TEST(ResultLines, OfAModelWithAsManyOtherNodesAsThePatternAreClosedToo) {
    const simulation::Surface surface = sample_surface();
    const std::size_t interfaces = surface.tessellation.interface_nodes.size();
    simulation::SurfaceResult other = bent(surface, Rows::EveryNode);
    for (std::size_t i = interfaces; i < other.nodes.size(); ++i) other.nodes[i].rest_position.x() += 0.002;
    const LineSet lines = result_lines(surface, other);
    EXPECT_EQ(lines.nodes.size(), interfaces);
    EXPECT_EQ(lines.lines.size(), 6U * surface.tessellation.tiles.size());
    EXPECT_EQ(lines.displacements->rows(), static_cast<Eigen::Index>(interfaces));
}

TEST(ResultLines, OfAnotherSurfaceAreRefused) {
    const simulation::Surface surface = sample_surface();
    const simulation::Surface larger = sample_surface(4, 3);
    EXPECT_THAT(complaint_of([&] { (void)result_lines(larger, bent(surface, Rows::InterfaceNodes)); }),
                HasSubstr("too few nodes"));
    simulation::SurfaceResult moved = bent(surface, Rows::EveryNode);
    moved.nodes[3].rest_position.x() += 0.001;
    EXPECT_THAT(complaint_of([&] { (void)result_lines(surface, moved); }), HasSubstr("node 3"));
}

TEST(DisplacedNodes, MoveByTheScaledDisplacement) {
    LineSet lines;
    lines.nodes = {{1.0, 2.0, 3.0}};
    EXPECT_EQ(displaced_nodes(lines, 5.0)[0], Eigen::Vector3d(1.0, 2.0, 3.0));
    lines.displacements = mechanics::NodeValues::Zero(1, 6);
    lines.displacements->row(0) << 0.5, 0.0, -0.25, 9.0, 9.0, 9.0;
    EXPECT_EQ(displaced_nodes(lines, 2.0)[0], Eigen::Vector3d(2.0, 2.0, 2.5));
}

TEST(RimLines, AreTheSidesOfOneTileOnly) {
    // 3 x 2 hexagons of the sample: 36 sides, of which 9 are shared: 3 between the rows, 3 between each two
    // columns.
    const simulation::Surface surface = sample_surface();
    EXPECT_EQ(surface.tessellation.interface_nodes.size(), 27U);
    EXPECT_EQ(rim_lines(surface).lines.size(), 18U);
}

/// Three beams in a row, from node 0 over nodes 2 and 3 to node 1.
mechanics::Frame row_of_beams() {
    mechanics::Frame frame;
    for (const double x : {0.0, 0.3, 0.1, 0.2}) frame.nodes.push_back({x, 0.02 * x, 0.0});
    for (const auto& [from, to] : {std::pair{0, 2}, {2, 3}, {3, 1}})
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(from), mechanics::NodeIndex(to)},
                               .section = {.area = 4e-6, .I2 = 1e-12, .I3 = 1e-12, .J = 2e-12},
                               .material = {.young_modulus = 1e9, .poisson_ratio = 0.3}});
    return frame;
}

TEST(BentBeams, NodesWithoutLoadsAreWhereTheLinearSolutionHasThem) {
    mechanics::Frame frame = row_of_beams();
    frame.supports = {{mechanics::NodeIndex(0), mechanics::DofSet::all()}};
    frame.loads = {{mechanics::NodeIndex(1), {0.01, 0.002, 0.003}, {0.0, 1e-4, 2e-4}}};
    const mechanics::NodeValues solved = mechanics::solve_linear(mechanics::assemble(frame)).displacements;
    const LineSet lines = detail::bent_beams(frame, solved.topRows(2));
    ASSERT_EQ(lines.lines.size(), 3U);
    ASSERT_TRUE(lines.displacements);
    EXPECT_LT((*lines.displacements - solved).norm(), 1e-9 * solved.norm());
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
