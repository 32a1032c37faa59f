// SPDX-License-Identifier: GPL-3.0-or-later
// The terminal gets one short line for a mistake, and nothing that it would obey.
#include "cli/command.hpp"
#include "output.hpp"
#include "support.hpp"
#include "verbs/solve_output.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

// An escape sequence, the same as a C1 control, a mark that turns the direction of writing, a backspace.
constexpr const char* kHarmful = "\\u001b[31m\\u009b31m\\u202e\\b";

class Messages : public testing::Test {
  protected:
    test::Outcome run(const std::string& command) { return run_command(command, folder_.path()); }
    void expect_one_short_line(const std::string& command) {
        const auto outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command.substr(0, 200);
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_LE(outcome.err.size(), 301U) << outcome.err;
        EXPECT_EQ(base::printable(outcome.err.substr(0, outcome.err.size() - 1)) + "\n", outcome.err);
        EXPECT_EQ(outcome.out, "");
    }
    TemporaryFolder folder_;
};

TEST_F(Messages, AreShortHoweverLongTheInput) {
    const std::string text(5000, 'x');
    const auto file = [&](const std::string& name, const std::string& content) {
        (void)folder_.file(name, content);
    };
    file("key.json", "{\"format\": \"fretwork/frame/1\", \"" + text + "\": 1}");
    file("value.json", "{\"format\": \"fretwork/frame/1\", \"nodes\": \"" + text + "\"}");
    file("format.json", "{\"format\": \"" + text + "\"}");
    file("token.json", "{\"format\": " + text + "}");
    file("number.json", "{\"format\": 1" + std::string(5000, '0') + "}");
    file("known.csv", text + "\n");
    for (const char* name : {"key", "value", "format", "token", "number"})
        expect_one_short_line("fretwork solve " + std::string(name) + ".json --out r.json");
    expect_one_short_line("fretwork solve " + text + ".json --out r.json");
    expect_one_short_line("fretwork solve a.json --out " + text + ".json");
    expect_one_short_line("fretwork enumerate --layout " + text);
    expect_one_short_line("fretwork enumerate --edges " + text);
    expect_one_short_line("fretwork enumerate --" + text);
    expect_one_short_line("fretwork " + text);
    expect_one_short_line("fretwork optimizers run --known known.csv --out o");
}

TEST_F(Messages, PassOnNothingThatATerminalObeys) {
    (void)folder_.file("key.json", std::string("{\"") + kHarmful + "\": 1}");
    (void)folder_.file("value.json", std::string("{\"format\": \"") + kHarmful + "\"}");
    (void)folder_.file("raw.json", "{\"format\": \x1b[31m}");
    for (const char* name : {"key", "value", "raw"})
        expect_one_short_line("fretwork solve " + std::string(name) + ".json --out r.json");
}

TEST_F(Messages, AreNotCutAtANul) {
    (void)folder_.file("key.json", R"({"format": "fretwork/setting/3", "a\u0000b": 1})");
    (void)folder_.file("choice.json",
                       R"({"format": "fretwork/setting/3", "section": {"type": "circ\u0000le"}})");
    for (const char* name : {"key", "choice"})
        expect_one_short_line("fretwork check " + std::string(name) + ".json");
    EXPECT_THAT(run("fretwork check key.json").err, HasSubstr("/a\\x00b: unknown key 'a\\x00b'; "));
    EXPECT_THAT(run("fretwork check choice.json").err, HasSubstr("'circ\\x00le'"));
}

TEST_F(Messages, NamesOfAProjectAreShownAndNotObeyed) {
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 "
                  "--out p.json")
                  .exit_code,
              0);
    std::string load_case = base::read_text_file(folder_.path() / "experiments/cases/own_weight.json");
    const std::string key = "\"name\": \"";
    load_case.insert(load_case.find(key) + key.size(), kHarmful);
    (void)folder_.file("case.json", load_case);
    ASSERT_EQ(run("fretwork case add p.json case.json").exit_code, 0);
    for (const char* command : {"fretwork case list p.json", "fretwork case list p.json --json"}) {
        std::string out = run(command).out;
        std::erase(out, '\n');
        EXPECT_EQ(base::printable(out), out);
        EXPECT_THAT(out, HasSubstr("31m"));
    }
}

TEST_F(Messages, NameThePlaceWhereNothingCanBeWrittenOrRead) {
    for (const char* command :
         {"fretwork solve frame.json --out ''", "fretwork solve '' --out r.json",
          "fretwork enumerate --library nowhere/N.db", "fretwork solve /dev/zero --out r.json",
          "fretwork library list --library .", "fretwork enumerate --list ."})
        expect_one_short_line(command);
    EXPECT_THAT(run("fretwork enumerate --library nowhere/N.db").err,
                HasSubstr("nowhere/N.db: cannot be written"));
    EXPECT_THAT(run("fretwork solve /dev/zero --out r.json").err, HasSubstr("/dev/zero: is a device"));
}

TEST(PathThatEndsEarly, NamesStepsAndStagesWhereItsIterationsAreSpent) {
    mechanics::Result result;
    result.solver = mechanics::solver_name(mechanics::Solver::Newton);
    result.solution.termination = mechanics::Termination::IterationsSpent;
    testing::internal::CaptureStdout();
    print_failure(result, mechanics::Branch::Primary);
    EXPECT_THAT(testing::internal::GetCapturedStdout(),
                HasSubstr("more load steps (--steps) or more load stages allow more"));
}

TEST(SizesOfFiles, HaveThreeDigitsInEveryUnit) {
    for (const auto& [bytes, text] :
         {std::pair(999U, "999 bytes"), std::pair(1000U, "1 kB"), std::pair(123'456U, "123 kB"),
          std::pair(999'499U, "999 kB"), std::pair(999'500U, "1 MB"), std::pair(1'250'000U, "1.25 MB"),
          std::pair(999'499'999U, "999 MB"), std::pair(999'500'000U, "1 GB")})
        EXPECT_EQ(bytes_text(bytes), text);
}

TEST_F(Messages, ALinkStaysALinkWhereItsFileIsWritten) {
    ASSERT_EQ(
        run("mkdir other && ln -s other/L.db L.db && fretwork enumerate --edges 2 --library L.db").exit_code,
        0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.path() / "L.db"));
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_.path() / "other/L.db"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
