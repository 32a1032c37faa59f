// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the server by themselves.
#include "library/sample.hpp"
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/tiling/tessellation.hpp>
#include <studio/document/edits.hpp>
#include <studio/document/history.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/document/pattern_list.hpp>
#include <studio/server/background.hpp>
#include <studio/server/outgoing.hpp>

#include <gmock/gmock.h>

#include <future>
#include <random>
#include <stdexcept>

namespace fretwork::studio {
namespace THIS_TEST {

Outgoing message(std::size_t size, const std::string& stream) {
    return {{text_part("head"), binary_part(std::string(size, 'x'))}, stream};
}

TEST(OutgoingQueue, OldSolutionsGiveWayAndNothingElse) {
    OutgoingQueue queue;
    queue.add(message(10, ""));
    for (std::size_t i = 0; i < 1000; ++i) queue.add(message(1'000'000 + i, "solution"));
    queue.add(message(20, ""));
    EXPECT_FALSE(queue.is_too_far_behind());
    std::vector<std::size_t> sizes;
    while (!queue.is_empty()) sizes.push_back(queue.take().bytes->size());
    EXPECT_THAT(sizes, testing::ElementsAre(4, 10, 4, 1'000'999, 4, 20));
    EXPECT_EQ(queue.bytes(), 0U);
}

TEST(OutgoingQueue, WhatWasBegunIsSentToItsEnd) {
    OutgoingQueue queue;
    queue.add(message(10, "solution"));
    (void)queue.take();
    queue.add(message(20, "solution"));
    EXPECT_EQ(queue.take().bytes->size(), 10U);
    EXPECT_EQ(queue.take().bytes->size(), 4U);
    EXPECT_EQ(queue.take().bytes->size(), 20U);
    EXPECT_TRUE(queue.is_empty());
}

TEST(OutgoingQueue, AReaderWhoMissesEditsIsTooFarBehind) {
    OutgoingQueue queue;
    for (int i = 0; i < 100 && !queue.is_too_far_behind(); ++i) queue.add(message(1'000'000, ""));
    EXPECT_TRUE(queue.is_too_far_behind());
}

State first_state() {
    return make_state(test::studio_project(30, 20), "/");
}

Edited random_edit(const State& state, std::mt19937& random) {
    const std::string tile = std::to_string(random() % state.tile_count());
    const char* patterns[] = {"0-6", "0-5+5-6", "0-1+1-6"};
    const auto json = base::JsonReader::from_text(
        R"({"do": "paint", "tiles": [)" + tile + R"(], "pattern": ")" + patterns[random() % 3] + R"("})",
        "test");
    return *edited(state, "paint", json);
}

TEST(StudioMessage, BytesThatAreNoTextDoNotKeepItFromBeingSent) {
    const Part part = json_part({{"event", "failed"}, {"error", "'\xb0' is no pattern"}});
    EXPECT_EQ(base::Json::parse(*part.bytes)["error"], "'\xef\xbf\xbd' is no pattern");
}

TEST(StudioBackground, AFailureIsOneLineWhateverItQuotes) {
    Background thread;
    std::promise<std::string> failure;
    thread.add(
        {.work = [](const base::Control&) { throw base::InputError("lib.db", "", "'\xb0\n' is no pattern"); },
         .failed = [&failure](const std::string& error) { failure.set_value(error); }});
    EXPECT_EQ(failure.get_future().get(), "lib.db: '\\xb0\\x0a' is no pattern");
}

TEST(StudioBackground, ADefectOfTheProgramIsAFailureAndNotTheEnd) {
    Background thread;
    std::promise<std::string> failure;
    thread.add({.work = [](const base::Control&) { throw std::out_of_range("map::at"); },
                .failed = [&failure](const std::string& error) { failure.set_value(error); }});
    EXPECT_EQ(failure.get_future().get(),
              "a defect of the program; please report it with what led to it: map::at");
}

TEST(StudioHistory, MemoryStaysBoundedUnderRandomEdits) {
    const History::Limits limits{.steps = 400, .bytes = 1'000'000};
    History history(first_state(), limits);
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        if (random() % 5 == 0)
            (void)(random() % 2 == 0 ? history.undo() : history.redo());
        else
            history.add(random_edit(*history.now(), random));
        ASSERT_LE(history.steps(), limits.steps);
        ASSERT_LE(history.bytes(), limits.bytes);
    }
    EXPECT_GT(history.steps(), 50U);
}

TEST(StudioHistory, CountsTheFilesOfPaintings) {
    constexpr std::size_t kFile = 300'000;
    const auto painted_by = [](const State& state,
                               const std::shared_ptr<const simulation::PaintingChoice>& recipe) {
        Painting painting = *state.painting;
        painting.recipes.assign(painting.recipes.size(), recipe);
        State next = state;
        next.painting = std::make_shared<const Painting>(std::move(painting));
        return next;
    };
    const auto recipe = [] {
        const simulation::FileContent content{std::string(kFile, 'x')};
        return std::make_shared<const simulation::PaintingChoice>(
            simulation::PaintByField{.field = simulation::FieldImage{"a.png", content}});
    };
    const State first = first_state();
    const auto one = recipe();
    const State by_one = painted_by(first, one);
    EXPECT_GE(size_of_difference(by_one, first), kFile) << "once, however many tiles have it";
    EXPECT_LT(size_of_difference(by_one, first), 2 * kFile);
    EXPECT_LT(size_of_difference(painted_by(by_one, one), by_one), kFile) << "both states share the file";

    const History::Limits limits{.steps = 400, .bytes = 1'000'000};
    History history(first, limits);
    for (int i = 0; i < 20; ++i) history.add({painted_by(*history.now(), recipe()), "paint"});
    EXPECT_LE(history.bytes(), limits.bytes);
    EXPECT_LE(history.steps(), 4U);
}

TEST(StudioHistory, AnUndoneStepIsForgottenByAnotherEdit) {
    std::mt19937 random(1);
    History history(first_state());
    history.add(random_edit(*history.now(), random));
    const StatePtr first = history.now();
    history.add(random_edit(*history.now(), random));
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.now(), first);
    history.add(random_edit(*history.now(), random));
    EXPECT_FALSE(history.redo());
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.now(), first);
}

