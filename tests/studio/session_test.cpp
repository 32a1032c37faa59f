// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of pages, and the answers of the server.
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <studio/solving/live_solver.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using simulation::Project;
using test::Client;
using test::header;
using test::RunningStudio;
using testing::HasSubstr;

/// Positions: their event, and the message that follows it.
struct Solved {
    Json event;
    std::string positions;
};
Solved next_positions(Client& client) {
    Solved solved;
    solved.event = client.event({"solved"});
    do {
        solved.positions = client.binary();
    } while (header(solved.positions, 1) != 2);
    return solved;
}
/// The next positions that are an answer.
Solved next_solution(Client& client) {
    Solved solved = next_positions(client);
    while (solved.event.value("provisional", false)) solved = next_positions(client);
    return solved;
}
/// The solution of the newest revision.
Solved solution_of(Client& client, std::int64_t revision) {
    Solved solved = next_solution(client);
    while (solved.event["revision"] < revision) solved = next_solution(client);
    return solved;
}

Json load_case_json(double force) {
    return Json::parse(simulation::load_case_text(test::cantilever({0, 0, force})));
}

/// The document as the page would save it.
std::string text_of(Client& client) {
    return client.ask("download")["text"].get<std::string>();
}

TEST(StudioMessages, AServerWithoutAProjectSaysSo) {
    const RunningStudio studio;
    Client client(studio.address());
    const Json answer = client.ask("hello", {{"protocol", 1}});
    EXPECT_FALSE(answer["has_document"].get<bool>());
    EXPECT_EQ(answer["examples"].size(), 6U);
    EXPECT_GE(answer["models"].size(), 3U);
    EXPECT_THAT(client.ask("undo")["error"].get<std::string>(), HasSubstr("no document yet"));
}

TEST(StudioMessages, HelloComesFirstAndTellsTheWholeDocument) {
    const Project project = test::studio_project();
    const RunningStudio studio(project);
    Client client(studio.address());
    EXPECT_THAT(client.ask("undo")["error"].get<std::string>(), HasSubstr("hello"));
    client.hello();
    const Json document = client.event({"document"});
    EXPECT_EQ(document["tiles"].size(), project.tessellation.tiles.size());
    EXPECT_EQ(document["painting"].size(), project.tessellation.tiles.size());
    EXPECT_EQ(document["load_cases"][0]["name"], "cantilever");
    EXPECT_TRUE(document["saved"].get<bool>());
    EXPECT_EQ(document["rim"].size(), 1U) << "one boundary, no hole";
    const std::string beams = client.binary();
    EXPECT_EQ(header(beams, 0), 0x46575254U);
    EXPECT_EQ(header(beams, 1), 1U);
    EXPECT_EQ(next_solution(client).event["model"], document["model"]);
}

TEST(StudioMessages, MalformedOnesAreAnsweredWithOneLineAndChangeNothing) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const std::string before = text_of(client);
    for (const char* message :
         {"",
          "{",
          "[]",
          "7",
          "\"paint\"",
          "{}",
          R"({"do": 3})",
          R"({"id": "x", "do": "undo"})",
          R"({"id": -1})",
          R"({"id": 1, "do": "fly"})",
          R"({"id": 1, "do": "paint"})",
          R"({"id": 1, "do": "paint", "tiles": [], "pattern": "0-6"})",
          R"({"id": 1, "do": "paint", "tiles": [0.5], "pattern": "0-6"})",
          R"({"id": 1, "do": "paint", "tiles": [1e9], "pattern": "0-6"})",
          R"({"id": 1, "do": "paint", "tiles": [0], "pattern": "nonsense"})",
          R"({"id": 1, "do": "paint", "tiles": [0], "pattern": "0-1"})",
          R"({"id": 1, "do": "paint", "tiles": [0], "pattern": "0-6", "colour": "red"})",
          R"({"id": 1, "do": "turn", "tiles": [0], "by": "much"})",
          R"({"id": 1, "do": "set_model", "model": "condensd"})",
          R"({"id": 1, "do": "set_load_case", "index": 0, "load_case": {}})",
          R"({"id": 1, "do": "set_load_case", "index": 7, "load_case": {}})",
          R"({"id": 1, "do": "remove_load_case", "index": 1})",
          R"({"id": 1, "do": "select_load_case", "index": 1})",
          R"({"id": 1, "do": "set_setting", "setting": {"section": {}}})",
          R"({"id": 1, "do": "open", "path": "/nowhere.json"})",
          R"({"id": 1, "do": "save", "path": "/etc/passwd"})",
          R"({"id": 1, "do": "upload", "text_base64": "?"})",
          R"({"id": 1, "do": "new", "example": "nothing"})",
          R"({"id": 1, "id": 2, "do": "undo"})"}) {
        client.send_text(message);
        Json answer = client.receive().json;
        while (!answer.is_object() || !answer.contains("ok")) answer = client.receive().json;
        EXPECT_FALSE(answer["ok"].get<bool>()) << message;
        const auto error = answer["error"].get<std::string>();
        EXPECT_FALSE(error.empty()) << message;
        EXPECT_EQ(error.find('\n'), std::string::npos) << message;
    }
    EXPECT_EQ(text_of(client), before);
}

