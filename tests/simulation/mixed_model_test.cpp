// SPDX-License-Identifier: GPL-3.0-or-later
#include "../support.hpp"
#include "honeycomb.hpp"

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>
#include <fretwork/simulation/results/tile_stability.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::cantilever;
using test::complaint_of;
using test::honeycomb;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tiling::TileIndex;

Surface surface() {
    return make_surface(honeycomb(4, 3, {"0-1+1-6", "1-6+3-6", "0-5+5-6"}), nullptr);
}

/// Bends the surface by more than half of its length.
LoadCase heavy() {
    return cantilever({0, 0, -0.3});
}

simulation::SurfaceResult solved(const std::string& model, const LoadCase& load_case = heavy()) {
    return simulate(surface(), load_case, {.model = model});
}

TEST(WorstTiles, HaveTheLargestProductsOfEnergyAndRotation) {
    const std::vector<TileDeformation> tiles = {{1.0, 0.1}, {3.0, 0.2}, {2.0, 0.0}, {0.1, 0.9}};
    EXPECT_THAT(worst_tiles(tiles, 0.5), ElementsAre(TileIndex(1), TileIndex(0)));
    EXPECT_THAT(worst_tiles(tiles, 0.51), ElementsAre(TileIndex(1), TileIndex(0), TileIndex(3)))
        << "rounded up";
    EXPECT_THAT(worst_tiles(tiles, 1.0), ElementsAre(TileIndex(1), TileIndex(0), TileIndex(3)))
        << "a tile that is not deformed is not worth its beams";
    EXPECT_THAT(worst_tiles(tiles, 0.0), IsEmpty());
    EXPECT_EQ(worst_tiles(std::vector(100, TileDeformation{1.0, 1.0}), 0.07).size(), 7U)
        << "0.07 times 100 is a little above 7 in floating point";
}

TEST(MixedModel, ShareIsANumberFromZeroToOne) {
    EXPECT_EQ(mixed_share("mixed:0.05"), 0.05);
    EXPECT_EQ(mixed_share("mixed:1"), 1.0);
    EXPECT_EQ(mixed_share("corotational"), std::nullopt);
    EXPECT_THAT(complaint_of([&] { (void)mixed_share("mixed"); }), HasSubstr("is missing, as in mixed:0.05"));
    for (const char* wrong : {"mixed:", "mixed:1.5", "mixed:-0.1", "mixed:nan", "mixed:5%", "mixed:0.1 "})
        EXPECT_THAT(complaint_of([&] { (void)mixed_share(wrong); }), HasSubstr("from 0 to 1")) << wrong;
}

TEST(MixedModel, ReachesFromCorotationalTilesToTheFullModel) {
    const auto full = solved("full");
    const auto corotational = solved("corotational");
    EXPECT_EQ(solved("mixed:0").solution.displacements, corotational.solution.displacements);
    const auto all = solved("mixed:1");
    EXPECT_EQ(all.subject->full_tiles.size(), 12U);
    EXPECT_LT(compare(full, all).relative_l2_error, 1e-7);  // the residual both are solved to
    const auto some = solved("mixed:0.25");
    EXPECT_EQ(some.subject->full_tiles.size(), 3U);
    EXPECT_EQ(some.subject->model, "mixed:0.25");
    EXPECT_LT(compare(full, some).mean_translation_error, compare(full, corotational).mean_translation_error);
}

TEST(MixedModel, TilesWithAModelOfTheirOwnKeepIt) {
    Surface painted = surface();
    painted.tile_models.assign(12, "full");
    painted.tile_models[0] = "";
    const auto result = simulate(painted, heavy(), {.model = "mixed:1"});
    EXPECT_THAT(result.subject->full_tiles, ElementsAre(0));
    EXPECT_EQ(result.subject->model, "mixed:1; full (11 tiles)");
}

/// Also where they would be among the worst.
TEST(MixedModel, PutsNoTileInFullThatHasAModelOfItsOwn) {
    const auto free = solved("mixed:0.1");
    Surface painted = surface();
    painted.tile_models.assign(12, "");
    for (const int tile : free.subject->full_tiles) painted.tile_models[tile] = "condensed";
    const auto result = simulate(painted, heavy(), {.model = "mixed:0.1"});
    EXPECT_EQ(result.subject->full_tiles.size(), free.subject->full_tiles.size());
    for (const int tile : result.subject->full_tiles) EXPECT_EQ(painted.tile_models[tile], "") << tile;
    EXPECT_EQ(result.subject->model, "mixed:0.1; condensed (2 tiles)");
}

