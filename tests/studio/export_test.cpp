// SPDX-License-Identifier: GPL-3.0-or-later
// A file shows what the page shows, whatever was done before.
#include "running_studio.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <studio/server/background.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using exports::WriterRow;
using simulation::Project;
using test::Client;
using test::RunningStudio;
using test::Wire;
using testing::HasSubstr;

Json load_case_json(double force, const std::string& name = "cantilever") {
    Json json = Json::parse(simulation::load_case_text(test::cantilever({0, 0, force})));
    json["name"] = name;
    return json;
}

struct Download {
    int status;
    std::string body;
};

Download exported(const RunningStudio& studio, const WriterRow& writer) {
    const std::string answer = test::http(
        studio.port(),
        test::get_request("/export?token=" + studio.token() + "&to=file" + std::string(writer.ending) +
                          "&content=" + std::string(content_name(writer.content)) + "&size=64x40"));
    return {test::status_of(answer), answer.substr(answer.find("\r\n\r\n") + 4)};
}

/// The state that the page shows: the document as it would be saved, with its live model and its selected
/// load case.
exports::Scene scene_of(Client& client, const std::string& model, std::size_t load_case) {
    const auto project =
        simulation::parse_project(client.ask("download")["text"].get<std::string>(), "the page");
    exports::Scene scene{simulation::make_surface(project, nullptr)};
    scene.load_case = project.load_cases.at(load_case);
    scene.conditions = simulation::resolve(*scene.load_case, scene.surface);
    scene.picture.size = {64, 40};
    scene.results.push_back({model, simulation::simulate(scene.surface, *scene.load_case, {.model = model})});
    return scene;
}

/// The largest displacement in a table of nodes.
double largest_in(const std::string& csv) {
    double largest = 0.0;
    const auto lines = base::split(csv, '\n');
    const auto names = base::split(lines.at(0), ',');
    const auto first = static_cast<std::size_t>(std::ranges::find(names, "ux_m") - names.begin());
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto values = base::split(lines[i], ',');
        if (values.size() <= first + 2) continue;
        double square = 0.0;
        for (std::size_t k = 0; k < 3; ++k) square += std::pow(std::stod(std::string(values[first + k])), 2);
        largest = std::max(largest, std::sqrt(square));
    }
    return largest;
}

void expect_exports_of_what_is_shown(const RunningStudio& studio, Client& client, const std::string& model,
                                     std::size_t load_case) {
    const exports::Scene shown = scene_of(client, model, load_case);
    exports::Scene at_rest = shown;
    at_rest.results.clear();
    const double wanted = largest_in(exports::find_writer("file.csv").write(shown).text);
    ASSERT_GT(wanted, 0.0);
    for (const WriterRow& writer : exports::writer_catalogue()) {
        const Download file = exported(studio, writer);
        ASSERT_EQ(file.status, 200) << writer.ending << ": " << file.body;
        if (writer.shows_results()) {
            EXPECT_NE(file.body, writer.write(at_rest).text) << writer.ending;
        }
        if (writer.ending == ".csv") {
            EXPECT_NEAR(largest_in(file.body), wanted, 1e-6 * wanted);
        }
    }
}

TEST(StudioExports, EveryKindOfFileShowsTheAnswerAfterEveryKindOfAction) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    std::string model = "corotational";
    std::size_t load_case = 0;
    const std::string other_file = (studio.folder() / "other.json").string();
    struct Action {
        const char* name;
        std::string request;
        Json more;
    };
    const Action actions[] = {
        {"nothing yet", "recoverable", Json::object()},
        {"save", "save", Json::object()},
        {"paint", "paint", {{"tiles", {1, 2}}, {"pattern", "0-1+1-5+1-6+5-6"}}},
        {"save what was painted", "save", Json::object()},
        {"turn", "turn", {{"tiles", {1}}, {"by", 1}}},
        {"undo", "undo", Json::object()},
        {"redo", "redo", Json::object()},
        {"save as another file", "save", {{"path", other_file}}},
        {"a load", "set_load_case", {{"index", 0}, {"load_case", load_case_json(-0.02)}}},
        {"a second load case",
         "set_load_case",
         {{"index", 1}, {"load_case", load_case_json(0.005, "upwards")}}},
        {"the first load case", "select_load_case", {{"index", 0}}},
        {"another model", "set_model", {{"model", "condensed"}}},
        {"save with another model", "save", Json::object()},
        {"the full model beside it", "solve", {{"model", "full"}, {"background", true}}},
        {"modes", "modes", {{"count", 2}}},
        {"buckling", "buckling", {{"count", 1}}},
        {"comparison", "compare", {{"model", "full"}}},
        {"open", "open", {{"path", other_file}}},
    };
    for (const Action& action : actions) {
        SCOPED_TRACE(action.name);
        const Json answer = client.ask(action.request, action.more);
        ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
        if (action.request == "set_model") model = action.more["model"].get<std::string>();
        if (action.request == "open") model = "corotational";
        if (action.more.contains("index")) load_case = action.more["index"].get<std::size_t>();
        expect_exports_of_what_is_shown(studio, client, model, load_case);
    }
}

