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

}  // namespace THIS_TEST
}  // namespace fretwork::app
