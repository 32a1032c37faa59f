// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/reduction/response.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

const std::vector<std::string> kPatterns = {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"};

Surface sample_surface() {
    return make_surface(test::honeycomb(4, 3, kPatterns, 1), nullptr);
}

Surface surface_with_stiff_joints() {
    Surface surface = sample_surface();
    surface.setting.joints = reduction::Joints::Stiff;
    return surface;
}

/// The beams as a model moves them.
BeamState state_of(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options) {
    Session session(surface, load_case, options);
    const simulation::SurfaceResult result = session.solve();
    const SurfaceBeams beams = surface_beams(surface);
    return beam_state(session, result.solution, beams, beam_sections(beams, surface.setting));
}

TEST(SurfaceBeams, HaveTheNodesOfTheFullModel) {
    const Surface surface = sample_surface();
    const SurfaceBeams beams = surface_beams(surface);
    const simulation::SurfaceResult full =
        simulate(surface, test::cantilever({0, 0, -0.001}), {.model = "full"});
    ASSERT_EQ(beams.nodes.size(), full.nodes.size());
    for (std::size_t n = 0; n < full.nodes.size(); ++n) {
        EXPECT_EQ(beams.nodes[n], full.nodes[n].rest_position);
        EXPECT_EQ(n < beams.interface_nodes, full.nodes[n].is_interface);
    }
}

TEST(SurfaceBeams, OfTilesThatAreNotPaintedAreLeftOut) {
    Surface surface = sample_surface();
    const SurfaceBeams all = surface_beams(surface);
    surface.tessellation.tiles[2].pattern = -1;
    const SurfaceBeams beams = surface_beams(surface);
    EXPECT_EQ(beams.ends.size(), all.ends.size() - (all.starts[3].beam - all.starts[2].beam));
    EXPECT_EQ(beams.starts[2].beam, beams.starts[3].beam);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        for (std::size_t b = beams.starts[t].beam; b < beams.starts[t + 1].beam; ++b)
            EXPECT_EQ(beams.tiles[b], tiling::TileIndex(t));
    }
}

class BeamStateOfBothJoints : public testing::TestWithParam<reduction::Joints> {
  protected:
    static Surface surface() {
        return GetParam() == reduction::Joints::Stiff ? surface_with_stiff_joints() : sample_surface();
    }
};
INSTANTIATE_TEST_SUITE_P(Joints, BeamStateOfBothJoints,
                         testing::Values(reduction::Joints::Centreline, reduction::Joints::Stiff));

TEST_P(BeamStateOfBothJoints, OfCondensedTilesIsThatOfTheLinearFullModel) {
    const Surface surface = BeamStateOfBothJoints::surface();
    const LoadCase load_case = test::cantilever({0.3, 0.05, -0.1});
    const BeamState full = state_of(surface, load_case, {.model = "full", .analysis = Analysis::Linear});
    const BeamState condensed = state_of(surface, load_case, {.model = "condensed"});
    // Condensing is exact; tiles are condensed from polygons that are rounded to a billionth.
    constexpr double kRounding = 1e-7;
    EXPECT_LT((condensed.nodes - full.nodes).norm(), kRounding * full.nodes.norm());
    for (Eigen::Index field = 0; field < full.forces.cols(); ++field) {
        EXPECT_LT((condensed.forces.col(field) - full.forces.col(field)).norm(),
                  10 * kRounding * full.forces.col(field).norm())
            << kBeamFields[static_cast<std::size_t>(field)];
    }
}

TEST(BeamState, OfCorotationalTilesIsThatOfCondensedOnesWhereDisplacementsAreSmall) {
    const Surface surface = sample_surface();
    const LoadCase load_case = test::cantilever({3e-4, 5e-5, -1e-5});
    const BeamState condensed = state_of(surface, load_case, {.model = "condensed"});
    const BeamState corotational = state_of(surface, load_case, {.model = "corotational"});
    // Rotations are some 1e-4: what is of their second order is left out.
    EXPECT_LT((corotational.nodes - condensed.nodes).norm(), 1e-3 * condensed.nodes.norm());
    EXPECT_LT((corotational.forces - condensed.forces).norm(), 1e-2 * condensed.forces.norm());
}

TEST(BeamState, OfCorotationalTilesFollowsTheFullModelFarBeyondSmallDisplacements) {
    const Surface surface = sample_surface();
    const LoadCase load_case = test::cantilever({0, 0, -0.2});
    const BeamState full = state_of(surface, load_case, {.model = "full"});
    const BeamState corotational = state_of(surface, load_case, {.model = "corotational"});
    const double deflection = full.nodes.leftCols<3>().rowwise().norm().maxCoeff();
    ASSERT_GT(deflection, 0.02) << "an eighth of the span";
    // The model itself is off by some per cent here; inner nodes are not worse than interface nodes.
    const Eigen::VectorXd errors = (corotational.nodes - full.nodes).leftCols<3>().rowwise().norm();
    const auto interface_nodes = static_cast<Eigen::Index>(surface.tessellation.interface_nodes.size());
    EXPECT_LT(errors.maxCoeff(), 0.05 * deflection);
    EXPECT_LT(errors.maxCoeff(), 1.5 * errors.head(interface_nodes).maxCoeff());
    // Bending moments, of which a wrong frame would make nonsense.
    const Eigen::VectorXd moment_errors = corotational.forces.col(4) - full.forces.col(4);
    EXPECT_LT(moment_errors.norm(), 0.1 * full.forces.col(4).norm());
}

