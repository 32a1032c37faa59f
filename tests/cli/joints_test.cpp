// SPDX-License-Identifier: GPL-3.0-or-later
// A setting's joints, from its file to the results of a surface.
#include "cli/command.hpp"
#include "support.hpp"

#include <nlohmann/json.hpp>

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using testing::HasSubstr;

class JointsOfASetting : public testing::Test {
  protected:
    JointsOfASetting() {
        for (const std::string joints : {"centreline", "stiff"}) make(joints);
    }
    Outcome run(const std::string& command) const { return run_command(command, folder_.path()); }
    std::string succeed(const std::string& command) const {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
        return outcome.out;
    }
    double deflection(const std::string& joints, const std::string& model) const {
        return nlohmann::json::parse(succeed("fretwork simulate " + joints + ".json --model " + model +
                                             " --json --out " + joints + "-" + model + ".json"))
            .at("largest_displacement");
    }

  private:
    void make(const std::string& joints) const {
        (void)folder_.file(joints + "-setting.json",
                           R"({"format": "fretwork/setting/2", "joints": ")" + joints + "\"}");
        succeed("fretwork enumerate --edges 2..2 --library " + joints + ".db");
        succeed("fretwork calibrate --starts 2 --patterns 0-1+1-6,1-6+3-6 --library " + joints +
                ".db --setting " + joints + "-setting.json");
        succeed(
            "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns random:1 "
            "--library " +
            joints + ".db --out " + joints + ".json");
        succeed("fretwork case add " + joints + ".json experiments/cases/cantilever.json");
    }
    test::TemporaryFolder folder_;
};

TEST_F(JointsOfASetting, StiffenEveryTileModel) {
    for (const char* model : {"full", "paper6", "condensed", "corotational"})
        EXPECT_LT(deflection("stiff", model), deflection("centreline", model)) << model;
}

TEST_F(JointsOfASetting, KeepLibrariesAndResultsApart) {
    const Outcome other = run("fretwork calibrate --library stiff.db --setting centreline-setting.json");
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, HasSubstr(R"(/joints: "centreline", where the library has "stiff")"));
    (void)deflection("stiff", "full");
    (void)deflection("centreline", "condensed");
    const Outcome compared = run("fretwork compare stiff-full.json centreline-condensed.json");
    EXPECT_EQ(compared.exit_code, 2);
    EXPECT_THAT(compared.err, HasSubstr("setting"));
}

class SettingOfAProject : public testing::Test {
  protected:
    Outcome run(const std::string& command) const { return run_command(command, folder_.path()); }
    std::string joints(const std::string& tile_options) const {
        const Outcome outcome = run(kTile + tile_options + " --json");
        EXPECT_EQ(outcome.exit_code, 0) << tile_options << "\n" << outcome.err;
        const auto told = nlohmann::json::parse(outcome.out);
        return told.at("setting").get<std::string>() + " " + told.at("joints").get<std::string>();
    }
    const std::string kTile =
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 ";
    test::TemporaryFolder folder_;
};

TEST_F(SettingOfAProject, IsThatOfThingsThatAreMadeUnlessItIsNamed) {
    EXPECT_EQ(joints("--out made.json"), "made stiff");
    EXPECT_EQ(joints("--setting paper --out paper.json"), "paper centreline");
    EXPECT_EQ(joints("--setting experiments/settings/pla.json --out pla.json"), "own centreline");
    const Outcome unknown = run(kTile + "--setting papper --out p.json");
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, testing::AllOf(HasSubstr("papper"), HasSubstr("made")));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "p.json"));
}

TEST_F(SettingOfAProject, StaysWhenItIsTiledAgain) {
    EXPECT_EQ(joints("--setting paper --out p.json"), "paper centreline");
    EXPECT_EQ(joints("--out p.json"), "paper centreline");
    EXPECT_EQ(joints("--setting made --out p.json"), "made stiff");
    EXPECT_EQ(joints("--out p.json"), "made stiff");
}

TEST_F(SettingOfAProject, OfAnOlderFileWithoutOneIsThePapers) {
    EXPECT_EQ(joints("--setting paper --out p.json"), "paper centreline");
    auto project = nlohmann::json::parse(base::read_text_file(folder_.path() / "p.json"));
    project.erase("setting");
    (void)folder_.file("p.json", project.dump());
    EXPECT_EQ(joints("--out p.json"), "paper centreline");
}

TEST_F(SettingOfAProject, IsThatOfItsLibrary) {
    ASSERT_EQ(run("fretwork enumerate --edges 2..2 --library paper.db && fretwork enumerate --edges 2..2 "
                  "--library made.db && fretwork calibrate --library made.db --setting made --model "
                  "condensed --patterns 0-1+1-6")
                  .exit_code,
              0);
    EXPECT_EQ(joints("--library paper.db --out p.json"), "paper centreline");
    EXPECT_EQ(joints("--out p.json"), "paper centreline") << "it keeps its library";
    EXPECT_EQ(joints("--library made.db --out m.json"), "made stiff");
    EXPECT_EQ(joints("--library made.db --setting made --out m.json"), "made stiff");
    for (const std::string options :
         {"--library paper.db --setting made --out q.json", "--library made.db --setting paper --out q.json",
          "--setting paper --out m.json"}) {
        const Outcome refused = run(kTile + options);
        EXPECT_EQ(refused.exit_code, 2) << options;
        EXPECT_THAT(refused.err, HasSubstr("/joints")) << options;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "q.json"));
}

TEST_F(SettingOfAProject, StandsInEachResultDrawingAndFactSheet) {
    EXPECT_EQ(joints("--out p.json"), "made stiff");
    const Outcome simulated = run(
        "fretwork case add p.json experiments/cases/cantilever.json && fretwork simulate p.json --out "
        "r.json && fretwork export p.json --result r.json --to d.svg && fretwork export p.json --to s.svg "
        "&& fretwork export p.json --to facts.txt && fretwork export p.json --result r.json --to v.html");
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
    EXPECT_THAT(simulated.out, HasSubstr("full model, joints: stiff"));
    const auto text = [&](const char* name) { return base::read_text_file(folder_.path() / name); };
    EXPECT_EQ(nlohmann::json::parse(text("r.json")).at("subject").at("joints"), "stiff");
    for (const char* name : {"d.svg", "s.svg", "v.html"})
        EXPECT_THAT(text(name), HasSubstr("joints: stiff")) << name;
    EXPECT_THAT(text("facts.txt"), testing::ContainsRegex("joints of the model +stiff"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
