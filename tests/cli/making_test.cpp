// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` for cutting and printing: what is written is read again and measured.
#include "cli/making.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using geometry::Box;

using namespace test;
using nlohmann::json;

using testing::Contains;
using testing::DoubleNear;
using testing::HasSubstr;
using testing::Not;

constexpr double kRounding = 2e-6;     // mm: files hold nanometres, and a difference has two of them
constexpr double kRadius = 1e-3;       // mm: nanometres at the ends of a short arc
constexpr double kBarHeight = 2.0;     // mm, and width, of the paper's setting
constexpr double kOutlineWidth = 180;  // mm, of specimen.svg
constexpr double kOutlineHeight = 260;

class MakingOptions : public Making {};

TEST_F(MakingOptions, KerfMovesTheLinesOutwardsByHalfOfItself) {
    const auto nominal = cut();
    const auto widened = cut("--kerf 0.3mm");
    EXPECT_NEAR(extents(widened).width(), extents(nominal).width() + 0.3, kRounding);
    EXPECT_NEAR(extents(widened).height(), extents(nominal).height() + 0.3, kRounding);
    EXPECT_GT(area(widened), area(nominal));
    EXPECT_EQ(facts("--kerf 0.3mm").at("area"), facts().at("area")) << "what is left";
}

TEST_F(MakingOptions, FrameIsCentredOnTheRim) {
    for (const double width : {4.0, 6.0}) {
        const Box box = extents(cut("--frame " + std::to_string(width) + "mm"));
        EXPECT_NEAR(box.width(), kOutlineWidth + width, kRounding);
        EXPECT_NEAR(box.height(), kOutlineHeight + width, kRounding);
    }
}

TEST_F(MakingOptions, FilletRoundsInnerCornersWithItsRadius) {
    const auto sharp = cut();
    EXPECT_TRUE(arc_radii(sharp, Turn::Right).empty());
    for (const double radius : {0.5, 1.0}) {
        const auto round = cut("--fillet " + std::to_string(radius) + "mm");
        const auto radii = arc_radii(round, Turn::Right);
        ASSERT_FALSE(radii.empty());
        EXPECT_NEAR(std::ranges::max(radii), radius, kRadius);
        EXPECT_GT(area(round), area(sharp));
        EXPECT_EQ(round.size(), sharp.size());
    }
}

TEST_F(MakingOptions, BoltsAreHolesAtTheSupportsInEyesOfTwiceTheirDiameter) {
    const auto drilled = cut("--case held --bolts 3mm");
    EXPECT_EQ(drilled.size(), cut().size() + 2);
    EXPECT_THAT(arc_radii(drilled, Turn::Left), Contains(DoubleNear(3.0, kRadius)));
    EXPECT_THAT(arc_radii(cut("--case held --bolts 3mm --eye 8mm"), Turn::Left),
                Contains(DoubleNear(4.0, kRadius)));
    const auto middles = holes(drilled, 3.0);
    ASSERT_EQ(middles.size(), 2U);
    const json project = json::parse(base::read_text_file(folder_.path() / "p.json"));
    for (const double x : {0.0, 180.0}) {
        const auto from_support = [x](double nx, double ny) { return std::hypot(nx - x, ny - 130.0); };
        double nearest_node = 1e9;
        for (const json& node : project.at("tessellation").at("interface_nodes"))
            nearest_node = std::min(
                nearest_node, from_support(1e3 * node.at(0).get<double>(), 1e3 * node.at(1).get<double>()));
        const double nearest_hole =
            std::min(from_support(middles[0].x, middles[0].y), from_support(middles[1].x, middles[1].y));
        EXPECT_NEAR(nearest_hole, nearest_node, 1e-3);
    }
}

