// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/parts.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/simulation/project/new_project.hpp>

#include <limits>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Box;

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

simulation::Surface wide_surface() {
    return honeycomb(8, 4, {"1-6+3-6", "0-1+1-6"});  // some 330 x 200 mm
}

double material(const CutSheet& sheet) {
    return area({sheet.pieces, 0.0});
}

/// How many sheets have something beyond the bed's margins.
std::size_t box_of_parts_beyond(const SheetSet& set, const Bed& bed) {
    std::size_t count = 0;
    for (const CutSheet& sheet : set.sheets) {
        const Box box = box_of(sheet);
        const double least = std::min(box.xmin, box.ymin) - bed.margin;
        const double most = std::max(box.xmax - bed.width, box.ymax - bed.height) + bed.margin;
        if (least < -1e-9 || most > 1e-9) ++count;
    }
    return count;
}

/// The least room of all interface nodes between parts: to the ends of their sides, and half way to the next.
double narrowest_room(const tiling::Tessellation& tessellation,
                      const base::IndexVector<tiling::TileIndex, std::size_t>& parts) {
    std::map<int, std::vector<std::size_t>> parts_of_node;
    std::map<int, double> room_of_node;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const tiling::Tile& tile = tessellation.tiles[t];
        for (std::size_t s = 0; s < tile.vertices.size(); ++s) {
            const int node = tile.interface_nodes[s];
            const Point2& place = tessellation.interface_nodes[node];
            parts_of_node[node].push_back(parts[t]);
            room_of_node[node] = std::min(
                distance(place, tessellation.vertices[tile.vertices[s]]),
                distance(place, tessellation.vertices[tile.vertices[(s + 1) % tile.vertices.size()]]));
        }
    }
    std::vector<int> connectors;
    for (const auto& [node, around] : parts_of_node)
        if (around.size() == 2 && around[0] != around[1]) connectors.push_back(node);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < connectors.size(); ++i) {
        least = std::min(least, room_of_node[connectors[i]]);
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, 0.5 * distance(tessellation.interface_nodes[connectors[i]],
                                                   tessellation.interface_nodes[connectors[j]]));
    }
    return least;
}

TEST(Sheets, ASurfaceThatFitsTheBedIsOnePartWithoutJoints) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.6, .height = 0.4});
    EXPECT_EQ(set.sheets.size(), 1U);
    EXPECT_EQ(set.parts, 1U);
    EXPECT_EQ(set.connectors, 0U);
    EXPECT_NEAR(material(set.sheets[0]), area(make_shape(wide_surface())), 1e-9);
}

TEST(Sheets, PartsLieOnTheBedWithinItsMargins) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {}, bed);
    EXPECT_GT(set.parts, 3U);
    EXPECT_GT(set.connectors, 5U);
    for (const CutSheet& sheet : set.sheets) {
        const Box box = box_of(sheet);
        EXPECT_GE(box.xmin, bed.margin - 1e-9);
        EXPECT_GE(box.ymin, bed.margin - 1e-9);
        EXPECT_LE(box.xmax, bed.width - bed.margin + 1e-9);
        EXPECT_LE(box.ymax, bed.height - bed.margin + 1e-9);
    }
}

TEST(Sheets, AWideFrameLiesOnTheBedToo) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {.frame_width = 0.02}, bed);
    for (const CutSheet& sheet : set.sheets) {
        const Box box = box_of(sheet);
        EXPECT_GE(std::min(box.xmin, box.ymin), bed.margin - 1e-9);
        EXPECT_LE(box.xmax, bed.width - bed.margin + 1e-9);
        EXPECT_LE(box.ymax, bed.height - bed.margin + 1e-9);
    }
}

TEST(Sheets, PartsOnASheetDoNotOverlap) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.2, .height = 0.15});
    for (const CutSheet& sheet : set.sheets) {
        for (std::size_t i = 0; i < sheet.pieces.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(box_of(sheet.pieces[i].outer).meets(box_of(sheet.pieces[j].outer)));
    }
}

