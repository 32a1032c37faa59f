// SPDX-License-Identifier: GPL-3.0-or-later
// The studio designs as `fretwork design` does; the painting is one step of undo, and a stop keeps the best.
#include "running_studio.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using simulation::Project;
using test::Client;
using test::RunningStudio;
using testing::HasSubstr;

constexpr const char* kPalette = "0-1+1-6,0-6,0-1+1-5+1-6+5-6,2-4+4-6";
constexpr int kEnoughSolutions = 40;

Json goal(double lift) {
    return {{"goals", {{{"select", {{"side", "right"}}}, {"displacement", {nullptr, nullptr, lift}}}}}};
}

/// Under this load single patterns move the right side by less and by more than the target asks for.
Project project_to_design() {
    Project project = test::studio_project(4, 3);
    project.load_cases.front().gravity = {0.0, 0.0, 0.0};
    return project;
}
constexpr double kLift = -0.012;

Json wish(double lift = kLift) {
    return {{"target", goal(lift)}, {"palette", kPalette}, {"solutions", kEnoughSolutions}};
}

std::vector<std::string> ids_by_tile(const Project& project) {
    std::vector<std::string> ids;
    for (const tiling::Tile& tile : project.tessellation.tiles)
        ids.push_back(project.tessellation.patterns[static_cast<std::size_t>(tile.pattern)].id);
    return ids;
}

Project in_studio(Client& client) {
    return simulation::parse_project(client.ask("download")["text"].get<std::string>(), "download");
}

struct OfTheProgram {
    Project project;
    std::string words;
};
OfTheProgram designed_by_the_program(const Project& project) {
    const test::TemporaryFolder folder;
    simulation::write_project(project, folder.path() / "p.json");
    Json target = goal(kLift);
    target["format"] = "fretwork/target/1";
    folder.file("t.json", target.dump());
    const std::string command = "cd " + folder.path().string() +
                                " && '" FRETWORK_PROGRAM "' design p.json --target t.json --palette " +
                                kPalette + " --solutions " + std::to_string(kEnoughSolutions) +
                                " --out d.json >out.txt 2>&1";
    (void)std::system(command.c_str());  // 1: no better than the best single pattern
    return {simulation::read_project(folder.path() / "d.json"),
            base::read_text_file(folder.path() / "out.txt")};
}

/// The end of a design: the last `designed`, or `failed`.
Json end_of_design(Client& client) {
    while (true) {
        Json event = client.event({"designed", "failed"});
        if (event["event"] == "failed" ? event["model"] == "design" : !event["sketch"].get<bool>())
            return event;
    }
}

TEST(StudioDesign, PaintsAsTheProgramDoesInItsWordsAndIsOneStepOfUndo) {
    const Project project = project_to_design();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    const std::string before = simulation::project_text(in_studio(client));
    ASSERT_TRUE(client.ask("design", wish())["ok"].get<bool>());
    const Json end = end_of_design(client);
    ASSERT_EQ(end["event"], "designed") << end;
    const OfTheProgram expected = designed_by_the_program(project);
    EXPECT_EQ(ids_by_tile(in_studio(client)), ids_by_tile(expected.project)) << expected.words;
    EXPECT_THAT(expected.words, HasSubstr(end["words"].get<std::string>()));
    EXPECT_THAT(expected.words, HasSubstr(end["best_uniform_pattern"].get<std::string>()));
    EXPECT_NEAR(end["share_closed"].get<double>(),
                1.0 - end["error_mean"].get<double>() / end["error_best_uniform"].get<double>(), 1e-12);
    EXPECT_GT(end["share_closed"].get<double>(), 0.0);
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(simulation::project_text(in_studio(client)), before);
    EXPECT_FALSE(client.ask("undo")["ok"].get<bool>());
}

TEST(StudioDesign, ShowsASketchAndEachBetterPaintingBeforeItEnds) {
    const RunningStudio studio(project_to_design());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("design", wish())["ok"].get<bool>());
    const Json first = client.event({"designing", "designed"});
    ASSERT_EQ(first["event"], "designing");
    EXPECT_GT(first["most"].get<int>(), 0);
    EXPECT_LT(first["most"].get<int>(), kEnoughSolutions) << "a sketch";
    EXPECT_GT(first["misfit"].get<double>(), 0.0);
    EXPECT_TRUE(client.event({"designed"})["sketch"].get<bool>());
    EXPECT_EQ(client.event({"designing"})["most"], kEnoughSolutions);
    EXPECT_FALSE(end_of_design(client)["sketch"].get<bool>());
}

TEST(StudioDesign, KeepsTheTilesThatMayNotChange) {
    const Project project = project_to_design();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    Json request = wish();
    request["tiles"] = {0, 1, 2};
    ASSERT_TRUE(client.ask("design", request)["ok"].get<bool>());
    ASSERT_EQ(end_of_design(client)["event"], "designed");
    const auto before = ids_by_tile(project);
    const auto after = ids_by_tile(in_studio(client));
    for (std::size_t tile = 3; tile < before.size(); ++tile) EXPECT_EQ(after[tile], before[tile]) << tile;
    EXPECT_NE(after, before);
}

