// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_reading.hpp"
#include "made_sample.hpp"

#include <fretwork/exports/making/making_files.hpp>

#include <pugixml.hpp>

#include <set>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using fabrication::Contour;
using testing::HasSubstr;

double sum_of_areas(const std::vector<Contour>& contours) {
    double sum = 0.0;
    for (const Contour& contour : contours) sum += signed_area(contour);
    return sum;
}

TEST(CutDxf, ReadAgainItHasTheAreaInSquareMillimetres) {
    const simulation::Surface surface = sample_surface();
    const fabrication::ShapeOptions options{.fillet = 5e-4};
    const auto contours = polylines(cut_dxf(fabrication::whole_sheet(surface, options)), "cut");
    const fabrication::Shape shape = fabrication::make_shape(surface, options);
    // Coordinates are rounded to a nanometre, along some metres of contour.
    EXPECT_NEAR(sum_of_areas(contours), 1e6 * area(shape), 1e-2);
}

TEST(CutDxf, SaysMillimetresAndClosesEveryContourInModelSpace) {
    const std::string text = cut_dxf(fabrication::whole_sheet(sample_surface(), {}));
    EXPECT_THAT(text, HasSubstr("$INSUNITS\n70\n4\n"));
    EXPECT_EQ(text.find("INSERT\n"), std::string::npos);
    std::size_t closed = 0, polylines_there = 0;
    std::string entity;
    for (const auto& [code, value] : groups(text)) {
        if (code == 0) entity = value;
        if (code == 0 && value == "LWPOLYLINE") ++polylines_there;
        if (entity == "LWPOLYLINE" && code == 70 && value == "1") ++closed;
    }
    EXPECT_GT(polylines_there, 10U);
    EXPECT_EQ(closed, polylines_there);
}

TEST(CutDxf, HandlesAreUnique) {
    std::set<std::string> handles;
    for (const auto& [code, value] : groups(cut_dxf(fabrication::whole_sheet(sample_surface(), {}))))
        if (code == 5 && value != "FFFFFF") {
            EXPECT_TRUE(handles.insert(value).second) << value;
        }
}

TEST(CutDxf, EveryTileHasItsNumberOnTheLayerOfLabels) {
    const std::string text = cut_dxf(fabrication::whole_sheet(sample_surface(3, 2), {}));
    for (int tile = 0; tile < 6; ++tile) EXPECT_THAT(text, HasSubstr("\n1\n" + std::to_string(tile) + "\n"));
}

TEST(CutSvg, HasTrueSizeAndLayers) {
    const fabrication::CutSheet sheet = fabrication::whole_sheet(sample_surface(), {});
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(cut_svg(sheet).c_str()));
    const auto svg = document.child("svg");
    const std::string width = svg.attribute("width").value();
    EXPECT_THAT(width, HasSubstr("mm"));
    const double margins = 4.0;
    EXPECT_NEAR(std::stod(width), 1e3 * box_of(sheet).width() + margins, 1e-5);
    EXPECT_THAT(svg.attribute("viewBox").value(), HasSubstr(width.substr(0, width.size() - 2)));
    std::set<std::string> layers;
    for (const auto& group : svg.children("g")) layers.insert(group.attribute("id").value());
    EXPECT_EQ(layers, (std::set<std::string>{"cut", "engrave", "labels", "guides"}));
    EXPECT_EQ(std::distance(svg.find_child_by_attribute("id", "cut").children("path").begin(),
                            svg.find_child_by_attribute("id", "cut").children("path").end()),
              static_cast<std::ptrdiff_t>(sheet.pieces.size()));
}

TEST(CutSvg, HasAnArcForEveryBulge) {
    const fabrication::CutSheet sheet = fabrication::whole_sheet(sample_surface(), {.fillet = 5e-4});
    std::size_t bulges = 0;
    for (const fabrication::Piece& piece : sheet.pieces) {
        const auto count = [&](const Contour& contour) {
            for (const auto& point : contour) bulges += point.bulge != 0.0 ? 1U : 0U;
        };
        count(piece.outer);
        for (const Contour& opening : piece.openings) count(opening);
    }
    const std::string text = cut_svg(sheet);
    const std::string cut = text.substr(text.find("id=\"cut\""));
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(cut, 'A')), bulges);
}

TEST(CutFiles, ABedGivesSheetsBesideEachOther) {
    Scene scene{sample_surface(6, 4)};
    scene.making.bed = fabrication::Bed{.width = 0.15, .height = 0.12};
    const std::string dxf = find_writer("a.dxf").write(scene).text;
    const auto beds = polylines(dxf, "guides");
    EXPECT_THAT(dxf, HasSubstr("Sheet 2"));
    EXPECT_THAT(dxf, HasSubstr("Assembly"));
    double largest = 0.0;
    for (const Contour& guide : beds) largest = std::max(largest, signed_area(guide));
    EXPECT_NEAR(largest, 150.0 * 120.0, 1e-3);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