TEST(Sheets, EachPartIsOnePiece) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.2, .height = 0.15});
    std::size_t pieces = 0;
    for (const CutSheet& sheet : set.sheets) pieces += sheet.pieces.size();
    EXPECT_EQ(pieces, set.parts);
}

TEST(Sheets, JointsLeaveTheFitAroundKnobsAndNothingElseIsLost) {
    // Two tiles, two parts, one joint. All of the surface and the joint's two half plates is there but the
    // gap of the fit: along the seam, the neck and the knob.
    const simulation::Surface surface = honeycomb(1, 2, {"1-6+3-6"});
    const Bed bed{.width = 0.0704, .height = 0.0704, .margin = 1e-3, .fit = 1e-4};
    const SheetSet set = cut_into_sheets(surface, {}, bed);
    ASSERT_EQ(set.parts, 2U);
    ASSERT_EQ(set.connectors, 1U);
    double sum = 0.0;
    for (const CutSheet& sheet : set.sheets) sum += material(sheet);
    const SheetSet tight =
        cut_into_sheets(surface, {}, {.width = 0.0704, .height = 0.0704, .margin = 1e-3, .fit = 0.0});
    double tight_sum = 0.0;
    for (const CutSheet& sheet : tight.sheets) tight_sum += material(sheet);
    const double plate = 3.4 * kWidth;
    const double knob_angle = std::asin(0.5 / 0.9);  // half of what the neck takes of the knob
    const double neck_length = 1.5 * kWidth - 0.9 * kWidth * std::cos(knob_angle);
    const double gap = 2.0 * plate - kWidth + 2.0 * neck_length + 0.9 * kWidth * 2.0 * (kPi - knob_angle);
    EXPECT_NEAR(tight_sum - sum, gap * 1e-4, 0.05 * gap * 1e-4);  // corners of the gap
}

TEST(Sheets, FramesEndAtTheSeam) {
    // Two tiles, two parts. Beside both ends of the seam, there is material of one part only.
    const simulation::Surface surface = honeycomb(1, 2, {"1-6+3-6"});
    const Bed bed{.width = 0.0704, .height = 0.0704, .margin = 1e-3};
    const SheetSet set = cut_into_sheets(surface, {.frame_width = 0.004}, bed);
    ASSERT_EQ(set.parts, 2U);
    const auto seam = tiling::shared_sides(surface.tessellation).front();
    const auto& vertices = surface.tessellation.vertices;
    const Point2 across = geometry::left_of(geometry::unit(vertices[seam.to] - vertices[seam.from]));
    for (const tiling::VertexIndex vertex : {seam.from, seam.to}) {
        for (const double beside : {-0.001, 0.001}) {
            const Point2 place = vertices[vertex] + beside * across;
            std::size_t parts_there = 0;
            for (const Contour& outline : set.assembly.guides)
                if (signed_area(outline) > 0.0 && detail::contains(flattened(outline, 1e-6), place))
                    ++parts_there;
            EXPECT_EQ(parts_there, 1U);
        }
    }
}

TEST(Sheets, ATileThatDoesNotFitTheBedIsNamed) {
    EXPECT_THAT(
        complaint_of([] { (void)cut_into_sheets(wide_surface(), {}, {.width = 0.04, .height = 0.04}); }),
        AllOf(HasSubstr("tile 0"), HasSubstr("bed")));
}

TEST(Sheets, AJointWithoutRoomIsNamedByItsNode) {
    simulation::Surface surface = wide_surface();
    surface.setting.section = mechanics::rectangle_section(0.0045, 0.002);
    EXPECT_THAT(complaint_of([&] { (void)cut_into_sheets(surface, {}, {.width = 0.2, .height = 0.15}); }),
                AllOf(HasSubstr("node"), HasSubstr("no room")));
}

TEST(Sheets, AConnectorDoesNotFillAHoleForABolt) {
    const simulation::Surface surface = honeycomb(1, 2, {"1-6+3-6"});
    const Bed bed{.width = 0.0704, .height = 0.0704, .margin = 1e-3};
    const TessellationNodeIndex node(tiling::shared_sides(surface.tessellation).front().nodes.front().value);
    const ShapeOptions options{.bolt_diameter = 1e-3, .bolts = {node}};
    EXPECT_THAT(complaint_of([&] { (void)cut_into_sheets(surface, options, bed); }),
                AllOf(HasSubstr("connector at node " + std::to_string(node)), HasSubstr("bolt")));
}

