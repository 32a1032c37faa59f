// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <regex>
#include <set>
#include <utility>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;

/// The table of runs without the column of times.
std::vector<std::vector<std::string>> untimed_rows(const std::filesystem::path& path) {
    constexpr std::ptrdiff_t kCpuSeconds = 16;
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : base::split(base::read_text_file(path), '\n')) {
        rows.push_back(base::split(line, ','));
        if (std::ssize(rows.back()) > kCpuSeconds) rows.back().erase(rows.back().begin() + kCpuSeconds);
    }
    return rows;
}

const std::string kKnown =
    "problem,best_value,scale,found_by\n"
    "analytic/beale,0,1,construction\nanalytic/levy,0,1,construction\nsynthetic/1,0,1,construction\n";

TEST(Optimizers, RunTheSameOnAnyNumberOfThreadsAndGoOnWhereTheyWereStopped) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    const std::string run =
        "fretwork optimizers run --known known.csv --budget 300 --optimizers "
        "crs2,cma-es,mlsl,ceres-multistart";
    ASSERT_EQ(run_command(run + " --repetitions 2 --threads 1 --out a", folder.path()).exit_code, 0);
    ASSERT_EQ(run_command(run + " --repetitions 1 --threads 4 --out b", folder.path()).exit_code, 0);
    const auto second = run_command(run + " --repetitions 2 --threads 4 --out b --json", folder.path());
    EXPECT_THAT(second.out, testing::HasSubstr("\"runs_before\": 12"));
    EXPECT_THAT(second.out, testing::HasSubstr("\"runs_done\": 9"));
    EXPECT_EQ(untimed_rows(folder.path() / "a/results.csv"), untimed_rows(folder.path() / "b/results.csv"));
    const auto other = run_command(run + " --repetitions 2 --seed 2 --out b", folder.path());
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, testing::HasSubstr("made with another seed"));
}

TEST(Optimizers, RunWithTheNumberOfStartsThatStandsBehindTheirName) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    const std::string run =
        "fretwork optimizers run --known known.csv --problems analytic/beale --repetitions 1 ";
    ASSERT_EQ(run_command(run + "--optimizers slsqp:3 --out o", folder.path()).exit_code, 0);
    EXPECT_EQ(untimed_rows(folder.path() / "o/results.csv").at(1).at(5), "3");
    for (const char* word : {"slsqp:", "slsqp:0", "slsqp:three"}) {
        const auto refused = run_command(run + "--optimizers " + word + " --out p", folder.path());
        EXPECT_EQ(refused.exit_code, 2) << word;
        EXPECT_THAT(refused.err, testing::HasSubstr("starts")) << word;
    }
    const auto twice = run_command(run + "--optimizers slsqp:3,slsqp:4 --out p", folder.path());
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_THAT(twice.err, testing::HasSubstr("'slsqp' is listed twice"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "p"));
}

TEST(Optimizers, SearchTheProblemsOfAListWhichMayBeOfAnyLayout) {
    const TemporaryFolder folder;
    (void)folder.file("ids.txt", "calibration/paper8:0-1+1-7\nanalytic/beale\n");
    const std::string known = "fretwork optimizers known --starts 1 --out known.csv --ids ";
    ASSERT_EQ(run_command(known + "ids.txt", folder.path()).exit_code, 0);
    const auto rows = untimed_rows(folder.path() / "known.csv");
    EXPECT_EQ(rows.at(1).at(0), "calibration/paper8:0-1+1-7");
    EXPECT_GT(std::stod(rows.at(1).at(1)), 0.0);
    EXPECT_EQ(rows.at(2).at(0), "analytic/beale");
    (void)folder.file("bad.txt", "analytic/beale\ncalibration/paper9:0-1\n");
    const auto refused = run_command(known + "bad.txt", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, testing::AllOf(testing::HasSubstr("bad.txt"), testing::HasSubstr("line 2")));
}

