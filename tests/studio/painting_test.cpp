// SPDX-License-Identifier: GPL-3.0-or-later
// The studio paints as `fretwork paint` does.
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>

#include <gmock/gmock.h>

#include <cstdlib>
#include <set>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using simulation::Project;
using test::Client;
using test::RunningStudio;
using testing::HasSubstr;

constexpr const char* kPalette = "0-1+1-6,2-4+4-6,0-5+5-6";
/// 16 pixels of grey in a row, from white to black.
constexpr const char* kRamp =
    "iVBORw0KGgoAAAANSUhEUgAAABAAAAABCAAAAADyEnGDAAAAGklEQVR4nGP4/"
    "+7umd2rZnaUp4W6GCsJMgAAWmEH+SROr2sAAAAASUVORK5CYII=";
/// The left 90 mm, red.
constexpr const char* kLeft =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="900mm" viewBox="0 0 90 900">
       <rect width="90" height="900" fill="red"/></svg>)";

std::vector<std::string> patterns_of(const Project& project) {
    std::vector<std::string> ids;
    for (const tiling::Tile& tile : project.tessellation.tiles)
        ids.push_back(
            tile.pattern < 0 ? "" : project.tessellation.patterns[static_cast<std::size_t>(tile.pattern)].id);
    return ids;
}

Project shown(Client& client) {
    return simulation::parse_project(client.ask("download")["text"].get<std::string>(), "download");
}

/// The project as the program paints it.
Project painted_by_the_program(const Project& project, const std::string& options) {
    const test::TemporaryFolder folder;
    simulation::write_project(project, folder.path() / "p.json");
    folder.file("ramp.png", base::decode_base64(kRamp, "ramp"));
    folder.file("left.svg", kLeft);
    const std::string command = "cd " + folder.path().string() + " && '" FRETWORK_PROGRAM "' paint p.json " +
                                options + " >out.txt 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << base::read_text_file(folder.path() / "out.txt");
    return simulation::read_project(folder.path() / "p.json");
}

struct Case {
    Json request;
    std::string options;  ///< that say the same to the program
};
Json sent(const std::string& name, const std::string& text_base64) {
    return {{"name", name}, {"text_base64", text_base64}};
}
std::vector<Case> cases() {
    const std::string weighted = "0-1+1-6=3,2-4+4-6,0-5+5-6=0.5";
    return {
        {{{"patterns", "random:7"}, {"palette", kPalette}},
         std::string("--patterns random:7 --palette ") + kPalette},
        {{{"patterns", "random:8"}, {"palette", weighted}, {"tiles", {11, 3, 3, 4, 0}}},
         "--patterns random:8 --tiles 0,3,4,11 --palette " + weighted},
        {{{"patterns", "field:(x-0.02)*20+(y-0.01)*4"}, {"palette", kPalette}},
         std::string("--patterns 'field:(x-0.02)*20+(y-0.01)*4' --palette ") + kPalette},
        {{{"patterns", "field:u"},
          {"palette", kPalette},
          {"property", "mass_per_area"},
          {"range", "0.1,0.4"},
          {"dither", true}},
         std::string("--patterns field:u --property mass_per_area --range 0.1,0.4 --dither --palette ") +
             kPalette},
        {{{"patterns", "image:"}, {"palette", kPalette}, {"file", sent("ramp.png", kRamp)}},
         std::string("--patterns image:ramp.png --palette ") + kPalette},
        {{{"patterns", "colours:"},
          {"palette", "red=0-5+5-6"},
          {"file", sent("left.svg", base::encode_base64(kLeft))}},
         "--patterns colours:left.svg --palette red=0-5+5-6"},
        {{{"patterns", "0-5+5-6"}, {"tiles", {2}}}, "--patterns 0-5+5-6 --tiles 2"},
    };
}

TEST(StudioPainting, IsThatOfTheProgramForTheSameWords) {
    const Project project = test::studio_project(5, 4);
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    Project expected = project;
    for (const Case& one : cases()) {
        const Json answer = client.ask("paint", one.request);
        ASSERT_TRUE(answer["ok"].get<bool>()) << one.options << answer;
        EXPECT_FALSE(answer.contains("unchanged")) << one.options;
        expected = painted_by_the_program(expected, one.options);
        EXPECT_EQ(patterns_of(shown(client)), patterns_of(expected)) << one.options;
    }
}

