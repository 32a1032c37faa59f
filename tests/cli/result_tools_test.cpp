// SPDX-License-Identifier: GPL-3.0-or-later
// Verbs that read results: beams, comparisons, the range of linear ones, stable paths, modes.
#include "cli/refusal.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using nlohmann::json;
using test::expect_refused;
using test::Outcome;
using test::run_command;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class ResultTools : public testing::Test {
  protected:
    ResultTools() {
        EXPECT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 "
                      "--out p.json && fretwork case add p.json experiments/cases/cantilever.json && "
                      "fretwork simulate p.json --out full.json && "
                      "fretwork simulate p.json --model condensed --out condensed.json")
                      .exit_code,
                  0);
    }
    [[nodiscard]] Outcome run(const std::string& command) const {
        return run_command(command, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(ResultTools, BeamsListTheMostStressedFirst) {
    const Outcome reported =
        run("fretwork beams p.json full.json --top 3 --strength 40MPa --json --out b.csv");
    ASSERT_EQ(reported.exit_code, 0) << reported.err;
    const json beams = json::parse(reported.out).at("beams");
    ASSERT_EQ(beams.size(), 3U);
    const double worst = beams[0].at("largest_von_mises");
    EXPECT_GE(worst, beams[1].at("largest_von_mises").get<double>());
    EXPECT_NEAR(beams[0].at("utilization").get<double>(), worst / 40e6, 1e-12 * worst / 40e6);
    // No beam of the table is worse.
    const auto lines = base::split(base::read_text_file(folder_.path() / "b.csv"), '\n');
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < lines.size(); ++i)
        largest = std::max(largest, std::stod(*(base::split(lines[i], ',').end() - 2)));
    EXPECT_EQ(largest, worst);
    EXPECT_EQ(run("fretwork beams p.json full.json --out b.csv").exit_code, 0) << "its own table is replaced";
    const Outcome recovered = run("fretwork beams p.json condensed.json");
    EXPECT_EQ(recovered.exit_code, 0) << "inner nodes are recovered";
    EXPECT_THAT(recovered.out, StartsWith("joints: stiff\n"));
    EXPECT_EQ(json::parse(reported.out).at("joints"), "stiff");
    EXPECT_EQ(run("fretwork beams p.json full.json --strength much").exit_code, 2);
    EXPECT_EQ(run("fretwork beams p.json full.json --top 0 --json").exit_code, 0)
        << "none is shown, all are known";
    ASSERT_EQ(run("fretwork paint p.json --patterns 0-5+5-6").exit_code, 0);
    EXPECT_THAT(run("fretwork beams p.json full.json").err, HasSubstr("is not a result of this project"));
}

TEST_F(ResultTools, ComparisonsAreATableForPeopleAndCsvIfAsked) {
    const Outcome table = run("fretwork compare full.json condensed.json");
    EXPECT_THAT(table.out, AllOf(HasSubstr("translation error"), HasSubstr(" mm"), HasSubstr("relative L2")));
    EXPECT_THAT(table.out, HasSubstr("\njoints: stiff\n"));
    const Outcome csv = run("fretwork compare full.json condensed.json --csv");
    EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 2);
    EXPECT_THAT(csv.out, StartsWith("example,width_m,height_m,max_displacement_m,"));
    EXPECT_THAT(csv.out, HasSubstr(",reduced_model_milliseconds\n"));
    const json told = json::parse(run("fretwork compare full.json condensed.json --json").out);
    EXPECT_FALSE(told.at("full_is_unstable"));
    EXPECT_EQ(told.at("joints"), "stiff");
}

