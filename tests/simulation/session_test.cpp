// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

using mechanics::NodeValues;
using test::cantilever;
using test::complaint_of;
using test::honeycomb;
using testing::HasSubstr;
using tiling::TileIndex;

const std::vector<std::string> kPatterns = {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"};

Surface sample_surface(int columns = 5, int rows = 4) {
    return make_surface(honeycomb(columns, rows, kPatterns), nullptr);
}

SimulationOptions condensed(int threads = 1) {
    return {.model = "condensed", .threads = threads};
}

std::vector<TileIndex> tiles(std::initializer_list<int> numbers) {
    return {numbers.begin(), numbers.end()};
}

double largest_difference(const NodeValues& a, const NodeValues& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

/// The result of the session's project when it is simulated from rest.
simulation::SurfaceResult from_nothing(const Session& session) {
    return simulate(session.surface(), session.load_case(), session.options());
}

TEST(Session, KeepsTheFactorsUnderANewLoad) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    (void)session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Refactorized);
    session.set_load_case(cantilever({0.0, 0.3, 0.1}));
    const auto result = session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Kept);
    EXPECT_EQ(session.last_report().tiles_built, 0U);
    EXPECT_EQ(largest_difference(result.solution.displacements, from_nothing(session).solution.displacements),
              0.0);
}

TEST(Session, BuildsOnlyTheTileThatIsRepainted) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    (void)session.solve();
    session.paint(tiles({7}), "1-6+3-6");
    (void)session.solve();
    EXPECT_EQ(session.last_report().tiles_built, 1U);
    session.paint(tiles({7}), kPatterns[0]);
    (void)session.solve();
    EXPECT_EQ(session.last_report().tiles_built, 0U) << "a congruent tile of that pattern is there";
}

TEST(Session, CondensesCongruentTilesOnce) {
    for (const int first_vertex : {0, 1, 4}) {
        Session session(make_surface(honeycomb(20, 15, kPatterns, first_vertex), nullptr),
                        cantilever({0, 0, -0.1}), condensed());
        (void)session.solve();
        EXPECT_EQ(session.last_report().tiles_built, kPatterns.size());
    }
}

TEST(Session, SharesCongruentTilesThatAreTurned) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    (void)session.solve();
    session.turn(tiles({3, 4, 9}), 2);
    const auto result = session.solve();
    EXPECT_EQ(session.last_report().tiles_built, 0U);
    const auto again = from_nothing(session);
    EXPECT_LT(largest_difference(result.solution.displacements, again.solution.displacements),
              1e-9 * again.solution.displacements.cwiseAbs().maxCoeff());
}

TEST(Session, ATurnedTileCostsNoMoreThanARepaintedOne) {
    Session session(make_surface(honeycomb(20, 15, kPatterns), nullptr), cantilever({0.1, 0.05, -0.2}),
                    condensed());
    (void)session.solve();
    session.turn(tiles({3}), 2);
    (void)session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Updated);
    std::vector<TileIndex> all;
    for (int t = 0; t < 300; ++t) all.emplace_back(t);
    session.turn(all, 1);
    const auto result = session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Refactorized);
    EXPECT_EQ(largest_difference(result.solution.displacements, from_nothing(session).solution.displacements),
              0.0);
}