TEST_F(MakingOptions, BedCutsIntoPartsThatLieOnSheetsOfItsSize) {
    const std::string text = exported("cut.dxf", "--bed 200x150");
    std::vector<Box> sheets;
    for (const Contour& guide : polylines(text, "guides")) {
        const Box box = box_of(guide);
        if (std::abs(box.width() - 200) < kRounding && std::abs(box.height() - 150) < kRounding)
            sheets.push_back(box);
    }
    ASSERT_GE(sheets.size(), 2U);
    EXPECT_THAT(text, HasSubstr("Sheet " + std::to_string(sheets.size())));
    EXPECT_THAT(text, Not(HasSubstr("Sheet " + std::to_string(sheets.size() + 1))));
    for (const Contour& contour : polylines(text, "cut")) {
        const Box box = box_of(contour);
        EXPECT_TRUE(std::ranges::any_of(sheets,
                                        [&](const Box& sheet) {
                                            return box.xmin > sheet.xmin && box.xmax < sheet.xmax &&
                                                   box.ymin > sheet.ymin && box.ymax < sheet.ymax;
                                        }))
            << box.xmin << " " << box.ymin;
    }
    EXPECT_EQ(exported("cut.dxf", "--bed 20cmx0.15m"), text);
}

TEST_F(MakingOptions, ABedThatHoldsAllLeavesOneSheetWithoutJoints) {
    const std::string text = exported("cut.dxf", "--bed 300x300");
    EXPECT_THAT(text, Not(HasSubstr("Sheet 2")));
    EXPECT_TRUE(polylines(text, "engrave").empty());
    EXPECT_NEAR(area(polylines(text, "cut")), area(cut()), 1e-3);
}

TEST_F(MakingOptions, FitIsTakenFromTheJointsOfParts) {
    const std::string usual = exported("cut.dxf", "--bed 200x150");
    EXPECT_EQ(exported("cut.dxf", "--bed 200x150 --fit 0.05mm"), usual);
    const auto loose = cut("--bed 200x150 --fit 0.2mm");
    EXPECT_EQ(loose.size(), polylines(usual, "cut").size());
    EXPECT_LT(area(loose), area(polylines(usual, "cut")));
}

TEST_F(MakingOptions, ContentChoosesWhereAnEndingHasSeveral) {
    EXPECT_THAT(exported("drawing.svg"), Not(HasSubstr("id=\"cut\"")));
    EXPECT_THAT(exported("cut.svg", "--content cut"), HasSubstr("id=\"cut\""));
    EXPECT_THAT(exported("lines.obj"), Not(HasSubstr("\nf ")));
    EXPECT_THAT(exported("solid.obj", "--content solid"), HasSubstr("\nf "));
    EXPECT_THAT(exported("lines.ply"), HasSubstr("element edge"));
    EXPECT_THAT(exported("solid.ply", "--content solid"), HasSubstr("element face"));
    EXPECT_THAT(exported("facts.txt", "--content facts"), HasSubstr("length of cut"));
    EXPECT_NE(exported("solid.3mf"), exported("lattice.3mf", "--content centrelines"));
}

TEST_F(MakingOptions, TheReportNamesEveryFileWithContentUnitAndSize) {
    const json report =
        json::parse(succeed("fretwork export p.json --to a.dxf --to b.stl --to c.vtu --kerf 0.2mm --json"));
    const auto& files = report.at("files");
    ASSERT_EQ(files.size(), 3U);
    const std::array<std::array<const char*, 3>, 3> expected = {{{"a.dxf", "cut", "millimetre"},
                                                                 {"b.stl", "solid", "millimetre"},
                                                                 {"c.vtu", "centrelines", "metre"}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(files[i].at("path"), expected[i][0]);
        EXPECT_EQ(files[i].at("content"), expected[i][1]);
        EXPECT_EQ(files[i].at("unit"), expected[i][2]);
        EXPECT_EQ(files[i].at("bytes"), std::filesystem::file_size(folder_.path() / expected[i][0]));
    }
}

TEST_F(MakingOptions, WhatDoesNotFitIsTold) {
    const std::string command = "fretwork export p.json --json --to a.dxf --to b.stl --to c.vtu ";
    const json made = json::parse(succeed(command + "--kerf 0.2mm"));
    for (const json& file : made.at("files")) EXPECT_THAT(file.at("remarks"), testing::IsEmpty());
    const auto outcome = run_command(command + "--kerf 5cm --fillet 9mm", folder_.path());
    EXPECT_EQ(outcome.exit_code, 0);
    const json files = json::parse(outcome.out).at("files");
    const json& remarks = files[0].at("remarks");
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_EQ(files[1].at("remarks"), json({remarks[1]})) << "a solid has no kerf";
    EXPECT_THAT(files[2].at("remarks"), testing::IsEmpty()) << "centrelines";
    EXPECT_THAT(remarks[0].get<std::string>(), HasSubstr("the kerf of 50 mm closes "));
    EXPECT_THAT(remarks[1].get<std::string>(), HasSubstr("the fillet of 9 mm does not fit in "));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 2) << "each once: " << outcome.err;
}