TEST_F(ResultTools, LinearResultsSayWhenTheyAreOutOfTheirRange) {
    folder_.file("far.json", R"({"format": "fretwork/load-case/1", "name": "far",
        "supports": [{"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
        "loads": [{"side": "right", "force": [0, 0, -50], "amount": "total"}]})");
    const Outcome far =
        run("fretwork simulate p.json --case ./far.json --model condensed --json --out far_r.json");
    EXPECT_EQ(far.exit_code, 0);
    EXPECT_THAT(far.err, HasSubstr("too large for a linear solution"));
    EXPECT_TRUE(json::parse(far.out).at("linear_range").at("is_exceeded"));
    const Outcome near = run("fretwork simulate p.json --model condensed --json --out near.json");
    EXPECT_EQ(near.err, "");
    EXPECT_FALSE(json::parse(near.out).at("linear_range").at("is_exceeded"));
    EXPECT_TRUE(
        json::parse(run("fretwork simulate p.json --json --out x.json").out).at("linear_range").is_null());
}

TEST_F(ResultTools, ReducedResultsSayByThemselvesThatTheyAreFarOff) {
    folder_.file("far.json", R"({"format": "fretwork/load-case/1", "name": "far",
        "supports": [{"side": "left", "fixed": ["ux", "uy", "uz"]}, {"side": "right", "fixed": ["ux", "uy", "uz"]}],
        "loads": [{"box": [0.06, -1, 0.12, 1], "force": [0, 0, -5], "amount": "total"}]})");
    for (const std::string model : {"corotational", "mixed:0.05"}) {
        const Outcome far =
            run("fretwork simulate p.json --case ./far.json --model " + model + " --json --out far_r.json");
        EXPECT_EQ(far.exit_code, 0) << far.err;
        EXPECT_THAT(far.err, HasSubstr("this model is off by about")) << model;
        const json told = json::parse(far.out);
        EXPECT_TRUE(told.at("model_doubt").at("is_large")) << model;
        EXPECT_GT(told.at("model_error_estimate").at("largest").get<double>(), 0.03) << model;
        EXPECT_EQ(told.at("warnings").size(), 1U) << model;
        EXPECT_THAT(run("fretwork beams p.json far_r.json").err, HasSubstr("this model is off by about"));
    }
    const Outcome plain = run("fretwork simulate p.json --model corotational --json --out near.json");
    EXPECT_EQ(plain.err, "");
    EXPECT_EQ(json::parse(plain.out).at("warnings").size(), 0U);
}

TEST_F(ResultTools, TheStrengthOfTheMaterialGivesUtilizationWithoutAnOption) {
    json project = json::parse(base::read_text_file(folder_.path() / "p.json"));
    reduction::Setting setting = reduction::made_setting();
    setting.strength = 40e6;
    project["setting"] = json::parse(reduction::setting_text(setting));
    folder_.file("p.json", project.dump());
    const Outcome reported = run("fretwork beams p.json full.json --top 1 --json");
    ASSERT_EQ(reported.exit_code, 0) << reported.err << " (a strength makes no other setting of it)";
    const json worst = json::parse(reported.out).at("beams")[0];
    EXPECT_NEAR(worst.at("utilization").get<double>(), worst.at("largest_von_mises").get<double>() / 40e6,
                1e-12);
    const json other =
        json::parse(run("fretwork beams p.json full.json --top 1 --json --strength 20MPa").out);
    EXPECT_EQ(other.at("strength"), 20e6) << "the option comes first";
    ASSERT_EQ(run("fretwork export p.json --result full.json --to x.vtu --to facts.txt").exit_code, 0);
    EXPECT_THAT(base::read_text_file(folder_.path() / "x.vtu"), HasSubstr("Name=\"utilization\""));
    EXPECT_EQ(run("fretwork export p.json --result full.json --to x.png --size 60x40 --colour utilization")
                  .exit_code,
              0);
}

TEST_F(ResultTools, StagesBelongToTheResultInEveryCommand) {
    folder_.file("stages.json", R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "cantilever", "factor": 0.5}]},
        {"name": "ease", "loads": [{"load_case": "cantilever", "factor": 0.25}]}]})");
    ASSERT_EQ(run("fretwork simulate p.json --stages stages.json --out staged.json").exit_code, 0);
    EXPECT_THAT(run("fretwork beams p.json staged.json").out, HasSubstr("after the stages 'press', 'ease'"));
    const Outcome compared = run("fretwork compare full.json staged.json");
    EXPECT_EQ(compared.exit_code, 2);
    EXPECT_THAT(compared.err, HasSubstr("the stages"));
    EXPECT_EQ(run("fretwork export p.json --result staged.json --to s.svg").exit_code, 0);
    EXPECT_THAT(run("fretwork export p.json --result staged.json --case cantilever --to s.svg").err,
                HasSubstr("the stages"));
}

/// The warnings of a result's path reach everybody who uses the result.
TEST_F(ResultTools, AResultThatIsNotTheAnswerSaysSoInEveryCommand) {
    json ended = json::parse(base::read_text_file(folder_.path() / "full.json"));
    ended["termination"] = "limit-load";
    ended["converged"] = false;
    ended["load_factor"] = 0.43;
    folder_.file("ended.json", ended.dump());
    for (const std::string command :
         {"beams p.json ended.json", "export p.json --result ended.json --to e.svg",
          "export p.json --result ended.json --content facts --to e.json", "compare ended.json full.json"})
        EXPECT_THAT(
            run("fretwork " + command).err,
            HasSubstr("fretwork: ended.json: this is not the answer to the load: the path ends at 43 % "
                      "of the load"))
            << command;
    EXPECT_THAT(base::read_text_file(folder_.path() / "e.json"), HasSubstr("ends at 43 % of the load"));
}