TEST(Optimizers, ReadListsAndTablesWhoseLinesEndInCrLf) {
    const TemporaryFolder folder;
    (void)folder.file("ids.txt", "analytic/beale\r\nanalytic/levy\r\n");
    (void)folder.file("known.csv",
                      "problem,best_value,scale,found_by\r\nanalytic/beale,0,1,construction\r\n");
    EXPECT_EQ(run_command("fretwork optimizers known --starts 1 --ids ids.txt --out out.csv", folder.path())
                  .exit_code,
              0);
    EXPECT_EQ(untimed_rows(folder.path() / "out.csv").at(2).at(0), "analytic/levy");
    const auto done =
        run_command("fretwork optimizers run --known known.csv --repetitions 1 --optimizers bobyqa --out o",
                    folder.path());
    EXPECT_EQ(done.exit_code, 0) << done.err;
    (void)folder.file("o.csv", std::regex_replace(base::read_text_file(folder.path() / "o/results.csv"),
                                                  std::regex("\n"), "\r\n"));
    EXPECT_EQ(run_command("fretwork optimizers known --from known.csv --results o.csv --out better.csv",
                          folder.path())
                  .exit_code,
              0);
}

TEST(Optimizers, RecoverTheParametersOfASyntheticTarget) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    ASSERT_EQ(run_command("fretwork optimizers run --known known.csv --problems synthetic --repetitions 1 "
                          "--optimizers gauss-newton-multistart --out o",
                          folder.path())
                  .exit_code,
              0);
    const auto row = untimed_rows(folder.path() / "o/results.csv").at(1);
    EXPECT_LT(std::stod(row.at(9)), 1e-3) << "the objective";
    EXPECT_LT(std::stod(row.at(11)), 1e-3) << "the largest miss as a share of the box";
}

TEST(Optimizers, TakeOverBetterValuesThatRunsFound) {
    const TemporaryFolder folder;
    (void)folder.file(
        "known.csv",
        "problem,best_value,scale,found_by\nanalytic/beale,5,5,guess\nanalytic/levy,0,1,construction\n");
    ASSERT_EQ(
        run_command("fretwork optimizers run --known known.csv --repetitions 1 --optimizers bobyqa --out o",
                    folder.path())
            .exit_code,
        0);
    ASSERT_EQ(
        run_command("fretwork optimizers known --from known.csv --results o/results.csv --out better.csv",
                    folder.path())
            .exit_code,
        0);
    const auto rows = untimed_rows(folder.path() / "better.csv");
    EXPECT_LT(std::stod(rows.at(1).at(1)), 1e-6);
    EXPECT_EQ(rows.at(1).at(3), "bobyqa in repetition 1 of the comparison");
    EXPECT_EQ(rows.at(2).at(3), "construction");
}

TEST(Optimizers, TakeAProgramOfItsOwnAsAMethod) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    const std::string script =
        std::string(FRETWORK_SOURCE_DIR) + "/experiments/optimizer_comparison/outside.py";
    const std::string run =
        "fretwork optimizers run --known known.csv --problems analytic/beale --repetitions 2 --budget 3000 "
        "--command 'mine=python3 " +
        script + "' ";
    ASSERT_EQ(run_command(run + "--out a --threads 1", folder.path()).exit_code, 0);
    ASSERT_EQ(run_command(run + "--optimizers mine:2,slsqp --out b --threads 4", folder.path()).exit_code, 0);
    const auto alone = untimed_rows(folder.path() / "a/results.csv");
    ASSERT_EQ(alone.size(), 4U) << "a header, two runs, and the end of the file";
    EXPECT_EQ(alone.at(1).at(1), "mine");
    EXPECT_EQ(alone.at(1).at(5), "1") << "starts";
    EXPECT_EQ(alone.at(1).at(8), "converged");
    EXPECT_LT(std::stod(alone.at(1).at(9)), 1e-9) << "the objective";
    EXPECT_NE(alone.at(1).at(9), alone.at(2).at(9)) << "another seed";
    const auto both = untimed_rows(folder.path() / "b/results.csv");
    EXPECT_EQ(both.at(1).at(5), "2") << "starts";
    EXPECT_EQ(both.at(3).at(1), "slsqp");
}

TEST(Optimizers, RefuseToMixTheRunsOfTwoCommands) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    const std::string run =
        "fretwork optimizers run --known known.csv --problems analytic/beale --repetitions 1 --out o "
        "--command ";
    const std::string program = "head -n 5 >/dev/null; echo value 0 0; read answer; echo done";
    ASSERT_EQ(run_command(run + "'mine=" + program + "'", folder.path()).exit_code, 0);
    ASSERT_EQ(run_command(run + "'mine=" + program + "'", folder.path()).exit_code, 0) << "all is done";
    const std::string stored = base::read_text_file(folder.path() / "o/results.csv");
    const auto refused = run_command(run + "'mine=true; " + program + "'", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err,
                testing::HasSubstr("line 2: rows of 'mine' were made by another command: " + program));
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    EXPECT_EQ(base::read_text_file(folder.path() / "o/results.csv"), stored);
    EXPECT_EQ(run_command(run + "'other=true; " + program + "'", folder.path()).exit_code, 0);
}

