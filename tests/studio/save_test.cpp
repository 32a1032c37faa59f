// SPDX-License-Identifier: GPL-3.0-or-later
// Nobody's work is lost where several programs write one project.
#include "running_studio.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/file_lock.hpp>

#include <gmock/gmock.h>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using simulation::Project;
using test::Client;
using test::RunningStudio;
using testing::HasSubstr;

/// As `fretwork case add` does.
void add_case_elsewhere(const std::filesystem::path& file, const std::string& name) {
    Project project = simulation::read_project(file);
    project.load_cases.push_back(project.load_cases.front());
    project.load_cases.back().name = name;
    simulation::write_project(project, file);
}

Json paint_first(Client& client, const std::string& pattern = "0-6") {
    return client.ask("paint", {{"tiles", {0}}, {"pattern", pattern}});
}

TEST(StudioSave, WhatAnotherProgramWroteIsNotReplacedWithoutAQuestion) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    add_case_elsewhere(studio.project_file(), "elsewhere");
    const std::string theirs = base::read_text_file(studio.project_file());
    ASSERT_TRUE(paint_first(client)["ok"].get<bool>());

    const Json refused = client.ask("save");
    ASSERT_FALSE(refused["ok"].get<bool>());
    EXPECT_THAT(refused["error"].get<std::string>(), HasSubstr("was changed by another program"));
    EXPECT_EQ(refused["conflict"]["reason"], "changed");
    EXPECT_EQ(refused["conflict"]["path"], studio.project_file().string());
    EXPECT_EQ(base::read_text_file(studio.project_file()), theirs);

    const Json replaced = client.ask("save", {{"replaces", refused["conflict"]["hash"]}});
    ASSERT_TRUE(replaced["ok"].get<bool>()) << replaced;
    EXPECT_EQ(simulation::read_project(studio.project_file()).load_cases.size(), 1U);
    ASSERT_TRUE(paint_first(client, "0-1+1-6")["ok"].get<bool>());
    EXPECT_TRUE(client.ask("save")["ok"].get<bool>()) << "the file is known again";
}

TEST(StudioSave, WhoHasSeenOneChangeDoesNotReplaceTheNext) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    add_case_elsewhere(studio.project_file(), "first");
    const Json refused = client.ask("save");
    add_case_elsewhere(studio.project_file(), "second");
    const Json again = client.ask("save", {{"replaces", refused["conflict"]["hash"]}});
    EXPECT_FALSE(again["ok"].get<bool>());
    EXPECT_NE(again["conflict"]["hash"], refused["conflict"]["hash"]);
    EXPECT_EQ(simulation::read_project(studio.project_file()).load_cases.size(), 3U);
}

TEST(StudioSave, TheirsIsKeptByOpeningTheFileAgain) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(paint_first(client)["ok"].get<bool>());
    add_case_elsewhere(studio.project_file(), "elsewhere");
    ASSERT_FALSE(client.ask("save")["ok"].get<bool>());
    ASSERT_TRUE(
        client.ask("open", {{"path", studio.project_file().string()}, {"discard", true}})["ok"].get<bool>());
    const Json project = Json::parse(client.ask("download")["text"].get<std::string>());
    EXPECT_EQ(project["load_cases"].size(), 2U);
    EXPECT_TRUE(client.ask("save")["ok"].get<bool>());
}

TEST(StudioSave, TwoStudiosOnOneFileKeepBothPeoplesWork) {
    const RunningStudio one(test::studio_project());
    Client first(one.address());
    first.hello();
    const RunningStudio two;
    Client second(two.address());
    second.hello();
    ASSERT_TRUE(second.ask("open", {{"path", one.project_file().string()}})["ok"].get<bool>());
    ASSERT_TRUE(paint_first(first)["ok"].get<bool>());
    ASSERT_TRUE(first.ask("save")["ok"].get<bool>());
    ASSERT_TRUE(second.ask("paint", {{"tiles", {1}}, {"pattern", "0-6"}})["ok"].get<bool>());
    const Json refused = second.ask("save");
    EXPECT_FALSE(refused["ok"].get<bool>());
    EXPECT_EQ(refused["conflict"]["reason"], "changed");
}

TEST(StudioSave, AnotherProjectIsNotReplacedWithoutAQuestion) {
    const RunningStudio studio(test::studio_project());
    const auto other = studio.folder() / "other.json";
    simulation::write_project(test::studio_project(5, 3), other);
    const std::string theirs = base::read_text_file(other);
    Client client(studio.address());
    client.hello();
    const Json refused = client.ask("save", {{"path", other.string()}});
    ASSERT_FALSE(refused["ok"].get<bool>());
    EXPECT_EQ(refused["conflict"]["reason"], "exists");
    EXPECT_EQ(base::read_text_file(other), theirs);
    EXPECT_TRUE(client.ask("save", {{"path", (studio.folder() / "third.json").string()}})["ok"].get<bool>());
    EXPECT_TRUE(
        client.ask("save", {{"path", other.string()}, {"replaces", refused["conflict"]["hash"]}})["ok"]
            .get<bool>());
    EXPECT_NE(base::read_text_file(other), theirs);
}

TEST(StudioSave, WaitsForNobodyWhoHoldsTheFile) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    ASSERT_TRUE(paint_first(client)["ok"].get<bool>());
    {
        const base::FileLock lock(studio.project_file());
        const Json refused = client.ask("save");
        EXPECT_FALSE(refused["ok"].get<bool>());
        EXPECT_THAT(refused["error"].get<std::string>(), HasSubstr("being written by another program"));
    }
    EXPECT_TRUE(client.ask("save")["ok"].get<bool>());
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