TEST(StudioPainting, ADrawingTooLargeToBeKeptIsRemarked) {
    const RunningStudio studio(test::studio_project(5, 4));
    Client client(studio.address());
    client.hello();
    const auto painted_by = [&](const std::string& name, const std::string& drawing) {
        const Json file = sent(name, base::encode_base64(drawing));
        return client.ask("paint", {{"patterns", "colours:"}, {"palette", "red=0-5+5-6"}, {"file", file}});
    };
    EXPECT_FALSE(painted_by("small.svg", kLeft).contains("remarks"));
    const std::string large = kLeft + std::string(simulation::kLargestKeptFile, ' ');
    const Json answer = painted_by("large.svg", large);
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    ASSERT_EQ(answer["remarks"].size(), 1U) << answer;
    EXPECT_THAT(answer["remarks"][0].get<std::string>(), HasSubstr("does not keep large.svg"));
    EXPECT_EQ(painted_by("large.svg", large)["remarks"], answer["remarks"]) << "also if nothing changes";
    const test::TemporaryFolder folder;
    folder.file("large.svg", large);
    const Json made = client.ask("new", {{"outline", sent("left.svg", base::encode_base64(kLeft))},
                                         {"tile_size", 0.04},
                                         {"patterns", "colours:" + (folder.path() / "large.svg").string()},
                                         {"palette", "red=0-5+5-6"},
                                         {"discard", true}});
    ASSERT_TRUE(made["ok"].get<bool>()) << made;
    EXPECT_THAT(made["remarks"].dump(), HasSubstr("does not keep"));
}

TEST(StudioPainting, AFieldAlongALineGoesFromTheFirstPatternToTheLastAndNoFurther) {
    const RunningStudio studio(test::studio_project(9, 1));
    Client client(studio.address());
    client.hello();
    // The row is 0.4 m wide; the line lies in its middle.
    ASSERT_TRUE(client.ask("paint", {{"patterns", "field:(x-0.15)*10"}, {"palette", kPalette}})["ok"]);
    const auto row = patterns_of(shown(client));
    EXPECT_EQ(row.front(), "0-1+1-6");
    EXPECT_EQ(row.back(), "0-5+5-6");
    EXPECT_EQ(std::set(row.begin(), row.end()).size(), 3U);
}

TEST(StudioPainting, ByChanceIsOneStepThatKeepsAllElse) {
    const Project project = test::studio_project();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    (void)client.event({"document"});
    const std::string before = simulation::project_text(shown(client));
    const Json request = {{"patterns", "random:1"}, {"palette", kPalette}, {"tiles", {0, 1, 2, 3, 4}}};
    ASSERT_TRUE(client.ask("paint", request)["ok"].get<bool>());
    const Json changed = client.event({"changed"});
    EXPECT_EQ(changed["history"]["undo"], "paint 5 tiles");
    EXPECT_EQ(changed["palette"][2], project.tessellation.patterns[2].id) << "what was in the palette stays";
    const Project after = shown(client);
    EXPECT_NE(patterns_of(after), patterns_of(project));
    EXPECT_EQ(after.load_cases.size(), project.load_cases.size());
    EXPECT_TRUE(client.ask("paint", request)["unchanged"].get<bool>()) << "the same seed";
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(simulation::project_text(shown(client)), before);
}

TEST(StudioPainting, WhatCannotBePaintedIsToldInTheWordsOfTheRequest) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const auto before = patterns_of(shown(client));
    const std::vector<std::pair<Json, std::string>> wrong = {
        {{{"patterns", "random:x"}, {"palette", kPalette}}, "is not a seed"},
        {{{"patterns", "random:1"}}, "palette"},
        {{{"patterns", "random:1"}, {"palette", "0-1+1-6=0"}}, "weight"},
        {{{"patterns", "random:1"}, {"palette", kPalette}, {"dither", true}}, "dither"},
        {{{"patterns", "random:1"}, {"palette", kPalette}, {"tiles", Json::array()}}, "at least one tile"},
        {{{"patterns", "random:1"}, {"palette", kPalette}, {"pattern", "0-6"}}, "pattern"},
        {{{"patterns", "field:z"}, {"palette", kPalette}}, "variables x, y"},
        {{{"patterns", "field:u"}, {"palette", kPalette}, {"property", "colour"}}, "property"},
        {{{"patterns", "image:"}, {"palette", kPalette}, {"file", sent("cat.png", "Zm9v")}}, "cat.png"},
        {{{"patterns", "field:u"}, {"palette", kPalette}, {"file", sent("cat.png", kRamp)}}, "image:"},
        {{{"patterns", 7}}, "text"}};
    for (const auto& [request, word] : wrong) {
        const Json answer = client.ask("paint", request);
        ASSERT_FALSE(answer["ok"].get<bool>()) << request;
        EXPECT_THAT(answer["error"].get<std::string>(),
                    testing::AllOf(HasSubstr(word), testing::Not(HasSubstr("--")),
                                   testing::Not(HasSubstr("fretwork-"))))
            << request;
    }
    EXPECT_EQ(patterns_of(shown(client)), before);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