TEST(StudioState, AProjectComesBackAsItWas) {
    simulation::Project project = test::studio_project();
    project.tile_models = {{"full", {tiling::TileIndex(2), tiling::TileIndex(5)}}};
    project.library_path = "sub/library.db";
    project.library_hash = "00";
    const State state = make_state(project, "/folder");
    EXPECT_EQ(simulation::project_text(make_project(state, "/folder")), simulation::project_text(project));
    EXPECT_EQ(make_project(state, "/folder/other").library_path, "../sub/library.db");
}

TEST(StudioState, ADocumentWithAnotherStrengthKeepsItsLibraryAndWithAnotherMaterialLeavesIt) {
    simulation::Project project = test::studio_project();
    project.library_path = "library.db";
    project.library_hash = "00";
    const State state = make_state(project, "/folder");
    const auto library_with = [&](const reduction::Setting& setting) {
        const auto request = base::JsonReader::from_text(
            R"({"do": "set_setting", "setting": )" + reduction::setting_text(setting) + "}", "test");
        return edited(state, "set_setting", request)->state.library->path.string();
    };
    reduction::Setting setting = *state.setting;
    setting.strength = 40e6;
    EXPECT_EQ(library_with(setting), "/folder/library.db");
    setting.material.young_modulus *= 2;
    EXPECT_EQ(library_with(setting), "");
}

TEST(StudioPatterns, HaveTheErrorsOfALibraryOfTheirOwnLayoutOnly) {
    const test::TemporaryFolder folder;
    simulation::Project project = test::studio_project();
    project.layout = pattern::find_node_layout("spider4");
    auto library = library::Library::create(folder.path() / "own.db", project.layout, *project.setting);
    const auto id = pattern_list("spider4", nullptr, {})["patterns"][0]["id"].get<std::string>();
    library.add_patterns(std::vector{pattern::parse_pattern_id(project.layout, id)});
    library.store(std::vector{library::PatternData{id, {}, {library::test::sample_calibration(0.25)}, {}}});
    project.library_path = "own.db";
    project.library_hash = library.content_hash();
    const State state = make_state(project, folder.path());
    auto other = base::Json::parse(pattern::node_layout_text(project.layout));
    other["name"] = "other";
    const std::string other_file = folder.file("other.json", other.dump());
    const auto count_errors = [&](const std::string& layout) {
        const base::Json list = pattern_list(layout, &state, {});
        int errors = 0;
        for (const base::Json& one : list["patterns"]) errors += one["error"].is_null() ? 0 : 1;
        return errors;
    };
    EXPECT_EQ(count_errors("spider4"), 1);
    EXPECT_EQ(count_errors(other_file), 0);
}

TEST(StudioBackground, StopsWhatIsUnderWayAndForgetsWhatWaits) {
    std::promise<void> began;
    std::promise<std::string> ended;
    std::promise<std::string> forgotten;
    Background thread;
    thread.add({.work =
                    [&](const base::Control& control) {
                        began.set_value();
                        while (true) control.check();
                    },
                .failed = [&](const std::string& error) { ended.set_value(error); }});
    thread.add({.work = [](const base::Control&) { FAIL() << "it was forgotten"; },
                .failed = [&](const std::string& error) { forgotten.set_value(error); }});
    began.get_future().wait();
    thread.cancel();
    EXPECT_EQ(ended.get_future().get(), "cancelled");
    EXPECT_EQ(forgotten.get_future().get(), "cancelled");
}

TEST(RimLoops, GoAroundTheSurfaceOnceAndAroundItsHoles) {
    // 3 x 3 hexagons without the one in the middle.
    tiling::Tessellation tessellation = test::honeycomb(3, 3, {"0-6"}).tessellation;
    const auto middle = tessellation.tiles.begin() + 4;
    const std::size_t around_the_hole = middle->interface_nodes.size();
    tessellation.tiles.erase(middle);
    auto loops = tiling::rim_loops(tessellation);
    ASSERT_EQ(loops.size(), 2U);
    std::ranges::sort(loops, {}, &std::vector<tiling::InterfaceIndex>::size);
    EXPECT_EQ(loops[0].size(), around_the_hole);
    std::map<int, int> tiles_of;
    for (const tiling::Tile& tile : tessellation.tiles) {
        for (const auto node : tile.interface_nodes) ++tiles_of[node.value];
    }
    const auto at_rim = std::ranges::count_if(tiles_of, [](const auto& node) { return node.second == 1; });
    EXPECT_EQ(loops[0].size() + loops[1].size(), static_cast<std::size_t>(at_rim));
}

TEST(Base64, IsDecodedOrRefused) {
    EXPECT_EQ(base::decode_base64("ZnJldA==", "x"), "fret");
    EXPECT_EQ(base::decode_base64("", "x"), "");
    for (const char* text : {"?", "Zg=", "Zg", "Z"})
        EXPECT_THROW((void)base::decode_base64(text, "x"), base::InputError) << text;
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
