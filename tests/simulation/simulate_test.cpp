// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/surface_frame.hpp>

namespace fretwork::simulation {
namespace THIS_TEST {

using mechanics::NodeValues;
using test::cantilever;
using test::complaint_of;
using test::honeycomb;
using testing::HasSubstr;

/// Patterns with the center and without, with the face node and without.
const std::vector<std::string> kPatterns = {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"};

NodeValues interface_rows(const simulation::SurfaceResult& result, const Surface& surface) {
    return result.solution.displacements.topRows(
        static_cast<Eigen::Index>(surface.tessellation.interface_nodes.size()));
}

double relative_difference(const NodeValues& a, const NodeValues& b) {
    return (a - b).norm() / a.norm();
}

/// A calibration of every model with any admissible values: these tests do not depend on them.
Surface with_parameters(Surface surface) {
    std::vector<reduction::Calibration> calibrations;
    for (const reduction::TileModel& model : reduction::tile_models()) {
        if (model.parameters.empty()) continue;
        reduction::Calibration& calibration = calibrations.emplace_back();
        calibration.model = model.name;
        for (const reduction::TileParameter& parameter : model.parameters) {
            const auto [lower, upper] = parameter.bounds(surface.setting);
            const bool is_logarithmic = parameter.scale == reduction::TileParameter::Scale::Logarithmic;
            const double value = is_logarithmic ? std::sqrt(lower * upper) : lower + 0.6 * (upper - lower);
            calibration.parameters.push_back({parameter.name, value});
        }
    }
    surface.calibrations.assign(surface.tessellation.patterns.size(), calibrations);
    return surface;
}

TEST(Simulate, CondensedEqualsTheLinearFullModelAtTheInterfaceNodes) {
    const Surface surface = make_surface(honeycomb(4, 3, kPatterns), nullptr);
    const LoadCase load_case = cantilever({0.1, 0.05, -0.2});
    const auto full = simulate(surface, load_case, {.model = "full", .analysis = Analysis::Linear});
    const auto condensed = simulate(surface, load_case, {.model = "condensed"});
    // Condensation is exact; what is left is rounding, magnified by the condition of the two systems.
    EXPECT_LT(relative_difference(interface_rows(full, surface), interface_rows(condensed, surface)), 1e-8);
}

TEST(Simulate, ReactionsOfEveryModelBalanceTheLoad) {
    const Surface surface = with_parameters(make_surface(honeycomb(3, 2, kPatterns), nullptr));
    const Eigen::Vector3d force(0.02, 0.01, -0.05);
    for (const reduction::TileModel& model : reduction::tile_models()) {
        const auto result = simulate(surface, cantilever(force), {.model = model.name});
        ASSERT_TRUE(result.solution.converged()) << model.name;
        const Eigen::Vector3d sum = result.solution.reactions.leftCols<3>().colwise().sum();
        EXPECT_LT((sum + force).norm(), 1e-7 * force.norm()) << model.name;
    }
}

// Only uz of a side is held: the surface moves in its plane, and turns about that side.
TEST(Simulate, MechanismIsToldWithEveryModel) {
    const Surface surface = with_parameters(make_surface(honeycomb(3, 2, kPatterns), nullptr));
    LoadCase load_case = cantilever({0.0, 1.0, 0.0});
    load_case.supports.front().fixed = {{false, false, true, false, false, false}};
    for (const reduction::TileModel& model : reduction::tile_models()) {
        for (const Analysis analysis : {Analysis::Linear, Analysis::OfTheModel}) {
            EXPECT_THAT(complaint_of([&] {
                            simulate(surface, load_case, {.model = model.name, .analysis = analysis});
                        }),
                        HasSubstr("the structure, as held, can move without strain at node "))
                << model.name;
        }
    }
}

TEST(Simulate, DisplacementsThatNoResultHasAreRefused) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    for (const char* model : {"full", "condensed"}) {
        EXPECT_THAT(
            complaint_of([&] {
                simulate(surface, cantilever({0, 0, 1e18}), {.model = model, .analysis = Analysis::Linear});
            }),
            testing::StartsWith("the largest displacement is "))
            << model;
    }
}

TEST(Simulate, NonlinearTendsToLinearAsTheLoadVanishes) {
    const Surface surface = make_surface(honeycomb(3, 2, kPatterns), nullptr);
    const auto relative = [&](double force) {
        const auto nonlinear = simulate(surface, cantilever({0, 0, force}), {.model = "full"});
        const auto linear =
            simulate(surface, cantilever({0, 0, force}), {.model = "full", .analysis = Analysis::Linear});
        return relative_difference(nonlinear.solution.displacements, linear.solution.displacements);
    };
    EXPECT_LT(relative(1e-6), 1e-5);
    EXPECT_GT(relative(0.3), 1e-3);
}

/// A pattern looks the same after a sixth of a turn, so which vertex of a hexagon is vertex 0 must not
/// matter.
TEST(Simulate, DoesNotDependOnWhichVertexOfAHexagonIsTheFirst) {
    const LoadCase load_case = cantilever({0.1, 0.05, -0.2});
    const Surface surface = with_parameters(make_surface(honeycomb(3, 2, kPatterns), nullptr));
    const Surface turned = with_parameters(make_surface(honeycomb(3, 2, kPatterns, 2), nullptr));
    const auto place = [](const Surface& s, std::size_t i) { return s.tessellation.interface_nodes[i]; };
    for (const reduction::TileModel& model : reduction::tile_models()) {
        const SimulationOptions options{.model = model.name, .analysis = Analysis::Linear};
        const auto a = simulate(surface, load_case, options).solution.displacements;
        const auto b = simulate(turned, load_case, options).solution.displacements;
        for (std::size_t i = 0; i < surface.tessellation.interface_nodes.size(); ++i) {
            const std::size_t j = [&] {
                for (std::size_t k = 0;; ++k) {
                    if (std::hypot(place(surface, i).x - place(turned, k).x,
                                   place(surface, i).y - place(turned, k).y) < 1e-7)
                        return k;
                }
            }();
            EXPECT_LT((a.row(static_cast<Eigen::Index>(i)) - b.row(static_cast<Eigen::Index>(j))).norm(),
                      1e-8 * a.norm())
                << model.name;
        }
    }
}

TEST(Simulate, LoadStepsEndInTheSameState) {
    const Surface surface = make_surface(honeycomb(3, 2, kPatterns), nullptr);
    const auto once = simulate(surface, cantilever({0, 0, 0.2}), {.model = "full"});
    const auto steps = simulate(surface, cantilever({0, 0, 0.2}), {.model = "full", .load_steps = 5});
    ASSERT_EQ(steps.load_steps.size(), 5U);
    EXPECT_LT(relative_difference(once.solution.displacements, steps.solution.displacements), 1e-7);
}

TEST(Simulate, ThePaperModelNeedsACalibrationOfEveryPattern) {
    const Surface surface = make_surface(honeycomb(2, 2, kPatterns), nullptr);
    EXPECT_THAT(complaint_of([&] {
                    simulate(surface, cantilever({0, 0, 1}), {.model = "paper6"});
                }),
                HasSubstr("0-1+1-6"));
}

TEST(Simulate, ASurfaceThatNothingHoldsIsRefused) {
    const Surface surface = make_surface(honeycomb(2, 2, kPatterns), nullptr);
    LoadCase load_case = cantilever({0, 0, 1});
    load_case.supports.clear();
    for (const reduction::TileModel& model : reduction::tile_models()) {
        if (!model.parameters.empty()) continue;  // refused: it has no calibration
        EXPECT_THROW(simulate(surface, load_case, {.model = model.name}), base::Error) << model.name;
    }
}

TEST(Simulate, ResultsOfALoadCaseWithoutANameAreCompared) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    LoadCase load_case = cantilever({0, 0, 0.01});
    load_case.name.clear();
    const auto full = simulate(surface, load_case, {.model = "full", .analysis = Analysis::Linear});
    const auto condensed = simulate(surface, load_case, {.model = "condensed"});
    EXPECT_LT(compare(full, condensed).relative_l2_error, 1e-7);
    load_case.loads[0].force *= 2.0;
    EXPECT_THROW((void)compare(full, simulate(surface, load_case, {.model = "condensed"})), base::InputError);
}

/// The ring of paper6 and the pattern 1-6+3-6 have six inner nodes in each hexagon, at other places.
TEST(Simulate, ModesAreKnownAtTheInterfaceNodesOfAReducedModelOnly) {
    const Surface surface = with_parameters(make_surface(honeycomb(2, 2, {"1-6+3-6"}), nullptr));
    const auto modes_of = [&](const char* model) {
        return simulate(surface, cantilever({0, 0, -0.001}),
                        {.model = model, .analysis = Analysis::Linear, .vibration_modes = 1});
    };
    const auto full = modes_of("full");
    const auto ring = modes_of("paper6");
    ASSERT_EQ(ring.nodes.size(), full.nodes.size()) << "else this says nothing";
    const NodeValues& own = full.vibration_modes.at(0).shape;
    const NodeValues& shape = ring.vibration_modes.at(0).shape;
    const auto interface_nodes = std::ssize(surface.tessellation.interface_nodes);
    EXPECT_TRUE(shape.topRows(interface_nodes) == own.topRows(interface_nodes));
    EXPECT_FALSE(own.bottomRows(own.rows() - interface_nodes).isZero(0.0));
    EXPECT_TRUE(shape.bottomRows(shape.rows() - interface_nodes).isZero(0.0));
}

TEST(Simulate, AnUnknownModelAndZeroStepsAreRefused) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    EXPECT_THAT(complaint_of([&] {
                    simulate(surface, cantilever({0, 0, 1}), {.model = "ful"});
                }),
                HasSubstr("did you mean 'full'?"));
    EXPECT_THAT(complaint_of([&] {
                    simulate(surface, cantilever({0, 0, 1}), {.model = "full", .load_steps = 0});
                }),
                HasSubstr("the number of steps is 0"));
    for (const int modes : {-1, 1001})
        EXPECT_THAT(complaint_of([&] {
                        simulate(surface, cantilever({0, 0, 1}), {.model = "full", .buckling_modes = modes});
                    }),
                    HasSubstr("the number of modes is " + std::to_string(modes) + ", where 0 to 1000"));
}

