// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork case, as a person runs it.
#include "cli/command.hpp"
#include "support.hpp"

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using testing::AllOf;
using testing::HasSubstr;

class CaseCommand : public testing::Test {
  protected:
    CaseCommand() {
        EXPECT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 "
                      "--out p.json")
                      .exit_code,
                  0);
        folder_.file("tip.json", R"({"format": "fretwork/load-case/1", "name": "tip",
            "supports": [{"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
            "loads": [{"side": "right", "force": [0, 0, -0.01]}]})");
        folder_.file("both.json", R"({"format": "fretwork/load-case/2", "name": "both",
            "combines": [{"load_case": "tip", "factor": 2}]})");
    }
    [[nodiscard]] Outcome run(const std::string& command) const {
        return run_command(command, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(CaseCommand, TellsWhatEachEntryPicked) {
    const Outcome added = run("fretwork case add p.json tip.json");
    EXPECT_EQ(added.exit_code, 0);
    EXPECT_EQ(added.err, "");
    EXPECT_THAT(added.out, testing::ContainsRegex("support +left: [0-9]+ nodes  holds ux uy uz rx ry rz"));
    EXPECT_EQ(run("fretwork case show p.json tip").out, added.out);
    EXPECT_THAT(run("fretwork case show p.json tip --json").out, HasSubstr("fretwork/load-case/1"));
}

TEST_F(CaseCommand, QuestionsPointsThatLieOutside) {
    folder_.file("far.json", R"({"format": "fretwork/load-case/1", "name": "far",
        "loads": [{"nearest": [[280, 190]], "force": [0, 0, -0.01]}]})");
    const Outcome added = run("fretwork case add p.json far.json");
    EXPECT_EQ(added.exit_code, 0);
    EXPECT_THAT(added.err, AllOf(HasSubstr("is that meant?"), HasSubstr("(280, 190)")));
    EXPECT_EQ(std::count(added.err.begin(), added.err.end(), '\n'), 1);
}

TEST_F(CaseCommand, ACaseThatOthersCombineDoesNotBecomeACombination) {
    folder_.file("other.json", R"({"format": "fretwork/load-case/1", "name": "other",
        "loads": [{"side": "right", "force": [0, 0.01, 0]}]})");
    folder_.file("new_tip.json", R"({"format": "fretwork/load-case/2", "name": "tip",
        "combines": [{"load_case": "other", "factor": 1}]})");
    for (const std::string file : {"tip.json", "other.json", "both.json"})
        ASSERT_EQ(run("fretwork case add p.json " + file).exit_code, 0) << file;
    const Outcome refused = run("fretwork case add p.json new_tip.json --replace");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("p.json"), HasSubstr("'tip' is a combination, too")));
    EXPECT_EQ(run("fretwork case list p.json").exit_code, 0) << "the project can still be read";
    ASSERT_EQ(run("fretwork case remove p.json both").exit_code, 0);
    EXPECT_EQ(run("fretwork case add p.json new_tip.json --replace").exit_code, 0) << "nothing combines it";
}

TEST_F(CaseCommand, ErrorsNameTheFileOfTheLoadCase) {
    folder_.file("push.json", R"({"format": "fretwork/load-case/4", "name": "push",
        "loads": [{"circle": {"center": [9, 8], "radius": 0.01}, "force": [0, 0, -1]}]})");
    folder_.file("sum.json", R"({"format": "fretwork/load-case/2", "name": "sum",
        "combines": [{"load_case": "push", "factor": 1}]})");
    folder_.file("self.json", R"({"format": "fretwork/load-case/2", "name": "self",
        "combines": [{"load_case": "self", "factor": 1}]})");
    for (const std::string command :
         {"case add p.json push.json", "simulate p.json --case push.json --out r.json"})
        EXPECT_THAT(run("fretwork " + command).err,
                    HasSubstr("fretwork: push.json: load case 'push': /loads/0: no interface node lies in"));
    for (const std::string command :
         {"case add p.json sum.json", "simulate p.json --case sum.json --out r.json"})
        EXPECT_THAT(
            run("fretwork " + command).err,
            HasSubstr(
                "fretwork: sum.json: load case 'sum': /combines/0/load_case: unknown load case 'push'"));
    EXPECT_THAT(
        run("fretwork case add p.json self.json").err,
        AllOf(HasSubstr("fretwork: self.json: "), HasSubstr("/combines/0/load_case: "), HasSubstr("itself")));
    EXPECT_EQ(run("fretwork case list p.json").out, "") << "none is added";
}

TEST_F(CaseCommand, RemovesAndRenames) {
    ASSERT_EQ(run("fretwork case add p.json tip.json && fretwork case add p.json both.json").exit_code, 0);
    const Outcome kept = run("fretwork case remove p.json tip");
    EXPECT_EQ(kept.exit_code, 2) << "a combination needs it";
    EXPECT_THAT(kept.err, HasSubstr("both"));
    ASSERT_EQ(run("fretwork case rename p.json tip end").exit_code, 0);
    EXPECT_THAT(run("fretwork case show p.json both --json").out, HasSubstr("\"end\""));
    EXPECT_EQ(run("fretwork case rename p.json end both").exit_code, 2);
    ASSERT_EQ(run("fretwork case remove p.json both && fretwork case remove p.json end").exit_code, 0);
    EXPECT_EQ(run("fretwork case list p.json").out, "");
    const Outcome none = run("fretwork case remove p.json tip");
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, HasSubstr("load case"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