TEST_F(MakingOptions, OpeningsThatTheKerfClosesBesideConnectorsAreCounted) {
    succeed(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 30mm --patterns 1-2+1-4+4-6 --out "
        "q.json");
    const auto remarks = [&](const std::string& options) {
        const json report =
            json::parse(succeed("fretwork export q.json --json --to a.dxf --to facts.txt " + options));
        return report.at("files")[0].at("remarks");
    };
    EXPECT_THAT(remarks("--kerf 0.3mm"), testing::IsEmpty()) << "in one piece";
    const std::string told = "closes 3 of 50 openings: they are not cut";
    for (const std::string kerf : {"0.3", "1"}) {
        const json parts = remarks("--bed 200x150 --kerf " + kerf + "mm");
        ASSERT_EQ(parts.size(), 1U);
        EXPECT_EQ(parts[0], "the kerf of " + kerf + " mm " + told);
        EXPECT_THAT(base::read_text_file(folder_.path() / "facts.txt"), HasSubstr(told));
    }
}

TEST_F(MakingOptions, ASolidBesideACutHasNoKerf) {
    const std::string plain = exported("plain.stl");
    succeed("fretwork export p.json --to a.dxf --to a.stl --kerf 0.3mm");
    EXPECT_EQ(base::read_text_file(folder_.path() / "a.stl"), plain);
}

TEST_F(MakingOptions, SolidIsTheCutExtruded) {
    for (const std::string options : {"", "--frame 5mm --fillet 1mm", "--case held --bolts 3mm"}) {
        const Measured solid = measured_obj(exported("solid.obj", "--content solid " + options));
        const auto outline = cut(options);
        const double chords = 0.02;  // mm, that chords are off arcs
        EXPECT_NEAR(solid.most[2] - solid.least[2], kBarHeight, kRounding);
        EXPECT_NEAR(solid.most[0] - solid.least[0], extents(outline).width(), 2 * chords);
        EXPECT_NEAR(solid.most[1] - solid.least[1], extents(outline).height(), 2 * chords);
        EXPECT_NEAR(solid.volume, kBarHeight * area(outline), 2e-3 * solid.volume) << options;
    }
}

TEST_F(MakingOptions, FactsFollowTheOptionsThatTheyAreFor) {
    const json usual = facts();
    EXPECT_NEAR(usual.at("area").get<double>(), 1e-6 * area(cut()), 1e-9);
    EXPECT_EQ(usual.at("layers"), 10);
    EXPECT_EQ(facts("--layer 0.1mm").at("layers"), 20);
    EXPECT_EQ(usual.at("smallest_inner_radius"), 0.0);
    EXPECT_GT(facts("--fillet 0.5mm").at("smallest_inner_radius"), 0.0);
    EXPECT_GT(facts("--clearance 3cm").at("warnings").size(), usual.at("warnings").size());
    EXPECT_GT(facts("--frame 4mm").at("mass"), usual.at("mass"));
    EXPECT_FALSE(usual.contains("sag"));
    const json held = facts("--case held --strength 40MPa");
    EXPECT_EQ(held.at("strength"), 4e7);
    EXPECT_NEAR(held.at("sag").at("weight").get<double>(), 9.80665 * held.at("mass").get<double>(), 1e-7);
}

TEST_F(MakingOptions, AnExportSaysWhatItWrote) {
    EXPECT_THAT(succeed("fretwork export p.json --to cut.dxf --to facts.txt --to page.html"),
                testing::MatchesRegex("cut.dxf: cut, lengths in millimetres, [0-9.]+ kB\n"
                                      "facts.txt: facts, [0-9.]+ (bytes|kB)\n"
                                      "page.html: drawing, [0-9.]+ (kB|MB)\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