TEST(Simulate, OnlyTheNonlinearFullModelHasStepsAndADiscretizationError) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    const LoadCase load_case = cantilever({0, 0, 0.2});
    const auto result = simulate(surface, load_case, {.estimate_error = true});
    ASSERT_TRUE(result.discretization_error.has_value());
    EXPECT_TRUE(result.discretization_error->known);
    EXPECT_GT(result.discretization_error->share, 0.0);
    EXPECT_LT(result.discretization_error->share, 1e-3);
    for (const SimulationOptions& wrong :
         {SimulationOptions{.analysis = Analysis::Linear, .estimate_error = true},
          SimulationOptions{.model = "condensed", .estimate_error = true},
          SimulationOptions{.model = "condensed", .load_steps = 4}})
        EXPECT_THROW(simulate(surface, load_case, wrong), base::InputError);
}

TEST(SurfaceFrame, SolvedOnItsOwnGivesTheSameDisplacements) {
    const Surface surface = make_surface(honeycomb(3, 2, kPatterns), nullptr);
    const LoadCase load_case = cantilever({0.1, 0.05, -0.2});
    const test::TemporaryFolder folder;
    mechanics::write_frame(surface_frame(surface, {}, resolve(load_case, surface)),
                           folder.path() / "frame.json");
    const auto solution =
        mechanics::solve_linear(mechanics::assemble(mechanics::read_frame(folder.path() / "frame.json")));
    const auto result = simulate(surface, load_case, {.model = "full", .analysis = Analysis::Linear});
    EXPECT_EQ(relative_difference(result.solution.displacements, solution.displacements), 0.0);
}