TEST(StudioMessages, WhatIsNoMessageEndsTheConnectionAndNotTheServer) {
    const RunningStudio studio(test::studio_project());
    const std::string huge = std::string("\x81\xff") + std::string("\0\0\1\0\0\0\0\0", 8) + "0000";
    const std::string binary = std::string("\x82\x81") + std::string(4, '\0') + "x";
    const std::string not_masked = std::string("\x81\x01") + "x";
    for (const std::string& bytes : {huge, binary, not_masked, std::string(10'000, '\xff')}) {
        Client client(studio.address());
        client.hello();
        client.send_raw(bytes);
        EXPECT_THROW(while (true) client.receive(), std::runtime_error);
    }
    Client client(studio.address());
    client.hello();
}

TEST(StudioMessages, TwoPagesSeeEachOthersEdits) {
    const RunningStudio studio(test::studio_project());
    Client one(studio.address());
    Client two(studio.address());
    one.hello();
    two.hello();
    ASSERT_TRUE(one.ask("paint", {{"tiles", {3, 4}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
    const Json seen = two.event({"changed"});
    EXPECT_EQ(seen["palette"].back(), "0-5+5-6");
    EXPECT_EQ(seen["painting"][3], seen["palette"].size() - 1);
    EXPECT_EQ(seen["history"]["undo"], "paint 2 tiles");
    ASSERT_TRUE(two.ask("undo")["ok"].get<bool>());
    (void)one.event({"changed"});
    EXPECT_EQ(one.event({"changed"})["history"]["undo"], nullptr);
    EXPECT_EQ(text_of(one), text_of(two));
}

TEST(StudioMessages, DisplacementsAreThoseOfTheCommandLine) {
    const Project project = test::studio_project();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    for (const char* model : {"condensed", "full"}) {
        ASSERT_TRUE(client.ask("set_model", {{"model", model}})["ok"].get<bool>());
        const Json changed = client.event({"changed"});
        const Solved solved = solution_of(client, changed["revision"]);
        const auto expected = simulation::simulate(simulation::make_surface(project, nullptr),
                                                   project.load_cases.front(), {.model = model});
        const auto& rows = expected.solution.displacements;
        const auto nodes = static_cast<std::size_t>(header(solved.positions, 3));
        const auto found = test::floats(solved.positions, 0, 6 * nodes);
        const double largest = rows.leftCols<3>().rowwise().norm().maxCoeff();
        EXPECT_NEAR(solved.event["largest_displacement"].get<double>(), largest, 1e-9 * largest);
        for (std::size_t n = 0; n < project.tessellation.interface_nodes.size(); ++n) {
            for (std::size_t d = 0; d < 3; ++d) {
                // Floats have seven digits.
                EXPECT_NEAR(found[3 * n + d],
                            rows(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(d)), 1e-6 * largest);
            }
        }
        EXPECT_TRUE(std::ranges::all_of(found, [](float value) { return std::isfinite(value); }))
            << "inner nodes are known, too";
    }
}

TEST(StudioMessages, PagesAreSentTheFieldsThatTheyShow) {
    const RunningStudio studio(test::studio_project());
    Client all(studio.address());
    all.hello();
    const Solved everything = next_solution(all);
    EXPECT_EQ(everything.event["fields"].size(), 8U);
    Client some(studio.address());
    ASSERT_TRUE(some.ask("hello", {{"protocol", 1}, {"fields", Json::array()}})["ok"].get<bool>());
    const Solved bare = next_solution(some);
    EXPECT_EQ(header(bare.positions, 4), 0U);
    EXPECT_EQ(header(bare.positions, 6), 0U);
    ASSERT_TRUE(some.ask("show", {{"fields", {"stress", "M2"}}})["ok"].get<bool>());
    const Solved two = next_solution(some);
    EXPECT_EQ(two.event["fields"], (Json{"M2", "stress"})) << "in the order of the message";
    const std::size_t motion = 6UL * header(everything.positions, 3);
    const std::size_t ends = 2UL * header(everything.positions, 4);
    const auto wanted = test::floats(two.positions, motion, 2 * ends);
    const auto known = test::floats(everything.positions, motion, 8 * ends);
    EXPECT_TRUE(std::equal(wanted.begin(), wanted.begin() + static_cast<std::ptrdiff_t>(ends),
                           known.begin() + static_cast<std::ptrdiff_t>(4 * ends)));
    EXPECT_TRUE(std::equal(wanted.begin() + static_cast<std::ptrdiff_t>(ends), wanted.end(),
                           known.begin() + static_cast<std::ptrdiff_t>(6 * ends)));
    EXPECT_THAT(some.ask("show", {{"fields", {"M4"}}})["error"].get<std::string>(), HasSubstr("M4"));
}

TEST(StudioMessages, FieldsAreComputedWhenAPageShowsThem) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    ASSERT_TRUE(client.ask("hello", {{"protocol", 1}, {"fields", Json::array()}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("paint", {{"tiles", {0}}, {"pattern", "0-6"}})["ok"].get<bool>());
    const Solved bare = solution_of(client, client.event({"changed"})["revision"]);
    ASSERT_TRUE(client.ask("show", {{"fields", {"stress"}}})["ok"].get<bool>());
    const Solved shown = next_solution(client);
    EXPECT_EQ(shown.event["revision"], bare.event["revision"]);
    EXPECT_EQ(header(shown.positions, 6), 1U);
    EXPECT_EQ(shown.event["residual"], bare.event["residual"]) << "it is the same solution";
}

TEST(StudioMessages, ReactionsBalanceTheLoads) {
    Project project = test::studio_project();
    project.load_cases.front().gravity.setZero();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    const Solved solved = next_solution(client);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    ASSERT_GT(solved.event["reactions"].size(), 1U);
    for (const Json& row : solved.event["reactions"]) {
        ASSERT_EQ(row["moment"].size(), 3U);
        for (std::size_t d = 0; d < 3; ++d)
            sum[static_cast<Eigen::Index>(d)] += row["force"][d].get<double>();
    }
    // The solver ends at a residual of 1e-8 or better; the load is 0.01 N.
    EXPECT_NEAR((sum - Eigen::Vector3d(0, 0, 0.01)).norm(), 0.0, 1e-8);
}

TEST(StudioMessages, StabilityLeftOpenInADragIsToldWhenItRests) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    (void)client.ask("set_model", {{"model", "corotational"}});
    Solved solved = next_solution(client);
    while (solved.event["model"] != "corotational" || solved.event["stable"].is_null())
        solved = next_solution(client);
    const auto revision = solved.event["revision"].get<std::int64_t>();
    (void)client.ask("set_load_case",
                     {{"index", 0}, {"load_case", load_case_json(-0.0101)}, {"merge", "drag"}});
    const Solved dragged = solution_of(client, revision + 1);
    EXPECT_TRUE(dragged.event["stable"].is_null());
    const Solved rested = next_solution(client);
    EXPECT_EQ(rested.event["revision"], dragged.event["revision"]);
    EXPECT_EQ(rested.event["stable"], true);
}

TEST(StudioMessages, ADraggedLoadIsShownBeforeItsEquilibriumIsFound) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    Solved before = next_solution(client);
    ASSERT_EQ(before.event["model"], "corotational");
    Solved first;
    // Who is slow to read gets the newest positions only; then the load is dragged on.
    for (int drag = 0; drag < 200; ++drag) {
        const auto revision = before.event["revision"].get<std::int64_t>() + 1;
        const double force = drag % 2 == 0 ? -0.011 : -0.01;
        (void)client.ask("set_load_case",
                         {{"index", 0}, {"load_case", load_case_json(force)}, {"merge", "drag"}});
        first = next_positions(client);
        while (first.event["revision"] < revision) first = next_positions(client);
        if (first.event.value("provisional", false)) break;
        before = first;
    }
    ASSERT_TRUE(first.event.value("provisional", false));
    EXPECT_FALSE(first.event["converged"].get<bool>());
    EXPECT_TRUE(first.event["warnings"].empty());
    const Solved answer = next_positions(client);
    EXPECT_FALSE(answer.event.value("provisional", false));
    EXPECT_EQ(answer.event["revision"], first.event["revision"]);
    EXPECT_TRUE(answer.event["converged"].get<bool>());
    const auto moved = [](const Solved& solved) {
        return solved.event["largest_displacement"].get<double>();
    };
    // The tangent leads most of the way.
    EXPECT_LT(std::abs(moved(first) - moved(answer)), 0.2 * std::abs(moved(before) - moved(answer)));
}

TEST(StudioMessages, StiffJointsMakeTheSurfaceStiffer) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    Json setting = client.event({"document"})["setting"];
    const double before = next_solution(client).event["largest_displacement"].get<double>();
    setting["format"] = "fretwork/setting/2";
    setting["joints"] = "stiff";
    const Json answer = client.ask("set_setting", {{"setting", setting}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_LT(next_solution(client).event["largest_displacement"].get<double>(), 0.99 * before);
}

TEST(StudioMessages, AStrengthGoesWithTheProjectAndChangesNothingThatIsSolved) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    Json setting = client.event({"document"})["setting"];
    const Json before = next_solution(client).event["largest_displacement"];
    setting["format"] = "fretwork/setting/2";
    setting["material"]["strength"] = 40e6;
    ASSERT_TRUE(client.ask("set_setting", {{"setting", setting}})["ok"].get<bool>());
    const Json changed = client.event({"changed"});
    EXPECT_EQ(changed["setting"]["material"]["strength"], 40e6);
    EXPECT_EQ(solution_of(client, changed["revision"]).event["largest_displacement"], before);
    EXPECT_EQ(simulation::parse_project(text_of(client), "download").setting->strength, 40e6);
    for (const Json& wrong : {Json(0), Json(-1e6), Json("much")}) {
        setting["material"]["strength"] = wrong;
        const Json answer = client.ask("set_setting", {{"setting", setting}});
        ASSERT_FALSE(answer["ok"].get<bool>()) << wrong;
        EXPECT_THAT(answer["error"].get<std::string>(), HasSubstr("material, strength")) << wrong;
    }
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(simulation::parse_project(text_of(client), "download").setting->strength, std::nullopt);
}

TEST(StudioMessages, MixedModelsTakeTheShareOfTilesInFull) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "mixed:0.25"}})["ok"].get<bool>());
    Solved solved = next_solution(client);
    while (solved.event["model"] != "mixed:0.25") solved = next_solution(client);
    const Project project = simulation::parse_project(text_of(client), "download");
    const auto expected = simulation::simulate(simulation::make_surface(project, nullptr),
                                               project.load_cases.front(), {.model = "mixed:0.25"});
    const double largest = expected.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
    // Both end at a residual of 1e-8 of the loads or better.
    EXPECT_NEAR(solved.event["largest_displacement"].get<double>(), largest, 1e-5 * largest);
    EXPECT_FALSE(client.ask("set_model", {{"model", "mixed:2"}})["ok"].get<bool>());
    EXPECT_FALSE(client.ask("set_tile_model", {{"tiles", {0}}, {"model", "mixed:0.5"}})["ok"].get<bool>());
}

