// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/internal/json_text.hpp>

#include <gmock/gmock.h>

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using testing::HasSubstr;

class LibraryFind : public testing::Test {
  protected:
    LibraryFind() {
        const Outcome made =
            run("fretwork enumerate --edges 2..2 --library lib.db && "
                "fretwork calibrate --starts 1 --patterns 0-1+1-6,1-6+3-6,1-3+3-6 --library lib.db");
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    Outcome run(const std::string& command) const { return run_command(command, folder_.path()); }
    test::TemporaryFolder folder_;
};

TEST_F(LibraryFind, PrintsPatternsInOrder) {
    const Outcome found = run("fretwork library find --library lib.db --sort bending_stiffness --json");
    ASSERT_EQ(found.exit_code, 0) << found.err;
    const base::Json json = base::Json::parse(found.out);
    ASSERT_EQ(json["patterns"].size(), 3U) << "patterns without properties are not found";
    for (std::size_t i = 1; i < 3; ++i)
        EXPECT_LE(json["patterns"][i - 1]["bending_stiffness"], json["patterns"][i]["bending_stiffness"]);
    const std::string softest = json["patterns"][0]["id"];
    const Outcome one = run("fretwork library find --library lib.db --sort bending_stiffness --limit 1");
    EXPECT_THAT(one.out, HasSubstr(softest));
    EXPECT_THAT(one.out, HasSubstr("1 of 3 patterns"));
}

TEST_F(LibraryFind, NamesTheOptionOfAnExpressionThatIsNone) {
    const Outcome wrong = run("fretwork library find --library lib.db --where 'bending > 1'");
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("--where: 'bending > 1'"));
    EXPECT_THAT(wrong.err, HasSubstr("no such column: bending"));
    const Outcome comment = run("fretwork library find --library lib.db --where 'edges --3 = 6'");
    EXPECT_EQ(comment.exit_code, 2);
    EXPECT_THAT(comment.err, HasSubstr("-- begins a comment"));
    EXPECT_EQ(run("fretwork library find --library lib.db --sort 1,2").exit_code, 2);
    EXPECT_EQ(run("fretwork library find --library lib.db --limit 0").exit_code, 2);
    EXPECT_EQ(run("fretwork library find --where 1").exit_code, 2);
}

using LibraryExport = LibraryFind;

TEST_F(LibraryExport, OfStiffnessIsRepeatedAndReplacesNoOther) {
    const std::string command = "fretwork library export --library lib.db --stiffness s --patterns ";
    ASSERT_EQ(run(command + "computed").exit_code, 0);
    const auto file = [&](const char* name) { return base::read_text_file(folder_.path() / "s" / name); };
    const std::string array = file("stiffness.npy");
    EXPECT_EQ(file("patterns.txt"), "0-1+1-6\n1-3+3-6\n1-6+3-6\n") << "those with responses";
    const Outcome again = run(command + "computed");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    for (const char* patterns : {"0-1+1-6", "all"}) {
        const Outcome other = run(command + patterns);
        EXPECT_EQ(other.exit_code, 2) << patterns;
        EXPECT_THAT(other.err, HasSubstr("is there with other content")) << patterns;
    }
    EXPECT_EQ(file("stiffness.npy"), array);
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