/// The tile that is kept is that of the rounded polygon, so its bits do not depend on which tile came first.
TEST(Session, DoesNotDependOnTheOrderInWhichCongruentTilesCame) {
    Session forward(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    Session backward(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    (void)forward.solve();
    backward.paint(tiles({0}), kPatterns[2]);
    (void)backward.solve();
    backward.paint(tiles({0}), kPatterns[0]);
    const auto b = backward.solve();
    EXPECT_LT(largest_difference(forward.solve().solution.displacements, b.solution.displacements),
              1e-9 * b.solution.displacements.cwiseAbs().maxCoeff());
}

/// One random edit of any kind. An edit that is refused changes nothing.
void edit(Session& session, base::RandomStream& random) {
    const auto below = [&](int count) { return static_cast<int>(random.uniform() * count); };
    const auto force = [&] { return Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform()); };
    const auto some_tile = [&] { return tiles({below(20)}); };
    switch (below(8)) {
        case 0:
            return session.paint(some_tile(), kPatterns[static_cast<std::size_t>(below(3))]);
        case 1:
            return session.paint(some_tile(), "1-6+3-6");
        case 2:
            return session.turn(some_tile(), below(6) - 2);
        case 3:
            return session.set_load_case(cantilever(force()));
        case 4:
            return session.set_load(static_cast<std::size_t>(below(2)), {NodesAtSide{Side::Top}, force()});
        case 5:
            return session.set_support(1, {NodesById{{below(50)}}, mechanics::DofSet::translations()});
        case 6: {
            reduction::Setting setting = session.surface().setting;
            setting.material.young_modulus *= 0.8 + 0.4 * random.uniform();
            return session.set_setting(setting);
        }
        default:
            return session.set_prescribed(0, {NodesById{{below(50)}}, mechanics::Dof::uz, 0.001});
    }
}

/// Whatever the edits, the answer is that of the final project.
TEST(Session, GivesTheAnswerOfTheFinalProjectAfterAnyEdits) {
    base::RandomStream random(11, 0);
    for (int run = 0; run < 6; ++run) {
        Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
        for (int i = 0; i < 25; ++i) {
            edit(session, random);
            if (random.uniform() < 0.5) continue;  // several edits between two solutions
            const auto edited = session.solve();
            const auto anew = from_nothing(session);
            const double size = anew.solution.displacements.cwiseAbs().maxCoeff();
            // Another order of elimination changes these surfaces by some 1e-12 of the largest displacement.
            EXPECT_LT(largest_difference(edited.solution.displacements, anew.solution.displacements),
                      1e-10 * size);
            EXPECT_LT(edited.solution.residual, 1e-9);
            if (session.last_report().factors == Session::Report::Factors::Refactorized) {
                EXPECT_EQ(largest_difference(edited.solution.displacements, anew.solution.displacements), 0.0)
                    << "run " << run << ", edit " << i;
            }
        }
    }
}

/// Small enough for one stable equilibrium; the tolerance is that of the residuals on both sides.
TEST(Session, GoesOnFromTheLastNonlinearEquilibrium) {
    Session session(sample_surface(3, 2), cantilever({0.0, 0.0, -0.02}), {.model = "full", .threads = 1});
    (void)session.solve();
    EXPECT_EQ(session.last_report().starting_point, mechanics::StartingPoint::Rest);
    session.set_load_case(cantilever({0.002, 0.001, -0.022}));
    const auto result = session.solve();
    EXPECT_EQ(session.last_report().starting_point, mechanics::StartingPoint::LastEquilibrium);
    const auto anew = from_nothing(session);
    EXPECT_LT(largest_difference(result.solution.displacements, anew.solution.displacements),
              1e-7 * anew.solution.displacements.cwiseAbs().maxCoeff());
    EXPECT_LT(result.solution.iterations, anew.solution.iterations);
    session.paint(tiles({1}), "1-6+3-6");
    (void)session.solve();
    EXPECT_EQ(session.last_report().starting_point, mechanics::StartingPoint::Rest)
        << "a full tile has other nodes";
}

TEST(Session, FailsAgainWhereASolveFailed) {
    Surface surface = sample_surface();
    reduction::Calibration calibration;
    calibration.model = "paper6";
    calibration.parameters = {{"A", 4e-6},  {"I2", 1e-12},  {"I3", 1e-12},
                              {"J", 1e-12}, {"theta", 0.1}, {"R", 0.01}};
    surface.calibrations.assign(surface.tessellation.patterns.size(), {calibration});
    Session session(surface, cantilever({0, 0, -0.1}), {.model = "paper6"});
    (void)session.solve();
    EXPECT_THAT(complaint_of([&] { session.set_calibrations({{}, {}, {}}); }), HasSubstr("no calibration"));
    (void)session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Kept)
        << "what was refused changed nothing";
    calibration.parameters[0].value = 0.0;
    session.set_calibrations(std::vector<std::vector<reduction::Calibration>>(
        surface.tessellation.patterns.size(), {calibration}));
    EXPECT_THROW((void)session.solve(), base::InputError) << "beams without an area";
    EXPECT_THROW((void)session.solve(), base::InputError) << "not the answer before the edit";
    reduction::Setting setting = surface.setting;
    setting.section.area = 0.0;
    EXPECT_THROW(session.set_setting(setting), base::InputError);
}