TEST_F(ResultTools, AWarningOfBothResultsIsGivenOnceByComparisons) {
    json unstable = json::parse(base::read_text_file(folder_.path() / "full.json"));
    unstable["stable"] = false;
    unstable["stability"] = "tangent";
    folder_.file("one.json", unstable.dump());
    unstable["subject"]["model"] = "corotational";
    unstable["subject"]["is_reference"] = false;
    folder_.file("two.json", unstable.dump());
    const Outcome both = run("fretwork compare one.json two.json");
    EXPECT_EQ(both.exit_code, 0);
    EXPECT_EQ(
        both.err,
        "fretwork: one.json and two.json: this equilibrium is unstable: a specimen does not stay there\n"
        "fretwork: one.json: the errors are relative to an equilibrium that is not stable; simulate "
        "--branch stable finds the stable one\n");
    EXPECT_THAT(run("fretwork compare two.json two.json").err,
                StartsWith("fretwork: two.json: this equilibrium is unstable"));
}

TEST_F(ResultTools, StagesAreListedAndCheckedBeforeTheyAreSimulated) {
    folder_.file("stages.json", R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "cantilever", "factor": 0.5}]},
        {"name": "ease", "loads": [{"load_case": "cantilever", "factor": 0.25}]}]})");
    const Outcome staged = run("fretwork simulate p.json --stages stages.json --out staged.json --json");
    ASSERT_EQ(staged.exit_code, 0) << staged.err;
    const json steps = json::parse(staged.out).at("load_steps");
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[1].at("stage"), "ease");
    EXPECT_EQ(steps[1].at("termination"), "converged");
    EXPECT_GT(steps[0].at("largest_displacement").get<double>(),
              steps[1].at("largest_displacement").get<double>());
    folder_.file("wrong.json", R"({"format": "fretwork/stages/1", "stages": [
        {"name": "let go", "free": [{"side": "right", "fixed": ["uz"]}]}]})");
    const Outcome wrong = run("fretwork simulate p.json --stages wrong.json --out wrong-result.json");
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.err, StartsWith("fretwork: wrong.json: /stages/0/free: releases nothing"));
}

/// Their errors name their file, and options of a load case alone would do nothing.
TEST_F(ResultTools, StagesRefuseWhatTheyWouldIgnore) {
    folder_.file("stages.json", R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "cantilever", "factor": 0.5}]}]})");
    const std::string staged = "fretwork simulate p.json --stages stages.json --out staged.json ";
    expect_refused(staged + "--model condensed", folder_.path(),
                   "fretwork: stages.json: load stages are followed by full and corotational tiles");
    expect_refused(staged + "--deck d.inp", folder_.path(), "--deck: is for a load case alone");
    expect_refused(staged + "--frame-out f.json", folder_.path(), "--frame-out: is for a load case alone");
    expect_refused(staged + "--buckling 1", folder_.path(), "--buckling: is for a load case alone");
    expect_refused(staged + "--steps 1", folder_.path(), "--steps: is for a load case alone");
}