TEST(MixedModel, ASessionAnswersEditsAsTheEditedSurfaceIsAnswered) {
    Session session(surface(), heavy(), {.model = "mixed:0.25"});
    const auto expect_as_from_nothing = [&](const std::string& what) {
        const auto found = session.solve();
        const auto expected = simulate(session.surface(), session.load_case(), session.options());
        EXPECT_LT(compare(expected, found).relative_l2_error, 1e-6) << what;
        std::vector<int> full;
        for (const TileIndex tile : session.full_tiles()) full.push_back(tile.value);
        EXPECT_EQ(full, expected.subject->full_tiles) << what;
    };
    expect_as_from_nothing("first");
    session.set_load(0, cantilever({0, 0, -0.33}).loads[0]);
    expect_as_from_nothing("another load");
    EXPECT_EQ(session.last_report().starting_point, mechanics::StartingPoint::LastEquilibrium);
    session.paint(std::vector{TileIndex(5)}, "0-5+5-6");
    expect_as_from_nothing("a repainted tile");
    session.set_tile_model(std::vector{session.full_tiles()[0]}, "condensed");
    expect_as_from_nothing("a tile with a model of its own");
    session.set_model("corotational");
    expect_as_from_nothing("corotational");
    session.set_model("mixed:0.5");
    expect_as_from_nothing("mixed again");
    EXPECT_EQ(session.options().model, "mixed:0.5");
}

TEST(MixedModel, HasNoDerivativesBeforeItIsSolved) {
    Session session(surface(), heavy(), {.model = "corotational"});
    const auto corotational = session.solve();
    ASSERT_TRUE(corotational.solution.converged());
    EXPECT_NO_THROW((void)session.linearize());
    session.set_model("mixed:0.25");
    EXPECT_THROW((void)session.linearize(), base::InputError) << "the solution was of another model";
    EXPECT_THROW((void)session.energy_gradient(corotational.solution), base::InputError);
    ASSERT_TRUE(session.solve().solution.converged());
    EXPECT_NO_THROW((void)session.linearize());
    session.set_model("mixed:0.5");
    EXPECT_THROW((void)session.linearize(), base::InputError) << "nor is it that of corotational tiles";
}

TEST(MixedModel, AsksOnceForTheCalibrationsOfAPattern) {
    int calls = 0;
    Session session(surface(), cantilever({0, 0, -0.1}), {.model = "mixed:0.25"}, [&](const std::string&) {
        if (++calls > 1) throw base::InputError("the library has gone");
        return std::vector<reduction::Calibration>{};
    });
    EXPECT_NO_THROW(session.paint(std::vector{TileIndex(5)}, "0-6"));
    EXPECT_EQ(calls, 1);
    const auto found = session.solve();
    ASSERT_FALSE(session.full_tiles().empty());
    const auto expected = simulate(session.surface(), session.load_case(), session.options());
    EXPECT_LT(compare(expected, found).relative_l2_error, 1e-6);
}

TEST(MixedModel, IsForLargeDisplacements) {
    EXPECT_THAT(complaint_of([&] {
                    simulate(surface(), heavy(), {.model = "mixed:0.1", .analysis = Analysis::Linear});
                }),
                HasSubstr("large displacements"));
}

/// Within a factor of two: what larger surfaces show is in experiments/large_deflections.
TEST(ModelError, IsEstimatedForEveryReducedModelThatHasOne) {
    const auto full = solved("full");
    for (const char* model : {"corotational", "condensed"}) {
        const auto result = simulate(surface(), heavy(), {.model = model, .estimate_model_error = true});
        ASSERT_TRUE(result.model_error) << model;
        const Comparison truth = compare(full, result);
        EXPECT_NEAR(result.model_error->relative_l2, truth.relative_l2_error, 0.5 * truth.relative_l2_error);
        const double mean = truth.mean_translation_error / truth.max_displacement;
        EXPECT_NEAR(result.model_error->mean, mean, 0.5 * mean) << model;
        EXPECT_EQ(result.solution.displacements, solved(model).solution.displacements) << model;
    }
}