TEST(StudioMessages, ASurfaceThatIsNotHeldIsToldInWords) {
    Project project = test::studio_project();
    project.load_cases.front().supports.clear();
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    const Json failed = client.event({"failed"});
    EXPECT_FALSE(failed["error"].get<std::string>().empty());
    ASSERT_TRUE(client.ask("set_load_case", {{"index", 0}, {"load_case", load_case_json(-0.01)}})["ok"]);
    (void)next_solution(client);
}

TEST(StudioMessages, APageThatLeavesDuringAJobHarmsNobody) {
    const RunningStudio studio(test::studio_project(12, 10));
    Client stays(studio.address());
    stays.hello();
    (void)next_solution(stays);
    {
        Client leaves(studio.address());
        leaves.hello();
        ASSERT_TRUE(leaves.ask("solve", {{"model", "full"}, {"background", true}})["ok"].get<bool>());
        leaves.send_text(R"({"id": 9, "do": "patterns"})");
        leaves.leave();
    }
    Json event = stays.event({"solved"});
    while (!event.contains("background")) event = stays.event({"solved"});
    EXPECT_EQ(event["model"], "full");
    ASSERT_TRUE(stays.ask("paint", {{"tiles", {0}}, {"pattern", "0-6"}})["ok"].get<bool>());
}

