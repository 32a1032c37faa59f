// SPDX-License-Identifier: GPL-3.0-or-later
// A tile model from outside of the library, in this one file: simulated, and written by every writer.
#include "sample.hpp"

#include <fretwork/exports/tables/series_files.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <set>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using reduction::TileModel;
using testing::HasSubstr;

/// The condensed tile, twice as stiff, which tells how its beams move.
TileModel twofold_model() {
    TileModel model;
    model.name = "twofold";
    model.summary = "the condensed tile with twice its stiffness";
    model.sharing = reduction::Sharing::Congruent;  // built in the same axes as the condensed tile
    model.build = [](const reduction::TileInput& input) {
        const int interface_nodes = input.fan->interface_node_count;
        mechanics::Frame beams = reduction::fan_frame(input.layout, input.fan, input.polygon, input.setting);
        Eigen::MatrixXd stiffness = 2.0 * reduction::condensed_frame(beams, interface_nodes);
        return reduction::stiffness_tile(
            std::move(stiffness), std::make_shared<reduction::InnerNodes>(std::move(beams), interface_nodes));
    };
    return model;
}

const std::vector<TileModel>& catalogue() {
    static const std::vector<TileModel> rows = [] {
        std::vector<TileModel> all = reduction::tile_models();
        all.push_back(twofold_model());
        return all;
    }();
    return rows;
}

simulation::LoadCase cantilever() {
    simulation::LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right},
                               Eigen::Vector3d(0.0, 0.0, -0.001), Eigen::Vector3d::Zero(),
                               simulation::LoadCase::Amount::Total});
    return load_case;
}

simulation::SurfaceResult result_of(const simulation::Surface& surface, const std::string& model) {
    return simulation::simulate(surface, cantilever(), {.model = model, .models = catalogue()});
}

Scene scene_of(const std::string& model) {
    Scene scene{sample_surface()};
    scene.results = {{model, result_of(scene.surface, model)}};
    scene.picture.size = {64, 40};
    scene.models = catalogue();
    return scene;
}

TEST(ExternalModel, IsWrittenByEveryWriter) {
    const Scene scene = scene_of("twofold");
    for (const WriterRow& writer : writer_catalogue())
        EXPECT_GT(writer.write(scene).text.size(), 500U) << writer.ending;
    EXPECT_EQ(series_files(scene.surface, scene.results.front().result, "s", {}, catalogue()).size(), 2U);
}

TEST(ExternalModel, OfTilesIsInTheFactsOfALoadCase) {
    Scene scene = scene_of("twofold");
    scene.results.clear();
    scene.load_case = cantilever();
    scene.surface.tile_models.resize(scene.surface.tessellation.tiles.size());
    for (std::string& model : scene.surface.tile_models) model = "twofold";
    EXPECT_THAT(find_writer("facts.json").write(scene).text, HasSubstr("\"stress\""));
}

TEST(ExternalModel, IsNamedByEveryWriterThatDoesNotKnowIt) {
    Scene scene = scene_of("twofold");
    scene.models = reduction::tile_models();
    std::set<std::string_view> refusing;
    for (const WriterRow& writer : writer_catalogue()) {
        try {
            (void)writer.write(scene);
        } catch (const base::InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("twofold")) << writer.ending;
            refusing.insert(writer.ending);
        }
    }
    EXPECT_TRUE(refusing.contains(".vtu"));
    EXPECT_TRUE(refusing.contains(".png"));
    EXPECT_TRUE(refusing.contains(".html"));
}

// Twice the stiffness halves the displacements under a load, and so the forces in the same beams. A factor of
// two is exact in floating point.
TEST(ExternalModel, GivesTheForcesOfItsBeams) {
    const simulation::Surface surface = sample_surface();
    const auto table = [&](const std::string& model) {
        return simulation::beam_table(surface, result_of(surface, model), catalogue());
    };
    const auto twofold = table("twofold");
    const auto condensed = table("condensed");
    ASSERT_EQ(twofold.unknown, 0U);
    ASSERT_EQ(twofold.rows.size(), condensed.rows.size());
    for (std::size_t i = 0; i < condensed.rows.size(); ++i) {
        EXPECT_EQ(2.0 * twofold.rows[i].largest_stress(), condensed.rows[i].largest_stress());
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