TEST(Optimizers, StopAProgramThatGoesOnAfterItsEvaluationsAreSpent) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    (void)folder.file(
        "deaf.py",
        "for _ in range(5): input()\nwhile True:\n    print('value 0 0', flush=True)\n    input()\n");
    const auto done = run_command(
        "fretwork optimizers run --known known.csv --problems analytic/beale --repetitions 1 --budget 9 "
        "--command 'deaf=python3 deaf.py' --out o --json",
        folder.path());
    EXPECT_EQ(done.exit_code, 0);
    EXPECT_THAT(done.out, testing::HasSubstr("\"runs_stopped\": 1"));
    EXPECT_THAT(done.err, testing::HasSubstr("1 run stopped: the program did not come to its end"));
    const auto row = untimed_rows(folder.path() / "o/results.csv").at(1);
    EXPECT_EQ(row.at(8), "stopped");
    EXPECT_EQ(row.at(12), "9") << "the cost";
}

TEST(Optimizers, RefuseAProgramThatIsNoMethod) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", kKnown);
    const std::string run =
        "fretwork optimizers run --known known.csv --problems analytic/beale --out o --command ";
    for (const auto& [command, said] :
         {std::pair{"mine", "is not NAME=COMMAND"},
          std::pair{"slsqp=true", "there is a method 'slsqp' already"},
          std::pair{"a,b=true", "is no name of a method"}, std::pair{"mine=", "has no command"},
          std::pair{"mine=false", "ended with exit code 1"},
          std::pair{"'mine=echo done'", "said 'done' without asking for a value"},
          std::pair{"'mine=echo hello'", "said 'hello'"}}) {
        const auto refused = run_command(run + command, folder.path());
        EXPECT_EQ(refused.exit_code, 2) << command;
        EXPECT_THAT(refused.err, testing::HasSubstr(said)) << command;
        EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    }
}

TEST(Optimizers, ComparedInASettingOfTheirOwnNameItInTheProblemsIds) {
    const TemporaryFolder folder;
    (void)folder.file(
        "thin.json",
        R"({"format": "fretwork/setting/1", "section": {"type": "rectangle", "width": 0.003, "height": 0.001}})");
    (void)folder.file("bad name.json", R"({"format": "fretwork/setting/1"})");
    const std::string known = "fretwork optimizers known --patterns 1 --starts 1 --out ";
    ASSERT_EQ(run_command(known + "known.csv --setting thin.json", folder.path()).exit_code, 0);
    ASSERT_EQ(run_command(known + "paper.csv", folder.path()).exit_code, 0);
    const auto thin = untimed_rows(folder.path() / "known.csv").at(1);
    const auto paper = untimed_rows(folder.path() / "paper.csv").at(1);
    EXPECT_EQ(thin.at(0), paper.at(0) + "@thin");
    EXPECT_NE(thin.at(1), paper.at(1));
    const std::string run =
        "fretwork optimizers run --known known.csv --optimizers slsqp --repetitions 1 --out o";
    EXPECT_EQ(run_command(run + " --setting thin.json", folder.path()).exit_code, 0);
    const auto without = run_command(run + "2", folder.path());
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_THAT(without.err, testing::HasSubstr("in a setting 'thin', which is not given"));
    const auto misnamed = run_command(known + "x.csv --setting 'bad name.json'", folder.path());
    EXPECT_EQ(misnamed.exit_code, 2);
    EXPECT_THAT(misnamed.err, testing::HasSubstr("cannot name a setting"));
}

TEST(Optimizers, ListTheWholeCatalogue) {
    const TemporaryFolder folder;
    const auto listed = run_command("fretwork optimizers list --json", folder.path());
    EXPECT_EQ(listed.exit_code, 0);
    for (const char* name : {"ceres-multistart", "simulated-annealing", "direct-l", "cma-es"}) {
        EXPECT_THAT(listed.out, testing::HasSubstr("\"name\": \"" + std::string(name) + "\""));
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
