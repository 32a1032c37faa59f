// SPDX-License-Identifier: GPL-3.0-or-later
// Changes that were not saved, when a server ends or another document is opened.
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <studio/document/autosave.hpp>

#include <gmock/gmock.h>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using test::Client;
using test::RunningStudio;
using testing::HasSubstr;

Json recoverable(Client& client) {
    return client.ask("recoverable")["recoverable"];
}

std::string text_of(Client& client) {
    return client.ask("download")["text"].get<std::string>();
}

void paint(Client& client) {
    ASSERT_TRUE(client.ask("paint", {{"tiles", {1}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
}

Json square() {
    const std::string content =
        R"({"format": "fretwork/outline/1", "boundary": [[0,0],[0.2,0],[0.2,0.2],[0,0.2]]})";
    return {{"outline", {{"name", "square.json"}, {"text_base64", base::encode_base64(content)}}},
            {"tile_size", 0.026},
            {"patterns", "0-1+1-6"}};
}

/// A server without a project, and a project beside it.
class StudioRecovery : public testing::Test {
  protected:
    StudioRecovery() { simulation::write_project(test::studio_project(), file_); }
    void open(Client& client) const {
        client.hello();
        ASSERT_TRUE(client.ask("open", {{"path", file_.string()}})["ok"].get<bool>());
    }
    RunningStudio studio_;
    std::filesystem::path file_ = studio_.folder() / "bridge.json";
};

TEST_F(StudioRecovery, OffersEveryDocumentThatWasNotSaved) {
    std::string changed;
    {
        Client client(studio_.address());
        open(client);
        paint(client);
        changed = text_of(client);
        ASSERT_TRUE(client.ask("new", square())["ok"].get<bool>());
    }
    studio_.restart();
    Client client(studio_.address());
    const Json hello = client.ask("hello", {{"protocol", 1}});
    ASSERT_EQ(hello["recoverable"].size(), 2U);
    std::map<std::string, Json> by_name;
    for (const Json& one : hello["recoverable"]) by_name[one["name"]] = one;
    ASSERT_TRUE(by_name.contains("bridge") && by_name.contains("square")) << hello;
    EXPECT_EQ(by_name["bridge"]["path"], file_.string());
    EXPECT_TRUE(by_name["square"]["path"].is_null());
    EXPECT_GT(by_name["square"]["time"], 1.7e9) << "seconds since 1970";

    ASSERT_TRUE(client.ask("recover", {{"key", by_name["bridge"]["key"]}})["ok"].get<bool>());
    EXPECT_EQ(text_of(client), changed);
    ASSERT_TRUE(client.ask("undo")["ok"].get<bool>());
    EXPECT_EQ(text_of(client), base::read_text_file(file_)) << "to what lies in the file";
    ASSERT_EQ(recoverable(client).size(), 1U) << "what is shown is not offered";
}

TEST_F(StudioRecovery, WhatWasNotSavedIsThereIfTheFileIsDamaged) {
    std::string changed;
    {
        Client client(studio_.address());
        open(client);
        paint(client);
        changed = text_of(client);
    }
    studio_.restart();
    base::write_file_atomically(file_, R"({"format": "fretwork/project/2", "layout": )");
    Client client(studio_.address());
    client.hello();
    EXPECT_FALSE(client.ask("open", {{"path", file_.string()}})["ok"].get<bool>());
    const Json found = recoverable(client);
    ASSERT_EQ(found.size(), 1U);
    const Json answer = client.ask("recover", {{"key", found[0]["key"]}});
    ASSERT_TRUE(answer["ok"].get<bool>()) << answer;
    EXPECT_EQ(text_of(client), changed);
    EXPECT_THAT(client.event({"warning"})["text"].get<std::string>(), HasSubstr("bridge.json"));
}

TEST_F(StudioRecovery, AutosavesAreReadStrictly) {
    {
        Client client(studio_.address());
        open(client);
        paint(client);
    }
    studio_.restart();
    const auto found = find_recoverable(studio_.folder() / "state");
    ASSERT_EQ(found.size(), 1U);
    const std::string text = base::read_text_file(found[0].file);
    const auto project = parse_autosave(text, "kept.json");
    EXPECT_EQ(project.tessellation.tiles.size(), found[0].tiles);
    const std::string more = "{\"surprise\": 1, " + text.substr(1);
    EXPECT_THROW((void)parse_autosave(more, "kept.json"), base::InputError);
    const std::string own = "\"project\": {";  // its errors have the place in the autosave
    std::string inner = text;
    inner.insert(text.find(own) + own.size(), "\"surprise\": 1, ");
    EXPECT_THAT(test::complaint_of([&] { (void)parse_autosave(inner, "kept.json"); }),
                HasSubstr("kept.json: /project/surprise: unknown key"));
    EXPECT_THROW((void)parse_autosave(text.substr(0, text.size() / 2), "kept.json"), base::InputError);
}

TEST_F(StudioRecovery, NewDocumentsDoNotOverwriteOneAnother) {
    Client client(studio_.address());
    client.hello();
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(client.ask("new", square())["ok"].get<bool>());
    studio_.restart();
    Client again(studio_.address());
    again.hello();
    EXPECT_EQ(recoverable(again).size(), 3U);
}

TEST_F(StudioRecovery, WhatIsDroppedIsGone) {
    {
        Client client(studio_.address());
        client.hello();
        ASSERT_TRUE(client.ask("new", square())["ok"].get<bool>());
    }
    studio_.restart();
    Client client(studio_.address());
    client.hello();
    const Json key = recoverable(client)[0]["key"];
    EXPECT_EQ(client.ask("forget", {{"key", key}})["recoverable"].size(), 0U);
    EXPECT_FALSE(client.ask("recover", {{"key", key}})["ok"].get<bool>());
    EXPECT_FALSE(client.ask("forget", {{"key", "../bridge"}})["ok"].get<bool>());
    EXPECT_TRUE(std::filesystem::exists(file_));
}

TEST_F(StudioRecovery, WhatIsDiscardedWhenAnotherDocumentIsOpenedIsGone) {
    Client client(studio_.address());
    open(client);
    paint(client);
    Json request = square();
    request["discard"] = true;
    ASSERT_TRUE(client.ask("new", request)["ok"].get<bool>());
    EXPECT_EQ(recoverable(client).size(), 0U);
    ASSERT_TRUE(client.ask("open", {{"path", file_.string()}})["ok"].get<bool>());
    EXPECT_FALSE(client.event({"document"})["recovered"].get<bool>());
    studio_.restart();
    Client again(studio_.address());
    again.hello();
    EXPECT_EQ(recoverable(again).size(), 1U) << "the square was not discarded";
}

TEST_F(StudioRecovery, ExamplesAndSentFilesThatNobodyChangedAreNoWorkToBeLost) {
    Client client(studio_.address());
    client.hello();
    ASSERT_TRUE(client.ask("new", {{"example", "leaf"}})["ok"].get<bool>());
    EXPECT_TRUE(client.event({"document"})["saved"].get<bool>());
    const std::string project = base::encode_base64(base::read_text_file(file_));
    ASSERT_TRUE(client.ask("upload", {{"name", "sent.json"}, {"text_base64", project}})["ok"].get<bool>());
    EXPECT_TRUE(client.event({"document"})["saved"].get<bool>());
    paint(client);
    EXPECT_FALSE(client.event({"changed"})["saved"].get<bool>());
    studio_.restart();
    Client again(studio_.address());
    again.hello();
    const Json found = recoverable(again);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0]["name"], "sent");
}

TEST_F(StudioRecovery, AnEditThatChangesNothingIsNoStepOfUndo) {
    Client client(studio_.address());
    open(client);
    const Json document = client.event({"document"});
    const auto pattern = document["painting"][0].get<std::size_t>();
    const Json edits = {{{"do", "set_model"}, {"model", document["model"]}},
                        {{"do", "set_setting"}, {"setting", document["setting"]}},
                        {{"do", "set_load_case"}, {"index", 0}, {"load_case", document["load_cases"][0]}},
                        {{"do", "set_tile_model"}, {"tiles", {0}}, {"model", ""}},
                        {{"do", "turn"}, {"tiles", {0}}, {"by", 6}},
                        {{"do", "paint"}, {"tiles", {0}}, {"pattern", document["palette"][pattern]}}};
    for (const Json& edit : edits) {
        const Json answer = client.ask(edit["do"], edit);
        EXPECT_TRUE(answer.value("unchanged", false)) << edit << answer;
    }
    EXPECT_FALSE(client.ask("undo")["ok"].get<bool>());
}

TEST_F(StudioRecovery, ErrorsAreWordsAndNotPlacesInMessages) {
    Client client(studio_.address());
    open(client);
    const auto error_of = [&](const std::string& name, const Json& more) {
        return client.ask(name, more)["error"].get<std::string>();
    };
    EXPECT_EQ(error_of("paint", {{"tiles", {0}}, {"pattern", "0-99"}}),
              "pattern: '0-99' is not a candidate edge of the layout 'paper7'");
    const Json nowhere = {{"format", "fretwork/load-case/1"},
                          {"name", "far"},
                          {"supports", {{{"box", {5, 5, 6, 6}}, {"fixed", {"ux"}}}}}};
    EXPECT_THAT(error_of("set_load_case", {{"index", 0}, {"load_case", nowhere}}),
                HasSubstr("support 1: no"));
    EXPECT_EQ(error_of("open", {{"path", "/no/such/loads"}}),
              "/no/such/loads: cannot be read: No such file or directory");
    ASSERT_TRUE(client.ask("set_model", {{"model", "paper6"}})["ok"].get<bool>());
    EXPECT_THAT(client.event({"failed"})["error"].get<std::string>(), HasSubstr("Choose another model"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
