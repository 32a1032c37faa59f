// SPDX-License-Identifier: GPL-3.0-or-later
// What a page sees of the folders of the server's machine.
#include "running_studio.hpp"

#include <fretwork/base/files/file.hpp>
#include <studio/files/folder_listing.hpp>

#include <gmock/gmock.h>

#include <unistd.h>

namespace fretwork::studio {
namespace THIS_TEST {

namespace fs = std::filesystem;
using base::Json;
using test::Client;
using test::RunningStudio;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names(const Json& entries) {
    std::vector<std::string> names;
    for (const Json& entry : entries) names.push_back(entry["name"]);
    return names;
}

class Folders : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* folder : {"b", "a", ".hidden"}) fs::create_directory(place() / folder);
        for (const char* file : {"z.json", "y.svg", ".x.json", "a/inner.json"})
            base::write_file_atomically(place() / file, "{}");
    }
    [[nodiscard]] fs::path place() const { return folder_.path(); }
    fretwork::test::TemporaryFolder folder_;
};

TEST_F(Folders, ListFoldersAndFilesWithFittingEndingsByName) {
    const Json listing = folder_listing(place(), {".json"}, {});
    EXPECT_THAT(names(listing["folders"]), ElementsAre("a", "b"));
    EXPECT_THAT(names(listing["files"]), ElementsAre("z.json"));
    EXPECT_EQ(listing["path"], place().string());
    EXPECT_EQ(listing["parent"], place().parent_path().string());
    EXPECT_EQ(listing["files"][0]["path"], (place() / "z.json").string());
    EXPECT_GT(listing["files"][0]["time"].get<std::int64_t>(), 1'600'000'000);
    EXPECT_EQ(listing["left_out"], 0);
    EXPECT_THAT(names(folder_listing(place(), {}, {})["files"]), ElementsAre("y.svg", "z.json"));
}

TEST_F(Folders, EndAtTheTop) {
    EXPECT_TRUE(folder_listing("/", {}, {})["parent"].is_null());
    EXPECT_EQ(folder_listing("/usr/", {}, {})["parent"], "/");
}

TEST_F(Folders, ListNoMoreThanTwoThousandEntries) {
    for (int i = 0; i < 2003; ++i) fs::create_directory(place() / ("many" + std::to_string(i)));
    const Json listing = folder_listing(place(), {}, {});
    EXPECT_EQ(listing["folders"].size() + listing["files"].size(), 2000U);
    EXPECT_EQ(listing["left_out"], 2 + 2003 + 2 - 2000);
}

TEST_F(Folders, ThatCannotBeReadAreRefusedInALine) {
    const RunningStudio studio;
    Client client(studio.address());
    client.hello();
    const auto refusal = [&](const fs::path& path) {
        const Json answer = client.ask("folder", {{"path", path.string()}});
        EXPECT_FALSE(answer["ok"].get<bool>());
        return answer["error"].get<std::string>();
    };
    EXPECT_THAT(refusal(place() / "z.json"), HasSubstr("not a folder"));
    EXPECT_THAT(refusal(place() / "nowhere"), HasSubstr("not a folder"));
    if (geteuid() == 0) return;  // root reads everything
    fs::permissions(place() / "a", fs::perms::none);
    EXPECT_THAT(refusal(place() / "a"), HasSubstr("cannot be read"));
    fs::permissions(place() / "a", fs::perms::owner_all);
}

TEST(StudioFolder, IsThatOfTheDocumentAtFirst) {
    const RunningStudio studio(test::studio_project());
    Client client(studio.address());
    client.hello();
    const Json answer = client.ask("folder", {{"endings", {".json"}}});
    ASSERT_TRUE(answer["ok"].get<bool>());
    EXPECT_EQ(answer["path"], studio.folder().string());
    EXPECT_THAT(names(answer["files"]), ElementsAre("project.json"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