TEST(StudioMessages, AProjectWithoutASettingHasThatOfItsLibrary) {
    const RunningStudio studio;
    Project project = test::studio_project();
    project.library_path = "own.db";
    project.library_hash =
        library::Library::create(studio.folder() / "own.db", project.layout, reduction::made_setting())
            .content_hash();
    project.setting.reset();
    simulation::write_project(project, studio.project_file());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("open", {{"path", studio.project_file().string()}})["ok"].get<bool>());
    EXPECT_EQ(client.event({"document"})["setting"]["joints"], "stiff");
    EXPECT_EQ(simulation::parse_project(text_of(client), "download").setting, reduction::made_setting());

    const std::string sent = base::encode_base64(simulation::project_text(project));
    const Json refused = client.ask("upload", {{"name", "sent.json"}, {"text_base64", sent}});
    ASSERT_FALSE(refused["ok"].get<bool>());
    EXPECT_THAT(refused["error"].get<std::string>(), HasSubstr("library"));
}

TEST(StudioMessages, APathThatIsTooMuchToBeSentIsRefused) {
    const RunningStudio studio(test::studio_project(30, 30));
    Client client(studio.address());
    client.hello();
    const std::string beams = client.binary();
    ASSERT_EQ(header(beams, 1), 1U);
    const std::size_t one_step = 32 + 4UL * (6UL * header(beams, 3) + 8UL * 2UL * header(beams, 4));
    ASSERT_GT(200 * one_step, std::size_t{64} << 20U) << "more than may wait for a page";
    const Json refused = client.ask("path", {{"steps", 200}});
    ASSERT_FALSE(refused["ok"].get<bool>());
    EXPECT_THAT(refused["error"].get<std::string>(),
                HasSubstr("is 200, where a surface of this size allows " +
                          std::to_string((std::size_t{48} << 20U) / one_step) + " with the fields"));
    ASSERT_TRUE(client.ask("show", {{"fields", Json::array()}})["ok"].get<bool>());
    EXPECT_TRUE(client.ask("path", {{"steps", 20}})["ok"].get<bool>());
    EXPECT_TRUE(client.ask("cancel")["ok"].get<bool>());
}

TEST(StudioMessages, JobsAreCancelledWhenThatIsAskedFor) {
    const RunningStudio studio(test::studio_project(20, 16));
    Client client(studio.address());
    ASSERT_TRUE(client.ask("hello", {{"protocol", 1}, {"fields", Json::array()}})["ok"].get<bool>());
    (void)next_solution(client);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(client.ask("path", {{"steps", 200}}).contains("ok"));
    ASSERT_TRUE(client.ask("solve", {{"model", "full"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("solve", {{"model", "full"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("cancel")["ok"].get<bool>());
    Json failed = client.event({"failed"});
    while (failed["error"] != "cancelled") failed = client.event({"failed"});
    EXPECT_TRUE(failed["background"].get<bool>());
}

TEST(StudioMessages, ModesAndComparisonsCarryTheirPositions) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "condensed"}})["ok"].get<bool>());
    const Solved live = solution_of(client, client.event({"changed"})["revision"]);
    ASSERT_TRUE(client.ask("modes", {{"count", 2}})["ok"].get<bool>());
    const Json modes = client.event({"modes"});
    ASSERT_EQ(modes["values"].size(), 2U);
    EXPECT_LE(modes["values"][0], modes["values"][1]);
    EXPECT_EQ(header(client.binary(), 3), header(live.positions, 3));
    (void)client.binary();
    ASSERT_TRUE(client.ask("compare", {{"model", "full"}})["ok"].get<bool>());
    const Json compared = client.event({"compared"});
    EXPECT_GT(compared["largest"], 0.0);
    EXPECT_LE(compared["mean"], compared["largest"]);
    const std::string positions = client.binary();
    EXPECT_EQ(header(positions, 5), 1U) << "one field: the error";
}

TEST(StudioHistory, UndoAndRedoGiveTheSameDocument) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    std::vector<std::string> texts = {text_of(client)};
    const auto edit = [&](const char* name, const Json& more) {
        const Json answer = client.ask(name, more);
        ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
        texts.push_back(text_of(client));
    };
    edit("paint", {{"tiles", {1, 2}}, {"pattern", "0-5+5-6"}});
    edit("turn", {{"tiles", {2, 3}}, {"by", 2}});
    edit("set_tile_model", {{"tiles", {0}}, {"model", "full"}});
    edit("set_load_case", {{"index", 0}, {"load_case", load_case_json(-0.2)}});
    Json second = load_case_json(0.1);
    second["name"] = "second";
    edit("set_load_case", {{"index", 1}, {"load_case", second}});
    edit("remove_load_case", {{"index", 0}});
    const std::size_t last = texts.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        EXPECT_NE(texts[i], texts[i + 1]);
    }
    for (std::size_t i = last; i > 0; --i) {
        ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
        EXPECT_EQ(text_of(client), texts[i - 1]);
    }
    EXPECT_FALSE(client.ask("undo")["ok"].get<bool>());
    // Another page: the history is the server's.
    Client reloaded(studio.address());
    reloaded.hello();
    for (std::size_t i = 0; i < last; ++i) {
        ASSERT_TRUE(reloaded.ask("redo")["ok"].get<bool>());
        EXPECT_EQ(text_of(reloaded), texts[i + 1]);
    }
    EXPECT_FALSE(reloaded.ask("redo")["ok"].get<bool>());
}