TEST(Sheets, AHoleForABoltWhereNoBarEndsIsRefusedByNode) {
    const simulation::Surface surface = wide_surface();
    const TessellationNodeIndex beyond(bar_plan(surface).nodes.size());
    const ShapeOptions options{.bolt_diameter = 1e-3, .bolts = {beyond}};
    EXPECT_THAT(
        complaint_of([&] { (void)cut_into_sheets(surface, options, {.width = 0.2, .height = 0.15}); }),
        HasSubstr("a bolt at node " + std::to_string(beyond)));
}

/// A rectangle of 380 x 480 mm with round corners and a slot for a hand.
outlines::Outline chair_back() {
    const auto rounded = [](const Box& box, double radius) {
        geometry::Polygon polygon;
        const std::array<Point2, 4> centers = {Point2{box.xmax - radius, box.ymin + radius},
                                               {box.xmax - radius, box.ymax - radius},
                                               {box.xmin + radius, box.ymax - radius},
                                               {box.xmin + radius, box.ymin + radius}};
        for (int corner = 0; corner < 4; ++corner)
            for (int i = 0; i <= 8; ++i)
                polygon.push_back(centers[static_cast<std::size_t>(corner)] +
                                  radius * geometry::direction(0.5 * kPi * (corner - 1 + i / 8.0)));
        return polygon;
    };
    return outlines::make_outline(rounded({0.0, 0.0, 0.38, 0.48}, 0.06),
                                  {rounded({0.13, 0.38, 0.25, 0.42}, 0.018)});
}

simulation::Surface chair_surface() {
    simulation::NewProjectOptions options;
    options.edge_length = 0.018;
    options.painting = simulation::PaintOnePattern{"0-1+1-6"};
    return make_surface(make_project(chair_back(), options, nullptr).project, nullptr);
}

TEST(Sheets, SeamsMoveToWhereConnectorsHaveRoom) {
    const simulation::Surface surface = chair_surface();
    const ShapeOptions options;
    const double plate = 3.4 * mechanics::section_width(surface.setting.section);
    for (const Bed& bed : {Bed{.width = 0.25, .height = 0.3}, Bed{.width = 0.4, .height = 0.3}}) {
        const SheetSet set = cut_into_sheets(surface, options, bed);
        EXPECT_LE(set.parts, 6U);
        EXPECT_EQ(box_of_parts_beyond(set, bed), 0U);
        const auto parts = detail::parts_of_tiles(surface.tessellation, bed, {plate, plate + bed.fit, {}});
        EXPECT_GT(narrowest_room(surface.tessellation, parts), plate + bed.fit);
    }
}

TEST(Sheets, SeamsDoNotDependOnChance) {
    const simulation::Surface surface = chair_surface();
    const Bed bed{.width = 0.25, .height = 0.3};
    const auto parts = [&] {
        return detail::parts_of_tiles(surface.tessellation, bed, {0.0068, 0.00685, {}});
    };
    EXPECT_EQ(parts(), parts());
}

TEST(Sheets, TheSearchForPartsCanBeStopped) {
    const simulation::Surface surface = chair_surface();
    const fretwork::test::StopAtLook stop(0);
    const Bed bed{.width = 0.6, .height = 0.6};
    EXPECT_THROW((void)detail::parts_of_tiles(surface.tessellation, bed, {0.0068, 0.00685, stop.control()}),
                 base::Stopped);
}

TEST(Sheets, SideBySideHasAllSheetsAndTheAssembly) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {}, bed);
    const CutSheet all = side_by_side(set, bed);
    double sum = 0.0;
    for (const CutSheet& sheet : set.sheets) sum += material(sheet);
    EXPECT_NEAR(material(all), sum, 1e-12);
    EXPECT_EQ(all.guides.size(), set.assembly.guides.size() + set.sheets.size());
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
