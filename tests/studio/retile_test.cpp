// SPDX-License-Identifier: GPL-3.0-or-later
// Other tiles for the outline of the document that is open.
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/retiling.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using simulation::Project;
using test::Client;
using test::RunningStudio;
using testing::HasSubstr;
using tiling::TileIndex;

constexpr const char* kPalette = "0-1+1-6,2-4+4-6,0-5+5-6";

/// A plate of 0.4 x 0.3 m that is held at its left side and at two nodes, and loaded at its right.
Project plate(double side = 0.04) {
    const outlines::Outline outline = outlines::make_outline({{0, 0}, {0.4, 0}, {0.4, 0.3}, {0, 0.3}}, {});
    Project project =
        simulation::make_project(
            outline, {.edge_length = side, .painting = simulation::PaintOnePattern{"0-1+1-6"}}, nullptr)
            .project;
    project.load_cases.push_back(test::cantilever({0.0, 0.0, -0.01}));
    project.load_cases.front().supports.push_back(
        {simulation::NodesById{{0, 1}}, mechanics::DofSet::translations()});
    return project;
}

Project shown(Client& client) {
    return simulation::parse_project(client.ask("download")["text"].get<std::string>(), "download");
}
std::string id_of(const Project& project, TileIndex tile) {
    const auto* pattern = tiling::pattern_of(project.tessellation, tile);
    return pattern ? pattern->id : "";
}
double middle_of(const Project& project, TileIndex tile) {
    return geometry::centroid(tiling::tile_polygon(project.tessellation, tile)).x;
}

TEST(StudioRetiling, APreviewSaysWhatComesAndChangesNothing) {
    const RunningStudio studio(plate());
    Client client(studio.address());
    client.hello();
    const std::string before = simulation::project_text(shown(client));
    const Json preview = client.ask("retile", {{"tile_size", 0.03}, {"preview", true}});
    ASSERT_TRUE(preview["ok"].get<bool>()) << preview;
    EXPECT_GT(preview["tiles"].get<std::size_t>(), plate().tessellation.tiles.size());
    EXPECT_NEAR(preview["side"]["mean"].get<double>(), 0.03, 0.001);
    EXPECT_GE(preview["side"]["largest"].get<double>(), preview["side"]["mean"].get<double>());
    EXPECT_EQ(preview["dropped"], (Json{{"supports", 1}, {"loads", 0}, {"prescribed", 0}}));
    EXPECT_EQ(preview["polygons"].size(), preview["tiles"].get<std::size_t>());
    EXPECT_EQ(simulation::project_text(shown(client)), before);
}

