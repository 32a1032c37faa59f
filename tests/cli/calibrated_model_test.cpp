// SPDX-License-Identifier: GPL-3.0-or-later
// Every tile model with parameters, from its calibration to a surface that is compared with the full one.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/reduction/tile_model.hpp>

namespace fretwork::app {
namespace {

using test::Outcome;
using test::run_command;
using testing::HasSubstr;

std::vector<reduction::TileModel> calibrated_models() {
    std::vector<reduction::TileModel> models;
    for (const reduction::TileModel& model : reduction::tile_models()) {
        if (!model.parameters.empty()) models.push_back(model);
    }
    return models;
}

class CalibratedModels : public testing::Test {
  protected:
    /// Two libraries of two patterns each, calibrated with all models, and both in one: all.db.
    CalibratedModels() {
        int part = 1;
        for (const std::string patterns : {"0-1+1-6,1-6+3-6", "1-3+3-6,0-5+5-6"}) {
            const std::string library = "part" + std::to_string(part++) + ".db";
            succeed("fretwork enumerate --edges 2..2 --library " + library);
            for (const reduction::TileModel& model : calibrated_models())
                succeed("fretwork calibrate --starts 2 --patterns " + patterns + " --library " + library +
                        " --model " + model.name);
        }
        succeed("fretwork library merge all.db part1.db part2.db");
    }
    std::string succeed(const std::string& command) const {
        const Outcome outcome = run_command(command, folder_.path());
        EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
        return outcome.out;
    }
    test::TemporaryFolder folder_;
};

TEST_F(CalibratedModels, AreShownWithAllParametersAndUnits) {
    const std::string shown = succeed("fretwork library show 1-3+3-6 --library all.db --svg pattern.svg");
    for (const reduction::TileModel& model : calibrated_models()) {
        EXPECT_THAT(shown, HasSubstr("  " + model.name + " by "));
        for (const reduction::TileParameter& parameter : model.parameters)
            EXPECT_THAT(shown, HasSubstr(parameter.name + " ")) << model.name;
    }
}

TEST_F(CalibratedModels, AreExportedAsTablesAndMeshes) {
    succeed("fretwork library export --library all.db --csv tables --meshes meshes --svg sheet.svg");
    for (const reduction::TileModel& model : calibrated_models()) {
        const std::string rows =
            succeed("grep -c '^0-5+5-6," + model.name + ",' tables/calibration_parameter.csv");
        EXPECT_EQ(rows, std::to_string(model.parameters.size()) + "\n") << model.name;
        EXPECT_EQ(succeed("ls meshes | grep -c '[.]" + model.name + "[.]obj$'"), "4\n");
    }
}

TEST_F(CalibratedModels, AreSimulatedComparedAndDrawn) {
    succeed(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns random:1 --palette "
        "0-1+1-6,1-6+3-6,1-3+3-6,0-5+5-6 --library all.db --out p.json"
        " && fretwork case add p.json experiments/cases/cantilever.json"
        " && fretwork simulate p.json --case cantilever --linear --out full.json");
    for (const reduction::TileModel& model : calibrated_models()) {
        succeed("fretwork simulate p.json --case cantilever --model " + model.name + " --out " + model.name +
                ".json");
        EXPECT_THAT(succeed("fretwork compare full.json " + model.name + ".json"), HasSubstr("error"));
        succeed("fretwork export p.json --result " + model.name + ".json --to " + model.name + ".svg --to " +
                model.name + ".vtu");
    }
}

TEST_F(CalibratedModels, AloneNeedTheLibraryOfAProject) {
    succeed(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns random:1 --palette "
        "0-1+1-6,1-6+3-6 --library all.db --out p.json"
        " && fretwork case add p.json experiments/cases/cantilever.json && rm all.db");
    for (const std::string model : {"full", "condensed"}) {
        succeed("fretwork simulate p.json --linear --model " + model + " --out r.json");
        succeed("fretwork export p.json --result r.json --to r.svg");
    }
    for (const reduction::TileModel& model : calibrated_models()) {
        const Outcome outcome =
            run_command("fretwork simulate p.json --model " + model.name + " --out c.json", folder_.path());
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr("all.db"));
    }
}

}  // namespace
}  // namespace fretwork::app