TEST(StudioDesign, AStopKeepsTheBestSoFarAndSaysSo) {
    const RunningStudio studio(project_to_design());
    Client client(studio.address());
    client.hello();
    Json request = wish();
    request["palette"] = "sample:300";
    request["solutions"] = 5000;
    ASSERT_TRUE(client.ask("design", request)["ok"].get<bool>());
    EXPECT_THAT(client.ask("design", request)["error"].get<std::string>(), HasSubstr("already"));
    const Json sketch = client.event({"designed"});
    ASSERT_TRUE(sketch["sketch"].get<bool>());
    ASSERT_TRUE(client.ask("stop_design")["ok"].get<bool>());
    const Json end = end_of_design(client);
    EXPECT_EQ(end["end"], "stopped");
    EXPECT_THAT(end["words"].get<std::string>(), HasSubstr("the best painting so far"));
    EXPECT_LE(end["error_mean"].get<double>(), sketch["error_mean"].get<double>());
    EXPECT_TRUE(client.ask("design", wish())["ok"].get<bool>()) << "the next one may begin";
}

TEST(StudioDesign, IsGivenUpWhenSomebodyElsePaints) {
    const RunningStudio studio(project_to_design());
    Client client(studio.address());
    client.hello();
    Json request = wish();
    request["solutions"] = 5000;
    request["palette"] = "sample:300";
    ASSERT_TRUE(client.ask("design", request)["ok"].get<bool>());
    ASSERT_TRUE(client.event({"designed"})["sketch"].get<bool>());
    const Json painted = client.ask("paint", {{"tiles", {0, 1}}, {"pattern", "0-1+1-5+1-6+5-6"}});
    ASSERT_TRUE(painted["ok"].get<bool>()) << painted;
    const Json end = end_of_design(client);
    ASSERT_EQ(end["event"], "failed");
    EXPECT_THAT(end["error"].get<std::string>(), HasSubstr("changed"));
    EXPECT_EQ(ids_by_tile(in_studio(client)).front(), "0-1+1-5+1-6+5-6");
}

TEST(StudioDesign, WhatCannotBeDesignedIsToldInOneLine) {
    const RunningStudio studio(project_to_design());
    Client client(studio.address());
    client.hello();
    const auto with = [](const char* key, const Json& value) {
        Json request = wish();
        request[key] = value;
        return request;
    };
    const std::vector<std::pair<Json, std::string>> refused = {
        {with("target", {{"goals", {{{"nodes", {1}}, {"displacement", {0, 0, 0}}}}}}), "target point 1"},
        {with("target", 7), "target"},
        {with("tiles", Json::array()), "at least one tile"},
        {with("tiles", {99}), "tile"},
        {with("max_patterns", 0), "max_patterns"},
        {with("free", {"weight"}), "factor"},
        {with("seconds", -1), "seconds"},
        {with("colour", "red"), "colour"}};
    for (const auto& [request, word] : refused) {
        const Json answer = client.ask("design", request);
        ASSERT_FALSE(answer["ok"].get<bool>()) << request;
        EXPECT_THAT(answer["error"].get<std::string>(),
                    testing::AllOf(HasSubstr(word), testing::Not(HasSubstr("\n"))))
            << request;
    }
    const std::vector<std::pair<Json, std::string>> failing = {
        {with("palette", "sample:0"), "palette: 'sample:0'"},
        {with("target", {{"goals", {{{"nodes", {9999}}, {"displacements", {{0, 0, 0.01}}}}}}}),
         "target point 1: there is no interface node 9999"}};
    for (const auto& [request, word] : failing) {
        ASSERT_TRUE(client.ask("design", request)["ok"].get<bool>()) << request;
        const Json end = end_of_design(client);
        EXPECT_EQ(end["event"], "failed");
        EXPECT_THAT(end["error"].get<std::string>(), HasSubstr(word));
    }
}

TEST(StudioErrors, TheErrorOfASurfaceThatIsBentFarIsEstimated) {
    Project project = project_to_design();
    project.load_cases.front() = test::cantilever({0.0, 0.0, -0.3});
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    Json live = client.event({"solved"});
    while (live["stable"].is_null()) live = client.event({"solved"});
    ASSERT_TRUE(live["doubtful"].get<bool>());
    const Json error = client.event({"model_error"});
    EXPECT_EQ(error["model"], live["model"]);
    EXPECT_GT(error["largest"].get<double>(), error["mean"].get<double>());
    EXPECT_LT(error["largest"].get<double>(), 0.2);
    EXPECT_GT(error["mean"].get<double>(), 0.0);
}

TEST(StudioErrors, AnErrorIsToldAgainWhenItsLoadCaseIsShownAgain) {
    Project project = project_to_design();
    project.load_cases.front() = test::cantilever({0.0, 0.0, -0.3});
    project.load_cases.push_back(project.load_cases.front());
    project.load_cases.back().name = "not held";
    project.load_cases.back().supports.clear();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    const Json error = client.event({"model_error"});
    ASSERT_TRUE(client.ask("select_load_case", {{"index", 1}})["ok"].get<bool>());
    (void)client.event({"failed"});
    ASSERT_TRUE(client.ask("select_load_case", {{"index", 0}})["ok"].get<bool>());
    EXPECT_EQ(client.event({"model_error"})["largest"], error["largest"]);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
