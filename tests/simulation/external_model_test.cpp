// SPDX-License-Identifier: GPL-3.0-or-later
// A tile model from outside of the library, in this one file: its row, and all that follows from it.
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/library/fill.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

using reduction::TileInput;
using reduction::TileModel;
using reduction::TileParameter;

/// The condensed tile with one number fitted to it: a factor on its whole stiffness.
TileModel scaled_model() {
    TileModel model;
    model.name = "scaled";
    model.summary = "the condensed tile, made softer or stiffer by one factor";
    model.sharing = reduction::Sharing::Congruent;
    model.parameters = {{.name = "factor",
                         .unit = "1",
                         .scale = TileParameter::Scale::Logarithmic,
                         .bounds = [](const reduction::Setting&) {
                             return TileParameter::Bounds{0.1, 10.0};
                         }}};
    model.build = [](const TileInput& input) {
        const mechanics::Frame frame = reduction::fan_frame(
            input.layout, input.fan, input.polygon, {input.setting->section, input.setting->material});
        return reduction::stiffness_tile(input.parameters[0] *
                                         reduction::condensed_frame(frame, input.fan->interface_node_count));
    };
    return model;
}

/// The built-in rows and the one from outside.
const std::vector<TileModel>& catalogue() {
    static const std::vector<TileModel> rows = [] {
        std::vector<TileModel> all = reduction::tile_models();
        all.push_back(scaled_model());
        return all;
    }();
    return rows;
}

class ExternalTileModel : public testing::Test {
  protected:
    static constexpr const char* kPattern = "0-1+1-6";

    [[nodiscard]] library::Library calibrated_library() const {
        const Project project = honeycomb();
        auto library = library::Library::create(folder_.path() / "lib.db", project.layout, setting());
        library.add_patterns(std::vector{pattern::parse_pattern_id(project.layout, kPattern)});
        library::FillOptions options;
        options.model = "scaled";
        options.models = catalogue();
        options.calibration.starts = 2;
        EXPECT_EQ(fill(library, library.patterns(), options).done, 1U);
        return library;
    }
    [[nodiscard]] static reduction::Setting setting() {
        reduction::Setting setting = reduction::paper_setting();
        setting.magnitudes = 2;
        return setting;
    }
    [[nodiscard]] static Project honeycomb() { return test::honeycomb(3, 2, {kPattern}); }

    test::TemporaryFolder folder_;
};

TEST_F(ExternalTileModel, IsCalibratedIntoALibrary) {
    const auto library = calibrated_library();
    const auto calibrations = library.best_calibrations(kPattern);
    ASSERT_EQ(calibrations.size(), 1U);
    const reduction::Calibration& found = calibrations[0];
    EXPECT_EQ(found.model, "scaled");
    ASSERT_EQ(found.parameters.size(), 1U);
    EXPECT_EQ(found.parameters[0].name, "factor");
    EXPECT_TRUE(found.converged);

    // The factor is the best one: others near it are worse.
    const auto layout = pattern::find_node_layout("paper7");
    const auto pattern = pattern::parse_pattern_id(layout, kPattern);
    const auto responses = library.responses(kPattern);
    const reduction::Setting own = setting();
    const TileModel& model = reduction::find_tile_model("scaled", catalogue());
    const reduction::ModelTile tile(model, layout, pattern, own);
    const reduction::Objective objective(responses, own);
    const double best = found.parameters[0].value;
    const auto error_at = [&](double factor) {
        return objective.value(tile.displacements(std::vector{factor}));
    };
    EXPECT_NEAR(error_at(best), found.objective, 1e-9 * found.objective);
    EXPECT_GT(error_at(1.02 * best), error_at(best));
    EXPECT_GT(error_at(best / 1.02), error_at(best));
}

TEST_F(ExternalTileModel, SimulatesASurfaceAndIsComparedWithTheFullModel) {
    const auto library = calibrated_library();
    const Surface surface = make_surface(honeycomb(), &library);
    const double factor = library.best_calibrations(kPattern).at(0).parameters[0].value;
    const LoadCase load_case = test::cantilever({0.0, 0.0, -0.001});
    const auto scaled = simulate(surface, load_case, {.model = "scaled", .models = catalogue()});
    const auto condensed = simulate(surface, load_case, {.model = "condensed"});
    EXPECT_EQ(scaled.subject->model, "scaled");
    const auto difference = scaled.solution.displacements * factor - condensed.solution.displacements;
    EXPECT_LT(difference.norm(), 1e-9 * condensed.solution.displacements.norm());
    const auto full = simulate(surface, load_case, {.model = "full"});
    EXPECT_GT(compare(full, scaled).relative_l2_error, 0.0);
}

TEST_F(ExternalTileModel, IsMixedWithBuiltInModels) {
    const auto library = calibrated_library();
    Project project = honeycomb();
    project.tile_models = {{"full", {tiling::TileIndex(0), tiling::TileIndex(3)}}};
    const Surface surface = make_surface(project, &library);
    const auto mixed =
        simulate(surface, test::cantilever({0.0, 0.0, -0.001}), {.model = "scaled", .models = catalogue()});
    EXPECT_TRUE(mixed.solution.converged());
    EXPECT_EQ(mixed.solver, "newton") << "a tile for large displacements makes the surface nonlinear";
    EXPECT_EQ(mixed.subject->model, "scaled; full (2 tiles)");
}

TEST_F(ExternalTileModel, IsListedWhereItsCatalogueIsPassed) {
    EXPECT_THAT(test::complaint_of([] { (void)reduction::find_tile_model("sealed", catalogue()); }),
                testing::HasSubstr("scaled"));
    EXPECT_THROW((void)reduction::find_tile_model("scaled"), base::InputError) << "it is registered nowhere";
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
