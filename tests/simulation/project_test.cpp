// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/project_check.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <nlohmann/json.hpp>

#include <regex>
#include <sys/stat.h>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::complaint_of;
using test::honeycomb;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::StartsWith;

Project example() {
    Project project = honeycomb(3, 2, {"0-1+1-6", "0-6"});
    project.load_cases = {test::cantilever({0, 0, -1})};
    LoadCase other;
    other.name = "other";
    other.supports.push_back({NodesNearest{{{0.1, 0.2}}}, mechanics::DofSet::translations()});
    other.loads.push_back({NodesInBox{{0, 0, 1, 1}}, {1, 0, 0}, {0, 2, 0}, LoadCase::Amount::Each});
    other.prescribed.push_back({NodesById{{1, 2}}, mechanics::Dof::uz, 0.01});
    other.gravity = {0, 0, -9.81};
    project.load_cases.push_back(other);
    return project;
}

TEST(ProjectFile, WritingWhatWasReadGivesTheSameFile) {
    const TemporaryFolder folder;
    write_project(example(), folder.path() / "a.json");
    const Project read = read_project(folder.path() / "a.json");
    write_project(read, folder.path() / "b.json");
    EXPECT_EQ(base::read_text_file(folder.path() / "a.json"), base::read_text_file(folder.path() / "b.json"));
    EXPECT_EQ(read.tessellation.tiles.size(), 6U);
    EXPECT_EQ(read.load_cases.size(), 2U);
    EXPECT_EQ(read.load_cases[1].gravity, Eigen::Vector3d(0, 0, -9.81));
}

TEST(ProjectFile, KeepsItsLibrary) {
    const TemporaryFolder folder;
    Project project = example();
    project.library_path = "lib.db";
    project.library_hash = "abc";
    write_project(project, folder.path() / "a.json");
    EXPECT_EQ(read_project(folder.path() / "a.json").library_path, "lib.db");
    EXPECT_EQ(read_project(folder.path() / "a.json").library_hash, "abc");
}

/// A named pipe has a folder; what comes through it does not lie there.
TEST(ProjectLibrary, OfAProjectThatComesThroughAPipeLiesInTheCurrentFolder) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const std::string pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    Project project = example();
    project.library_path = "lib.db";
    const std::string from_here = fs::absolute("lib.db").lexically_relative(folder.path());
    for (const std::string& stream : {pipe, std::string("/dev/stdin"), std::string("/dev/fd/0")}) {
        EXPECT_TRUE(folder_of_project(stream).empty()) << stream;
        EXPECT_EQ(library_path_of(stream, project), "lib.db") << stream;
        Project written = project;
        move_library_path(written, stream, folder.path() / "p.json");
        EXPECT_EQ(written.library_path, from_here) << stream;
    }
    EXPECT_TRUE(folder_of_project(folder.path() / "p.json") == folder.path());
    EXPECT_EQ(library_path_from(folder.path() / "p.json", folder.path() / "lib.db"), "lib.db");
    EXPECT_EQ(library_path_from("/dev/stdout", "lib.db"), "lib.db");
    EXPECT_EQ(library_path_from("p.json", "sub/../lib.db"), "lib.db");
}

TEST(ProjectFile, KeepsItsSettingAndTheModelsOfItsTiles) {
    Project project = example();
    project.setting = reduction::paper_setting();
    project.setting->material.young_modulus = 2.3465e9;
    project.tile_models = {{"full", {tiling::TileIndex(2), tiling::TileIndex(5)}}};
    const Project read = parse_project(project_text(project), "its own text");
    EXPECT_EQ(read.setting, project.setting);
    ASSERT_EQ(read.tile_models.size(), 1U);
    EXPECT_EQ(read.tile_models[0].tiles, project.tile_models[0].tiles);
    EXPECT_EQ(make_surface(read, nullptr).setting, *project.setting);
    EXPECT_EQ(make_surface(read, nullptr).tile_models[5], "full");
}

/// Rectangles and circles with equal radii of gyration bear different stresses. Settings of one library may
/// differ in the shape and in the strength.
TEST(ProjectLibrary, LeavesAProjectItsShapeAndItsStrength) {
    const TemporaryFolder folder;
    reduction::Setting setting = reduction::paper_setting();
    setting.section = mechanics::circle_section(2e-3);
    const auto library = library::Library::create(folder.path() / "lib.db", pattern::paper_layout(), setting);
    Project project;
    project.setting = setting;
    project.setting->section.shape.reset();  // numbers alone count as a rectangle
    project.setting->strength = 5e7;
    EXPECT_EQ(setting_of(project, &library).section.shape, std::nullopt);
    EXPECT_EQ(setting_of(project, &library).strength, project.setting->strength);
    const auto numbers =
        library::Library::create(folder.path() / "numbers.db", pattern::paper_layout(), *project.setting);
    project.setting = setting;
    EXPECT_EQ(setting_of(project, &numbers).section.shape, setting.section.shape);
    EXPECT_EQ(setting_of(project, &numbers).strength, 5e7);
}

