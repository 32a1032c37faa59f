// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <set>

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