TEST(SurfaceFrame, RefusesTilesThatAreNotMadeOfBeams) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    EXPECT_THAT(complaint_of([&] { (void)surface_frame(surface, {"condensed"}, {}); }),
                HasSubstr("tiles that do not consist of beams"));
    EXPECT_FALSE(tile_beams(surface, {"condensed"}).has_value());
}

TEST(SurfaceFrame, HasTheBeamsOfItsTilesWithWhatActsOnThem) {
    const Surface surface = make_surface(honeycomb(2, 1, kPatterns), nullptr);
    const auto conditions = resolve(cantilever({0.0, 0.0, 0.1}), surface);
    const auto beams = tile_beams(surface, {});
    ASSERT_TRUE(beams.has_value());
    EXPECT_TRUE(beams->loads.empty());
    EXPECT_TRUE(beams->supports.empty());
    mechanics::Frame loaded = surface_frame(surface, {}, conditions);
    EXPECT_EQ(loaded.loads.size(), conditions.loads.size());
    EXPECT_EQ(loaded.beams.size(), beams->beams.size());
    EXPECT_EQ(beams->nodes.size(), loaded.nodes.size());
}

TEST(Compare, OfAResultWithItselfIsZero) {
    const Surface surface = make_surface(honeycomb(3, 2, kPatterns), nullptr);
    auto result = simulate(surface, cantilever({0, 0, 0.2}), {.model = "full"});
    EXPECT_THAT(complaint_of([&] { compare(result, result); }), HasSubstr("nothing to compare"));
    result.subject.reset();
    const Comparison comparison = compare(result, result);
    EXPECT_EQ(comparison.max_translation_error, 0.0);
    EXPECT_EQ(comparison.relative_l2_error, 0.0);
    EXPECT_NEAR(comparison.max_rotation_error, 0.0,
                1e-7);  // acos near 1 is exact to the square root of the rounding only
    EXPECT_GT(comparison.max_displacement, 0.0);
}