TEST(StudioHistory, ADragIsOneStep) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const std::string before = text_of(client);
    for (int i = 1; i <= 5; ++i) {
        ASSERT_TRUE(
            client.ask("set_load_case",
                       {{"index", 0}, {"load_case", load_case_json(-0.01 * i)}, {"merge", "drag 1"}})["ok"]);
    }
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(text_of(client), before);
}

TEST(StudioHistory, ManyEditsEndAsOneEdit) {
    // Whatever the way to it, the surface answers as one that was made so at once.
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "condensed"}})["ok"].get<bool>());
    std::mt19937 random(1);
    const std::vector<std::string> patterns = {"0-6", "0-5+5-6", "0-1+1-6", "0-1+1-3+1-6"};
    std::int64_t revision = 0;
    for (int i = 0; i < 60; ++i) {
        Json answer;
        switch (random() % 4) {
            case 0:
                answer =
                    client.ask("paint", {{"tiles", {random() % 12}}, {"pattern", patterns[random() % 4]}});
                break;
            case 1:
                answer = client.ask("turn", {{"tiles", {random() % 12}}, {"by", 1 + random() % 5}});
                break;
            case 2:
                answer = client.ask("undo");
                break;
            default:
                answer = client.ask(
                    "set_load_case",
                    {{"index", 0},
                     {"load_case", load_case_json(-0.001 * static_cast<double>(1 + random() % 9))}});
        }
        if (answer["ok"].get<bool>() && !answer.value("unchanged", false))
            revision = client.event({"changed"})["revision"];
    }
    const Solved solved = solution_of(client, revision);
    const Project project = simulation::parse_project(text_of(client), "download");
    const auto expected = simulation::simulate(simulation::make_surface(project, nullptr),
                                               project.load_cases.front(), {.model = "condensed"});
    const double largest = expected.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
    EXPECT_NEAR(solved.event["largest_displacement"].get<double>(), largest, 1e-6 * largest);
}

TEST(StudioFiles, SavedAndOpenedAgainItIsTheSameDocument) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("paint", {{"tiles", {1}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("turn", {{"tiles", {1}}, {"by", 2}})["ok"].get<bool>());
    const std::string text = text_of(client);
    const std::string path = (studio.folder() / "copy.json").string();
    ASSERT_TRUE(client.ask("save", {{"path", path}})["ok"].get<bool>());
    EXPECT_EQ(base::read_text_file(path), text);
    ASSERT_TRUE(client.ask("open", {{"path", path}})["ok"].get<bool>());
    EXPECT_EQ(text_of(client), text);
}

TEST(StudioFiles, AFileThatIsNoProjectIsNotOverwritten) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const auto other = studio.folder() / "other.json";
    base::write_file_atomically(other, R"({"format": "fretwork/setting/1"})");
    EXPECT_FALSE(client.ask("save", {{"path", other.string()}})["ok"].get<bool>());
    EXPECT_EQ(base::read_text_file(other), R"({"format": "fretwork/setting/1"})");
}

TEST(StudioFiles, AnOutlineBecomesADocument) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    // { "format": "fretwork/outline/1", "boundary": [[0,0],[0.2,0],[0.2,0.2],[0,0.2]] }
    const std::string outline =
        "eyJmb3JtYXQiOiAiZnJldHdvcmsvb3V0bGluZS8xIiwgImJvdW5kYXJ5IjogW1swLDBdLFswLjIsMF0sWzAuMiwwLjJdLFswLDAu"
        "Ml1dIH0=";
    const Json answer = client.ask("new", {{"outline", {{"name", "square.json"}, {"text_base64", outline}}},
                                           {"tile_size", 0.026},
                                           {"patterns", "0-1+1-6"}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    const Json document = client.event({"document"});
    EXPECT_EQ(document["tiles"].size(), answer["tiles"]);
    EXPECT_THAT(client.event({"failed"})["error"].get<std::string>(), HasSubstr("No load case yet"));
    const Json refused =
        client.ask("new", {{"outline", {{"name", "../../x.zip"}, {"text_base64", outline}}}});
    EXPECT_FALSE(refused["ok"].get<bool>());
}

TEST(StudioFiles, AnOutlineIsMeasuredAndScaledToTheWidthThatIsWanted) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    // A square of 4 mm with a hole, in the project's own form.
    const std::string content =
        R"({"format": "fretwork/outline/1", "boundary": [[0,0],[0.004,0],[0.004,0.004],[0,0.004]],
            "holes": [[[0.001,0.001],[0.001,0.002],[0.002,0.002]]]})";
    Json outline = {{"name", "icon.json"}, {"text_base64", base::encode_base64(content)}};
    const Json measured = client.ask("measure", {{"outline", outline}});
    ASSERT_TRUE(measured["ok"].get<bool>()) << measured;
    EXPECT_EQ(measured["size"], (Json{0.004, 0.004}));
    EXPECT_EQ(measured["loops"].size(), 2U);
    EXPECT_FALSE(client.ask("new", {{"outline", outline}})["ok"].get<bool>()) << "too small for a tile";
    outline["width"] = 0.3;
    EXPECT_NEAR(client.ask("measure", {{"outline", outline}})["size"][1].get<double>(), 0.3, 1e-12);
    ASSERT_TRUE(client.ask("new", {{"outline", outline}, {"tile_size", 0.026}})["ok"].get<bool>());
    EXPECT_EQ(client.event({"document"})["name"], "icon");
    outline["width"] = -1;
    EXPECT_THAT(client.ask("measure", {{"outline", outline}})["error"].get<std::string>(),
                HasSubstr("width"));
}

