// SPDX-License-Identifier: GPL-3.0-or-later
// Names and paths in messages that no file can have.
#include "running_studio.hpp"

#include <fretwork/base/files/base64.hpp>

#include <gmock/gmock.h>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using test::Client;
using test::RunningStudio;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StudioNames : public testing::Test {
  protected:
    void SetUp() override { client_.hello(); }
    /// Why a request is refused, which one line tells.
    std::string refusal(const std::string& name, const Json& more) {
        const Json answer = client_.ask(name, more);
        EXPECT_FALSE(answer["ok"].get<bool>()) << name << more;
        const std::string error = answer.value("error", "");
        EXPECT_THAT(error, AllOf(Not(HasSubstr("filesystem error")), Not(HasSubstr("\n")))) << name << more;
        EXPECT_LT(error.size(), 300U);
        return error;
    }
    [[nodiscard]] std::string in_folder(const std::string& name) const {
        return (studio_.folder() / name).string();
    }

    RunningStudio studio_{test::studio_project()};
    Client client_{studio_.address()};
};

const std::string kNul = std::string("nul\0.json", 9);
const std::string kLong = std::string(5000, 'A') + ".json";

Json outline(const std::string& name) {
    const std::string content =
        R"({"format": "fretwork/outline/1", "boundary": [[0,0],[0.2,0],[0.2,0.2],[0,0.2]]})";
    return {{"outline", {{"name", name}, {"text_base64", base::encode_base64(content)}}}};
}

TEST_F(StudioNames, APathWithNulNamesNoFile) {
    EXPECT_THAT(refusal("save", {{"path", in_folder("") + kNul}}), HasSubstr("NUL"));
    EXPECT_FALSE(std::filesystem::exists(in_folder("nul")));
    EXPECT_THAT(refusal("open", {{"path", in_folder("") + kNul}}), HasSubstr("NUL"));
    EXPECT_THAT(refusal("paint", {{"patterns", "image:" + kNul}, {"palette", "0-6"}}), HasSubstr("NUL"));
}

TEST_F(StudioNames, PathsThatAreTooLongOrEmptyAreToldInALine) {
    for (const char* request : {"save", "open"}) {
        EXPECT_THAT(refusal(request, {{"path", in_folder(kLong)}}), HasSubstr("File name too long"));
        EXPECT_THAT(refusal(request, {{"path", ""}}), HasSubstr("is empty"));
    }
}

TEST_F(StudioNames, ASentFileHasANameThatAFileCanHave) {
    for (const char* request : {"new", "measure"}) {
        EXPECT_THAT(refusal(request, outline(kNul)), HasSubstr("'nul\\x00.json' with the character NUL"));
        EXPECT_THAT(refusal(request, outline(kLong)), HasSubstr("5005 bytes"));
        EXPECT_THAT(refusal(request, outline("")), HasSubstr("is empty"));
        EXPECT_THAT(refusal(request, outline("a." + std::string(250, 'x'))), HasSubstr("this ends in"));
    }
    EXPECT_THAT(refusal("upload", {{"name", kLong}, {"text_base64", ""}}), HasSubstr("5005 bytes"));
    Json with_layout = outline("square.json");
    with_layout["layout"] = kLong;
    EXPECT_THAT(refusal("new", with_layout), HasSubstr("5005 bytes"));
    EXPECT_TRUE(client_.ask("measure", outline(std::string(250, 'A') + ".json"))["ok"].get<bool>());
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