TEST(Compare, CallsTheFullResultUnstableOnlyIfItsTestDecides) {
    simulation::SurfaceResult full;
    full.nodes = {{0, {0, 0, 0}, true}};
    full.solution.displacements = NodeValues::Constant(1, 6, 0.004);
    full.solution.stable = false;
    full.solution.stability = mechanics::StabilityTest::SymmetricPart;
    EXPECT_FALSE(compare(full, full).full_is_unstable);
    full.solution.stability = mechanics::StabilityTest::Tangent;
    EXPECT_TRUE(compare(full, full).full_is_unstable);
}

/// Two nodes with errors of 3 and 1 mm: mean 2, sd of the population 1; rotations about x by 0.1 and 0.
TEST(Compare, MatchesAnExampleByHand) {
    simulation::SurfaceResult full;
    full.nodes = {{0, {0, 0, 0}, true}, {1, {0.3, 0.2, 0}, true}};
    full.solution.displacements = NodeValues::Zero(2, 6);
    full.solution.displacements(0, 2) = 0.004;
    full.solution.displacements(0, 3) = 0.1;
    simulation::SurfaceResult reduced = full;
    reduced.solution.displacements(0, 2) = 0.001;
    reduced.solution.displacements(0, 3) = 0.0;
    reduced.solution.displacements(1, 1) = 0.001;
    const Comparison comparison = compare(full, reduced);
    EXPECT_DOUBLE_EQ(comparison.width, 0.3);
    EXPECT_DOUBLE_EQ(comparison.height, 0.2);
    EXPECT_DOUBLE_EQ(comparison.max_displacement, 0.004);
    EXPECT_DOUBLE_EQ(comparison.max_translation_error, 0.003);
    EXPECT_DOUBLE_EQ(comparison.mean_translation_error, 0.002);
    EXPECT_DOUBLE_EQ(comparison.sd_translation_error, 0.001);
    EXPECT_NEAR(comparison.max_rotation_error, 0.1, 1e-12);
    EXPECT_NEAR(comparison.mean_rotation_error, 0.05, 1e-12);
    EXPECT_DOUBLE_EQ(comparison.relative_l2_error, std::sqrt(10.0) / 4.0);
}