TEST(StudioFiles, OneOrAllPartsOfADrawingAreTaken) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    const std::string content =
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="600mm" height="300mm" viewBox="0 0 600 300">)"
        R"(<rect width="200" height="100"/><rect x="300" width="300" height="300"/></svg>)";
    Json outline = {{"name", "two.svg"}, {"text_base64", base::encode_base64(content)}};
    const auto near = [](const Json& size, double width, double height) {
        EXPECT_NEAR(size[0].get<double>(), width, 1e-9);
        EXPECT_NEAR(size[1].get<double>(), height, 1e-9);
    };
    const Json largest = client.ask("measure", {{"outline", outline}});
    near(largest["size"], 0.3, 0.3);
    ASSERT_EQ(largest["parts"].size(), 2U) << largest;
    near(largest["parts"][0], 0.3, 0.3);
    near(largest["parts"][1], 0.2, 0.1);

    outline["part"] = "2";
    const Json second = client.ask("measure", {{"outline", outline}});
    near(second["size"], 0.2, 0.1);
    EXPECT_NEAR(second["area"].get<double>(), 0.02, 1e-9);
    EXPECT_EQ(second["loops"].size(), 1U);
    outline["width"] = 0.4;
    const Json scaled = client.ask("measure", {{"outline", outline}});
    near(scaled["size"], 0.4, 0.2);
    near(scaled["parts"][0], 0.6, 0.6);

    outline.erase("width");
    outline["part"] = "all";
    const Json all = client.ask("measure", {{"outline", outline}});
    near(all["size"], 0.6, 0.3);
    EXPECT_NEAR(all["area"].get<double>(), 0.11, 1e-9);
    EXPECT_EQ(all["loops"].size(), 2U);
    const Json made = client.ask("new", {{"outline", outline}, {"tile_size", 0.03}});
    ASSERT_TRUE(made["ok"].get<bool>()) << made;
    outline["part"] = "2";
    const Json fewer = client.ask("new", {{"outline", outline}, {"tile_size", 0.03}, {"discard", true}});
    ASSERT_TRUE(fewer["ok"].get<bool>()) << fewer;
    EXPECT_LT(fewer["tiles"].get<int>(), made["tiles"].get<int>() / 3);

    outline["part"] = "3";
    for (const char* message : {"measure", "new"})
        EXPECT_THAT(client.ask(message, {{"outline", outline}})["error"].get<std::string>(),
                    HasSubstr("part '3' is none of largest, all, 1 .. 2"));
}

TEST(StudioFiles, TheFacesOfADroppedMeshBecomeTilesAtTheWidthThatIsWanted) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    const std::string squares =
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n";
    const auto sent = [](const std::string& text) {
        return Json{{"name", "two.obj"}, {"text_base64", base::encode_base64(text)}, {"width", 0.3}};
    };
    const Json answer = client.ask("new", {{"outline", sent(squares)}, {"tiles", "faces"}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_EQ(answer["tiles"], 2);
    const Json document = client.event({"document"});
    double right = 0.0;
    for (const Json& vertex : document["vertices"]) right = std::max(right, vertex[0].get<double>());
    EXPECT_NEAR(right, 0.3, 1e-12);
    // The middles of the tiles lie at a quarter and at three quarters of the width.
    const Json painted = client.ask("new", {{"outline", sent(squares)},
                                            {"tiles", "faces"},
                                            {"patterns", "field:x/0.3"},
                                            {"palette", "0-1+1-6,0-6"}});
    ASSERT_TRUE(painted["ok"].get<bool>()) << painted;
    EXPECT_EQ(client.event({"document"})["painting"], (Json{0, 1}));
    const std::string dented = "v 0 0 0\nv 1 0 0\nv 0.2 0.2 0\nv 0 1 0\nf 1 2 3 4\n";
    const Json refused = client.ask("new", {{"outline", sent(dented)}, {"tiles", "faces"}});
    EXPECT_FALSE(refused["ok"].get<bool>());
    EXPECT_THAT(refused["error"].get<std::string>(),
                testing::AllOf(testing::StartsWith("two.obj"), HasSubstr("convex")));
}

TEST(StudioFiles, MessagesNameTheKeysOfARequestAndNotTheOptionsOfACommand) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    const Json outline = {
        {"name", "square.json"},
        {"text_base64",
         base::encode_base64(
             R"({"format": "fretwork/outline/1", "boundary": [[0,0],[0.2,0],[0.2,0.2],[0,0.2]]})")}};
    for (const Json& more : {Json{{"patterns", "random:1"}}, Json{{"patterns", "0-99"}},
                             Json{{"palette", "0-6"}}, Json{{"patterns", "random:x"}, {"palette", "0-6"}}}) {
        Json request = {{"outline", outline}};
        request.update(more);
        const Json answer = client.ask("new", request);
        ASSERT_FALSE(answer["ok"].get<bool>()) << more;
        EXPECT_THAT(answer["error"].get<std::string>(), testing::Not(HasSubstr("--"))) << more;
    }
}