TEST(Session, AnEditThatIsRefusedChangesNothing) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    const auto before = session.solve();
    EXPECT_THAT(complaint_of([&] { session.paint(tiles({400}), kPatterns[0]); }), HasSubstr("no tile 400"));
    EXPECT_THAT(complaint_of([&] { session.paint(tiles({1}), "0-99"); }), HasSubstr("0-99"));
    EXPECT_THAT(complaint_of([&] { session.set_model("paper6"); }), HasSubstr("no calibration"));
    EXPECT_THAT(complaint_of([&] { session.set_model("condensd"); }), HasSubstr("condensed"));
    EXPECT_THAT(complaint_of([&] { session.set_tile_model(tiles({1}), "paper6"); }),
                HasSubstr("no calibration"));
    EXPECT_THAT(complaint_of([&] {
                    session.set_support(0, {NodesById{{100000}}, mechanics::DofSet::all()});
                }),
                HasSubstr("100000"));
    EXPECT_THAT(complaint_of([&] { session.set_load(5, {NodesAtSide{Side::Top}}); }), HasSubstr("no load 5"));
    reduction::Setting without_thickness = session.surface().setting;
    without_thickness.tile_side = -1.0;
    EXPECT_THROW(session.set_setting(without_thickness), base::Error);
    const auto after = session.solve();
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Kept);
    EXPECT_EQ(largest_difference(before.solution.displacements, after.solution.displacements), 0.0);
}

TEST(Session, UsesTheModelsChosenForSomeTiles) {
    Session session(sample_surface(), cantilever({0.0, 0.0, -0.001}), condensed());
    const auto linear = session.solve();
    session.set_tile_model(tiles({0, 1}), "full");
    const auto mixed = session.solve();
    EXPECT_EQ(mixed.solver, "newton");
    EXPECT_GT(mixed.nodes.size(), linear.nodes.size());
    session.set_tile_model(tiles({0, 1}), "");
    const auto again = session.solve();
    EXPECT_EQ(largest_difference(again.solution.displacements, linear.solution.displacements), 0.0);
}

TEST(Session, GivesTheSameBitsWithAnyNumberOfThreads) {
    const auto solve_with = [](int threads) {
        Session session(sample_surface(12, 10), cantilever({0.1, 0.05, -0.2}), condensed(threads));
        (void)session.solve();
        session.paint(tiles({5, 50}), "1-6+3-6");
        return session.solve().solution.displacements;
    };
    EXPECT_EQ(largest_difference(solve_with(1), solve_with(4)), 0.0);
}

TEST(Session, KeepsItsEditsWhenASolveIsStopped) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    (void)session.solve();
    session.paint(tiles({3}), "1-6+3-6");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)session.solve({stop.get_token(), nullptr}), base::Stopped);
    const auto result = session.solve();
    EXPECT_EQ(largest_difference(result.solution.displacements, from_nothing(session).solution.displacements),
              0.0);
}

TEST(Session, RefusesMotionsInASolutionThatIsOlderThanAnEditOfTiles) {
    Session session(sample_surface(3, 2), cantilever({0.0, 0.0, -0.02}),
                    {.model = "corotational", .threads = 1});
    const auto before = session.solve();
    const auto expect_refused = [&](const char* edit) {
        EXPECT_THROW((void)session.beam_motion(TileIndex(3), before.solution), base::InputError) << edit;
        EXPECT_THROW((void)session.motion_gradient(TileIndex(3), before.solution, NodeValues()),
                     base::InputError)
            << edit;
        EXPECT_THROW((void)session.energy_gradient(before.solution), base::InputError) << edit;
    };
    session.set_load_case(cantilever({0.0, 0.0, -0.01}));
    EXPECT_TRUE(session.beam_motion(TileIndex(3), before.solution)) << "no tile is another";
    session.paint(tiles({3}), "1-6+3-6");
    expect_refused("another pattern");
    (void)session.solve_adjoint(Eigen::MatrixXd::Zero(before.solution.displacements.size(), 1));
    expect_refused("another pattern, which is built");
    (void)session.solve();
    reduction::Setting setting = session.surface().setting;
    setting.material.young_modulus *= 2.0;
    session.set_setting(setting);
    expect_refused("another setting");
    const auto after = session.solve();
    EXPECT_TRUE(session.beam_motion(TileIndex(3), after.solution));
    EXPECT_EQ(session.energy_gradient(after.solution).rows(), after.solution.displacements.rows());
}

