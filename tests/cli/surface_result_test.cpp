// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a surface that were changed by hand, and what is said of them.
#include "cli/command.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class SurfaceResults : public testing::Test {
  protected:
    SurfaceResults() {
        const Outcome made =
            run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 --out "
                "p.json"
                " && fretwork case add p.json experiments/cases/cantilever.json"
                " && fretwork simulate p.json --case cantilever --linear --out full.json"
                " && fretwork simulate p.json --case cantilever --model condensed --out condensed.json");
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    Outcome run(const std::string& command) const { return run_command(command, folder_.path()); }
    /// Change a file by a sed script, and see that the result is refused with its place.
    void expect_refused(const std::string& change, const std::string& complaint) const {
        ASSERT_EQ(
            run("sed '" + change + "' full.json > changed.json && ! cmp -s full.json changed.json").exit_code,
            0)
            << change;
        for (const char* command : {"fretwork compare changed.json condensed.json",
                                    "fretwork export p.json --result changed.json --to x.svg"}) {
            const Outcome outcome = run(command);
            EXPECT_EQ(outcome.exit_code, 2) << command;
            EXPECT_THAT(outcome.err, AllOf(StartsWith("fretwork: changed.json: "), HasSubstr(complaint)));
        }
    }
    test::TemporaryFolder folder_;
};

TEST_F(SurfaceResults, AreComparedAndDrawn) {
    EXPECT_EQ(run("fretwork compare full.json condensed.json").exit_code, 0);
    EXPECT_EQ(run("fretwork export p.json --result full.json --to x.svg").exit_code, 0);
}

TEST_F(SurfaceResults, OfMixedModelsSayWhichTilesAreInFull) {
    const std::string simulate = "fretwork simulate p.json --case cantilever ";
    const Outcome mixed = run(simulate + "--model mixed:0.1 --out mixed.json");
    EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
    EXPECT_THAT(mixed.out, HasSubstr("tiles in full: "));
    EXPECT_EQ(run("grep full_tiles mixed.json && fretwork compare full.json mixed.json").exit_code, 0);
    EXPECT_EQ(run("fretwork export p.json --result mixed.json --to m.svg").exit_code, 0);
    const Outcome wrong = run(simulate + "--model mixed:2 --out x.json");
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("mixed:2: the share of tiles in full is a number from 0 to 1"));
}

TEST_F(SurfaceResults, TellTheErrorOfTheirModelIfAsked) {
    const std::string simulate = "fretwork simulate p.json --case cantilever --estimate-model-error ";
    for (const std::string model : {"corotational", "condensed"}) {
        const Outcome outcome = run(simulate + "--model " + model + " --out e.json");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("error of the model, estimated: "));
        EXPECT_EQ(run("grep model_error_estimate e.json && fretwork compare full.json e.json").exit_code, 0);
    }
    EXPECT_EQ(run(simulate + "--model full --out x.json").exit_code, 2);
}

TEST_F(SurfaceResults, AreRefusedIfTheyWereChangedByHand) {
    expect_refused("s/\"model\": \"full\"/\"model\": \"ful\"/", "/subject/model: unknown tile model 'ful'");
    expect_refused("s/\"is_reference\": true/\"is_reference\": false/",
                   "/subject/is_reference: does not agree");
    expect_refused("s/\"painting\": \"/\"painting\": \"x/", "/subject/painting: is ");
    expect_refused("s/\"seconds\": /\"seconds\": -/", "/seconds: is -");
    expect_refused("s/\"gravity\": /\"gravety\": /", "/subject/load_case/gravety");
}

TEST_F(SurfaceResults, OfDifferentPaintingsAreRefusedWithBothNames) {
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-5+5-6 "
                  "--out p.json"
                  " && fretwork simulate p.json --case cantilever --model condensed --out other.json")
                  .exit_code,
              0);
    EXPECT_THAT(run("fretwork compare full.json other.json").err,
                StartsWith("fretwork: full.json and other.json: "));
}

TEST_F(SurfaceResults, AreComparedUnderANameThatATerminalDoesNotObey) {
    const Outcome outcome =
        run("fretwork compare full.json condensed.json --name \"$(printf 'a\\033[31m')\"");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos);
    EXPECT_THAT(outcome.out, HasSubstr("a\\x1b[31m"));
}

TEST_F(SurfaceResults, AreDrawnWithTheirOwnLoadCaseOnly) {
    ASSERT_EQ(run("sed s/cantilever/other/ experiments/cases/cantilever.json > other.json"
                  " && fretwork case add p.json other.json")
                  .exit_code,
              0);
    EXPECT_EQ(run("fretwork export p.json --case cantilever --result full.json --to own.svg").exit_code, 0);
    const Outcome outcome = run("fretwork export p.json --case other --result full.json --to mix.svg");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("fretwork: full.json: "), HasSubstr("'other' of --case")));
}

TEST_F(SurfaceResults, AreHeldAgainstFiniteTolerancesOnly) {
    for (const std::string value : {"inf", "nan", "-1", "1e999", "x"}) {
        const Outcome outcome = run("fretwork compare full.json condensed.json --tolerance=" + value);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("--tolerance"),
                                       HasSubstr("'" + value + "' is not a number of zero or more")));
    }
}

TEST_F(SurfaceResults, OfUnreleasedFormatsAreRefusedWithFileAndPlace) {
    ASSERT_EQ(run("sed -e 's#result/5#result/1#' condensed.json > old.json").exit_code, 0);
    const Outcome outcome = run("fretwork export p.json --result old.json --to x.svg");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err,
                HasSubstr("fretwork: old.json: /format: is \"fretwork/result/1\", of an unreleased version"));
}

TEST_F(SurfaceResults, WithoutTheirCalibrationsAreRefusedWithFileAndPlace) {
    const Outcome all = run("fretwork simulate p.json --case cantilever --model paper6 --out r.json");
    EXPECT_EQ(all.exit_code, 2);
    EXPECT_THAT(all.err,
                StartsWith("fretwork: p.json: pattern 0-1+1-6 has no calibration of the tile model paper6"));
    ASSERT_EQ(
        run("sed -i 's/^}$/,\"tile_models\": [{\"model\": \"paper6\", \"tiles\": [0]}]}/' p.json").exit_code,
        0);
    const Outcome one = run("fretwork simulate p.json --case cantilever --out r.json");
    EXPECT_EQ(one.exit_code, 2);
    EXPECT_THAT(one.err, StartsWith("fretwork: p.json: /tile_models/0: pattern 0-1+1-6 has no calibration"));
}

TEST_F(SurfaceResults, OfTileModelsThatThereAreNotAreRefusedWithFileAndPlace) {
    ASSERT_EQ(run("sed -i 's/^}$/,\"tile_models\": [{\"model\": \"condensd\", \"tiles\": [0]}]}/' p.json")
                  .exit_code,
              0);
    const Outcome outcome = run("fretwork simulate p.json --case cantilever --out r.json");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("p.json: /tile_models/0/model: "), HasSubstr("'condensed'")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