TEST(StudioFiles, ExportsAreThoseOfTheCommandWithItsOptions) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    (void)next_solution(client);
    const auto get = [&](const std::string& more) {
        return test::http(studio.port(),
                          test::get_request("/export?token=" + studio.token() + "&to=" + more));
    };
    const std::string picture = get("picture.png&size=64x40&view=-30,20&colour=stress");
    EXPECT_EQ(test::status_of(picture), 200);
    EXPECT_THAT(picture, HasSubstr("\x89PNG"));
    const std::string page = get("view.html&scale=2");
    EXPECT_THAT(page, HasSubstr("\"scale\":2.0"));
    EXPECT_THAT(page, HasSubstr("cantilever"));
    const auto size_of_cut = [&](const std::string& more) { return get("cut.dxf" + more).size(); };
    EXPECT_NE(size_of_cut("&frame=4mm"), size_of_cut(""));
    EXPECT_THAT(get("cut.dxf&kerf=wide"), HasSubstr("kerf"));
    for (const char* wrong :
         {"picture.png&size=huge", "cut.dxf&bed=600", "solid.stl&fillet=-1mm", "picture.png&view=up",
          "picture.png&colour=red", "picture.png&colour=utilization", "view.html&scale=x",
          "picture.png&scale=1e200", "x.step"})
        EXPECT_EQ(test::status_of(get(wrong)), 422) << wrong;
}