TEST(Session, KnowsASolutionOfOtherTilesAfterANewSolve) {
    for (const char* model : {"corotational", "condensed", "mixed:0.2"}) {
        Session session(sample_surface(3, 2), cantilever({0.0, 0.0, -0.02}), {.model = model, .threads = 1});
        const auto before = session.solve();
        EXPECT_NO_THROW(session.require_since_edit(before.solution)) << model;
        session.paint(tiles({3}), "1-6+3-6");
        const auto after = session.solve();
        EXPECT_THROW(session.require_since_edit(before.solution), base::InputError) << model;
        EXPECT_THROW((void)session.energy_gradient(before.solution), base::InputError) << model;
        EXPECT_NO_THROW(session.require_since_edit(after.solution)) << model;
        session.set_load_case(cantilever({0.0, 0.0, -0.01}));
        (void)session.solve();
        EXPECT_NO_THROW(session.require_since_edit(after.solution)) << model << ": no tile is another";
    }
}

TEST(Session, TakesASolutionThatOtherTilesHaveToo) {
    Session session(sample_surface(3, 2), cantilever({0.0, 0.0, 0.0}), condensed());
    const auto at_rest = session.solve();
    session.paint(tiles({3}), "1-6+3-6");
    (void)session.solve();
    EXPECT_NO_THROW(session.require_since_edit(at_rest.solution));
}

TEST(Session, RefusesDeformationsInASolutionWithOtherNodes) {
    Session session(sample_surface(3, 2), cantilever({0.0, 0.0, -0.02}), condensed());
    const auto few = session.solve();
    EXPECT_THROW((void)Session(sample_surface(3, 2), cantilever({0, 0, 1}), condensed())
                     .tile_deformations(few.solution),
                 base::InputError)
        << "never solved";
    EXPECT_EQ(session.tile_deformations(few.solution).size(), 6U);
    session.set_model("full");
    (void)session.solve();
    EXPECT_THROW((void)session.tile_deformations(few.solution), base::InputError);
}

/// K^-1 g by reciprocity: what a unit load at a does at b, a unit load at b does at a.
TEST(Session, SolvesAdjointSystems) {
    Session session(sample_surface(), cantilever({0.1, 0.05, -0.2}), condensed());
    const auto result = session.solve();
    const auto rows = static_cast<Eigen::Index>(result.nodes.size()) * 6;
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(rows, 2);
    units(6 * 30 + 2, 0) = 1.0;
    units(6 * 40 + 4, 1) = 1.0;
    const Eigen::MatrixXd answers = session.solve_adjoint(units);
    EXPECT_EQ(session.last_report().factors, Session::Report::Factors::Kept);
    EXPECT_EQ(session.last_report().tiles_built, 0U);
    EXPECT_NEAR(answers(6 * 40 + 4, 0), answers(6 * 30 + 2, 1), 1e-9 * answers.cwiseAbs().maxCoeff());
    session.set_load_case([] {
        LoadCase load_case = cantilever({0, 0, 0});
        load_case.loads = {{NodesById{{30}}, {0, 0, 1}}};
        return load_case;
    }());
    const NodeValues loaded = session.solve().solution.displacements;
    EXPECT_NEAR(answers(6 * 40 + 4, 0), loaded(40, 4), 1e-9 * loaded.cwiseAbs().maxCoeff());
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
