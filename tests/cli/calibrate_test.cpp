// SPDX-License-Identifier: GPL-3.0-or-later
// calibrate as its user runs it: stopped, killed, in shards, on a full disk, in a pipe.
#include "cli/command.hpp"
#include "support.hpp"

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr const char* kCalibrate = "fretwork calibrate --patterns sample:24 --starts 1 --library ";

class Calibrate : public testing::Test {
  protected:
    test::Outcome run(const std::string& command) { return run_command(command, folder_.path()); }
    void make(const std::string& name) {
        ASSERT_EQ(run("fretwork enumerate --edges 2..4 --library " + name).exit_code, 0);
    }
    /// The tables of a library, in one text.
    std::string tables(const std::string& name) {
        return run("fretwork library export --library " + name + " --csv csv_" + name + " && cat csv_" +
                   name + "/*")
            .out;
    }
    /// Those of an undisturbed run.
    std::string undisturbed() {
        make("alone.db");
        EXPECT_EQ(run(std::string(kCalibrate) + "alone.db").exit_code, 0);
        return tables("alone.db");
    }
    TemporaryFolder folder_;
};

/// A file that outgrows its limit ends the program within the write that does so.
TEST_F(Calibrate, EndsWithTheSameTablesAfterWritesThatFail) {
    make("lib.db");
    for (const char* blocks : {"0", "30", "90"}) {
        const auto outcome = run("ulimit -c 0; ulimit -f $(( $(stat -c %s lib.db) / 512 + " +
                                 std::string(blocks) + " )); " + kCalibrate + "lib.db");
        ASSERT_EQ(outcome.exit_code, 2) << blocks << " blocks: " << outcome.err;
        EXPECT_EQ(run("sqlite3 lib.db 'PRAGMA integrity_check'").out, "ok\n");
    }
    EXPECT_EQ(run(std::string(kCalibrate) + "lib.db").exit_code, 0);
    EXPECT_EQ(tables("lib.db"), undisturbed());
}

TEST_F(Calibrate, GoesOnAfterAFullDisk) {
    make("lib.db");
    const auto full = run("trap '' XFSZ; ulimit -f $(( $(stat -c %s lib.db) / 512 + 200 )); " +
                          std::string(kCalibrate) + "lib.db");
    EXPECT_EQ(full.exit_code, 2);
    EXPECT_THAT(full.err, HasSubstr("lib.db: cannot be"));
    EXPECT_EQ(std::ranges::count(full.err, '\n'), 1) << full.err;
    EXPECT_EQ(run(std::string(kCalibrate) + "lib.db").exit_code, 0);
    EXPECT_EQ(tables("lib.db"), undisturbed());
}

/// As a search that failed would store it.
TEST_F(Calibrate, TellsAnObjectiveFarAboveItsLike) {
    make("lib.db");
    const std::string command = std::string(kCalibrate) + "lib.db";
    const auto usual = run(command + " --json");
    EXPECT_EQ(usual.exit_code, 0);
    EXPECT_THAT(usual.err, testing::Not(HasSubstr("far above")));
    EXPECT_THAT(usual.out,
                testing::AllOf(HasSubstr("\"dead_starts\": 0"), HasSubstr("\"far_above_its_like\": []")));
    run("sqlite3 lib.db 'UPDATE calibration SET objective = 1e30 "
        "WHERE pattern_id = (SELECT min(pattern_id) FROM calibration)'");
    const auto odd = run(command + " --json");
    EXPECT_EQ(odd.exit_code, 0);
    EXPECT_THAT(odd.err, testing::AllOf(HasSubstr("1 calibration is far above others like it"),
                                        HasSubstr("E = 1e+30 of 0-1+"), HasSubstr("--seed")));
    EXPECT_THAT(odd.out, HasSubstr("\"objective\": 1e+30"));
}

TEST_F(Calibrate, ShardsMergeToTheSameTables) {
    for (const char* part : {"1", "2", "3"}) {
        const std::string name = std::string("part") + part + ".db";
        make(name);
        EXPECT_EQ(run(std::string(kCalibrate) + name + " --shard " + part + "/3").exit_code, 0);
    }
    EXPECT_EQ(run("fretwork library merge merged.db part2.db part3.db part1.db").exit_code, 0);
    EXPECT_EQ(tables("merged.db"), undisturbed());
}

TEST_F(Calibrate, IsQuietInAPipe) {
    make("lib.db");
    const auto outcome = run("fretwork calibrate --library lib.db --patterns 0-1+1-6 --starts 1");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, testing::StartsWith("1 of 1 open patterns done"));
}

TEST_F(Calibrate, KeepsToThePolicyOfTheLibrary) {
    make("lib.db");
    const std::string command = "fretwork calibrate --library lib.db --patterns 0-1+1-6 --starts 1 ";
    EXPECT_THAT(run(command + "--policy stable").out, HasSubstr("policy stable"));
    EXPECT_THAT(run(command).out, HasSubstr("policy stable")) << "the library's own";
    const auto refused = run(command + "--policy paper");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("branch"));
}

TEST_F(Calibrate, KeepsToTheSettingOfTheLibrary) {
    make("lib.db");
    const std::string command =
        "fretwork calibrate --library lib.db --patterns 0-1+1-6 --starts 1 --setting ";
    EXPECT_EQ(run(command + "experiments/settings/pla.json").exit_code, 0);
    const auto refused = run(command + "experiments/settings/paper.json");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("young_modulus"));
}

TEST_F(Calibrate, AsksAboutSlipsOfUnitsAndTellsAnotherStrength) {
    make("lib.db");
    const auto setting = [&](const std::string& material) {
        return folder_
            .file("setting.json", R"({"format": "fretwork/setting/2", "material": {"poisson_ratio": 0.3,
            "density": 1240, )" + material +
                                      "}}")
            .string();
    };
    const std::string command =
        "fretwork calibrate --library lib.db --patterns 0-1+1-6 --starts 1 --setting ";
    EXPECT_EQ(run(command + setting(R"("young_modulus": 1e9, "strength": 4e7)")).err,
              "fretwork: the library's strength is 40 MPa now\n");
    EXPECT_EQ(run(command + setting(R"("young_modulus": 1e9, "strength": 40)")).err,
              "fretwork: the library's strength is 4e-05 MPa now\n"
              "fretwork: is that meant? the strength is 40 Pa, less than any solid bears (40 MPa is 4e7)\n");
    make("soft.db");
    EXPECT_THAT(run("fretwork calibrate --library soft.db --patterns 0-1+1-6 --starts 1 --setting " +
                    setting(R"("young_modulus": 2.3)"))
                    .err,
                HasSubstr("is that meant? Young's modulus is 2.3 Pa"));
}

TEST_F(Calibrate, ThePapersNumbersStandBesideThoseOfItsSettingAlone) {
    make("lib.db");
    EXPECT_THAT(run("fretwork calibrate --library lib.db --patterns 0-1+1-6 --starts 1").out,
                HasSubstr("(paper: 9.7"));
    make("pla.db");
    EXPECT_THAT(run("fretwork calibrate --library pla.db --patterns 0-1+1-6 --starts 1 --setting "
                    "experiments/settings/pla.json")
                    .out,
                testing::Not(HasSubstr("(paper:")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