TEST(StudioMessages, CombinationsAreSolvedAndWhatTheyNameStays) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "condensed"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("set_load_case", {{"index", 0}, {"load_case", load_case_json(-0.01)}})["ok"]);
    const Solved one = solution_of(client, client.event({"changed"})["revision"].get<std::int64_t>() + 1);
    const Json both = {{"format", "fretwork/load-case/2"},
                       {"name", "twice"},
                       {"combines", {{{"load_case", "cantilever"}, {"factor", 2.0}}}}};
    const Json answer = client.ask("set_load_case", {{"index", 1}, {"load_case", both}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    Json changed = client.event({"changed"});
    while (changed["selected_load_case"] != 1) changed = client.event({"changed"});
    const Solved two = solution_of(client, changed["revision"]);
    EXPECT_NEAR(two.event["largest_displacement"].get<double>(),
                2 * one.event["largest_displacement"].get<double>(), 1e-9)
        << "linear tiles";
    EXPECT_FALSE(client.ask("remove_load_case", {{"index", 0}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("remove_load_case", {{"index", 1}})["ok"].get<bool>());
    EXPECT_TRUE(client.ask("remove_load_case", {{"index", 0}})["ok"].get<bool>());
}

TEST(StudioMessages, ALineLoadIsToldWithItsNodesEditedAndKept) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    Json load_case = Json::parse(simulation::load_case_text(test::cantilever({0, 0, -0.01})));
    load_case.erase("format");
    load_case["loads"] = {{{"side", "top"}, {"per_length", {0, 0, -2}}}};
    ASSERT_TRUE(client.ask("set_load_case", {{"index", 0}, {"load_case", load_case}})["ok"].get<bool>());
    Json changed = client.event({"changed"})["load_cases"][0];
    EXPECT_FALSE(changed.contains("format")) << "that is of files";
    const Json mark = changed["marks"]["loads"][0];
    EXPECT_FALSE(mark["nodes"].empty());
    EXPECT_EQ(mark["nodes"].size(), mark["shares"].size());
    EXPECT_NEAR(mark["force"][2].get<double>(), -2 * mark["extent"].get<double>(), 1e-12);

    // Sent back as it came, with one value edited and a load on an area beside it.
    changed["loads"][0]["per_length"] = {0, 0, -3};
    changed["loads"].push_back({{"tiles", {0}}, {"per_area", {0, 0, -1}}});
    const Json answer = client.ask("set_load_case", {{"index", 0}, {"load_case", changed}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    const Json kept = Json::parse(text_of(client))["load_cases"][0];
    EXPECT_EQ(kept["format"], "fretwork/load-case/3");
    EXPECT_EQ(kept["loads"][0], Json({{"side", "top"}, {"per_length", {0.0, 0.0, -3.0}}}));
    EXPECT_EQ(kept["loads"].size(), 2U);
}

TEST(StudioFiles, EveryExampleBendsAtOnce) {
    const RunningStudio studio;
    Client client(studio.address());
    const Json hello = client.ask("hello", {{"protocol", 1}});
    for (const Json& example : hello["examples"]) {
        ASSERT_TRUE(client.ask("new", {{"example", example["name"]}})["ok"].get<bool>());
        const Json document = client.event({"document"});
        const Solved solved = solution_of(client, document["revision"]);
        EXPECT_TRUE(solved.event["converged"].get<bool>()) << example;
        EXPECT_GT(solved.event["largest_displacement"], 0.005) << example;
    }
}

TEST(StudioFiles, TheDomeRisesBecauseItsRimIsPushedInwards) {
    const RunningStudio studio;
    Client client(studio.address());
    client.ask("hello", {{"protocol", 1}});
    const auto rise = [&](const Json& event) {
        const Solved solved = solution_of(client, event["revision"]);
        EXPECT_TRUE(solved.event["converged"].get<bool>());
        return solved.event["largest_displacement"].get<double>();
    };
    ASSERT_TRUE(client.ask("new", {{"example", "dome"}})["ok"].get<bool>());
    const Json document = client.event({"document"});
    const double pushed = rise(document);
    Json load_case = document["load_cases"][0];
    load_case.erase("marks");
    for (Json& entry : load_case["prescribed"]) {
        for (const char* dof : {"ux", "uy"})
            if (entry.contains(dof)) entry[dof] = 0.0;
    }
    ASSERT_TRUE(client.ask("set_load_case", {{"index", 0}, {"load_case", load_case}})["ok"].get<bool>());
    EXPECT_GT(pushed, 5 * rise(client.event({"changed"}))) << "the push alone";
}

TEST(StudioFiles, ANewSurfaceIsPaintedWithOnePatternThatCanBeMade) {
    const RunningStudio studio;
    Client client(studio.address());
    client.ask("hello", {{"protocol", 1}});
    const std::string square =
        R"({"format": "fretwork/outline/1", "boundary": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]})";
    const auto made = [&](double side) {
        const Json answer = client.ask(
            "new", {{"outline", {{"name", "square.json"}, {"text_base64", base::encode_base64(square)}}},
                    {"tile_size", side},
                    {"patterns", "made:one"},
                    {"discard", true}});
        EXPECT_TRUE(answer["ok"].get<bool>()) << answer;
        return std::pair(answer, client.event({"document"}));
    };
    const auto [answer, document] = made(0.02);
    EXPECT_TRUE(answer["remarks"].empty()) << answer;
    EXPECT_EQ(document["palette"].size(), 1U);
    EXPECT_EQ(std::set<int>(document["painting"].begin(), document["painting"].end()), std::set<int>{0});
    EXPECT_TRUE(client.event({"making"})["words"].empty());

    const auto [small, bare] = made(0.005);
    EXPECT_THAT(small["remarks"].dump(), HasSubstr("larger tiles or narrower bars"));
    EXPECT_EQ(bare["painting"][0], -1);
}

TEST(StudioFiles, BarsThatOverlapAreToldWithTheirPlacesAndInTheRemarkOfExports) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    // Bars six times as wide are wider than what lies between them.
    Json setting = client.event({"document"})["setting"];
    setting["section"]["I3"] = 36.0 * setting["section"]["I3"].get<double>();
    ASSERT_TRUE(client.ask("set_setting", {{"setting", setting}})["ok"].get<bool>());
    Json making = client.event({"making"});
    if (making["words"].empty())
        making = client.event({"making"});  // that of the first setting, if it was sent
    ASSERT_FALSE(making["words"].empty()) << making;
    EXPECT_FALSE(making["places"].empty());
    std::size_t listed = 0;
    for (const Json& place : making["places"]) listed += place["kind"] == "overlap" ? 1 : 0;
    EXPECT_GE(making["counts"]["overlap"].get<std::size_t>(), listed);
    EXPECT_GT(making["counts"]["overlap"].get<std::size_t>(), 0U);
    EXPECT_THAT(
        test::http(studio.port(), test::get_request("/export?token=" + studio.token() + "&to=solid.stl")),
        HasSubstr("Fretwork-Remark"));
}

TEST(StudioFiles, WhetherBarsOverlapIsToldAgainAfterAChangeThatIsTakenBack) {
    const RunningStudio studio(test::studio_project(20, 16));  // not solved before the change is taken back
    Client client(studio.address());
    client.hello();
    const Json making = client.event({"making"});
    ASSERT_TRUE(client.ask("paint", {{"tiles", {1}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(client.event({"making"})["words"], making["words"]);
}

TEST(StudioFiles, UnsavedChangesAreThereAfterARestart) {
    RunningStudio studio(test::studio_project());
    std::string text;
    {
        Client client(studio.address());
        client.hello();
        ASSERT_TRUE(client.ask("paint", {{"tiles", {1}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
        text = text_of(client);
    }
    studio.restart();
    Client client(studio.address());
    client.hello();
    EXPECT_TRUE(client.event({"document"})["recovered"].get<bool>());
    EXPECT_EQ(text_of(client), text);
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>()) << "to what lies in the file";
    EXPECT_EQ(text_of(client), base::read_text_file(studio.project_file()));
    ASSERT_TRUE(client.ask("redo")["ok"].get<bool>());
    ASSERT_TRUE(client.ask("save")["ok"].get<bool>());
    studio.restart();
    Client again(studio.address());
    again.hello();
    EXPECT_FALSE(again.event({"document"})["recovered"].get<bool>()) << "it was saved";
}

TEST(StudioJobs, AnUnknownModelIsRefusedAndTheModelsAreNamed) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    for (const char* request : {"solve", "compare"}) {
        const Json answer = client.ask(request, {{"model", "x"}});
        EXPECT_FALSE(answer["ok"].get<bool>()) << request;
        const auto error = answer.value("error", "");
        EXPECT_THAT(error, HasSubstr("'x'"));
        EXPECT_THAT(error, HasSubstr("condensed"));
        EXPECT_THAT(error, HasSubstr("full"));
    }
}

TEST(StudioWarnings, CallAnEquilibriumUnstableOnlyIfItsTestDecides) {
    simulation::SurfaceResult result;
    result.solution.stable = false;
    result.solution.stability = mechanics::StabilityTest::SymmetricPart;
    EXPECT_THAT(warnings_of(result), testing::IsEmpty());
    result.solution.stability = mechanics::StabilityTest::Tangent;
    EXPECT_THAT(warnings_of(result), testing::ElementsAre(HasSubstr("not stable")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