TEST_F(ResultTools, ALinearResultSaysInItsFileThatItIsOutOfItsRange) {
    folder_.file("far.json", R"({"format": "fretwork/load-case/1", "name": "far",
        "supports": [{"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
        "loads": [{"side": "right", "force": [0, 0, -50], "amount": "total"}]})");
    ASSERT_EQ(run("fretwork simulate p.json --case ./far.json --linear --out linear.json").exit_code, 0);
    const json written = json::parse(base::read_text_file(folder_.path() / "linear.json"));
    EXPECT_GT(written.at("linear_range").at("error_estimate").get<double>(), 0.1);
    EXPECT_THAT(run("fretwork beams p.json linear.json").err,
                AllOf(StartsWith("fretwork: linear.json: "), HasSubstr("linear solution")));
    EXPECT_FALSE(json::parse(base::read_text_file(folder_.path() / "full.json")).contains("linear_range"));
}

TEST_F(ResultTools, StablePathsAndModesAreThereOnRequest) {
    const Outcome stable = run(
        "fretwork simulate p.json --branch stable --modes 2 --buckling 1 --json --out s.json --vtu s.vtu");
    ASSERT_EQ(stable.exit_code, 0) << stable.err;
    const json reported = json::parse(stable.out);
    ASSERT_EQ(reported.at("frequencies").size(), 2U);
    EXPECT_GT(reported.at("frequencies")[0].get<double>(), 0.0);
    EXPECT_LE(reported.at("buckling_load_factors").size(), 1U);
    EXPECT_THAT(base::read_text_file(folder_.path() / "s.vtu"),
                AllOf(HasSubstr("Name=\"stress\""), HasSubstr("Name=\"radius\""), HasSubstr("pattern_names"),
                      HasSubstr("vibration 2")));
    EXPECT_EQ(run("fretwork simulate p.json --branch stable --model condensed --out x.json").exit_code, 2);
}

TEST_F(ResultTools, LoadStepsAreASeriesForParaviewInFilesOfTheirOwn) {
    const std::string series = "fretwork simulate p.json --steps 2 --out st.json --series st.pvd";
    ASSERT_EQ(run(series).exit_code, 0);
    EXPECT_THAT(base::read_text_file(folder_.path() / "st.pvd"),
                AllOf(HasSubstr("timestep=\"0.5\" part=\"0\" file=\"st-1.vtu\""),
                      HasSubstr("timestep=\"1\" part=\"0\" file=\"st-2.vtu\"")));
    EXPECT_THAT(base::read_text_file(folder_.path() / "st-2.vtu"), HasSubstr("Name=\"stress\""));
    EXPECT_EQ(run(series).exit_code, 0) << "its own files are replaced";
    folder_.file("st-2.vtu", "mine");
    const Outcome refused = run(series);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, StartsWith("fretwork: st-2.vtu: is there, and not made by fretwork"));
}

TEST_F(ResultTools, AStepOfASeriesIsNoOtherFileOfTheCommand) {
    const std::string series = "fretwork simulate p.json --steps 2 --series x.pvd ";
    const auto refuse = [&](const std::string& command, const std::string& complaint) {
        const Outcome refused = run(command);
        EXPECT_EQ(refused.exit_code, 2) << command;
        EXPECT_THAT(refused.err, StartsWith("fretwork: " + complaint)) << command;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "x.pvd")) << command;
    };
    const std::string twice = "is named for two outputs of this command";
    refuse(series + "--out x.json --vtu x-1.vtu", "x-1.vtu: " + twice);
    refuse(series + "--out x.json --vtu ./x-2.vtu", "./x-2.vtu: " + twice);
    std::filesystem::create_symlink("x-2.vtu", folder_.path() / "link.vtu");
    refuse(series + "--out x.json --vtu link.vtu", "link.vtu: " + twice);
    folder_.file("x-1.vtu", R"({"format": "fretwork/load-case/1"})");
    refuse(series + "--out x.json --case ./x-1.vtu", "x-1.vtu: is read by this command, and would be");
    std::filesystem::remove(folder_.path() / "x-1.vtu");
    EXPECT_EQ(run(series + "--out x.json --vtu x-3.vtu").exit_code, 0) << "the series has two steps";
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "x-3.vtu"));
}

TEST_F(ResultTools, SlipsOfUnitsAndNamesAreRefusedWithWhatIsMeant) {
    const std::string tile = "fretwork tile experiments/outlines/specimen.svg --out q.json --edge-length ";
    EXPECT_THAT(run(tile + "26").err, HasSubstr("did you mean 26mm?"));
    EXPECT_EQ(run(tile + "''").exit_code, 2);
    EXPECT_THAT(run("fretwork simulate p.json --model foo --out x.json").err, HasSubstr("mixed:SHARE"));
    EXPECT_THAT(run("fretwork simulate p.json --steps 0 --out x.json").err, HasSubstr("number of steps"));
    EXPECT_THAT(run("fretwork export p.json --to x.png --colour stress").err, HasSubstr("--result"));
    EXPECT_EQ(run("fretwork export p.json --result full.json --to x.png --view 1e300,0").exit_code, 2);
    for (const std::string scale : {"1.01e9", "-1e200", "nan"})
        EXPECT_THAT(run("fretwork export p.json --result full.json --to x.png --scale=" + scale).err,
                    HasSubstr("--scale: '" + scale + "' is not a number from -1e9 to 1e9"));
    EXPECT_THAT(run("fretwork export p.json --result full.json --to x.png --colour utilization").err,
                HasSubstr("--strength"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