TEST(StudioRetiling, IsOneStepThatPagesAreShownAndThatIsUndone) {
    const RunningStudio studio(plate());
    Client client(studio.address());
    client.hello();
    (void)client.event({"document"});
    const std::string before = simulation::project_text(shown(client));
    const Json answer = client.ask("retile", {{"tile_size", 0.03}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_FALSE(answer.contains("polygons")) << "they come with the event";
    const Json changed = client.event({"changed"});
    const std::size_t tiles = answer["tiles"];
    for (const char* key : {"tiles", "painting", "turns", "tile_models"})
        EXPECT_EQ(changed[key].size(), tiles) << key;
    EXPECT_EQ(changed["interface_nodes"].size(), answer["interface_nodes"].get<std::size_t>());
    EXPECT_EQ(changed["history"]["undo"], "tiles of 30 mm");
    const Json& load_case = changed["load_cases"][0];
    EXPECT_EQ(load_case["supports"],
              (Json{{{"side", "left"}, {"fixed", {"ux", "uy", "uz", "rx", "ry", "rz"}}}}));
    EXPECT_GT(load_case["marks"]["supports"][0].size(), 3U);
    Json solved = client.event({"solved"});
    while (solved["revision"] < changed["revision"] || solved.value("provisional", false))
        solved = client.event({"solved"});
    EXPECT_TRUE(solved["converged"].get<bool>()) << "it bends on its new tiles";
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(client.event({"changed"})["tiles"].size(), plate().tessellation.tiles.size());
    EXPECT_EQ(simulation::project_text(shown(client)), before);
    ASSERT_TRUE(client.ask("redo")["ok"].get<bool>());
    EXPECT_EQ(shown(client).tessellation.tiles.size(), tiles);
}

TEST(StudioRetiling, HandPaintedTilesStayByPlace) {
    const RunningStudio studio(plate());
    Client client(studio.address());
    client.hello();
    Json left = Json::array();
    const Project before = plate();
    for (const TileIndex tile : before.tessellation.tiles.indices())
        if (middle_of(before, tile) < 0.2) left.push_back(tile.value);
    ASSERT_TRUE(client.ask("paint", {{"tiles", left}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("retile", {{"tile_size", 0.02}})["ok"].get<bool>());
    const Project after = shown(client);
    for (const TileIndex tile : after.tessellation.tiles.indices()) {
        const double x = middle_of(after, tile);
        if (std::abs(x - 0.2) < 0.04) continue;
        EXPECT_EQ(id_of(after, tile), x < 0.2 ? "0-5+5-6" : "0-1+1-6");
    }
}

/// A field that is painted again has as many steps as there are tiles to show them; by place it has those of
/// the old tiles.
TEST(StudioRetiling, AFieldIsPaintedAgainWhereItWasPainted) {
    const RunningStudio studio(plate());
    Client client(studio.address());
    client.hello();
    const Json field = {{"patterns", "field:u"}, {"palette", kPalette}};
    ASSERT_TRUE(client.ask("paint", field)["ok"].get<bool>());
    const Json answer = client.ask("retile", {{"tile_size", 0.02}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_EQ(answer["painted_again"], (Json{{"field", answer["tiles"]}}));
    const Project after = shown(client);
    // The same words on the new tiles give the same painting.
    EXPECT_TRUE(client.ask("paint", field).value("unchanged", false));
    // A tile that was painted by hand since then stays so.
    ASSERT_TRUE(client.ask("paint", {{"tiles", {0}}, {"pattern", "0-6"}})["ok"].get<bool>());
    const Json finer = client.ask("retile", {{"tile_size", 0.015}, {"preview", true}});
    EXPECT_LT(finer["painted_again"]["field"].get<int>(), finer["tiles"].get<int>());
    EXPECT_EQ(id_of(after, TileIndex(0)), "0-1+1-6");
}

/// What is saved and opened again is the text that is downloaded.
TEST(StudioRetiling, AFieldOfAFileThatIsOpenedIsPaintedAgain) {
    std::string saved;
    {
        const RunningStudio studio(plate());
        Client client(studio.address());
        client.hello();
        ASSERT_TRUE(client.ask("paint", {{"patterns", "field:u"}, {"palette", kPalette}})["ok"].get<bool>());
        ASSERT_TRUE(client.ask("paint", {{"tiles", {0}}, {"pattern", "0-6"}})["ok"].get<bool>());
        saved = client.ask("download")["text"].get<std::string>();
    }
    const Project opened = simulation::parse_project(saved, "saved");
    ASSERT_EQ(opened.recipes.size(), 1U);
    EXPECT_EQ(opened.recipes[0].tiles.size() + 1, opened.tessellation.tiles.size());
    const RunningStudio studio(opened);
    Client client(studio.address());
    client.hello();
    EXPECT_EQ(simulation::project_text(shown(client)), saved) << "to open changes nothing";
    const Json answer = client.ask("retile", {{"tile_size", 0.02}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_GT(answer["painted_again"]["field"].get<int>(), 0);
    const Project after = shown(client);
    const Project expected = simulation::retile(opened, {.edge_length = 0.02}, nullptr).project;
    for (const TileIndex tile : after.tessellation.tiles.indices())
        EXPECT_EQ(id_of(after, tile), id_of(expected, tile)) << tile.value;
    EXPECT_EQ(after.recipes, expected.recipes);
}

TEST(StudioRetiling, OnePatternForAllAndAnotherLayout) {
    const RunningStudio studio(plate());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("retile", {{"tile_size", 0.03}, {"patterns", "0-5+5-6"}, {"angle", 0.2}})["ok"]);
    for (const Project project = shown(client); const TileIndex tile : project.tessellation.tiles.indices())
        EXPECT_EQ(id_of(project, tile), "0-5+5-6");
    EXPECT_TRUE(shown(client).recipes.empty());
    const Json other =
        client.ask("retile", {{"tile_size", 0.05}, {"layout", "paper8"}, {"patterns", "made:one"}});
    ASSERT_TRUE(other["ok"].get<bool>()) << other;
    const Project project = shown(client);
    EXPECT_EQ(project.layout.name(), "paper8");
    EXPECT_EQ(other["unpainted"].get<int>(), other["remarks"].empty() ? 0 : other["tiles"].get<int>());
    std::set<std::string> patterns;
    for (const TileIndex tile : project.tessellation.tiles.indices()) patterns.insert(id_of(project, tile));
    EXPECT_EQ(patterns.size(), 1U);
}

TEST(StudioRetiling, WhatCannotBeDoneIsRefusedAndChangesNothing) {
    Project project = plate();
    const auto& node = project.tessellation.interface_nodes[30];
    project.load_cases.front().supports.push_back(
        {simulation::NodesInBox{{node.x - 1e-6, node.y - 1e-6, node.x + 1e-6, node.y + 1e-6}},
         mechanics::DofSet::all()});
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    const std::string before = simulation::project_text(shown(client));
    const std::vector<std::pair<Json, std::string>> wrong = {
        {{{"tile_size", 0}}, "side of the tiles"},
        {Json::object(), "tile_size"},
        {{{"tile_size", "big"}}, "side of the tiles"},
        {{{"tile_size", 0.03}, {"patterns", "nonsense"}}, "nonsense"},
        {{{"tile_size", 0.03}, {"layout", "paper8"}}, "choose one pattern"},
        {{{"tile_size", 0.03}, {"layout", "paper99"}}, "paper99"},
        {{{"tile_size", 0.03}, {"angle", "steep"}}, "angle"},
        {{{"tile_size", 0.03}, {"merge", "a"}}, "merge"},
        {{{"tile_size", 0.00001}}, "tiles"},
        {{{"tile_size", 0.029}}, "support"}};
    for (const auto& [request, word] : wrong) {
        const Json answer = client.ask("retile", request);
        ASSERT_FALSE(answer["ok"].get<bool>()) << request;
        EXPECT_THAT(answer["error"].get<std::string>(), HasSubstr(word)) << request;
    }
    EXPECT_EQ(simulation::project_text(shown(client)), before);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