TEST_P(BeamStateOfBothJoints, OfTheFullModelMeetsTheLoadsAtEveryInnerNode) {
    // Nothing acts on inner nodes: the forces of the beams that meet there add up to nothing.
    const Surface surface = BeamStateOfBothJoints::surface();
    const SurfaceBeams beams = surface_beams(surface);
    Session session(surface, test::cantilever({0.3, 0.05, -0.1}),
                    {.model = "full", .analysis = Analysis::Linear});
    const auto result = session.solve();
    const BeamState state =
        beam_state(session, result.solution, beams, beam_sections(beams, surface.setting));
    std::vector<Eigen::Vector3d> sums(beams.nodes.size(), Eigen::Vector3d::Zero());
    for (std::size_t b = 0; b < beams.ends.size(); ++b) {
        const auto from = static_cast<std::size_t>(beams.ends[b][0]);
        const auto to = static_cast<std::size_t>(beams.ends[b][1]);
        const Eigen::Vector3d axis1 = (beams.nodes[to] - beams.nodes[from]).normalized();
        const Eigen::Vector3d axis3 = Eigen::Vector3d::UnitZ();
        const auto row = state.forces.row(static_cast<Eigen::Index>(2 * b));
        const Eigen::Vector3d force = row[0] * axis1 + row[1] * axis3.cross(axis1) + row[2] * axis3;
        sums[from] += force;
        sums[to] -= force;
    }
    const double scale = state.forces.leftCols<3>().cwiseAbs().maxCoeff();
    for (std::size_t n = beams.interface_nodes; n < sums.size(); ++n)
        EXPECT_LT(sums[n].norm(), 1e-8 * scale) << "node " << n;
}

TEST(BeamState, OfStiffJointsDeflectsLessAndBearsTheSameLoad) {
    const LoadCase load_case = test::cantilever({0.3, 0.05, 0});
    const SimulationOptions linear{.model = "full", .analysis = Analysis::Linear};
    const BeamState soft = state_of(sample_surface(), load_case, linear);
    const BeamState stiff = state_of(surface_with_stiff_joints(), load_case, linear);
    EXPECT_LT(stiff.nodes.leftCols<2>().norm(), 0.97 * soft.nodes.leftCols<2>().norm());
    EXPECT_NEAR(stiff.forces.col(0).norm(), soft.forces.col(0).norm(), 0.1 * soft.forces.col(0).norm())
        << "normal forces follow from statics but for what the joints shift among them";
}

TEST(BeamState, OfAResultThatWasReadIsThatOfItsSession) {
    const Surface surface = sample_surface();
    const LoadCase load_case = test::cantilever({0, 0, -0.2});
    const SurfaceBeams beams = surface_beams(surface);
    const auto sections = beam_sections(beams, surface.setting);
    for (const char* model : {"full", "condensed", "corotational"}) {
        Session session(surface, load_case, {.model = model});
        const BeamState expected = beam_state(session, session.solve().solution, beams, sections);
        const simulation::SurfaceResult result = simulate(surface, load_case, {.model = model});
        const BeamState state = beam_state(surface, result, beams, sections);
        EXPECT_EQ(state.nodes, expected.nodes) << model;
        EXPECT_EQ(state.forces, expected.forces) << model;
    }
    const BeamState mixed =
        beam_state(surface, simulate(surface, load_case, {.model = "mixed:0.3"}), beams, sections);
    EXPECT_TRUE(mixed.nodes.allFinite());
    EXPECT_THROW(beam_state(make_surface(test::honeycomb(4, 4, kPatterns, 1), nullptr),
                            simulate(surface, load_case, {.model = "full"}), surface_beams(surface), {}),
                 base::InputError);
}

TEST(BeamState, IsUnknownWhereATileModelHasOtherBeams) {
    reduction::TileModel substitute = reduction::find_tile_model("full");
    substitute.name = "substitute";
    substitute.build = [](const reduction::TileInput& input) {
        return reduction::beam_tile(reduction::fan_frame(input.layout, input.fan, input.polygon,
                                                         {input.setting->section, input.setting->material}),
                                    input.fan->interface_node_count);
    };
    const std::vector<reduction::TileModel> models = {substitute};
    const Surface surface = sample_surface();
    const BeamState state =
        state_of(surface, test::cantilever({0, 0, -0.001}), {.model = "substitute", .models = models});
    const auto interface_nodes = static_cast<Eigen::Index>(surface.tessellation.interface_nodes.size());
    EXPECT_TRUE(state.nodes.topRows(interface_nodes).allFinite());
    EXPECT_TRUE(state.nodes.bottomRows(state.nodes.rows() - interface_nodes).array().isNaN().all());
    EXPECT_TRUE(state.forces.array().isNaN().all());
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