/// A project that a program of the first format made, with a library.
TEST(NewProject, HasStiffJointsUnlessAnotherSettingIsAskedFor) {
    const auto outline = outlines::make_outline({{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, {});
    EXPECT_EQ(make_project(outline, {}, nullptr).project.setting, reduction::made_setting());
    reduction::Setting wanted = reduction::paper_setting();
    wanted.tile_side = 0.05;
    const NewProject made = make_project(outline, {.setting = wanted}, nullptr);
    EXPECT_EQ(made.project.setting, wanted);
    EXPECT_EQ(made.edge_length, 0.05);
}

TEST(ProjectFile, RefusesModelsOfTilesThatAreNotThereOrAreChosenTwice) {
    const auto complaint = [](std::vector<tiling::TileIndex> tiles) {
        Project project = example();
        project.tile_models = {{"full", std::move(tiles)}};
        return complaint_of([&] { (void)parse_project(project_text(project), "p.json"); });
    };
    EXPECT_THAT(complaint({tiling::TileIndex(6)}), HasSubstr("/tile_models/0/tiles/0"));
    EXPECT_THAT(complaint({tiling::TileIndex(1), tiling::TileIndex(1)}), HasSubstr("chosen twice"));
}

TEST(ProjectSurface, RefusesModelsOfTilesThatAreNotThere) {
    Project project = example();
    for (const int tile : {6, 1'000'000, -1}) {
        project.tile_models = {{"full", {tiling::TileIndex(tile)}}};
        EXPECT_THAT(complaint_of([&] { (void)make_surface(project, nullptr); }),
                    HasSubstr("there is no tile " + std::to_string(tile) + ": tiles run from 0 to 5"));
    }
}

TEST(LoadCaseFile, WritingWhatWasReadGivesTheSameFile) {
    const TemporaryFolder folder;
    const LoadCase load_case = example().load_cases[1];
    write_load_case(load_case, folder.path() / "case.json");
    EXPECT_EQ(load_case_text(read_load_case(folder.path() / "case.json")), load_case_text(load_case));
    EXPECT_EQ(load_case_text(parse_load_case(load_case_text(load_case), "text")), load_case_text(load_case));
}

/// The complaint about a project file in which the first match of `what` is replaced.
std::string complaint_after(const std::string& what, const std::string& replacement) {
    const TemporaryFolder folder;
    write_project(example(), folder.path() / "a.json");
    const std::string text = base::read_text_file(folder.path() / "a.json");
    const std::string changed =
        std::regex_replace(text, std::regex(what), replacement, std::regex_constants::format_first_only);
    EXPECT_NE(changed, text) << what;
    base::write_file_atomically(folder.path() / "a.json", changed);
    return complaint_of([&] { read_project(folder.path() / "a.json"); });
}

TEST(ProjectFile, RefusesTheFormatOfAnUnreleasedVersion) {
    EXPECT_THAT(
        complaint_after("fretwork/project/2", "fretwork/project/1"),
        HasSubstr("/format: is \"fretwork/project/1\", of an unreleased version: make the project again"));
}

TEST(ProjectFile, NamesThePlaceOfAnErrorInAFileInsideIt) {
    EXPECT_THAT(complaint_after("\"1/3\"", "\"5/3\""), HasSubstr("a.json: /layout/radial/"));
}

TEST(ProjectFile, RefusesInconsistentContentWithItsPlace) {
    EXPECT_THAT(complaint_after("\"load_cases\"", "\"loadcases\""), HasSubstr("unknown key 'loadcases'"));
    EXPECT_THAT(complaint_after("\"0-6\"", "\"0-3\""), HasSubstr("/tessellation/patterns/1"));
    EXPECT_THAT(complaint_after("\"pattern\": 1", "\"pattern\": 7"), HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"vertices\": \\[0", "\"vertices\": [4000"), HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"interface_nodes\": \\[0", "\"interface_nodes\": [3"),
                HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"other\"", "\"cantilever\""), HasSubstr("the name of two load cases"));
    EXPECT_THAT(complaint_after("fretwork/project/2", "fretwork/project/9"),
                HasSubstr("\"fretwork/project/4\" or \"fretwork/project/3\" or \"fretwork/project/2\""));
    EXPECT_THAT(complaint_after("\"1/3\"", "\"1/0\""), HasSubstr("/layout"));
}

/// The complaint about a project whose JSON has another value at a pointer.
std::string complaint_with(const Project& project, const std::string& pointer, const std::string& value) {
    auto json = nlohmann::ordered_json::parse(project_text(project));
    json[nlohmann::ordered_json::json_pointer(pointer)] = nlohmann::ordered_json::parse(value);
    return complaint_of([&] { (void)parse_project(json.dump(), "a.json"); });
}