TEST(StressRefinement, EndsWithTheTilesAroundTheWorstBeamInFull) {
    Session session(surface(), heavy(), {.model = "corotational"});
    const RefinedStress refined = refine_stress(session, {});
    ASSERT_TRUE(refined.is_settled);
    EXPECT_GT(refined.solutions, 1);
    EXPECT_LT(refined.full_tiles.size(), surface().tessellation.tiles.size());
    const BeamRow worst = most_stressed(refined.table, 1).front();
    for (const TileIndex tile : tiles_around(surface(), worst))
        EXPECT_TRUE(std::ranges::binary_search(refined.full_tiles, tile)) << tile.value;
    const auto largest = [](const BeamTable& table) {
        return most_stressed(table, 1).front().largest_von_mises();
    };
    const double truth = largest(beam_table(surface(), solved("full")));
    const double before = largest(beam_table(surface(), solved("corotational")));
    EXPECT_LT(std::abs(largest(refined.table) - truth), std::abs(before - truth));
}

TEST(StressRefinement, IsOfNonlinearReducedResults) {
    EXPECT_THAT(complaint_of([] { (void)refine_stress(surface(), solved("full")); }),
                HasSubstr("model 'full'"));
    const SurfaceResult read = solved("mixed:0.1");
    EXPECT_TRUE(refine_stress(surface(), read).is_settled);
}

TEST(ModelError, CoversTheLargestStress) {
    const auto largest = [](const SurfaceResult& result) {
        return most_stressed(beam_table(surface(), result), 1).front().largest_von_mises();
    };
    const double truth = largest(solved("full"));
    for (const char* model : {"corotational", "condensed"}) {
        const auto result = simulate(surface(), heavy(), {.model = model, .estimate_model_error = true});
        ASSERT_TRUE(result.model_error && result.model_error->largest_stress) << model;
        const double error = std::abs(largest(result) - truth) / truth;
        EXPECT_NEAR(*result.model_error->largest_stress, error, 0.5 * error + 1e-3) << model;
    }
}

TEST(ModelError, IsRefusedWhereThereIsNoBetterModel) {
    const auto complaint = [](const std::string& model) {
        return complaint_of(
            [&] { simulate(surface(), heavy(), {.model = model, .estimate_model_error = true}); });
    };
    EXPECT_THAT(complaint("full"), HasSubstr("is the reference"));
}

/// Corotational tiles are not made of beams, as those of the result may be.
TEST(ModelError, IsEstimatedWithoutTheErrorOfBeams) {
    Surface painted = surface();
    painted.tile_models.assign(12, "");
    painted.tile_models[0] = "full";
    const SimulationOptions wanted{.model = "paper6", .estimate_error = true, .estimate_model_error = true};
    EXPECT_NO_THROW(wanted.validate(painted));
    const SimulationOptions options = estimating_options(painted, wanted);
    EXPECT_EQ(options.model, "corotational");
    EXPECT_FALSE(options.estimate_error);
    EXPECT_FALSE(options.estimate_model_error);
}

TEST(ModelError, OfAMixedModelIsThatFromMoreTilesInFull) {
    EXPECT_EQ(better_share("corotational"), 0.3);
    EXPECT_EQ(better_share("corotational", {.tile_rotation = 0.4}), 1.0);
    EXPECT_EQ(better_share("mixed:0.1", {.tile_rotation = 0.4}), 1.0);
    EXPECT_EQ(better_share("mixed:0.1"), 0.1 + 0.6);
    EXPECT_EQ(better_share("mixed:0.8"), 1.0);
    EXPECT_EQ(mixed_model(better_share("mixed:0.1")), "mixed:0.7");
    const auto result = simulate(surface(), heavy(), {.model = "mixed:0.1", .estimate_model_error = true});
    ASSERT_TRUE(result.model_error);
    EXPECT_EQ(result.solution.displacements, solved("mixed:0.1").solution.displacements);
    EXPECT_EQ(result.subject->full_tiles, solved("mixed:0.1").subject->full_tiles);
    const Comparison truth = compare(solved("full"), result);
    EXPECT_NEAR(result.model_error->relative_l2, truth.relative_l2_error, 0.5 * truth.relative_l2_error);
}

SurfaceResult doubted(const std::string& model, const LoadCase& load_case,
                      mechanics::Branch branch = mechanics::Branch::Primary) {
    return simulate(surface(), load_case,
                    {.model = model, .estimate_where_doubtful = true, .branch = branch});
}

TEST(ModelDoubt, IsTheLargestTurnInATile) {
    const auto result = doubted("corotational", heavy());
    Session session(surface(), heavy(), {.model = "corotational"});
    double largest = 0.0;
    for (const TileDeformation& tile : session.tile_deformations(session.solve().solution))
        largest = std::max(largest, tile.rotation);
    ASSERT_TRUE(result.model_doubt);
    EXPECT_EQ(result.model_doubt->tile_rotation, largest);
    EXPECT_EQ(result.model_doubt->change, 0.0);
}