TEST(Compare, RefusesResultsOfDifferentSubjects) {
    const Surface surface = make_surface(honeycomb(3, 2, kPatterns), nullptr);
    const LoadCase load_case = cantilever({0, 0, 0.01});
    const auto full = simulate(surface, load_case, {.model = "full"});
    const auto complaint = [&](const Surface& other, const LoadCase& other_case) {
        const auto reduced = simulate(other, other_case, {.model = "condensed"});
        return complaint_of([&] { compare(full, reduced); });
    };
    EXPECT_THAT(complaint(surface, cantilever({0, 0, 0.02})),
                HasSubstr("what the load case 'cantilever' holds"));
    LoadCase renamed = load_case;
    renamed.name = "other";
    EXPECT_THAT(complaint(surface, renamed), HasSubstr("'cantilever' and 'other'"));
    Surface changed = surface;
    changed.setting.material.young_modulus *= 2.0;
    EXPECT_THAT(complaint(changed, load_case), HasSubstr("differ in the setting"));
    changed = surface;
    changed.tessellation.tiles[0].pattern = 1;
    EXPECT_THAT(complaint(changed, load_case), HasSubstr("differ in the painting"));
    changed = surface;
    tiling::Tile& turned = changed.tessellation.tiles[2];
    std::ranges::rotate(turned.vertices, turned.vertices.begin() + 1);
    std::ranges::rotate(turned.interface_nodes, turned.interface_nodes.begin() + 1);
    EXPECT_THAT(complaint(changed, load_case), testing::EndsWith("differ in the painting"));
    EXPECT_THAT(complaint(make_surface(honeycomb(2, 3, kPatterns), nullptr), load_case),
                HasSubstr("the tessellation"));
    const auto condensed = simulate(surface, load_case, {.model = "condensed"});
    EXPECT_THAT(complaint_of([&] { compare(condensed, full); }), HasSubstr("name the full one first"));
    LoadCase described = load_case;
    described.description = "in other words";
    EXPECT_NO_THROW(compare(full, simulate(surface, described, {.model = "condensed"})));
}

TEST(Compare, RefusesResultsOfDifferentSurfaces) {
    simulation::SurfaceResult full;
    full.nodes = {{0, {0, 0, 0}, true}, {1, {0.3, 0.2, 0}, true}};
    full.solution.displacements = NodeValues::Zero(2, 6);
    simulation::SurfaceResult fewer = full;
    fewer.nodes[1].is_interface = false;
    EXPECT_THAT(complaint_of([&] { compare(full, fewer); }), HasSubstr("2 and 1 interface nodes"));
    simulation::SurfaceResult moved = full;
    moved.nodes[1].rest_position.x() = 0.31;
    EXPECT_THAT(complaint_of([&] { compare(full, moved); }),
                HasSubstr("interface node 1 lies at different places"));
    simulation::SurfaceResult failed = full;
    failed.solution.termination = mechanics::Termination::Diverged;
    EXPECT_THAT(complaint_of([&] { compare(full, failed); }), HasSubstr("did not converge"));
}

TEST(Comparison, TheRowHasAsManyColumnsAsTheHeader) {
    EXPECT_EQ(base::split(comparison_header(), ',').size(), base::split(comparison_row("A", {}), ',').size());
    EXPECT_EQ(comparison_header() + "\n",
              base::read_text_file(FRETWORK_SOURCE_DIR "/tests/simulation/data/table3_header.csv"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