TEST(ProjectFile, NamesThePlaceOfARangeInItsSetting) {
    Project project = example();
    project.setting = reduction::paper_setting();
    EXPECT_THAT(complaint_with(project, "/setting/material/young_modulus", "1e300"),
                StartsWith("a.json: /setting/material/young_modulus: is 1e+300, where"));
    EXPECT_THAT(complaint_with(project, "/setting/scenarios/0/max_magnitude", "1e300"),
                StartsWith("a.json: /setting/scenarios/0/max_magnitude: is 1e+300, where"));
    EXPECT_THAT(complaint_with(project, "/setting/scenarios", "[]"),
                StartsWith("a.json: /setting/scenarios: "));
}

TEST(ProjectFile, NamesTheLoadCaseThatCombinesAnUnknownOne) {
    Project project = example();
    LoadCase both;
    both.name = "both";
    both.combines = {{"cantilever", 1.0}};
    project.load_cases.push_back(both);
    EXPECT_EQ(complaint_with(project, "/load_cases/2/combines/0/load_case", "\"nosuch\""),
              "a.json: /load_cases/2/combines/0/load_case: unknown load case 'nosuch'; there is: cantilever, "
              "other");
    EXPECT_EQ(complaint_with(project, "/load_cases/2/combines/0/load_case", "\"both\""),
              "a.json: /load_cases/2/combines/0/load_case: is the load case itself");
    EXPECT_EQ(
        complaint_with(project, "/load_cases/2/format", "\"fretwork/load-case/1\""),
        "a.json: /load_cases/2/combines: fretwork/load-case/1 has no combines; fretwork/load-case/2 has");
}

TEST(ProjectFile, NamesThePartWhoseOutlineIsWrong) {
    const auto with_part = [](const char* boundary) {
        return R"([{"holes": [], "boundary": [[5, 5], )" + std::string(boundary) + ", [6, 6]]}]";
    };
    EXPECT_THAT(complaint_with(example(), "/outline/further_parts", with_part("[1e300, 0]")),
                StartsWith("a.json: /outline/further_parts/0: point 1 of the boundary"));
    EXPECT_THAT(complaint_with(example(), "/outline/boundary/1", "[1e300, 0]"),
                StartsWith("a.json: /outline: point 1 of the boundary"));
}

TEST(ProjectCheck, FindsWhatOnlyLaterWorkWouldRefuse) {
    const auto complaint = [](const Project& project) {
        return complaint_of([&] { check_project(project, "a.json"); });
    };
    EXPECT_NO_THROW(check_project(example(), "a.json"));
    Project project = example();
    project.tile_models = {{"nosuch", {tiling::TileIndex(0)}}};
    EXPECT_THAT(complaint(project), StartsWith("a.json: /tile_models/0/model: unknown tile model 'nosuch'"));
    project = example();
    project.load_cases[1].prescribed[0].where = NodesById{{999}};
    EXPECT_THAT(complaint(project),
                StartsWith("a.json: load case 'other': /prescribed/0: there is no interface node 999"));
    project = example();
    project.load_cases[1].area_loads.push_back({LoadCase::AreaLoad::Tiles{{999}}, {0, 0, -1}});
    EXPECT_THAT(complaint(project), HasSubstr("/tiles: there is no tile 999"));
    project = example();
    const PaletteChoice palette{.ids = {"0-6"}};
    project.recipes = {{PaintByField{.field = FieldExpression{"u"}, .palette = palette, .property = "nosuch"},
                        {tiling::TileIndex(0)}}};
    EXPECT_THAT(complaint(project), StartsWith("a.json: /recipes/0/property: unknown property 'nosuch'"));
    project.library_path = "own.db";  // which may have a property of this name
    EXPECT_NO_THROW(check_project(project, "a.json"));
    project.recipes[0].choice =
        PaintByField{.field = FieldImage{"grey.png", FileContent{"none"}}, .palette = palette};
    EXPECT_THAT(complaint(project),
                StartsWith("a.json: /recipes/0/image: grey.png: cannot be read as a PNG"));
    project.recipes[0].choice = PaintByColours{"ring.svg", {{"#ff0000", "0-6"}}, FileContent{"none"}};
    EXPECT_THAT(complaint(project), StartsWith("a.json: /recipes/0/drawing: ring.svg: "));
}

TEST(FindLoadCase, TakesTheOnlyOneAndRefusesToChooseAmongSeveral) {
    Project project = example();
    EXPECT_EQ(find_load_case(project, "other").name, "other");
    EXPECT_THAT(complaint_of([&] { find_load_case(project, ""); }), HasSubstr("cantilever, other"));
    EXPECT_THAT(complaint_of([&] { find_load_case(project, "cantilver"); }),
                HasSubstr("did you mean 'cantilever'?"));
    project.load_cases.pop_back();
    EXPECT_EQ(find_load_case(project, "").name, "cantilever");
    project.load_cases.pop_back();
    EXPECT_THAT(complaint_of([&] { find_load_case(project, ""); }), HasSubstr("fretwork case add"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