TEST(ModelDoubt, OfAMixedModelIsAlsoTheChangeByItsTilesInFull) {
    const auto result = doubted("mixed:0.1", heavy());
    const Comparison change = compare(solved("mixed:0.1"), solved("corotational"));
    ASSERT_TRUE(result.model_doubt);
    EXPECT_DOUBLE_EQ(result.model_doubt->change, change.max_translation_error / change.max_displacement);
}

TEST(ModelDoubt, HasNoChangeWhereAMixedSolutionWasNotFound) {
    Session session(surface(), heavy(), {.model = "mixed:0.1"});
    SurfaceResult result = session.solve();
    EXPECT_GT(model_doubt(session, result).change, 0.0);
    result.solution.termination = mechanics::Termination::LimitLoad;
    const ModelDoubt doubt = model_doubt(session, result);
    EXPECT_EQ(doubt.change, 0.0);
    result.subject = result_subject(surface(), heavy(), session.options());
    EXPECT_FALSE(estimate_model_error(session, result, doubt, surface(), result));
    EXPECT_EQ(session.options().model, "mixed:0.1") << "no better solution was looked for";
}

TEST(ModelDoubt, HasTheErrorEstimatedWhereItIsLarge) {
    const LoadCase light = cantilever({0, 0, -0.01});
    const LoadCase far = cantilever({0, 0, -3.0});
    for (const char* model : {"corotational", "mixed:0.1"}) {
        const auto plain = doubted(model, light);
        ASSERT_TRUE(plain.model_doubt) << model;
        EXPECT_FALSE(is_doubtful(plain)) << model;
        EXPECT_FALSE(plain.model_error) << model;
        EXPECT_EQ(model_warning(plain), "") << model;
        const auto result = doubted(model, far);
        ASSERT_TRUE(is_doubtful(result)) << model;
        const auto better = solved(mixed_model(better_share(model, *result.model_doubt)), far);
        ASSERT_TRUE(result.model_error) << model;
        EXPECT_NEAR(result.model_error->largest, model_error(result, better)->largest, 1e-6) << model;
        EXPECT_EQ(result.solution.displacements, solved(model, far).solution.displacements) << model;
    }
    EXPECT_FALSE(doubted("full", far).model_doubt) << "the reference";
    EXPECT_FALSE(doubted("condensed", far).model_doubt) << "a linear solution has a range";
}

/// A better solution follows the same branch.
TEST(ModelDoubt, HasTheErrorEstimatedOnEveryBranch) {
    const LoadCase far = cantilever({0, 0, -3.0});
    const auto primary = doubted("corotational", far);
    const auto stable = doubted("corotational", far, mechanics::Branch::Stable);
    ASSERT_TRUE(primary.solution.stable) << "else the branches differ";
    ASSERT_TRUE(primary.model_error && stable.model_error);
    EXPECT_NEAR(stable.model_error->largest, primary.model_error->largest, 1e-6);
}

TEST(ModelDoubt, IsWarnedOfWhereNoErrorIsEstimated) {
    SurfaceResult result;
    result.solution.termination = mechanics::Termination::Converged;
    result.model_doubt = ModelDoubt{.tile_rotation = 2.0 * kDoubtfulRotation};
    EXPECT_THAT(model_warning(result), HasSubstr("nothing was estimated"));
}

/// What is asked for and what is estimated by itself are the same estimate.
TEST(ModelDoubt, IsTheEstimateThatIsAskedFor) {
    const LoadCase far = cantilever({0, 0, -3.0});
    const auto own = doubted("corotational", far);
    const auto asked = simulate(surface(), far, {.model = "corotational", .estimate_model_error = true});
    ASSERT_TRUE(own.model_error && asked.model_error);
    EXPECT_GT(own.model_doubt->tile_rotation, kFarRotation) << "else it says nothing";
    EXPECT_EQ(*own.model_error, *asked.model_error);
    EXPECT_EQ(own.model_error->full_share, 1.0);
    const auto near = simulate(surface(), cantilever({0, 0, -0.1}),
                               {.model = "corotational", .estimate_model_error = true});
    ASSERT_TRUE(near.model_error);
    EXPECT_GT(near.model_error->full_share, 0.0);
    EXPECT_LT(near.model_error->full_share, 1.0);
}