TEST(StudioExports, AMixedModelIsShownWithItsFullTiles) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "mixed:0.25"}})["ok"].get<bool>());
    for (const WriterRow& writer : exports::writer_catalogue()) {
        const Download file = exported(studio, writer);
        EXPECT_EQ(file.status, 200) << writer.ending << ": " << file.body;
    }
}

TEST(StudioExports, WithoutAnAnswerFilesThatWouldShowItAreRefusedWithTheReason) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    Json not_held = load_case_json(-0.01);
    not_held["supports"] = Json::array();
    ASSERT_TRUE(client.ask("set_load_case", {{"index", 0}, {"load_case", not_held}})["ok"].get<bool>());
    for (const WriterRow& writer : exports::writer_catalogue()) {
        const Download file = exported(studio, writer);
        if (writer.shows_results()) {
            EXPECT_EQ(file.status, 422) << writer.ending;
            EXPECT_THAT(file.body, HasSubstr("there is no answer to export: ")) << writer.ending;
        } else {
            EXPECT_EQ(file.status, 200) << writer.ending << ": " << file.body;
        }
    }
}

TEST(StudioExport, RefusalsAreOneLineAndUnknownKeysAreRefused) {
    const RunningStudio studio(test::studio_project());
    const auto refusal = [&](const std::string& query) {
        const std::string answer =
            test::http(studio.port(), test::get_request("/export?token=" + studio.token() + "&" + query));
        EXPECT_EQ(test::status_of(answer), 422) << query;
        const std::string body = answer.substr(answer.find("\r\n\r\n") + 4);
        EXPECT_EQ(std::ranges::count(body, '\n'), 1) << query;
        EXPECT_EQ(std::ranges::count(body, '\r'), 0) << query;
        EXPECT_LT(body.size(), 600U) << query;
        return body;
    };
    EXPECT_THAT(refusal("to=a.svg&foo=bar"), HasSubstr("'foo'"));
    EXPECT_THAT(refusal("to=project.json&foo=bar"), HasSubstr("'foo'"));
    EXPECT_THAT(refusal("to=a.svg&siez=1x1"), HasSubstr("size"));
    EXPECT_THAT(refusal("to=a%0d%0ab.xyz%0d%0a"), HasSubstr("\\x0d"));
    EXPECT_THAT(refusal("to=a.svg&view=%0d%0aside"), HasSubstr("\\x0d"));
    refusal("to=a.svg&" + std::string(5000, 'k') + "=1");
    refusal("to=" + std::string(5000, 'n') + ".xyz");
}

TEST(StudioExports, MoreThanCanWaitAreRefusedWhenTheAnswerComesAndTheServerGoesOn) {
    Project project = test::studio_project(20, 20);
    project.load_cases.front() = test::cantilever({0.0, 0.0, -1e-6});  // full beams: solved for a while
    const RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(client.ask("set_model", {{"model", "full"}})["ok"].get<bool>());
    std::vector<std::unique_ptr<Wire>> wires;
    for (std::size_t i = 0; i < Background::kMostWaiting + 8; ++i) {
        wires.push_back(std::make_unique<Wire>(studio.port()));
        wires.back()->send(test::get_request("/export?token=" + studio.token() + "&to=file.csv"));
    }
    for (const auto& wire : wires)
        EXPECT_THAT(test::status_of(wire->receive_all()), testing::AnyOf(200, 422));
    EXPECT_TRUE(client.ask("recoverable")["ok"].get<bool>());
}

/// The targets of an animated glTF.
std::size_t states_in(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    return Json::parse(glb.substr(20, length))["meshes"][0]["primitives"][0]["targets"].size();
}

TEST(StudioExport, AMovingFileHasTheStepsThatItIsAskedFor) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const auto glb = [&](const std::string& more) {
        const std::string answer = test::http(
            studio.port(), test::get_request("/export?token=" + studio.token() + "&to=a.glb" + more));
        EXPECT_EQ(test::status_of(answer), 200);
        return answer.substr(answer.find("\r\n\r\n") + 4);
    };
    ASSERT_TRUE(client.ask("set_model", {{"model", "corotational"}})["ok"].get<bool>());
    EXPECT_EQ(states_in(glb("")), 1U);
    EXPECT_EQ(states_in(glb("&steps=5")), 5U);
    ASSERT_TRUE(client.ask("set_model", {{"model", "condensed"}})["ok"].get<bool>());
    EXPECT_EQ(states_in(glb("&steps=5")), 1U) << "the path of a linear model is straight";
    const std::string refused =
        test::http(studio.port(), test::get_request("/export?token=" + studio.token() + "&to=a.glb&steps=1"));
    EXPECT_EQ(test::status_of(refused), 422);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
