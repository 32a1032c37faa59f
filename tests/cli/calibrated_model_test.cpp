// SPDX-License-Identifier: GPL-3.0-or-later
// Every tile model with parameters, from its calibration to a surface that is compared with the full one.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::app {
namespace THIS_TEST {

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

TEST_F(CalibratedModels, ADamagedOneIsRefusedByItsName) {
    succeed(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-5+5-6 --library "
        "all.db "
        "--out p.json && fretwork case add p.json experiments/cases/cantilever.json");
    succeed("sqlite3 all.db \"UPDATE calibration_parameter SET value = -1 WHERE name = 'A'\"");
    const Outcome outcome =
        run_command("fretwork simulate p.json --case cantilever --model paper6 --library all.db --out r.json",
                    folder_.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("calibration of pattern 0-5+5-6 with paper6 is damaged: A is -1"));
}

TEST_F(CalibratedModels, TilesOfAnotherSizeAreTold) {
    for (const auto& [edge_length, warns] : {std::pair("30mm", false), std::pair("60mm", true)}) {
        succeed(
            std::string("fretwork tile experiments/outlines/specimen.svg --patterns 0-5+5-6 --library all.db "
                        "--out p.json --edge-length ") +
            edge_length);
        const Outcome outcome = run_command(
            "fretwork simulate p.json --case experiments/cases/cantilever.json --model paper6 --out r.json",
            folder_.path());
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(
            outcome.err.find("paper6 is calibrated for tiles with sides of 26 mm; those of this surface") !=
                std::string::npos,
            warns)
            << outcome.err;
    }
}

TEST_F(CalibratedModels, AProjectTellsWhichLibraryItLacks) {
    succeed(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-5+5-6 --library "
        "all.db "
        "--out p.json && fretwork case add p.json experiments/cases/cantilever.json && mv all.db other.db");
    const std::string command = "fretwork simulate p.json --case cantilever --model paper6 --out r.json";
    const Outcome outcome = run_command(command, folder_.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "fretwork: p.json: /library/path: the library all.db is not there; bring it back, or give "
              "another library\n");
    succeed(command + " --library other.db");
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

}  // namespace THIS_TEST
}  // namespace fretwork::app