TEST(ModelDoubt, HasTheErrorOfTheStressEstimated) {
    const LoadCase far = cantilever({0, 0, -3.0});
    const auto largest = [](const SurfaceResult& result) {
        return most_stressed(beam_table(surface(), result), 1).front().largest_von_mises();
    };
    const double truth = largest(solved("full", far));
    for (const char* model : {"corotational", "mixed:0.1"}) {
        const auto result = doubted(model, far);
        ASSERT_TRUE(result.model_error && result.model_error->largest_stress) << model;
        const double error = std::abs(largest(result) - truth) / truth;
        EXPECT_NEAR(*result.model_error->largest_stress, error, 0.5 * error + 1e-3) << model;
    }
}

TEST(ModelDoubt, IsLargeWhereThePathTookManySolves) {
    SurfaceResult result;
    result.solution.iterations = 1000;
    EXPECT_FALSE(is_doubtful(result)) << "a result without a doubt, as of the full model";
    result.model_doubt = ModelDoubt{};
    EXPECT_TRUE(is_doubtful(result));
    result.solution.iterations = 10;
    EXPECT_FALSE(is_doubtful(result));
}

TEST(ModelWarning, NamesAnErrorThatMayBeFivePercent) {
    SurfaceResult result;
    result.solution.termination = mechanics::Termination::Converged;
    result.model_error = ModelError{.mean = 0.01, .largest = 0.029};
    EXPECT_EQ(model_warning(result), "");
    result.model_error->largest = 0.049;
    EXPECT_NE(model_warning(result), "") << "it may be larger than it was estimated";
    result.model_error->full_share = 1.0;
    EXPECT_EQ(model_warning(result), "") << "it was not estimated: all tiles were in full";
    result.model_error->largest = 0.17;
    EXPECT_THAT(model_warning(result), HasSubstr("about 17 % of the largest displacement"));
    EXPECT_THAT(model_warning(result), testing::Not(HasSubstr("stress"))) << "it is not known";
    result.model_error->largest_stress = 0.24;
    EXPECT_THAT(model_warning(result), HasSubstr("by 24 % of the largest stress"));
}

TEST(MixedModel, DiscretizationErrorIsRefusedByItsName) {
    EXPECT_THAT(
        complaint_of([&] { simulate(surface(), heavy(), {.model = "mixed:0.05", .estimate_error = true}); }),
        HasSubstr("the discretization error of mixed:0.05"));
}

/// Straight beams of 22.5 mm and 2 x 2 mm from a tile's center to its sides. Two opposite ones are one beam
/// of twice that length, clamped at its ends: Euler's strain is 4 pi^2 I / (A l^2) = 0.0065.
TEST(BuckledTiles, AreThoseWhoseBeamsBuckleWhileTheInterfaceIsHeld) {
    const Surface two = make_surface(honeycomb(2, 1, {"0-6"}), nullptr);
    const auto buckled = [&](double strain) {
        mechanics::Solution solution;
        const auto& nodes = two.tessellation.interface_nodes;
        solution.displacements = mechanics::NodeValues::Zero(std::ssize(nodes), mechanics::kDofsPerNode);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            solution.displacements.row(static_cast<Eigen::Index>(i)).head<2>() << -strain * nodes[i].x,
                -strain * nodes[i].y;
        return buckled_tiles(two, solution, {});
    };
    EXPECT_THAT(buckled(0.0), IsEmpty());
    EXPECT_THAT(buckled(0.005), IsEmpty());
    EXPECT_THAT(buckled(0.01), ElementsAre(TileIndex(0), TileIndex(1)));
    EXPECT_THAT(buckled(-0.01), IsEmpty()) << "pulled";
}

TEST(BuckledTiles, ATurnOfTheWholeBucklesNothing) {
    const Surface two = make_surface(honeycomb(2, 1, {"0-1+1-6"}), nullptr);
    const auto& nodes = two.tessellation.interface_nodes;
    const Eigen::Vector3d turn(0.3, 2.0, -1.0);
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    mechanics::Solution solution;
    solution.displacements.resize(std::ssize(nodes), mechanics::kDofsPerNode);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Eigen::Vector3d place(nodes[i].x, nodes[i].y, 0.0);
        solution.displacements.row(static_cast<Eigen::Index>(i)) << (rotation * place - place).transpose(),
            turn.transpose();
    }
    EXPECT_THAT(buckled_tiles(two, solution, {}), IsEmpty());
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
